// SPDX-License-Identifier: MIT
// Prints Mealy machines and test sequences.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>

#include "support/json_text.hpp"
#include "syntax/print/automaton.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

namespace {

using Machine = MealyMachine;
using OrderedJson = nlohmann::ordered_json;

std::string state_text(const Machine& machine, Id<Machine::State> id) {
    const Machine::State& state = machine.states[id];
    return fmt::format("{} {}{}{}", id.index, state.situation, state.detail.empty() ? "" : "  ", state.detail);
}

OrderedJson values_json(const std::vector<std::int64_t>& values, const auto& variables) {
    OrderedJson object = OrderedJson::object();
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (variables[k].type.boolean) object[variables[k].name] = values[k] != 0;
        else object[variables[k].name] = values[k];
    }
    return object;
}

template <class T>
OrderedJson names_json(const std::vector<T>& variables) {
    OrderedJson names = OrderedJson::array();
    for (const T& variable : variables) names.push_back(variable.name);
    return names;
}

void add_details(const Machine& machine, OrderedJson& head) {
    head["inputs"] = names_json(machine.inputs);
    head["outputs"] = names_json(machine.outputs);
    head["assumed"] = condition_text(machine, machine.assumed);
    OrderedJson activation = OrderedJson::array(), states = OrderedJson::array(), transitions = OrderedJson::array(),
                unstable = OrderedJson::array();
    for (const Machine::Activation& one : machine.activation)
        activation.push_back({{"condition", condition_text(machine, one.condition)},
                              {"outputs", values_json(machine.answers[one.answer].values, machine.outputs)}});
    for (const Id<Machine::State> id : machine.states.ids())
        states.push_back(
            {{"state", id.index}, {"situation", machine.states[id].situation}, {"detail", machine.states[id].detail}});
    for (const Machine::Transition& one : machine.transitions)
        transitions.push_back({{"from", one.from.index},
                               {"to", one.to.index},
                               {"condition", condition_text(machine, one.condition)},
                               {"outputs", values_json(machine.answers[one.answer].values, machine.outputs)},
                               {"wait_ms", one.wait_ms}});
    for (const Machine::Unstable& one : machine.unstable)
        unstable.push_back({{"from", one.from.index}, {"condition", condition_text(machine, one.condition)}});
    head["activation"] = activation;
    head["state_table"] = states;
    head["transition_table"] = transitions;
    head["unstable_table"] = unstable;
}

OrderedJson step_json(const TestSequence& test, const TestSequence::Step& step, std::size_t number) {
    return {{"step", number},
            {"wait_ms", step.wait_ms},
            {"cycles", step.cycles},
            {"inputs", values_json(step.inputs, test.inputs)},
            {"outputs", values_json(step.outputs, test.outputs)},
            {"situation", test.situations[step.situation].text}};
}

}  // namespace

std::string result_text(const Machine& machine, Id<Machine::OutputWord> answer, std::string_view none) {
    std::string text;
    for (std::size_t k = 0; k < machine.outputs.size(); ++k) {
        const std::int64_t value = machine.answers[answer].values[k];
        if (value == 0) continue;
        text += (text.empty() ? "" : ", ") + machine.outputs[k].name;
        if (!machine.outputs[k].type.boolean) text += " = " + std::to_string(value);
    }
    return text.empty() ? std::string(none) : text;
}

std::optional<std::uint64_t> transition_count(const Machine& machine) {
    if (!machine.combinations) return {};
    std::uint64_t count = 0;
    if (__builtin_mul_overflow(*machine.combinations, std::uint64_t{machine.states.size()}, &count)) return {};
    return count;
}

std::string condition_text(const Machine& machine, Id<Expr> condition) {
    return expr_text(machine.exprs, condition, plain_spelling, [&](std::ostream& out, const Expr& leaf) {
        out << machine.inputs[static_cast<std::size_t>(leaf.value)].name;
    });
}

void print_mealy(std::ostream& out, const Machine& machine, bool details) {
    const auto text = [](std::optional<std::uint64_t> count) { return count ? std::to_string(*count) : "very many"; };
    out << fmt::format("Mealy machine of {}, {}\n{} states\n{} transitions, one per state and combination of inputs",
                       machine.name, word(machine.mode), machine.states.size(), text(transition_count(machine)));
    if (machine.unstable_pairs != 0)
        out << "; for " << text(machine.unstable_pairs) << " of them, the situation never becomes stable";
    out << '\n';
    if (!is_true(machine.exprs, machine.assumed))
        out << "assumed: " << condition_text(machine, machine.assumed) << '\n';
    for (const Machine::Activation& one : machine.activation)
        out << fmt::format("first cycle, which activates the initial steps: {}{}\n",
                           result_text(machine, one.answer, "no output"),
                           machine.activation.size() == 1 ? "" : " when " + condition_text(machine, one.condition));
    if (!details) return;
    for (const Id<Machine::State> id : machine.states.ids()) {
        out << '\n' << state_text(machine, id) << (id == machine.initial ? "  (initial)" : "") << '\n';
        for (const Machine::Transition& one : transitions_from(machine, id))
            out << fmt::format(
                "    {}{} -> {} / {}\n", one.wait_ms != 0 ? "wait " + duration_text(one.wait_ms) + ", " : "",
                condition_text(machine, one.condition), one.to.index, result_text(machine, one.answer, "no output"));
        for (const Machine::Unstable& one : machine.unstable)
            if (one.from == id)
                out << "    when " << condition_text(machine, one.condition)
                    << ", the situation never becomes stable\n";
    }
}

