// SPDX-License-Identifier: MIT
// AGRAFE GRAFCET (EMF, XMI 2.0) -> tree. All of its meta-model is read: partial grafcets, expansions of macro-steps,
// enclosing steps with activation links, forcing orders, timed transitions, actions of every kind, terms.
//
// EMF leaves defaults out: a declaration without a type is an input, a stored action without one is on activation, a
// missing value is false or 0, a missing unit is s. References are positions (`//@partialGrafcets.0/@steps.1`).
#pragma once

#include "grafverif/support/diagnostic.hpp"
#include "read/xml.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

/// The chart of `xml`, called `name` unless the document names it. Broken after an error.
tree::File read_agrafe(const Xml& xml, std::string_view name, bool lossy, Diagnostics& diagnostics);

}  // namespace grafverif
