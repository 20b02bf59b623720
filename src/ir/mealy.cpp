// SPDX-License-Identifier: MIT
#include "grafverif/ir/mealy.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace grafverif {

using State = MealyMachine::State;
using Transition = MealyMachine::Transition;

namespace {

struct MealyCheck {
    const MealyMachine& machine;
    std::vector<std::string> faults = {};

    void fault(std::string text) { faults.push_back(std::move(text)); }

    void condition(Id<Expr> condition) {
        if (!machine.exprs.contains(condition)) return fault("a condition is not a term of the machine");
        if (is_false(machine.exprs, condition)) fault("a condition is never true");
        for (const Id<Expr> leaf : leaves(machine.exprs, condition)) {
            const Expr& node = machine.exprs[leaf];
            if (node.op != Op::Variable || static_cast<std::size_t>(node.value) >= machine.inputs.size())
                fault("a condition reads something other than an input");
        }
    }

    void answers() {
        for (const MealyMachine::OutputWord& answer : machine.answers) {
            if (answer.values.size() != machine.outputs.size()) {
                fault("the outputs of a transition do not have exactly one value per output");
                continue;
            }
            for (std::size_t k = 0; k < answer.values.size(); ++k)
                if (answer.values[k] < machine.outputs[k].type.low || answer.values[k] > machine.outputs[k].type.high)
                    fault("a value of `" + machine.outputs[k].name + "` is outside its range");
        }
    }

    void states() {
        if (!machine.states.contains(machine.initial)) fault("there is no initial state");
        std::set<std::pair<std::string, std::string>> names;
        for (const State& state : machine.states)
            if (!names.emplace(state.situation, state.detail).second) fault("two states are named " + state.situation);
    }

    void transitions() {
        if (!std::ranges::is_sorted(machine.transitions, {}, &Transition::from))
            fault("the transitions are not ordered by `from`");
        for (const Transition& transition : machine.transitions) {
            if (!machine.states.contains(transition.from) || !machine.states.contains(transition.to))
                fault("a transition refers to a state that does not exist");
            if (!machine.answers.contains(transition.answer))
                fault("a transition refers to output values that do not exist");
            if (transition.wait_ms < 0) fault("a transition waits for a negative time");
            condition(transition.condition);
        }
        if (!std::ranges::is_sorted(machine.unstable, {}, &MealyMachine::Unstable::from))
            fault("the unstable inputs are not ordered by `from`");
        for (const MealyMachine::Unstable& unstable : machine.unstable) {
            if (!machine.states.contains(unstable.from))
                fault("an entry of unstable inputs refers to a state that does not exist");
            condition(unstable.condition);
        }
        for (const MealyMachine::Activation& activation : machine.activation) {
            if (!machine.answers.contains(activation.answer))
                fault("the activation refers to output values that do not exist");
            condition(activation.condition);
        }
    }
};

}  // namespace

std::span<const Transition> transitions_from(const MealyMachine& machine, Id<State> state) {
    const auto found = std::ranges::equal_range(machine.transitions, state, {}, &Transition::from);
    return {found.begin(), found.end()};
}

std::vector<std::string> verify(const MealyMachine& machine) {
    MealyCheck check{machine};
    check.states();
    check.answers();
    check.transitions();
    check.condition(machine.assumed);
    return std::move(check.faults);
}

}  // namespace grafverif