void print_mealy_json(std::ostream& out, const Machine& machine, bool details) {
    OrderedJson head = {{"name", machine.name},
                        {"mode", word(machine.mode)},
                        {"states", machine.states.size()},
                        {"transitions", optional_json(transition_count(machine))},
                        {"unstable_pairs", optional_json(machine.unstable_pairs)},
                        {"combinations", optional_json(machine.combinations)},
                        {"initial", machine.initial.index}};
    if (details) add_details(machine, head);
    out << json_text(head) << '\n';
}

void print_test_json(std::ostream& out, const TestSequence& test) {
    OrderedJson sequences = OrderedJson::array();
    for (const TestSequence::Sequence& sequence : test.sequences) {
        OrderedJson steps = OrderedJson::array();
        if (sequence.activation) steps.push_back(step_json(test, *sequence.activation, 0));
        for (std::size_t k = 0; k < sequence.steps.size(); ++k)
            steps.push_back(step_json(test, sequence.steps[k], k + 1));
        sequences.push_back(std::move(steps));
    }
    const OrderedJson whole = {{"chart", test.chart},
                               {"mode", word(test.mode)},
                               {"cover", word(test.cover)},
                               {"hold", test.one_cycle_each ? "one" : "stable"},
                               {"steps", step_count(test)},
                               {"lower_bound", test.lower_bound},
                               {"proven_least", test.proven_least},
                               {"covered", test.covered},
                               {"to_cover", test.to_cover},
                               {"inputs", names_json(test.inputs)},
                               {"outputs", names_json(test.outputs)},
                               {"sequences", sequences}};
    out << json_text(whole) << '\n';
}

namespace {

/// For each situation of a test: the situations that directly precede it, or that directly follow it.
using Adjacency = std::vector<std::set<std::uint32_t>>;

Adjacency adjacency(const TestSequence& test, bool back) {
    Adjacency next(test.situations.size());
    for (const TestSequence::Sequence& sequence : test.sequences)
        for (std::size_t k = 1; k < sequence.steps.size(); ++k) {
            const std::uint32_t from = sequence.steps[k - 1].situation.index, to = sequence.steps[k].situation.index;
            next[back ? to : from].insert(back ? from : to);
        }
    return next;
}

std::set<std::uint32_t> led_to(const Adjacency& next, std::uint32_t from) {
    std::set<std::uint32_t> found{from};
    for (std::vector<std::uint32_t> open{from}; !open.empty();) {
        const std::uint32_t here = open.back();
        open.pop_back();
        for (const std::uint32_t to : next[here])
            if (found.insert(to).second) open.push_back(to);
    }
    return found;
}

/// Returns, for each terminal strongly connected component of situations that the test reaches, the first situation of
/// the component in a sequence. The test covers all reachable transitions. Therefore, if no step of the test leaves a
/// component, no transition of the machine leaves this component. A test needs several sequences only because a
/// sequence cannot leave a terminal component.
std::vector<std::string> traps(const TestSequence& test) {
    if (test.sequences.size() < 2 || test.cover == TestCover::Locations) return {};
    const Adjacency next = adjacency(test, false), before = adjacency(test, true);
    std::vector<std::string> found;
    std::set<std::uint32_t> known;
    for (const TestSequence::Sequence& sequence : test.sequences) {
        const std::uint32_t end = sequence.steps.back().situation.index;
        if (known.contains(end)) continue;
        const std::set<std::uint32_t> stays = led_to(next, end);
        // If a situation after `end` does not lead back to `end`, the component of `end` is not terminal.
        if (!std::ranges::includes(led_to(before, end), stays)) continue;
        known.insert(stays.begin(), stays.end());
        const auto entered = std::ranges::find_if(
            sequence.steps, [&](const TestSequence::Step& step) { return stays.contains(step.situation.index); });
        found.push_back(test.situations[entered->situation].text);
    }
    return found;
}

/// Returns a text about terminal components, such as `; no transition leads back from {2} and {4,5}`.
std::string traps_text(const TestSequence& test) {
    constexpr std::size_t most = 5;
    const std::vector<std::string> found = traps(test);
    std::string text;
    for (std::size_t k = 0; k < std::min(found.size(), most); ++k)
        text += (k == 0 ? "" : k + 1 == found.size() ? " and " : ", ") + found[k];
    if (found.size() > most) text += fmt::format(" and {} more", found.size() - most);
    return text.empty() ? text : "; no transition leads back from " + text;
}

}  // namespace

std::string summary(const TestSequence& test) {
    const std::size_t steps = step_count(test);
    std::string text = fmt::format("{} step{} in {} sequence{} from power-on, covering {} of {} {}; ", steps,
                                   steps == 1 ? "" : "s", test.sequences.size(), test.sequences.size() == 1 ? "" : "s",
                                   test.covered, test.to_cover, word(test.cover));
    return text + fmt::format("{} least (lower bound {}){}", test.proven_least ? "proven" : "not proven",
                              test.lower_bound, traps_text(test));
}

}  // namespace grafverif
