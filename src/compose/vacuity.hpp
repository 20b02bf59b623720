// SPDX-License-Identifier: MIT
// Vacuity of observed properties: their probes (ir/probes.hpp), violated exactly if a property that holds does so for lack of
// anything to check (docs/properties.md has the table of all forms).
#pragma once

#include <vector>

#include "compose/observer.hpp"
#include "grafverif/ir/network.hpp"
#include "support/unique_names.hpp"

namespace grafverif {

/// Adds to the observer `automaton` what the probes of scopes that have to close need: a variable that tells whether the
/// open scope has had a state with the premise. Not valid: none is needed. Changes nothing else that the observer does.
Id<Network::Variable> follow_scope(Network& network, UniqueNames& names, const Property& property,
                                   const ObserverTerms& terms, Network::Template& automaton);

/// The probes of `property`, the most general first: the first that is violated says why the property is vacuous.
/// `followed` is the variable of follow_scope.
std::vector<Property> vacuity_probes(Network& network, const Property& property, const ObserverTerms& terms,
                                     Id<Network::Process> observer, Id<Network::Variable> followed);

}  // namespace grafverif
