// SPDX-License-Identifier: MIT
#include "support/random_chart.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace grafverif {

std::int64_t random_number(Random& random, std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(high - low + 1));
}

bool chance(Random& random, int percent) { return random_number(random, 1, 100) <= percent; }

namespace {

using VariableKind = Chart::VariableKind;

struct Generator {
    Random& random;
    TimedTerms timed;
    Chart chart = {};
    /// For each partial chart, the partial chart that contains its owner step, or -1 if it has no owner step.
    std::vector<std::int64_t> outer = {};
    std::vector<Id<Chart::Variable>> inputs = {}, continuous = {}, stored_bools = {}, stored_ints = {}, numbers = {};

    std::int64_t number(std::int64_t low, std::int64_t high) { return random_number(random, low, high); }
    bool often(int percent) { return chance(random, percent); }

    template <class T>
    T pick(const std::vector<T>& from) {
        return from[static_cast<std::size_t>(number(0, static_cast<std::int64_t>(from.size()) - 1))];
    }

    Id<Chart::Variable> variable(std::string name, VariableKind kind, Type type, std::int64_t initial) {
        return chart.variables.add({std::move(name), kind, type, initial, {}});
    }

    void variables() {
        for (std::int64_t k = number(1, 4); k > 0; --k)
            inputs.push_back(variable("in" + std::to_string(k), VariableKind::Input, {}, 0));
        if (often(40)) numbers.push_back(variable("level", VariableKind::Input, integer_type(0, 3), 0));
        for (std::int64_t k = number(0, 4); k > 0; --k)
            continuous.push_back(variable("OUT" + std::to_string(k), VariableKind::Output, {}, 0));
        if (often(50)) stored_bools.push_back(variable("LOCK", VariableKind::Output, {}, 0));
        if (often(30)) stored_ints.push_back(variable("SPEED", VariableKind::Output, integer_type(0, 3), 0));
        if (often(50)) stored_bools.push_back(variable("armed", VariableKind::Internal, {}, number(0, 1)));
        for (std::int64_t k = number(0, 2); k > 0; --k)
            stored_ints.push_back(
                variable("count" + std::to_string(k), VariableKind::Internal, integer_type(-2, 5), number(-2, 5)));
        numbers.insert(numbers.end(), stored_ints.begin(), stored_ints.end());
    }

    /// Adds the steps. Each partial chart belongs to a step of an earlier partial chart, or to no step.
    void steps() {
        const std::int64_t partials = often(50) ? 1 : number(2, 4);
        for (std::int64_t p = 0; p < partials; ++p) {
            const std::int64_t kind = p == 0 ? 0 : number(0, 99);
            const auto as = kind < 40   ? Chart::PartialKind::Plain
                            : kind < 65 ? Chart::PartialKind::Expansion
                                        : Chart::PartialKind::Enclosed;
            chart.partial_charts.add({p == 0 ? "" : "G" + std::to_string(p), as, {}, {}});
            outer.push_back(as == Chart::PartialKind::Plain ? -1 : number(0, p - 1));
        }
        for (std::int64_t p = 0; p < partials; ++p) add_steps(p);
        make_names_unique();
    }

    void add_steps(std::int64_t p) {
        const Id<Chart::PartialChart> partial{static_cast<std::uint32_t>(p)};
        const std::int64_t count = number(1, 5);
        const std::int64_t initial = often(90) ? number(0, count - 1) : -1;
        const auto kind = chart.partial_charts[partial].kind;
        const bool owned = kind != Chart::PartialKind::Plain;
        const std::int64_t entry = number(0, count - 1), exit = number(0, count - 1);
        for (std::int64_t s = 0; s < count; ++s) {
            Chart::Step step;
            // A step of the unnamed chart is inaccessible if another step hides its name.
            step.name = std::to_string(p == 0 || often(80) ? 10 * p + s : 100 + s);
            step.initial = owned ? often(15) : s == initial || often(10);
            step.entry = kind == Chart::PartialKind::Expansion && s == entry;
            step.exit = kind == Chart::PartialKind::Expansion && s == exit;
            step.activation_link = kind == Chart::PartialKind::Enclosed && (s == entry || often(20));
            step.chart = partial;
            chart.steps.add(step);
        }
        for (std::size_t inner = 0; inner < outer.size(); ++inner) {
            if (outer[inner] != p) continue;
            Chart::PartialChart& owned_chart = chart.partial_charts[{static_cast<std::uint32_t>(inner)}];
            Chart::Step step;
            const bool is_macro = owned_chart.kind == Chart::PartialKind::Expansion;
            step.name = (is_macro ? "M" : "N") + std::to_string(inner);
            step.kind = is_macro ? Chart::StepKind::Macro : Chart::StepKind::Enclosing;
            step.initial = often(30);
            step.chart = partial;
            owned_chart.owner = chart.steps.add(step);
        }
    }

