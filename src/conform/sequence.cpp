// SPDX-License-Identifier: MIT
// Computes the arcs to cover, their tour, and the steps of a test that performs the tour.
#include <algorithm>
#include <map>

#include "conform/input_space.hpp"
#include "conform/test_sequence.hpp"
#include "conform/tour.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

using namespace conform;
using State = MealyMachine::State;

class Writer {
public:
    Writer(const MealyMachine& machine, const TestOptions& options)
        : machine_(machine), options_(options), space_(named(machine.inputs), {}), sets_(machine.exprs, space_) {
        space_.assume(sets_(machine.assumed));
        std::uint32_t stride = 1;  // used only for TestCover::Transitions, whose number of combinations is limited
        weights_.resize(space_.space().variables());
        for (std::size_t input = machine.inputs.size(); input-- > 0;) {
            strides_.push_back(stride);
            for (std::size_t place = 0; place < space_.word(input).bits.size(); ++place)
                weights_[space_.word(input).bits[place]] = stride << place;
            const Type type = machine.inputs[input].type;
            stride *= static_cast<std::uint32_t>(type.high - type.low + 1);
        }
        std::ranges::reverse(strides_);
    }

    TestSequence write() {
        if (options_.cover == TestCover::Transitions) list_all();
        else list_one_each();
        const auto nodes = static_cast<std::uint32_t>(machine_.states.size());
        const Tour tour = options_.cover == TestCover::Locations ? visiting_tour(nodes, machine_.initial.index, arcs_)
                                                                 : least_tour(nodes, machine_.initial.index, arcs_);
        TestSequence test;
        test.chart = machine_.name;
        test.mode = machine_.mode;
        test.cover = options_.cover;
        test.one_cycle_each = options_.one_cycle_each;
        for (const MealyMachine::Variable& input : machine_.inputs) test.inputs.push_back({input.name, input.type});
        for (const MealyMachine::Variable& output : machine_.outputs)
            test.outputs.push_back({output.name, output.type});
        for (const State& state : machine_.states) test.situations.add({state.situation});
        for (const auto& sequence : tour.sequences)
            if (!sequence.empty()) test.sequences.push_back(steps(sequence));
        test.covered = test.to_cover = to_cover_;
        test.lower_bound = options_.cover == TestCover::Locations ? to_cover_ : tour.length + crossed_before_waits_;
        test.proven_least = step_count(test) == test.lower_bound;
        return test;
    }

private:
    Bdd set_of(Id<Expr> condition) { return sets_(condition) & space_.assumed(); }

    /// Calls `visit` with the number of every combination in `set`.
    template <class Visit>
    void for_each_combination(const Bdd& set, Visit visit) {
        for_each_cube(set, [&](std::span<const BddLiteral> cube) {
            std::uint32_t number = 0;
            std::vector<std::uint32_t> open = weights_;
            for (const BddLiteral literal : cube) {
                if (literal.value) number += weights_[literal.variable];
                open[literal.variable] = 0;
            }
            std::erase(open, 0U);
            for (std::uint64_t choice = 0; choice < std::uint64_t{1} << open.size(); ++choice) {
                std::uint32_t sum = number;
                for (std::size_t k = 0; k < open.size(); ++k)
                    if (((choice >> k) & 1U) != 0) sum += open[k];
                visit(sum);
            }
            return true;
        });
    }

    std::uint64_t pair(std::uint32_t state, std::uint32_t inputs) const {
        return std::uint64_t{state} * combinations_ + inputs;
    }

