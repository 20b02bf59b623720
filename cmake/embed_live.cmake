# SPDX-License-Identifier: MIT
# Writes OUTPUT, a C++ source that contains the text of each of FILES, the files of the pages of `serve` and `edit`. In
# an HTML file, the first line is replaced by the text of HEAD, which all pages share.
include("${CMAKE_CURRENT_LIST_DIR}/literal.cmake")
file(READ "${HEAD}" head)
set(entries "")
foreach(file IN LISTS FILES)
    file(READ "${file}" text)
    string(REPLACE "<!-- head.html -->\n" "${head}" text "${text}")
    get_filename_component(name "${file}" NAME)
    literal_of("${text}" literal)
    string(APPEND entries "    {\"${name}\", ${literal}sv},\n")
endforeach()
file(WRITE "${OUTPUT}" "// SPDX-License-Identifier: MIT
#include \"app/serve/live_files.hpp\"

namespace grafverif::app {

namespace {

using namespace std::string_view_literals;

constexpr LiveFile files[] = {
${entries}};

}  // namespace

std::span<const LiveFile> live_files() { return files; }

}  // namespace grafverif::app
")
