// SPDX-License-Identifier: MIT
// Conditions put into the text of charts, and texts read again as if they were in the files.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "grafverif/grafverif.hpp"

namespace grafverif {

/// A term over names: `all`: a conjunction of disjunctions, else a disjunction of conjunctions; each name with a sign.
struct NamedTerm {
    std::vector<std::vector<std::pair<std::string, bool>>> terms = {};
    bool all = false;
};

/// As the language writes it.
std::string text_of(const NamedTerm& term);

/// The file in canonical form, with each term added to the condition of the transition or continuous action that begins
/// at its offset. Requires a source without errors.
std::string with_conditions(Id<Source> file, const Sources& sources, const std::map<std::uint32_t, NamedTerm>& terms);

/// The same, with a property `NAME: always possible TERM` in the closed loop `loop`. Empty after an error: the term is none.
std::optional<std::string> with_marked(Id<Source> file, Sources& sources, const std::string& loop,
                                       const std::string& name, const std::string& term, Diagnostics& diagnostics);

/// `main` with its includes, other texts standing for those of some files. Sources are added to `to`.
std::optional<Model> read_again(Id<Source> main, const std::map<std::string, std::string>& texts, const Sources& from,
                                Sources& to, const ReadOptions& read, Diagnostics& diagnostics);

}  // namespace grafverif
