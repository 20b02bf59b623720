// SPDX-License-Identifier: MIT
// TransitionSystem -> NuSMV model, according to DESDES06 section 6: `main` with the free variables, the instances and
// the specifications, then one module per controller: VAR, ASSIGN with init and next, DEFINE.
//
// Mapping:
//   variable     VAR `x : boolean;`, `n : 0..10;` or `{still, moving}`, in the order of the symbols, which is the order
//                of the BDD variables
//   choice       IVAR
//   transitions, invariants, justice   TRANS, INVAR, JUSTICE
//   always, never, exactly one of   INVARSPEC      at stable: `settled -> ...`
//   reachable    INVARSPEC never_P := !p   at stable: `settled -> !p`; P holds if it is false
//   inevitable   SPEC AF p         at stable: AF (settled & p)
//   p leads to q SPEC AG (p -> AF q)   at stable: settled & on both sides
//   always possible  SPEC AG EF p  at stable: AG EF (settled & p)
//   ctl, ltl     SPEC, LTLSPEC, as written
// Every specification has the name of its property. However, `reachable` is negated and named accordingly, because a
// specification is true if all initial states satisfy it (emit/nusmv/properties). An omitted property is replaced by a
// comment with the reason.
// A value by cases is `case ... esac`; names are made legal once (syntax/print/legal_names), the map is in the header.
#pragma once

#include <iosfwd>

#include "ir/flat_system.hpp"

namespace grafverif::nusmv {

/// `system` without the formulas (ctl, ltl) that do not fit the model, with the reason: unknown names, or names used
/// with a wrong type.
TransitionSystem sayable(TransitionSystem system);

/// `system` without the properties that may exceed 32 bits, for which NuSMV would silently compute other values.
/// Formulas for external tools are kept.
TransitionSystem narrow(TransitionSystem system);

/// Requires verify(system).empty(), and that the system fits (emit/wide.hpp).
void emit(const TransitionSystem& system, std::ostream& out);

/// The names in the model that `emit` writes.
SystemSpelling spelling(const TransitionSystem& system);

}  // namespace grafverif::nusmv
