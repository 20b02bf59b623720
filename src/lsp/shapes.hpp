// SPDX-License-Identifier: MIT
// Values as LSP 3.17 has them in JSON. What is read throws nlohmann::json::exception where it is of another shape.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "lsp/text.hpp"
#include "lsp/told.hpp"

namespace grafverif::lsp {

using Json = nlohmann::json;

/// The address that the editor knows a file by.
using UriOf = std::function<std::string(const std::string& path)>;

Json json_of(Position position);
Json json_of(Range range);
Json json_of(const Place& place, const UriOf& uri_of);
Json json_of(const Told& told, const UriOf& uri_of);
/// A WorkspaceEdit.
Json json_of(const std::vector<Edit>& edits, const UriOf& uri_of);
/// A CodeAction that does what the hint of `told` asks for.
Json quick_fix(const Told& told, const UriOf& uri_of);

Position position_of(const Json& json);
Range range_of(const Json& json);
std::vector<Change> changes_of(const Json& json);

/// What a member of an object says, however deep; `fallback` where it, or what leads to it, is missing or something else.
bool flag(const Json& object, std::initializer_list<const char*> path);

/// Whether brackets nest deeper than any message does; such a text is not parsed.
bool nests_too_deep(std::string_view json);

}  // namespace grafverif::lsp
