// SPDX-License-Identifier: MIT
// The specifications of a NuSMV text, read with NuSMV's own precedences and decided on an explicit graph of states with
// the semantics of SMV. An invariant holds in all reachable states; a CTL formula is about fair paths (Clarke,
// Grumberg, Peled, "Model Checking", 6.3) and true if every initial state satisfies it. Independent of property
// patterns.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "support/explicit_search.hpp"
#include "support/nusmv_reader.hpp"

namespace grafverif {

/// A formula: an operator, or a name or number without operands. Operators are spelled as NuSMV spells them.
struct SpecTerm {
    std::string op = {};
    std::vector<SpecTerm> operands = {};
    bool operator==(const SpecTerm&) const = default;
};

/// Nothing: it is not a CTL formula as the emitter or NuSMV write them.
std::optional<SpecTerm> read_spec(std::string_view text);

/// A model checker's verdict on the specification. Fails the test if the formula is not about states alone, or if the
/// treatment of initial states without a fair run matters: tools differ there.
bool spec_is_true(const TransitionSystem& system, const SystemGraph& graph, const NusmvModel::Specification& spec);

/// The verdict on the property of the specification, according to its polarity in the text: the name of a negated one
/// begins with `never_`.
bool verdict_of_spec(const NusmvModel::Specification& spec, const Property& property, bool is_true);

}  // namespace grafverif
