# SPDX-License-Identifier: MIT
# Writes OUTPUT, a C++ source that holds the text of each of FILES, the parts of the page of `serve`.
set(entries "")
foreach(file IN LISTS FILES)
    file(READ "${file}" text)
    get_filename_component(name "${file}" NAME)
    # A raw string may be 65,535 characters long: longer ones are several side by side.
    set(literal "")
    string(LENGTH "${text}" length)
    foreach(at RANGE 0 ${length} 8000)
        string(SUBSTRING "${text}" ${at} 8000 piece)
        string(APPEND literal "R\"~~~(${piece})~~~\"\n")
    endforeach()
    string(APPEND entries "    {\"${name}\", ${literal}},\n")
endforeach()
file(WRITE "${OUTPUT}" "// SPDX-License-Identifier: MIT
#include \"app/serve/live_files.hpp\"

namespace grafverif::app {

namespace {

const LiveFile files[] = {
${entries}};

}  // namespace

std::span<const LiveFile> live_files() { return files; }

}  // namespace grafverif::app
")
