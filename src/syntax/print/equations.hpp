// SPDX-License-Identifier: MIT
// Prints equations as plain text (with the order and sections of Fig. 19 in the paper CEP13), as LaTeX (`align*` of
// amsmath), and as JSON.
//
// The sections are: (a) firing conditions; (b) step activities; (s) stored actions, if there are any, with their values
// after the first evolution and their race conditions; (c) outputs, preceded by timers.
#pragma once

#include <iosfwd>
#include <string>

#include "grafverif/ir/equations.hpp"

namespace grafverif {

/// Returns one equation as plain text, such as `X_2 = ...`.
std::string equation_text(const Equations& equations, Id<Equations::Variable> variable, Id<Expr> term);
void print_equations(std::ostream& out, const Equations& equations);
void print_equations_latex(std::ostream& out, const Equations& equations);

/// Prints an object `{"name", "firing_conditions": [{"variable", "transition", "equation"}],
///   "steps": [{"variable", "step", "initial", "equation"}],
///   "stored": [{"variable", "equation", "first", "race", "first_race"}],
///   "conflicts": [equation], "previous": [{"variable", "equation"}], "watches": [{"variable", "equation"}],
///   "timers": [{"name", "watched", "rise_ms", "fall_ms", "end", "equation"}],
///   "outputs": [{"variable", "equation"}], "stable"}`, with the equations as plain text.
void print_equations_json(std::ostream& out, const Equations& equations);

}  // namespace grafverif
