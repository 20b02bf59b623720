# SPDX-License-Identifier: MIT
# Writes OUTPUT, a C++ source that contains the text of each of PAGES, the pages that the MCP server offers as resources.
include("${CMAKE_CURRENT_LIST_DIR}/literal.cmake")
set(entries "")
foreach(file IN LISTS PAGES)
    file(READ "${file}" text)
    get_filename_component(name "${file}" NAME_WE)
    literal_of("${text}" literal)
    string(APPEND entries "    {\"${name}\", ${literal}sv},\n")
endforeach()
file(WRITE "${OUTPUT}" "// SPDX-License-Identifier: MIT
#include \"mcp/resources.hpp\"

namespace grafverif::mcp {

namespace {

using namespace std::string_view_literals;

constexpr Page all[] = {
${entries}};

}  // namespace

std::span<const Page> pages() { return all; }

}  // namespace grafverif::mcp
")
