// SPDX-License-Identifier: MIT
// Writes a TransitionSystem as a NuSMV model, according to DESDES06 section 6. `main` contains the free variables, the
// instances and the specifications. One module per controller follows, with VAR, ASSIGN (init and next) and DEFINE.
//
// Mapping:
//   variable: A declaration in VAR: `x : boolean;`, `n : 0..10;` or `x : {still, moving};`. The order of the
//     declarations is the order of the symbols and of the BDD variables.
//   choice: A declaration in IVAR.
//   transitions, invariants, justice: TRANS, INVAR, JUSTICE.
//   `always`, `never`, `exactly one of`: INVARSPEC; with `at stable`: `settled -> ...`.
//   `reachable p`: `INVARSPEC never_P := !p`; with `at stable`: `settled -> !p`. P holds if never_P is false.
//   `inevitable p`: `SPEC AF p`; with `at stable`: `AF (settled & p)`.
//   `p leads to q`: `SPEC AG (p -> AF q)`; with `at stable`: `settled & ...` in both operands.
//   `always possible p`: `SPEC AG EF p`; with `at stable`: `AG EF (settled & p)`.
//   `ctl`, `ltl`: SPEC, LTLSPEC; the formula is copied from the file.
//
// Every specification has the name of its property. The exception is `reachable`: its specification is negated and
// named `never_P`, because a specification is true only if all initial states satisfy it (emit/nusmv/properties). An
// omitted property is replaced by a comment with the reason. A value with several cases is `case ... esac`. Names are
// converted to legal names once (syntax/print/legal_names); the header of the file contains the map of changed names.
#pragma once

#include <iosfwd>

#include "ir/flat_system.hpp"

namespace grafverif::nusmv {

/// Returns `system` without the formulas (ctl, ltl) that are invalid in the model, because a name is unknown or is used
/// with a wrong type.
TransitionSystem sayable(TransitionSystem system);

/// Returns `system` without the properties whose values may exceed 32 bits, for which NuSMV would silently compute
/// other values. Formulas for external tools are kept.
TransitionSystem narrow(TransitionSystem system);

/// Writes the model. Requires verify(system).empty(), and that 32 bits are sufficient for the system (emit/wide.hpp).
void emit(const TransitionSystem& system, std::ostream& out);

/// Returns the names in the model that `emit` writes.
SystemSpelling spelling(const TransitionSystem& system);

}  // namespace grafverif::nusmv