    /// Returns `partial`, or, for an expansion, the partial chart that contains its macro-step, directly or indirectly.
    std::int64_t root(std::int64_t partial) const {
        while (chart.partial_charts[{static_cast<std::uint32_t>(partial)}].kind == Chart::PartialKind::Expansion)
            partial = outer[static_cast<std::size_t>(partial)];
        return partial;
    }

    /// Adds the forcing orders, which go from earlier to later charts.
    void forcing() {
        for (std::int64_t count = often(50) ? number(1, 3) : 0; count > 0; --count) {
            const Id<Chart::Step> step = pick_step();
            const std::int64_t forced = number(0, static_cast<std::int64_t>(chart.partial_charts.size()) - 1);
            if (root(chart.steps[step].chart.index) >= root(forced)) continue;
            Chart::ForcingOrder order{step, {static_cast<std::uint32_t>(forced)}, Chart::ForcedTo::Empty, {}, {}};
            order.to = static_cast<Chart::ForcedTo>(number(0, 3));
            const std::vector<Id<Chart::Step>> all = steps_of(order.forced);
            if (order.to == Chart::ForcedTo::Steps) order.situation.push_back(pick(all));
            if (order.to == Chart::ForcedTo::Steps && often(30) && order.situation[0] != all.back())
                order.situation.push_back(all.back());
            chart.forcing.add(order);
        }
        std::ranges::stable_sort(chart.forcing, {}, &Chart::ForcingOrder::step);
    }

    /// Makes names unique within each partial chart. Different partial charts may use the same names.
    void make_names_unique() {
        for (const Id<Chart::Step> id : chart.steps.ids())
            for (const Id<Chart::Step> other : chart.steps.ids())
                if (other < id && chart.steps[other].chart == chart.steps[id].chart &&
                    chart.steps[other].name == chart.steps[id].name)
                    chart.steps[id].name += "x" + std::to_string(id.index);
    }

    std::vector<Id<Chart::Step>> steps_of(Id<Chart::PartialChart> partial) const {
        std::vector<Id<Chart::Step>> result;
        for (const Id<Chart::Step> id : chart.steps.ids())
            if (chart.steps[id].chart == partial) result.push_back(id);
        return result;
    }

    /// The variables that a term may read, in addition to inputs, steps and stored variables.
    struct Allowed {
        std::size_t outputs = 0;  ///< number of continuous outputs, from the first one on
        bool edges = false;
        bool times = true;
    };

    Allowed everything() const { return {continuous.size(), true, true}; }

    Id<Expr> comparison(Allowed allowed) {
        static constexpr std::array relations{Op::Equal,     Op::NotEqual, Op::Less,
                                              Op::LessEqual, Op::Greater,  Op::GreaterEqual};
        if (numbers.empty() || often(15))
            return chart.exprs.apply(often(50) ? Op::Equal : Op::NotEqual, condition(1, allowed),
                                     condition(1, allowed));
        return chart.exprs.apply(relations[static_cast<std::size_t>(number(0, 5))], value(1), value(0));
    }

