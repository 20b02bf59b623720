// SPDX-License-Identifier: MIT
// Parses modified texts as if they were in the files.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "grafverif/grafverif.hpp"

namespace grafverif {

/// Parses `main` and its includes. `texts` replaces the contents of some files. Adds the sources to `to`.
std::optional<Model> read_again(Id<Source> main, const std::map<std::string, std::string>& texts, const Sources& from,
                                Sources& to, const ReadOptions& read, Diagnostics& diagnostics);

}  // namespace grafverif
