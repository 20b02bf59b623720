// SPDX-License-Identifier: MIT
// print_model: Chart, Component, ClosedLoop and Model as canonical text, through the tree printer. The text is read
// back as the same element: print(read(print(c))) == print(c).
#pragma once

#include <iosfwd>

#include "grafverif/ir/closed_loop.hpp"

namespace grafverif {

void print(std::ostream& out, const Chart& chart);
void print(std::ostream& out, const Component& component);
/// Requires verify(loop, model).empty().
void print(std::ostream& out, const ClosedLoop& loop, const Model& model);
/// Charts, components and loops, in this order.
void print(std::ostream& out, const Model& model);

}  // namespace grafverif
