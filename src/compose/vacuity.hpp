// SPDX-License-Identifier: MIT
// Vacuity of observed properties: their probes (ir/probes.hpp). A probe is violated exactly if a property that holds
// does so vacuously (docs/reference/properties.md has the table of all forms).
#pragma once

#include <vector>

#include "compose/observer.hpp"
#include "grafverif/ir/network.hpp"
#include "support/unique_names.hpp"

namespace grafverif {

/// Adds the variable for probes of scopes that must close: it records if the open scope has had a state with the
/// premise. Invalid if the scope does not need it. The observer is otherwise unchanged.
Id<Network::Variable> follow_scope(Network& network, UniqueNames& names, const Property& property,
                                   const ObserverTerms& terms, Network::Template& automaton);

/// The probes of `property`, the most general first: the first violated one states why the property is vacuous.
/// `followed`: result of follow_scope.
std::vector<Property> vacuity_probes(Network& network, const Property& property, const ObserverTerms& terms,
                                     Id<Network::Process> observer, Id<Network::Variable> followed);

}  // namespace grafverif
