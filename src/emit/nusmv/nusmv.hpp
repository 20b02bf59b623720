// SPDX-License-Identifier: MIT
// TransitionSystem -> NuSMV model, as DESDES06 section 6 writes them: `main` with the free variables, the instances and
// the specifications, then one module per controller: VAR, ASSIGN with init and next, DEFINE.
//
// What becomes what:
//   variable     VAR `x : boolean;`, `n : 0..10;` or `{still, moving}`, in the order of the symbols, which is the order
//                of the BDD variables
//   choice       IVAR
//   transitions, invariants, justice   TRANS, INVAR, JUSTICE
//   always, never, exactly one of   INVARSPEC      at stable: `settled -> ...`
//   reachable    INVARSPEC never_P := !p   at stable: `settled -> !p`; P holds where it is false
//   inevitable   SPEC AF p         at stable: AF (settled & p)
//   p leads to q SPEC AG (p -> AF q)   at stable: settled & on both sides
//   always possible  SPEC AG EF p  at stable: AG EF (settled & p)
//   ctl, ltl     SPEC, LTLSPEC, as written
// Every specification has a name, that of its property; but `reachable` is asked as its opposite, for a specification is
// true if all initial states satisfy it (emit/nusmv_properties), and named so. A property that is omitted leaves a comment with the reason in its place.
// A value by cases is `case ... esac`; names are legalised once (syntax/legal_names), the map is in the header.
#pragma once

#include <iosfwd>

#include "ir/flat_system.hpp"

namespace grafverif::nusmv {

/// `system` with those formulas (ctl, ltl) omitted that cannot be said of it, with the reason: they name what the model
/// has not, by the names it is written with, or use it for what it is not.
TransitionSystem sayable(TransitionSystem system);

/// `system` with those properties omitted that may need integers of more than 32 bits: NuSMV would find other values, and say
/// nothing. Formulas that are passed through say what they say.
TransitionSystem narrow(TransitionSystem system);

/// Requires verify(system).empty(), and that the system fits (emit/wide.hpp).
void emit(const TransitionSystem& system, std::ostream& out);

/// The names that stand in the model that `emit` writes.
SystemSpelling spelling(const TransitionSystem& system);

}  // namespace grafverif::nusmv
