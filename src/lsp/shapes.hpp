// SPDX-License-Identifier: MIT
// Converts between values and JSON as defined by LSP 3.17. A conversion from JSON throws nlohmann::json::exception if
// the JSON does not have the required structure.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "lsp/diagnostics.hpp"
#include "lsp/text.hpp"

namespace grafverif::lsp {

using Json = nlohmann::json;

/// Returns the address by which the editor refers to a file.
using UriOf = std::function<std::string(const std::string& path)>;

Json json_of(Position position);
Json json_of(Range range);
Json json_of(const Place& place, const UriOf& uri_of);
Json json_of(const LspDiagnostic& diagnostic, const UriOf& uri_of);
/// Returns a WorkspaceEdit.
Json json_of(const std::vector<Edit>& edits, const UriOf& uri_of);
/// Returns a CodeAction that applies the fix of `diagnostic`.
Json quick_fix(const LspDiagnostic& diagnostic, const UriOf& uri_of);

Position position_of(const Json& json);
Range range_of(const Json& json);
std::vector<Change> changes_of(const Json& json);

/// Returns the Boolean at `path`, a list of member names in nested objects. Returns false if the member, or an object
/// on the path, is missing or has another type.
bool flag(const Json& object, std::initializer_list<const char*> path);

}  // namespace grafverif::lsp
