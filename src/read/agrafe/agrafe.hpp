// SPDX-License-Identifier: MIT
// Reads charts of AGRAFE GRAFCET (EMF, XMI 2.0) to a syntax tree. The reader supports the complete meta-model of
// AGRAFE: partial grafcets, expansions of macro-steps, enclosing steps with activation links, forcing orders, timed
// transitions, all types of actions, terms.
//
// EMF (Eclipse Modeling Framework) omits default values. A declaration without a type is an input; a stored action
// without a type is executed on activation. A missing value is false or 0, and a missing time unit is s. References are
// paths such as `//@partialGrafcets.0/@steps.1`.
#pragma once

#include "grafverif/support/diagnostic.hpp"
#include "read/xml.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

/// Reads the chart of `xml`. The chart has the name `name` unless the document contains a name. After an error,
/// `broken` of the result is true.
tree::File read_agrafe(const Xml& xml, std::string_view name, bool lossy, Diagnostics& diagnostics);

}  // namespace grafverif
