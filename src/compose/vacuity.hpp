// SPDX-License-Identifier: MIT
// Vacuity of observed properties: their probes (ir/probes.hpp). A probe is violated exactly if its property, which
// holds, does so vacuously. docs/reference/properties.md has a table of all forms.
#pragma once

#include <vector>

#include "compose/observer.hpp"
#include "grafverif/ir/network.hpp"
#include "support/unique_names.hpp"

namespace grafverif {

/// Adds the variable for probes of scopes that must close. It records if a state with the premise has occurred in the
/// open scope. The result is invalid if the scope does not need the variable. The observer is otherwise unchanged.
Id<Network::Variable> follow_scope(Network& network, UniqueNames& names, const Property& property,
                                   const ObserverTerms& terms, Network::Template& automaton);

/// Returns the probes of `property`, the most general first. The first violated probe states why the property is
/// vacuous. `followed` is the result of follow_scope.
std::vector<Property> vacuity_probes(Network& network, const Property& property, const ObserverTerms& terms,
                                     Id<Network::Process> observer, Id<Network::Variable> followed);

}  // namespace grafverif