    /// Adds one arc per state and input combination. Unless the option `one_cycle_each` is set, a transition that stays
    /// in its state needs no separate arc in two cases: another arc arrives in the state with the same inputs and stays
    /// there, or a wait with these inputs starts in the state.
    void list_all() {
        combinations_ = 1;
        for (const MealyMachine::Variable& input : machine_.inputs)
            combinations_ *= static_cast<std::uint64_t>(input.type.high - input.type.low) + 1;
        std::vector<bool> seen(machine_.states.size() * combinations_), waits(seen.size());
        for (const MealyMachine::Transition& transition : machine_.transitions) {
            const Bdd set = set_of(transition.condition), held = set & staying(transition);
            const bool loop = transition.from == transition.to && transition.wait_ms == 0;
            for (const bool still : {true, false})
                for_each_combination(still ? held : set & ~held, [&](std::uint32_t inputs) {
                    ++to_cover_;
                    if (loop) return;
                    if (still && !options_.one_cycle_each) seen[pair(transition.to.index, inputs)] = true;
                    if (transition.wait_ms != 0) waits[pair(transition.from.index, inputs)] = true;
                    add(transition, inputs, still);
                });
        }
        for (const MealyMachine::Transition& transition : machine_.transitions) {
            if (transition.from != transition.to || transition.wait_ms != 0) continue;
            for_each_combination(set_of(transition.condition), [&](std::uint32_t inputs) {
                const std::uint64_t here = pair(transition.to.index, inputs);
                if (seen[here]) return;
                if (waits[here] && !options_.one_cycle_each) ++crossed_before_waits_;
                else add(transition, inputs, true);
            });
        }
    }

    /// Adds one arc per transition that leads to another state or waits. For a cover of locations, transitions that
    /// stay in their state are also added.
    void list_one_each() {
        for (const MealyMachine::Transition& transition : machine_.transitions) {
            const bool loop = transition.from == transition.to && transition.wait_ms == 0;
            if (loop && options_.cover == TestCover::Evolutions) continue;
            const Bdd set = set_of(transition.condition);
            const Bdd held = set & staying(transition);
            const bool still = !held.is_false();
            witnesses_.push_back(space_.witness(still ? held : set));
            add(transition, static_cast<std::uint32_t>(witnesses_.size() - 1), still);
        }
        to_cover_ = arcs_.size();
        if (options_.cover != TestCover::Locations) return;
        std::vector<bool> entered(machine_.states.size());
        for (const TourArc& arc : arcs_) entered[arc.to] = true;
        to_cover_ = static_cast<std::uint64_t>(std::ranges::count(entered, true));
    }

    /// Returns the inputs under which the machine stays in the target of `arrival` with the output of `arrival`. If
    /// states were merged, a machine that stays in the state may write another output than on arrival; such inputs are
    /// not included.
    const Bdd& staying(const MealyMachine::Transition& arrival) {
        const auto [place, added] = staying_.try_emplace({arrival.to, arrival.answer});
        if (!added) return place->second;
        for (const MealyMachine::Transition& one : transitions_from(machine_, arrival.to))
            if (one.to == arrival.to && one.answer == arrival.answer && one.wait_ms == 0)
                place->second |= set_of(one.condition);
        return place->second;
    }

    void add(const MealyMachine::Transition& transition, std::uint32_t inputs, bool stays) {
        arcs_.push_back(
            {transition.from.index, transition.to.index, inputs, transition.answer.index, transition.wait_ms, stays});
    }

    std::vector<std::int64_t> values(std::uint32_t inputs) const {
        if (!witnesses_.empty()) return witnesses_[inputs];
        std::vector<std::int64_t> values;
        for (std::size_t input = 0; input < machine_.inputs.size(); ++input) {
            const Type type = machine_.inputs[input].type;
            const auto count = static_cast<std::uint32_t>(type.high - type.low + 1);
            values.push_back(type.low + static_cast<std::int64_t>(inputs / strides_[input] % count));
        }
        return values;
    }

