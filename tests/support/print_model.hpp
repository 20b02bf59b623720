// SPDX-License-Identifier: MIT
// print_model prints a Chart, Component, ClosedLoop or Model as canonical text with the tree printer. The text is read
// back as the same element: print(read(print(c))) == print(c).
#pragma once

#include <iosfwd>

#include "grafverif/ir/closed_loop.hpp"

namespace grafverif {

void print(std::ostream& out, const Chart& chart);
void print(std::ostream& out, const Component& component);
/// Requires verify(loop, model).empty().
void print(std::ostream& out, const ClosedLoop& loop, const Model& model);
/// Prints the charts, the components and the loops, in this order.
void print(std::ostream& out, const Model& model);

}  // namespace grafverif
