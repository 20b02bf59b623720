// SPDX-License-Identifier: MIT
#include "support/print_model.hpp"

#include "support/model_trees.hpp"
#include "syntax/language/format.hpp"

namespace grafverif {

void print(std::ostream& out, const Chart& chart) {
    tree::File file;
    Trees trees(file);
    file.declarations.emplace_back(tree_of(chart, file, trees));
    format(file, out);
}

void print(std::ostream& out, const Component& component) {
    tree::File file;
    Trees trees(file);
    file.declarations.emplace_back(tree_of(component, file, trees));
    format(file, out);
}

void print(std::ostream& out, const ClosedLoop& loop, const Model& model) {
    tree::File file;
    Trees trees(file);
    file.declarations.emplace_back(tree_of(loop, model, file, trees));
    format(file, out);
}

void print(std::ostream& out, const Model& model) {
    tree::File file;
    Trees trees(file);
    for (const Chart& chart : model.charts) file.declarations.emplace_back(tree_of(chart, file, trees));
    for (const Component& component : model.components) file.declarations.emplace_back(tree_of(component, file, trees));
    for (const ClosedLoop& loop : model.loops) file.declarations.emplace_back(tree_of(loop, model, file, trees));
    format(file, out);
}

}  // namespace grafverif
