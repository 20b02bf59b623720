// SPDX-License-Identifier: MIT
// Writes a Network as a UPPAAL project in a form that engineers can read. The project has one template per component
// and one process per instance. The equations of each PLC are functions of its template, and the properties are
// queries.
//
// Mapping:
//   variable, clock: `bool x;`, `int[lo,hi] n;`, `clock t;`. Global variables are grouped by role; scratch variables
//     are `meta`.
//   parameter Read, Written: `bool &x`, `int[lo,hi] &n`. Parameters that are only read are not `const &`, because
//     UPPAAL cannot bind a variable to a `const &` parameter of a process.
//   parameter Constant: `const int D`, `const bool K`.
//   urgent edge: Emits on one urgent broadcast channel, which needs no receiver (CEP13 section 5). UPPAAL lets no time
//     pass while the guard of the edge holds.
//   procedure: A function `void evolve() { ... }` of the template, with one assignment per line; edges call the
//     function.
//   property: A query with a formula, the expected outcome, and a comment that begins with the name of the property.
//
// A long guard becomes a Boolean function. Names are converted to legal names once (syntax/print/legal_names); the
// header of the file contains the map of changed names. A process whose initial location differs from the initial
// location of its template has a separate template (see `lower`). Locations, edges and labels are laid out by
// emit/layout.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif::uppaal {

/// Returns an equivalent network in which each process starts in the initial location of its template. If the processes
/// of a template start in several locations, the template is copied for each of these locations, and each copy is named
/// after its location (`sensors`, `sensors_out`). Location indices, and therefore properties, are unchanged. A constant
/// parameter that can exceed UPPAAL's default integers gets the range of its arguments.
Network lower(Network network);

/// Writes the project as `.xml`. Requires verify(network).empty() and a lowered network.
void emit(const Network& network, std::ostream& out);

/// Writes only the queries, as `.q`. The formulas are the same as in the project, with comments in `/* */`. Requires
/// verify(network).empty() and a lowered network, as for `emit`.
void emit_queries(const Network& network, std::ostream& out);

/// A property that UPPAAL's query language cannot express. A comment replaces the property.
struct Inexpressible {
    Id<Property> property = {};
    std::string reason = {};
    bool operator==(const Inexpressible&) const = default;
};
std::vector<Inexpressible> inexpressible(const Network& network);

/// A query without its comment, for external programs that check a single query.
struct Formula {
    Id<Property> property = {};
    std::string name = {};  ///< name of the property; `S.X7` for one step of a property that is checked per step
    std::string text = {};  ///< formula in one line; empty if the property is inexpressible
    bool operator==(const Formula&) const = default;
};
/// Returns the formulas in the order of emit_queries. The requirements are the same as for `emit`.
std::vector<Formula> formulas(const Network& network);

}  // namespace grafverif::uppaal
