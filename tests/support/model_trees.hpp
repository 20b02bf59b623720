// SPDX-License-Identifier: MIT
// Converts the charts, components and closed loops of a model to syntax trees.
#pragma once

#include "grafverif/ir/closed_loop.hpp"
#include "support/trees.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

tree::Chart tree_of(const Chart& chart, tree::File& file, Trees& trees);
tree::Component tree_of(const Component& component, tree::File& file, Trees& trees);
tree::ClosedLoop tree_of(const ClosedLoop& loop, const Model& model, tree::File& file, Trees& trees);

}  // namespace grafverif