    /// Returns a Boolean term.
    Id<Expr> condition(int depth, Allowed allowed) {
        Exprs& exprs = chart.exprs;
        if (depth > 0 && often(60)) {
            const std::int64_t kind = number(0, 9);
            if (kind == 0) return comparison(allowed);
            const Id<Expr> left = condition(depth - 1, allowed);
            if (kind <= 3) return exprs.negation(left);
            const Id<Expr> right = condition(depth - 1, allowed);
            return kind <= 6 ? exprs.conjunction(left, right) : exprs.disjunction(left, right);
        }
        const std::int64_t kind = number(0, 99);
        if (kind < 15) return exprs.leaf(Op::Step, pick_step().index);
        if (kind < 25 && allowed.outputs > 0)
            return exprs.leaf(
                Op::Variable,
                continuous[static_cast<std::size_t>(number(0, static_cast<std::int64_t>(allowed.outputs) - 1))].index);
        if (kind < 35 && !stored_bools.empty()) return exprs.leaf(Op::Variable, pick(stored_bools).index);
        if (kind < 45 && !numbers.empty()) return comparison(allowed);
        if (kind < 57 && allowed.times) return time_condition(allowed);
        if (kind < 70 && allowed.edges) return edge(allowed);
        if (kind < 73) return exprs.constant(true);
        return exprs.leaf(Op::Variable, pick(inputs).index);
    }

    Id<Expr> edge(Allowed allowed) {
        allowed.edges = false;
        const Id<Expr> operand = often(60) ? chart.exprs.leaf(Op::Variable, pick(inputs).index) : condition(1, allowed);
        return chart.exprs.apply(often(60) ? Op::Rise : Op::Fall, std::array{operand});
    }

    /// Returns a condition that is false if there is no edge.
    Id<Expr> event() {
        const Id<Expr> first = edge(everything());
        if (often(50)) return first;
        return often(70) ? chart.exprs.conjunction(first, condition(1, everything()))
                         : chart.exprs.disjunction(first, edge(everything()));
    }

    Id<Chart::Step> pick_step() {
        return Id<Chart::Step>{
            static_cast<std::uint32_t>(number(0, static_cast<std::int64_t>(chart.steps.size()) - 1))};
    }

    /// Returns the time for the delay or the limit of an action; 0 means none.
    std::int64_t action_time() { return timed == TimedTerms::Any && often(20) ? duration() : 0; }

    std::int64_t duration() { return pick(std::vector<std::int64_t>{500, 1000, 3000}); }

    Id<Expr> time_condition(Allowed allowed) {
        allowed.edges = false;
        allowed.times = often(20);
        const bool step_only = timed == TimedTerms::Steps;
        const Id<Expr> watched =
            step_only || often(60) ? chart.exprs.leaf(Op::Step, pick_step().index) : condition(1, allowed);
        const std::int64_t kind = step_only ? 0 : number(0, 9);
        const Chart::TimeCondition time{kind < 8 ? duration() : 0, watched, kind < 5 ? 0 : duration(), {}};
        for (const auto id : chart.time_conditions.ids())
            if (chart.time_conditions[id] == time) return chart.exprs.leaf(Op::Timed, id.index);
        return chart.exprs.leaf(Op::Timed, chart.time_conditions.add(time).index);
    }

    /// Returns an integer term.
    Id<Expr> value(int depth) {
        Exprs& exprs = chart.exprs;
        if (depth > 0 && often(50)) {
            const std::int64_t kind = number(0, 6);
            if (kind == 0) return exprs.apply(Op::Negate, std::array{value(depth - 1)});
            if (kind == 1) return exprs.apply(Op::Divide, value(depth - 1), exprs.integer(2));
            if (kind == 2) return exprs.apply(Op::Modulo, value(depth - 1), exprs.integer(3));
            if (kind == 3) return exprs.apply(Op::Times, value(depth - 1), value(0));
            return exprs.apply(kind == 4 ? Op::Minus : Op::Plus, value(depth - 1), value(0));
        }
        if (numbers.empty() || often(40)) return exprs.integer(number(0, 3));
        return exprs.leaf(Op::Variable, pick(numbers).index);
    }

    std::vector<Id<Chart::Step>> some(const std::vector<Id<Chart::Step>>& steps) {
        std::vector<Id<Chart::Step>> result;
        const std::int64_t kind = number(0, 99);
        for (std::int64_t k = kind < 6 ? 0 : kind < 70 ? 1 : kind < 92 ? 2 : 3; k > 0; --k) {
            const Id<Chart::Step> step = pick(steps);
            if (std::ranges::find(result, step) == result.end()) result.push_back(step);
        }
        return result;
    }

