// SPDX-License-Identifier: MIT
// Converts a component to a tree. The summary of the component becomes the comment above it.
#include <string>
#include <vector>

#include "support/model_trees.hpp"

namespace grafverif {

namespace {

class ComponentPrinter {
public:
    ComponentPrinter(const Component& component, tree::File& file, Trees& trees)
        : component_(component), file_(file), trees_(trees) {}

    tree::Component print() {
        tree::Component printed;
        printed.name = trees_.name(component_.name);
        if (!component_.summary.empty()) file_.comments.push_back({"// " + component_.summary, trees_.next(), true});
        printed.where = trees_.next();
        parameters(printed);
        body(printed.items);
        trees_.end(printed.where);
        return printed;
    }

private:
    Id<tree::Expr> expression(Id<Expr> root) {
        return trees_.expression(component_.exprs, root, [&](const Expr& leaf) {
            const auto index = static_cast<std::uint32_t>(leaf.value);
            if (leaf.op == Op::Parameter)
                return trees_.path(component_.parameters[Id<Component::Parameter>{index}].name);
            return trees_.path(component_.variables[Id<Component::Variable>{index}].name);
        });
    }

    template <class Declared>
    tree::Variable variable(const Declared& declared) {
        tree::Variable written;
        written.name = trees_.name(declared.name);
        if (declared.value == Component::ValueKind::Integer) written.type = tree::TypeWord::Int;
        if (declared.low && declared.high)
            written.range = tree::Range{expression(*declared.low), expression(*declared.high)};
        if (declared.initial) written.value = expression(*declared.initial);
        return written;
    }

    /// Converts the declaration of a constant. The type is omitted if the default value implies it, or if the type is
    /// the unbounded integer.
    tree::Variable constant(const Component::Parameter& declared) {
        tree::Variable written = variable(declared);
        written.type = tree::TypeWord::None;
        if (declared.initial) return written;
        if (declared.value == Component::ValueKind::Boolean) written.type = tree::TypeWord::Bool;
        if (declared.value == Component::ValueKind::Duration) written.type = tree::TypeWord::Duration;
        return written;
    }

    void parameters(tree::Component& printed) {
        const Component::Parameter* last = nullptr;
        for (const Component::Parameter& declared : component_.parameters) {
            const bool is_constant = declared.kind == Component::ParameterKind::Constant;
            if (last == nullptr || last->kind != declared.kind) {
                const auto kind = is_constant                                        ? tree::VariableKind::Constant
                                  : declared.kind == Component::ParameterKind::Input ? tree::VariableKind::Input
                                                                                     : tree::VariableKind::Output;
                printed.parameters.push_back({kind, {}, {}});
            }
            printed.parameters.back().variables.push_back(is_constant ? constant(declared) : variable(declared));
            last = &declared;
        }
    }

    std::vector<tree::Assignment> assignments(const std::vector<Component::Assignment>& written) {
        std::vector<tree::Assignment> printed;
        for (const Component::Assignment& assignment : written) {
            const Expr& target = component_.exprs[assignment.target];
            const auto index = static_cast<std::uint32_t>(target.value);
            const std::string& name = target.op == Op::Parameter
                                          ? component_.parameters[Id<Component::Parameter>{index}].name
                                          : component_.variables[Id<Component::Variable>{index}].name;
            printed.push_back({trees_.name(name), expression(assignment.value), {}});
        }
        return printed;
    }

    tree::Op relation(Op op) const {
        switch (op) {
        case Op::Less: return tree::Op::Less;
        case Op::LessEqual: return tree::Op::LessEqual;
        case Op::Greater: return tree::Op::Greater;
        case Op::GreaterEqual: return tree::Op::GreaterEqual;
        default: return tree::Op::Equal;
        }
    }

    /// Returns the conjunction of the guard and the clock constraints, in this order. The result is
    /// not valid if the guard and the constraints are trivial.
    Id<tree::Expr> conjunction(Id<Expr> guard, const std::vector<Component::ClockConstraint>& clocks) {
        std::vector<Id<tree::Expr>> conjuncts;
        if (guard.valid() && !is_true(component_.exprs, guard)) conjuncts.push_back(expression(guard));
        for (const Component::ClockConstraint& clock : clocks)
            conjuncts.push_back(trees_.node(
                relation(clock.relation), {trees_.path(component_.clocks[clock.clock].name), expression(clock.bound)}));
        if (conjuncts.size() < 2) return conjuncts.empty() ? Id<tree::Expr>{} : conjuncts.front();
        const Id<tree::Expr> all = trees_.node(tree::Op::And, {});
        for (const Id<tree::Expr> conjunct : conjuncts) tree::append(file_.exprs, all, conjunct);
        return all;
    }

    void body(std::vector<tree::ComponentItem>& items) {
        for (const Component::Variable& declared : component_.variables) {
            const Span where = trees_.next();
            items.emplace_back(tree::Variables{tree::VariableKind::Own, {variable(declared)}, where});
        }
        if (!component_.clocks.empty()) {
            tree::Clocks clocks{{}, trees_.next()};
            for (const Component::Clock& clock : component_.clocks) clocks.names.push_back(trees_.name(clock.name));
            items.emplace_back(std::move(clocks));
        }
        for (const Component::Constraint& constraint : component_.constraints) {
            const Span where = trees_.next();
            items.emplace_back(tree::Constraint{expression(constraint.condition), where});
        }
        for (const Id<Component::Location> id : component_.locations.ids()) {
            const Component::Location& location = component_.locations[id];
            const Span where = trees_.next(id.index == 0);
            items.emplace_back(tree::Location{id == component_.initial, trees_.name(location.name),
                                              conjunction({}, location.invariant), assignments(location.initially),
                                              where});
        }
        for (const Id<Component::Edge> id : component_.edges.ids()) {
            const Component::Edge& edge = component_.edges[id];
            const Span where = trees_.next(id.index == 0);
            tree::Edge written{edge.urgent,
                               trees_.name(component_.locations[edge.from].name),
                               trees_.name(component_.locations[edge.to].name),
                               conjunction(edge.guard, edge.constraint),
                               assignments(edge.assignments),
                               where};
            for (const Id<Component::Clock> clock : edge.resets)
                written.assignments.push_back({trees_.name(component_.clocks[clock].name), trees_.number(0), {}});
            items.emplace_back(std::move(written));
        }
    }

    const Component& component_;
    tree::File& file_;
    Trees& trees_;
};

}  // namespace

tree::Component tree_of(const Component& component, tree::File& file, Trees& trees) {
    return ComponentPrinter(component, file, trees).print();
}

}  // namespace grafverif
