# SPDX-License-Identifier: MIT
# Writes OUTPUT, a C++ source that contains the text of each of FILES, the component library. Therefore the program can
# read the library independently of the installation folder.
set(entries "")
foreach(file IN LISTS FILES)
    file(READ "${file}" text)
    get_filename_component(name "${file}" NAME_WE)
    string(APPEND entries "    {.name = \"${name}\", .text = R\"~~~(${text})~~~\"sv, .path = \"<library>/${name}.grafcet\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "// SPDX-License-Identifier: MIT
#include \"pipeline/components.hpp\"

namespace grafverif {

namespace {

using namespace std::string_view_literals;

constexpr LibraryEntry entries[] = {
${entries}};

}  // namespace

std::span<const LibraryEntry> library() { return entries; }

}  // namespace grafverif
")
