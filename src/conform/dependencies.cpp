// SPDX-License-Identifier: MIT
// Determines the dependencies from the value of each term for the case that no transition fires: firing conditions in
// the term are replaced by `false`, and the result is simplified by constant folding. If the next value of a variable
// is then the variable itself, the variable changes only if a transition that the next value reads fires. Similarly, if
// the condition of a race is then `false`, the race occurs only if a transition that the condition reads fires.
#include "conform/dependencies.hpp"

#include <algorithm>
#include <optional>

namespace grafverif::conform {

namespace {

using Role = Equations::Role;

class Analysis {
public:
    Analysis(const Equations& equations, const StateLayout& layout)
        : equations_(equations), exprs_(equations.exprs), layout_(layout), firing_of_(equations.variables.size()) {
        for (std::uint32_t firing = 0; firing < equations.firings.size(); ++firing)
            firing_of_[equations.firings[firing].variable.index] = firing;
    }

    Dependencies found() const {
        Dependencies result;
        add_guards(result);
        result.fields.by_firing.resize(equations_.firings.size());
        result.races.by_firing.resize(equations_.firings.size());
        for (std::uint32_t field = 0; field < layout_.evolving; ++field) {
            const Kept& kept = layout_.fields[field].kept;
            Exprs scratch;
            const Expr quiet = scratch[while_quiet(kept.next, scratch)];
            add(field, kept.next, quiet.op == Op::Variable && quiet.value == std::int64_t{kept.variable.index},
                result.fields);
        }
        for (std::uint32_t stored = 0; stored < equations_.stored.size(); ++stored) {
            Exprs scratch;
            const Id<Expr> race = equations_.stored[stored].race;
            add(stored, race, is_false(scratch, while_quiet(race, scratch)), result.races);
        }
        result.firing_unsettles = firing_unsettles();
        return result;
    }

private:
    std::optional<std::uint32_t> firing_of(const Expr& leaf) const {
        return firing_of_[static_cast<std::size_t>(leaf.value)];
    }

    /// Sets Dependencies::guarded and unguarded. If a transition has an upstream step, the first operand of its firing
    /// condition is such a step.
    void add_guards(Dependencies& result) const {
        result.guarded.resize(layout_.fields.size());
        std::vector<std::optional<std::uint32_t>> field_of(equations_.variables.size());
        for (std::uint32_t field = 0; field < layout_.fields.size(); ++field)
            if (const auto id = layout_.fields[field].kept.variable; equations_.variables[id].role == Role::Step)
                field_of[id.index] = field;
        for (std::uint32_t firing = 0; firing < equations_.firings.size(); ++firing) {
            const Id<Expr> condition = equations_.firings[firing].condition;
            const Expr& guard = exprs_[exprs_[condition].op == Op::And ? exprs_.operands(condition)[0] : condition];
            const auto field =
                guard.op == Op::Variable ? field_of[static_cast<std::size_t>(guard.value)] : std::nullopt;
            (field ? result.guarded[*field] : result.unguarded).push_back(firing);
        }
    }

    /// Returns the value of `term` for the case that no transition fires, as a term in `scratch`.
    Id<Expr> while_quiet(Id<Expr> term, Exprs& scratch) const {
        return translate(exprs_, term, scratch, [&](const Expr& leaf) {
            return firing_of(leaf) ? scratch.constant(false)
                                   : scratch.leaf(Op::Variable, static_cast<std::uint32_t>(leaf.value));
        });
    }

    void add(std::uint32_t number, Id<Expr> term, bool rests_while_quiet, Dependencies::Computed& computed) const {
        if (!rests_while_quiet) return computed.always.push_back(number);
        for (const Id<Expr> leaf : leaves(exprs_, term))
            if (const auto firing = firing_of(exprs_[leaf])) computed.by_firing[*firing].push_back(number);
    }

    /// True if the equation `stable` is the negation of a disjunction whose operands include the firing condition of
    /// every transition that can fire.
    bool firing_unsettles() const {
        if (exprs_[equations_.stable].op != Op::Not) return false;
        const Id<Expr> changes = exprs_.operands(equations_.stable)[0];
        const auto is_firing = [&](Id<Expr> term) {
            return exprs_[term].op == Op::Variable && firing_of(exprs_[term]);
        };
        const auto found = exprs_[changes].op == Op::Or ? std::ranges::count_if(exprs_.operands(changes), is_firing)
                                                        : is_firing(changes);
        const auto never =
            std::ranges::count_if(equations_.firings, [&](const auto& one) { return is_false(exprs_, one.condition); });
        return static_cast<std::size_t>(found + never) == equations_.firings.size();
    }

    const Equations& equations_;
    const Exprs& exprs_;
    const StateLayout& layout_;
    /// For each variable: the index of the firing condition that it represents.
    std::vector<std::optional<std::uint32_t>> firing_of_;
};

}  // namespace

Dependencies dependencies(const Equations& equations, const StateLayout& layout) {
    return Analysis(equations, layout).found();
}

}  // namespace grafverif::conform
