// SPDX-License-Identifier: MIT
#include "analyse/order.hpp"

#include <utility>

#include "analyse/memory.hpp"

namespace grafverif::analysis {

namespace {

using Variable = Equations::Variable;

/// Marks `index`; whether it was marked before.
bool mark_again(std::vector<bool>& marks, std::size_t index) {
    const bool before = marks[index];
    marks[index] = true;
    return before;
}

class Order {
public:
    Order(const Equations& equations, const std::vector<bool>& wanted)
        : equations_(equations), seen_(equations.exprs.size()), open_(wanted), written_(equations.variables.size()) {
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
    /// Places the variables that `root` reads, from left to right.
    void read(Id<Expr> root) {
        std::vector<Id<Expr>> open{root};
        while (!open.empty()) {
            const Id<Expr> term = open.back();
            open.pop_back();
            if (mark_again(seen_, term.index)) continue;
            const Expr& node = equations_.exprs[term];
            if (node.op == Op::Variable) place({static_cast<std::uint32_t>(node.value)});
            const auto operands = equations_.exprs.operands(term);
            open.insert(open.end(), operands.rbegin(), operands.rend());
        }
    }

    /// Places `id`, and what is written when it changes right after it.
    void place(Id<Variable> id) {
        append(id);
        for (const Id<Variable> written : std::exchange(written_[id.index], {})) append(written);
    }

    void append(Id<Variable> id) {
        if (open_[id.index]) order_.push_back(id);
        open_[id.index] = false;
    }

    const Equations& equations_;
    std::vector<bool> seen_;
    std::vector<bool> open_;
    std::vector<std::vector<Id<Variable>>> written_;   ///< per variable: the stored ones that its change may write
    std::vector<Id<Variable>> order_ = {};
};

/// Marks what terms read, through firing conditions and the values of what is marked.
class Marks {
public:
    explicit Marks(const Equations& equations)
        : equations_(equations), seen_(equations.exprs.size()), marks_(equations.variables.size()),
          values_(equations.variables.size()) {
        for (const Equations::Stored& stored : equations.stored) values_[stored.variable.index] = stored.next;
        for (const Remembered& each : remembered(equations)) values_[each.variable.index] = each.value;
        for (const Clock& clock : clocks(equations)) watched_.emplace_back(clock.end, clock.watched);
    }

    void mark(Id<Variable> id) {
        if (mark_again(marks_, id.index)) return;
        if (values_[id.index].valid()) mark(values_[id.index]);
        for (const auto& [end, watched] : watched_)
            if (end == id) mark(watched);
    }

    void mark(Id<Expr> root) {
        std::vector<Id<Expr>> open{root};
        while (!open.empty()) {
            const Id<Expr> term = open.back();
            open.pop_back();
            if (mark_again(seen_, term.index)) continue;
            const Expr& node = equations_.exprs[term];
            if (node.op == Op::Variable) pending_.emplace_back(static_cast<std::uint32_t>(node.value));
            const auto operands = equations_.exprs.operands(term);
            open.insert(open.end(), operands.begin(), operands.end());
        }
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
    const Equations& equations_;
    std::vector<bool> seen_, marks_;
    std::vector<Id<Expr>> values_;   ///< per variable: what it becomes, where that is a term
    std::vector<std::pair<Id<Variable>, Id<Variable>>> watched_ = {};
    std::vector<std::uint32_t> pending_ = {};
};

}  // namespace

std::vector<Id<Variable>> variable_order(const Equations& equations, const std::vector<bool>& wanted) {
    return Order(equations, wanted).all();
}

std::vector<bool> variables_that_matter(const Equations& equations) {
    Marks marks(equations);
    for (const Equations::Firing& firing : equations.firings) marks.mark(firing.condition);
    for (const Equations::StepActivity& step : equations.steps) {
        marks.mark(step.next);
        marks.mark(step.variable);
    }
    for (const Equations::Stored& stored : equations.stored) {
        marks.mark(stored.race);
        marks.mark(stored.first_race);
        // What is stored may be out of range, or have no value; a Boolean constant is neither.
        for (const Equations::Write& write : stored.writes)
            if (!is_constant(equations.exprs[write.value].op)) marks.mark(write.value);
    }
    for (const Equations::Output& output : equations.outputs) marks.mark(output.value);
    for (const Equations::Conflict& conflict : equations.conflicts) marks.mark(conflict.condition);
    marks.mark(equations.stable);
    std::vector<bool> all = marks.all();
    for (const Id<Variable> id : equations.variables.ids())
        if (equations.variables[id].role == Equations::Role::FiringCondition) all[id.index] = false;
    return all;
}

}  // namespace grafverif::analysis
