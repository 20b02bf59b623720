// SPDX-License-Identifier: MIT
// The specifications of a NuSMV text, read with NuSMV's own precedences and decided on an explicit graph of states with
// the semantics of SMV: an invariant holds in all reachable states; a formula of CTL is about fair paths (Clarke,
// Grumberg, Peled, "Model Checking", 6.3) and true if every initial state satisfies it. It knows nothing of patterns.
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

/// Nothing: it is no formula of CTL as the emitter or NuSMV writes them.
std::optional<SpecTerm> read_spec(std::string_view text);

/// What a model checker says of the specification. Fails the test where it is not about states alone, or where it makes
/// a difference whether initial states without a fair run count: tools differ there.
bool spec_is_true(const TransitionSystem& system, const SystemGraph& graph, const NusmvModel::Specification& spec);

/// The verdict on the property that the specification tells, by what the text says of its polarity: the name of one that
/// is asked as its opposite begins with `never_`.
bool verdict_of_spec(const NusmvModel::Specification& spec, const Property& property, bool is_true);

}  // namespace grafverif
