// SPDX-License-Identifier: MIT
// Parses a model again with modified texts instead of the contents of its files.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "grafverif/grafverif.hpp"

namespace grafverif {

/// Parses `main` and its includes. `texts` contains the modified texts by file name; all other texts are from `from`.
/// Adds the sources to `to`. The result is empty after an error.
std::optional<Model> read_again(Id<Source> main, const std::map<std::string, std::string>& texts, const Sources& from,
                                Sources& to, const ReadOptions& read, Diagnostics& diagnostics);

}  // namespace grafverif