    void transition(Id<Chart::PartialChart> partial, std::vector<Id<Chart::Step>> from,
                    std::vector<Id<Chart::Step>> to) {
        if (from.empty() && to.empty()) return;
        const Id<Expr> when = condition(2, everything());
        const std::string name = "t" + std::to_string(chart.transitions.size());
        chart.transitions.add({name, std::move(from), std::move(to), when, partial, {}});
    }

    void transitions() {
        for (const Id<Chart::PartialChart> partial : chart.partial_charts.ids()) {
            const std::vector<Id<Chart::Step>> all = steps_of(partial);
            for (std::size_t k = 0; k < all.size(); ++k)
                if (often(85)) transition(partial, {all[k]}, {all[(k + 1) % all.size()]});
            for (std::int64_t k = number(0, 3); k > 0; --k) transition(partial, some(all), some(all));
        }
    }

    void actions() {
        for (std::size_t k = 0; k < continuous.size(); ++k)
            for (std::int64_t count = number(0, 3); count > 0; --count)
                chart.continuous.add({pick_step(),
                                      continuous[k],
                                      often(50) ? chart.exprs.constant(true) : condition(2, Allowed{k}),
                                      action_time(),
                                      action_time(),
                                      {}});
        for (const Id<Chart::Variable> target : stored_bools)
            for (std::int64_t count = number(0, 3); count > 0; --count)
                store(target, often(60) ? chart.exprs.constant(often(50)) : condition(2, everything()));
        for (const Id<Chart::Variable> target : stored_ints)
            for (std::int64_t count = number(0, 3); count > 0; --count) store(target, stored_number(target));
    }

    /// Sorts the actions as a reader does: by step, then by transition.
    void sort_actions() {
        std::ranges::stable_sort(chart.continuous, {}, &Chart::ContinuousAction::step);
        std::ranges::stable_sort(chart.stored, {}, [](const Chart::StoredAction& action) {
            return std::pair(action.step, action.transition);
        });
    }

    Id<Expr> stored_number(Id<Chart::Variable> target) {
        Exprs& exprs = chart.exprs;
        const std::int64_t kind = number(0, 9);
        if (kind < 4) return exprs.integer(number(0, 3));
        if (kind < 6) return exprs.apply(Op::Plus, exprs.leaf(Op::Variable, target.index), exprs.integer(1));
        if (kind == 6) return exprs.apply(Op::Modulo, value(2), exprs.leaf(Op::Variable, pick(numbers).index));
        return value(2);
    }

    void store(Id<Chart::Variable> target, Id<Expr> stored) {
        const Type type = chart.variables[target].type;
        if (chart.exprs[stored].op == Op::Integer)
            stored = chart.exprs.integer(std::clamp(chart.exprs[stored].value, type.low, type.high));
        const std::int64_t kind = number(0, 99);
        const auto on = kind < 45   ? Chart::StoredOn::Activation
                        : kind < 65 ? Chart::StoredOn::Deactivation
                                    : Chart::StoredOn::Event;
        if (kind >= 85 && !chart.transitions.empty()) {
            const Id<Chart::Transition> cleared{
                static_cast<std::uint32_t>(number(0, static_cast<std::int64_t>(chart.transitions.size()) - 1))};
            chart.stored.add({Chart::StoredOn::Clearing, {}, cleared, target, stored, {}, {}});
            return;
        }
        const Id<Expr> when = on == Chart::StoredOn::Event ? event() : Id<Expr>{};
        chart.stored.add({on, pick_step(), {}, target, stored, when, {}});
    }
};

}  // namespace

Chart random_chart(Random& random, TimedTerms timed) {
    Generator generator{random, timed};
    generator.chart.name = "law";
    generator.variables();
    generator.steps();
    generator.transitions();
    generator.actions();
    generator.forcing();
    generator.sort_actions();
    return tidied(generator.chart);
}

}  // namespace grafverif
