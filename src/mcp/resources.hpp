// SPDX-License-Identifier: MIT
// Provides the resources of the MCP server: the reference of the language, and the components of the library. All
// resources are embedded in the program.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string_view>

namespace grafverif::mcp {

using Json = nlohmann::json;

/// A page of the documentation in Markdown.
struct Page {
    std::string_view name = {};
    std::string_view text = {};
};
std::span<const Page> pages();

/// Returns the list of resources in the form in which the method `resources/list` returns it.
Json resource_list();
/// Returns the content of a resource in the form in which the method `resources/read` returns it; nothing if no
/// resource has the address `uri`.
std::optional<Json> resource_content(std::string_view uri);

}  // namespace grafverif::mcp
