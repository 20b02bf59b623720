// SPDX-License-Identifier: MIT
#include "check/symbolic/dead_transitions.hpp"

#include <map>
#include <vector>

#include "check/lost_text.hpp"

namespace grafverif::symbolic {

namespace {

using System = TransitionSystem;

Bdd reachable_from(const StateSpace& model, const Bdd& reached, const State& from) {
    Bdd reachable = model.only(from);
    if (model.has_clusters()) return model.closure(reachable) & reached;
    for (Bdd latest = reachable; !latest.is_false(); reachable |= latest)
        latest = model.image(latest) & reached & ~reachable;
    return reachable;
}

class DeadTransitionSearch {
public:
    DeadTransitionSearch(const System& system, FlatSystem& flat, const StateSpace& model, Bdd reachable)
        : system_(system), flat_(flat), model_(model), reachable_(std::move(reachable)) {
        for (const System::Controller& controller : system.controllers) {
            for (const auto& step : controller.words.steps)
                add_name(step.variable, prefix_of(controller) + step.name.variable());
            for (const auto* list : {&controller.words.inputs, &controller.words.outputs, &controller.words.internals})
                for (const System::Named& named : *list) add_name(named.variable, named.name);
        }
    }

    std::string words() {
        std::string text;
        for (const System::Controller& controller : system_.controllers)
            for (const System::Named& transition : controller.words.transitions) {
                if (is_cleared(controller, transition)) continue;
                text += text.empty() ? "" : ", ";
                text += prefix_of(controller) + transition.name;
                const std::string why = false_part(flat_.symbols[transition.variable.index]);
                if (!why.empty()) text += " (" + why + " stays false)";
            }
        return text.empty() ? text : dead_text + text;
    }

private:
    std::string prefix_of(const System::Controller& controller) const {
        return system_.controllers.size() > 1 ? controller.words.name + "." : "";
    }

    void add_name(Id<System::Symbol> symbol, const std::string& name) {
        const Expr& value = flat_.exprs[flat_.symbols[symbol.index]];
        if (value.op == Op::Variable) names_.emplace(value.value, name);
    }

    /// True if a step from a state of `reachable_` clears the transition, or if the clearing condition is undefined in
    /// such a state.
    bool is_cleared(const System::Controller& controller, const System::Named& transition) {
        Id<Expr> clears = flat_.symbols[transition.variable.index];
        if (controller.evolves.valid())
            clears = flat_.exprs.conjunction(clears, flattened(system_, flat_, controller.evolves));
        BddTerms terms = model_.terms();
        const BddTerm& term = terms(clears);
        if (!(reachable_ & term.undefined).is_false()) return true;
        return !model_.image(reachable_, model_.steps_where(term.bits.front())).is_false();
    }

    /// Returns the first conjunct of the condition that is a named variable or its negation and is false in all states
    /// of `reachable_`. The result is an empty string if no conjunct has these properties.
    std::string false_part(Id<Expr> condition) {
        std::vector<Id<Expr>> parts = {condition};
        if (flat_.exprs[condition].op == Op::And)
            parts.assign(flat_.exprs.operands(condition).begin(), flat_.exprs.operands(condition).end());
        for (const Id<Expr> part : parts) {
            const bool negated = flat_.exprs[part].op == Op::Not;
            const Expr& leaf = flat_.exprs[negated ? flat_.exprs.operands(part)[0] : part];
            if (leaf.op != Op::Variable || !names_.contains(leaf.value)) continue;
            BddTerms terms = model_.terms();
            if ((reachable_ & terms(part).bits.front()).is_false()) return (negated ? "!" : "") + names_.at(leaf.value);
        }
        return {};
    }

    const System& system_;
    FlatSystem& flat_;
    const StateSpace& model_;
    Bdd reachable_;
    // Maps the index of each flat variable that represents a step, an input, an output or an internal variable to its
    // name.
    std::map<std::int64_t, std::string> names_ = {};
};

}  // namespace

std::string dead_transitions_note(const System& system, FlatSystem& flat, const StateSpace& model, const Bdd& reached,
                                  const State& from) {
    if (system.controllers.empty()) return {};
    return DeadTransitionSearch(system, flat, model, reachable_from(model, reached, from)).words();
}

}  // namespace grafverif::symbolic
