// SPDX-License-Identifier: MIT
// Network -> UPPAAL project: the closed loop as an engineer opens it in UPPAAL, with one template per component, one
// process per instance, the equations of each PLC in functions of its template, and the properties as queries.
//
// What becomes what:
//   variable, clock      `bool x;`, `int[lo,hi] n;`, `clock t;`; globals grouped by role, scratch variables `meta`
//   Read, Written        `bool &x`, `int[lo,hi] &n`: UPPAAL binds no variable to a `const &` of a process
//   Constant             `const int D`, `const bool K`
//   urgent edge          emits on one urgent broadcast channel, which nobody needs to receive (CEP13 section 5);
//                        UPPAAL then lets no time pass while its guard holds
//   procedure            `void evolve() { ... }` of the template, one assignment per line; edges call it
//   property             a query: formula, a comment that begins with the property's name, the expected outcome
// Where the target forces a choice: a guard of many lines stands in a Boolean function; names are legalised once
// (syntax/legal_names), the map is in the header; a process that starts elsewhere than its template says needs a
// template of its own (`lower`). Locations, edges and labels are laid out by emit/layout.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif::uppaal {

/// The same network with each process starting where its template does: a template whose processes start at several
/// locations becomes several, named by the location (`sensors`, `sensors_out`). Location indices, hence properties,
/// stay as they are. A constant beyond UPPAAL's default integers gets the range of its arguments.
Network lower(Network network);

/// The project as `.xml`. Requires verify(network).empty() and a lowered network.
void emit(const Network& network, std::ostream& out);

/// The queries alone, as `.q`: the same formulas, their comments in `/* */`. Requires what emit does.
void emit_queries(const Network& network, std::ostream& out);

/// A property that UPPAAL's queries cannot say. It is left out, with a comment in its place.
struct Inexpressible {
    Id<Property> property = {};
    std::string reason = {};
    bool operator==(const Inexpressible&) const = default;
};
std::vector<Inexpressible> inexpressible(const Network& network);

/// One query without its comment: what a program is asked that reads no others.
struct Formula {
    Id<Property> property = {};
    std::string name = {};  ///< the property's; `S.X7` of one that asks for each step
    std::string text = {};  ///< one line; empty: inexpressible
    bool operator==(const Formula&) const = default;
};
/// In the order of emit_queries. Requires what emit does.
std::vector<Formula> formulas(const Network& network);

}  // namespace grafverif::uppaal
