// SPDX-License-Identifier: MIT
// Inserts conditions into the text of charts.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "grafverif/grafverif.hpp"

namespace grafverif {

/// A term over names, each of which may be negated. If `all` is true, the term is a conjunction of disjunctions;
/// otherwise, the term is a disjunction of conjunctions.
struct NamedTerm {
    std::vector<std::vector<std::pair<std::string, bool>>> terms = {};
    bool all = false;
};

/// Returns the term in the syntax of the language.
std::string text_of(const NamedTerm& term);

/// Returns the position of a transition or continuous action inside a `for` declaration of the chart; empty if there is
/// no such element. A condition cannot be added to only one copy of the element.
std::optional<Span> replicated_element(const Chart& chart, const Sources& sources);

/// Returns the file in canonical form. Each term is added to the condition of the transition or continuous action that
/// begins at its offset. Requires a source without errors.
std::string with_conditions(Id<Source> file, const Sources& sources, const std::map<std::uint32_t, NamedTerm>& terms);

/// Returns the file with a property `NAME: always possible TERM` added to the closed loop `loop`. The result is empty
/// after an error: the term is invalid.
std::optional<std::string> with_marked(Id<Source> file, Sources& sources, const std::string& loop,
                                       const std::string& name, const std::string& term, Diagnostics& diagnostics);

}  // namespace grafverif
