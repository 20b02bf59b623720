// SPDX-License-Identifier: MIT
#include "analyse/order.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "analyse/cones.hpp"
#include "ir/reads.hpp"
#include "support/force.hpp"

namespace grafverif::analysis {

namespace {

using Variable = Equations::Variable;

class Order {
public:
    Order(const Equations& equations, const std::vector<bool>& wanted)
        : equations_(equations), reads_(equations.exprs), open_(wanted), written_(equations.variables.size()) {
        for (const Equations::Stored& stored : equations.stored)
            for (const Equations::Write& write : stored.writes)
                for (const Id<Expr> leaf : leaves(equations.exprs, write.trigger))
                    written_[static_cast<std::size_t>(equations.exprs[leaf].value)].push_back(stored.variable);
    }

    std::vector<Id<Variable>> all() {
        for (const Equations::Firing& firing : equations_.firings) {
            read(firing.condition);
            place(firing.variable);
        }
        for (const Equations::Output& output : equations_.outputs) read(output.value);
        for (const Id<Variable> id : equations_.variables.ids()) place(id);
        return std::move(order_);
    }

private:
    /// Appends the variables that `root` reads to the order, from left to right.
    void read(Id<Expr> root) {
        reads_.each(root, [&](std::uint32_t variable) { place({variable}); });
    }

    /// Appends `id` to the order, followed by the variables that are written when `id` changes.
    void place(Id<Variable> id) {
        append(id);
        for (const Id<Variable> written : std::exchange(written_[id.index], {})) append(written);
    }

    void append(Id<Variable> id) {
        if (open_[id.index]) order_.push_back(id);
        open_[id.index] = false;
    }

    const Equations& equations_;
    Reads reads_;
    std::vector<bool> open_;
    /// For each variable: the stored variables that may be written when the variable changes.
    std::vector<std::vector<Id<Variable>>> written_;
    std::vector<Id<Variable>> order_ = {};
};

/// Marks the variables that terms read directly, or indirectly through firing conditions and the values of marked
/// variables.
class Marks {
public:
    explicit Marks(const Equations& equations)
        : timers_(equations.timers),
          reads_(equations.exprs),
          marks_(equations.variables.size()),
          values_(equations.variables.size()) {
        for (const Kept& each : kept(equations)) values_[each.variable.index] = each.next;
    }

    void mark(Id<Variable> id) {
        if (marks_[id.index]) return;
        marks_[id.index] = true;
        if (values_[id.index].valid()) mark(values_[id.index]);
        for (const Equations::Timer& timer : timers_)
            if (timer.end == id) mark(timer.watched);
    }

    void mark(Id<Expr> root) {
        reads_.each(root, [&](std::uint32_t variable) { pending_.push_back(variable); });
    }

