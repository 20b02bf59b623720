// SPDX-License-Identifier: MIT
// Network -> UPPAAL project, in a form that engineers can read. It has one template per component and one process per
// instance. The equations of each PLC are functions of its template, and the properties are queries.
//
// Mapping:
//   variable, clock      `bool x;`, `int[lo,hi] n;`, `clock t;`; globals grouped by role, scratch variables `meta`
//   Read, Written        `bool &x`, `int[lo,hi] &n`: UPPAAL binds no variable to a `const &` of a process
//   Constant             `const int D`, `const bool K`
//   urgent edge          emits on one urgent broadcast channel, which needs no receiver (CEP13 section 5);
//                        UPPAAL then lets no time pass while its guard holds
//   procedure            `void evolve() { ... }` of the template, one assignment per line; edges call it
//   property             a query: formula, a comment that begins with the property's name, the expected outcome
// A long guard becomes a Boolean function. Names are made legal once (syntax/print/legal_names); the map is in the
// header. A process with an initial location different from that of its template needs a separate template (`lower`).
// Locations, edges and labels are laid out by emit/layout.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif::uppaal {

/// The same network with each process starting in the initial location of its template. A template whose processes
/// start in several locations is copied for each of them, named by the location (`sensors`, `sensors_out`). Location
/// indices, and hence properties, are unchanged. A constant beyond UPPAAL's default integers gets the range of its
/// arguments.
Network lower(Network network);

/// The project as `.xml`. Requires verify(network).empty() and a lowered network.
void emit(const Network& network, std::ostream& out);

/// The queries alone, as `.q`: the same formulas, with comments in `/* */`. Same requirements as emit.
void emit_queries(const Network& network, std::ostream& out);

/// A property that UPPAAL's query language cannot express. It is replaced by a comment.
struct Inexpressible {
    Id<Property> property = {};
    std::string reason = {};
    bool operator==(const Inexpressible&) const = default;
};
std::vector<Inexpressible> inexpressible(const Network& network);

/// One query without its comment, for external programs that check a single one.
struct Formula {
    Id<Property> property = {};
    std::string name = {};  ///< that of the property; `S.X7` for one that is checked per step
    std::string text = {};  ///< one line; empty: inexpressible
    bool operator==(const Formula&) const = default;
};
/// In the order of emit_queries. Same requirements as emit.
std::vector<Formula> formulas(const Network& network);

}  // namespace grafverif::uppaal
