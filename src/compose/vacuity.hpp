// SPDX-License-Identifier: MIT
// Adds probes that detect whether a property with an observer holds vacuously (ir/probes.hpp). A probe is violated if
// and only if its property holds vacuously. docs/reference/properties.md has a table of all forms.
#pragma once

#include <vector>

#include "compose/observer.hpp"
#include "grafverif/ir/network.hpp"
#include "support/unique_names.hpp"

namespace grafverif {

/// Adds the variable that probes need if only closed scopes are relevant for the property. The variable records whether
/// the premise has been true in a state of the open scope. The result is invalid if open scopes are also relevant, or
/// if an operand contains a division. The function does not change the observer in any other way.
Id<Network::Variable> follow_scope(Network& network, UniqueNames& names, const Property& property,
                                   const ObserverTerms& terms, Network::Template& automaton);

/// Returns the probes of `property`, beginning with the most general probe. The first violated probe states why the
/// property holds vacuously. `followed` is the result of follow_scope.
std::vector<Property> vacuity_probes(Network& network, const Property& property, const ObserverTerms& terms,
                                     Id<Network::Process> observer, Id<Network::Variable> followed);

}  // namespace grafverif
