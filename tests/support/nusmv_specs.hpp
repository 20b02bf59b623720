// SPDX-License-Identifier: MIT
// Reads the specifications of a NuSMV text with the operator precedences of NuSMV, and decides them on an explicit
// graph of states with the semantics of SMV. An invariant holds in all reachable states. A CTL formula quantifies over
// fair paths (Clarke, Grumberg, Peled, "Model Checking", 6.3) and is true if every initial state satisfies it. The code
// does not use property patterns.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "support/explicit_search.hpp"
#include "support/nusmv_reader.hpp"

namespace grafverif {

/// A formula: an operator with operands, or a name or number without operands. The operators have the spelling of
/// NuSMV.
struct SpecTerm {
    std::string op = {};
    std::vector<SpecTerm> operands = {};
    bool operator==(const SpecTerm&) const = default;
};

/// Reads a CTL formula. Returns nothing if the text has a form that neither the emitter nor NuSMV writes.
std::optional<SpecTerm> read_spec(std::string_view text);

/// Returns a model checker's verdict on the specification. Fails the test if the formula contains an operator that is
/// not an operator on states. The test also fails if the verdict depends on the treatment of initial states without a
/// fair run, because tools differ in this treatment.
bool spec_is_true(const TransitionSystem& system, const SystemGraph& graph, const NusmvModel::Specification& spec);

/// True if the property of the specification holds; `is_true` is the verdict on the specification. If the name of the
/// specification begins with `never_`, the specification is the negation of the property, and the verdict is inverted.
bool verdict_of_spec(const NusmvModel::Specification& spec, const Property& property, bool is_true);

}  // namespace grafverif