    TestSequence::Sequence steps(const std::vector<std::uint32_t>& tour) {
        TestSequence::Sequence sequence;
        const TestSequence::Step* last = nullptr;
        bool held = false;  // true if the machine stays in its state when the inputs of the last step are applied again
        for (const std::uint32_t index : tour) {
            const TourArc& arc = arcs_[index];
            const std::vector<std::int64_t> inputs = values(arc.inputs);
            if (arc.wait_ms != 0 && !(held && last != nullptr && last->inputs == inputs))
                sequence.steps.push_back({inputs, staying_answer(arc.from, inputs), cycles(true), 0, {arc.from}});
            sequence.steps.push_back(
                {inputs, machine_.answers[{arc.answer}].values, cycles(arc.stays), arc.wait_ms, {arc.to}});
            last = &sequence.steps.back();
            held = arc.stays && (!options_.one_cycle_each || arc.from == arc.to);
        }
        if (!machine_.activation.empty()) sequence.activation = activation(sequence.steps.front().inputs);
        return sequence;
    }

    std::uint32_t cycles(bool stays) const { return stays && !options_.one_cycle_each ? 2 : 1; }

    bool holds(Id<Expr> condition, const std::vector<std::int64_t>& inputs) const {
        return evaluate(machine_.exprs, condition, [&](const Expr& leaf) {
                   return inputs[static_cast<std::size_t>(leaf.value)];
               }).value_or(0) != 0;
    }

    /// Returns the output that the machine writes while it stays in `state` under `inputs`.
    std::vector<std::int64_t> staying_answer(std::uint32_t state, const std::vector<std::int64_t>& inputs) const {
        for (const MealyMachine::Transition& transition : transitions_from(machine_, {state}))
            if (transition.to.index == state && transition.wait_ms == 0 && holds(transition.condition, inputs))
                return machine_.answers[transition.answer].values;
        return std::vector<std::int64_t>(machine_.outputs.size());
    }

    TestSequence::Step activation(const std::vector<std::int64_t>& inputs) const {
        for (const MealyMachine::Activation& activation : machine_.activation)
            if (holds(activation.condition, inputs))
                return {inputs, machine_.answers[activation.answer].values, 1, 0, {machine_.initial.index}};
        return {inputs, std::vector<std::int64_t>(machine_.outputs.size()), 1, 0, {machine_.initial.index}};
    }

    const MealyMachine& machine_;
    const TestOptions& options_;
    InputSpace space_;
    InputSets sets_;
    std::uint64_t combinations_ = 0;
    std::vector<std::uint32_t> strides_ = {};  ///< factor of each input in the number of a combination
    std::vector<std::uint32_t> weights_ = {};  ///< weight of each variable of the space in the number of a combination
    std::vector<TourArc> arcs_ = {};
    std::vector<std::vector<std::int64_t>> witnesses_ = {};
    std::map<std::pair<Id<State>, Id<MealyMachine::OutputWord>>, Bdd> staying_ = {};
    std::uint64_t to_cover_ = 0;
    std::uint64_t crossed_before_waits_ = 0;  ///< number of stable transitions that only the step before a wait covers
};

/// Returns the total number of bits of all inputs.
std::size_t input_bits(const MealyMachine& machine) {
    std::size_t bits = 0;
    for (const MealyMachine::Variable& input : machine.inputs) bits += bit_count(input.type);
    return bits;
}

}  // namespace

std::optional<TestSequence> test_sequence(const MealyMachine& machine, const TestOptions& options, Span chart,
                                          Diagnostics& diagnostics) {
    const std::size_t bits = input_bits(machine);
    if (options.cover == TestCover::Transitions) {
        if (bits > options.max_input_bits) {
            diagnostics.add(messages::too_many_inputs(chart, machine.name, bits, options.max_input_bits));
            return {};
        }
        if (machine.states.size() > options.max_pairs >> bits) {
            diagnostics.add(messages::too_many_pairs(chart, machine.states.size(), options.max_pairs));
            return {};
        }
    }
    TestSequence test = Writer(machine, options).write();
    if (test.to_cover != 0) return test;
    diagnostics.add(messages::nothing_to_test(chart, machine.name, word(options.cover)));
    return {};
}

}  // namespace grafverif