    std::vector<bool> all() {
        while (!pending_.empty()) {
            const Id<Variable> id{pending_.back()};
            pending_.pop_back();
            mark(id);
        }
        return std::move(marks_);
    }

private:
    const std::vector<Equations::Timer>& timers_;
    Reads reads_;
    std::vector<bool> marks_;
    std::vector<Id<Expr>> values_;  ///< for each variable: the term of its next value; invalid if there is no such term
    std::vector<std::uint32_t> pending_ = {};
};

/// Returns `order`, changed by the heuristic FORCE so that the distances between related variables are shorter. Each
/// variable, together with all variables that its next value reads, is a hyperedge.
std::vector<Id<Variable>> drawn_together(const Equations& equations, const std::vector<Id<Variable>>& order) {
    // Maximum number of variables for which the order is improved. For more variables, this computation would take
    // longer than a search.
    constexpr std::size_t most_variables = 5000;
    if (order.size() > most_variables) return order;
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    const Dependencies reads(equations);
    std::vector<std::uint32_t> vertex(equations.variables.size(), none);
    for (std::uint32_t k = 0; k < order.size(); ++k) vertex[order[k].index] = k;
    std::vector<ForceEdge> edges;
    for (const Id<Variable> id : order) {
        ForceEdge edge{id.index};
        for (const std::uint32_t read : reads.of(id.index)) {
            if (equations.variables[Id<Variable>{read}].role != Equations::Role::FiringCondition) edge.push_back(read);
            else edge.insert(edge.end(), reads.of(read).begin(), reads.of(read).end());
        }
        for (std::uint32_t& member : edge) member = vertex[member];
        std::erase(edge, none);
        std::ranges::sort(edge);
        const auto rest = std::ranges::unique(edge);
        edge.erase(rest.begin(), rest.end());
        if (edge.size() > 1) edges.push_back(std::move(edge));
    }
    const std::vector<double> places = force_places(order.size(), edges);
    std::vector<Id<Variable>> result(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) result[static_cast<std::size_t>(places[k])] = order[k];
    return result;
}

}  // namespace

std::vector<std::uint32_t> integer_groups(const Equations& equations) {
    std::vector<std::uint32_t> first(equations.variables.size());
    std::iota(first.begin(), first.end(), 0U);
    const auto root = [&](std::uint32_t variable) {
        while (first[variable] != variable) variable = first[variable] = first[first[variable]];
        return variable;
    };
    // For each term: one integer variable on which the value of an integer term depends; `none` if
    // this value depends on no integer variable, or if the term is not an integer term.
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> made_of(equations.exprs.size(), none);
    for (std::uint32_t term = 0; term < equations.exprs.size(); ++term) {
        const Expr& node = equations.exprs[Id<Expr>{term}];
        if (node.op == Op::Variable &&
            !equations.variables[Id<Variable>{static_cast<std::uint32_t>(node.value)}].type.boolean)
            made_of[term] = static_cast<std::uint32_t>(node.value);
        if (!is_comparison(node.op) && !is_arithmetic(node.op) && node.op != Op::Conditional) continue;
        for (const Id<Expr> operand : equations.exprs.operands(Id<Expr>{term})) {
            const std::uint32_t integer = made_of[operand.index];
            if (integer == none) continue;
            if (made_of[term] != none) first[root(integer)] = root(made_of[term]);
            made_of[term] = integer;
        }
        if (is_comparison(node.op)) made_of[term] = none;
    }
    for (std::uint32_t variable = 0; variable < first.size(); ++variable) first[variable] = root(variable);
    return first;
}

std::vector<Id<Variable>> variable_order(const Equations& equations, const std::vector<bool>& wanted) {
    const std::vector<Id<Variable>> written = Order(equations, wanted).all();
    const std::vector<Id<Variable>> drawn = drawn_together(equations, written);
    const std::vector<std::uint32_t> group = integer_groups(equations);
    std::vector<std::vector<Id<Variable>>> members(equations.variables.size());
    for (const Id<Variable> id : drawn) members[group[id.index]].push_back(id);
    std::vector<Id<Variable>> result;
    for (const Id<Variable> id : drawn)
        for (const Id<Variable> member : std::exchange(members[group[id.index]], {})) result.push_back(member);
    return result;
}

std::vector<bool> variables_that_matter(const Equations& equations) {
    Marks marks(equations);
    for (const Equations::Firing& firing : equations.firings) marks.mark(firing.condition);
    for (const Equations::StepActivity& step : equations.steps) marks.mark(step.variable);
    for (const Fault& fault : faults(equations))
        for (const Id<Expr> condition : {fault.condition, fault.first})
            if (condition.valid()) marks.mark(condition);
    // A stored value that is not a constant may be out of range or undefined; therefore, its term
    // is marked.
    for (const Equations::Stored& stored : equations.stored)
        for (const Equations::Write& write : stored.writes)
            if (!is_constant(equations.exprs[write.value].op)) marks.mark(write.value);
    for (const Equations::Output& output : equations.outputs) marks.mark(output.value);
    marks.mark(equations.stable);
    std::vector<bool> all = marks.all();
    for (const Id<Variable> id : equations.variables.ids())
        if (equations.variables[id].role == Equations::Role::FiringCondition) all[id.index] = false;
    return all;
}

}  // namespace grafverif::analysis
