// SPDX-License-Identifier: MIT
// Randomized test: the location automaton of a chart, computed for all inputs together, predicts the location, the
// outputs and total instability in every run of the interpreter. The tests generated from the automaton pass on the
// interpreter.
#include <algorithm>
#include <optional>
#include <sstream>

#include "run/replay_test.hpp"
#include "support/random_chart.hpp"
#include "support/test_size.hpp"
#include "unit/conform/conforming.hpp"

namespace grafverif {
namespace {

constexpr int runs_per_chart = 3, cycles_per_run = 12;

/// Counts the cases in the random runs, so that the test fails if the generator no longer produces them.
struct Walked {
    int refused = 0, evolutions = 0, stays = 0, unstable = 0, conditional = 0, timed = 0, watched = 0, tests = 0,
        several = 0, waiting = 0, merged = 0, constrained = 0;
};

/// Returns, for each timer of the equations, the corresponding timed element of the chart.
std::vector<std::size_t> elements_of(const Chart& chart, const Equations& equations) {
    const std::vector<TimedElement> elements = timed_elements(chart);
    std::vector<std::size_t> result(equations.timers.size());
    for (std::size_t k = 0; k < elements.size(); ++k) {
        for (std::size_t timer = 0; timer < equations.timers.size(); ++timer) {
            const Equations::Timer& one = equations.timers[timer];
            const bool of_action = k >= equations.conditions.size();
            if (of_action ? one.watched == equations.steps[elements[k].step.index].variable &&
                                one.rise_ms == elements[k].rise_ms && one.fall_ms == 0
                          : equations.conditions[k] == Id<Equations::Timer>{static_cast<std::uint32_t>(timer)})
                result[timer] = k;
        }
    }
    return result;
}

/// A chart and its automaton, executed in lockstep.
class Walk {
public:
    Walk(const Chart& chart, const Equations& equations, const LocationAutomaton& automaton, Walked& walked)
        : chart_(chart),
          automaton_(automaton),
          walked_(walked),
          elements_(elements_of(chart, equations)),
          state_(power_on(chart)),
          location_(automaton.init) {}

    /// Executes one cycle. Returns a description of a difference, or an empty string. Sets `ended` if the run cannot
    /// continue.
    std::string cycle_with(const std::vector<std::int64_t>& inputs, bool& ended) {
        read_inputs(inputs);
        const Cycle run = cycle(chart_, state_, inputs, automaton_.mode);
        ended = true;
        if (run.race || run.fault) return "the automaton does not contain the race or fault";
        const LocationAutomaton::Instability* instability = nullptr;
        for (const LocationAutomaton::Instability& one : instabilities_of(automaton_, location_))
            if (value(one.condition) != 0) instability = &one;
        if ((instability != nullptr) != !run.endless.empty()) return "total instability";
        if (instability != nullptr)
            return ++walked_.unstable,
                   instability->cycle.size() == run.endless.size() ? "" : "the cycle of instability";
        const LocationAutomaton::Evolution* taken = nullptr;
        for (const LocationAutomaton::Evolution& one : evolutions_from(automaton_, location_)) {
            if (value(one.condition) == 0) continue;
            if (taken != nullptr) return "two evolutions at once";
            taken = &one;
        }
        ++(taken != nullptr ? walked_.evolutions : walked_.stays);
        if (taken != nullptr) location_ = taken->to;
        ended = false;
        state_ = run.state;
        read_inputs(inputs);  // outputs may read the timer outputs after the cycle
        return compared();
    }

    void wait(std::int64_t milliseconds) { state_ = pass_time(state_, milliseconds); }

private:
    void read_inputs(const std::vector<std::int64_t>& inputs) {
        inputs_.clear();
        for (const Id<Chart::Variable> id : chart_.variables.ids())
            if (chart_.variables[id].kind == Chart::VariableKind::Input) inputs_.push_back(inputs[id.index]);
        const std::vector<bool> holds = time_conditions(chart_, state_);
        for (std::size_t timer = 0; timer < elements_.size(); ++timer) {
            inputs_.push_back(holds[elements_[timer]]);
            const LocationAutomaton::Input& input =
                automaton_.inputs[Id<LocationAutomaton::Input>{static_cast<std::uint32_t>(inputs_.size() - 1)}];
            if (inputs_.back() != 0) ++(input.timed.valid() ? walked_.timed : walked_.watched);
        }
    }

    std::int64_t value(Id<Expr> term) const {
        return evaluate(automaton_.exprs, term,
                        [&](const Expr& leaf) { return inputs_[static_cast<std::size_t>(leaf.value)]; })
            .value_or(-1);
    }

    std::string compared() {
        const LocationAutomaton::Location& location = automaton_.locations[location_];
        std::vector<Id<LocationAutomaton::Step>> situation;
        for (const Id<Chart::Step> step : chart_.steps.ids())
            if (state_.situation[step.index]) situation.push_back({step.index});
        if (situation != location.situation)
            return "the situation is " + situation_text(automaton_, situation) + ", not " +
                   situation_text(automaton_, location.situation);
        std::vector<std::int64_t> outputs(automaton_.outputs.size());
        for (const LocationAutomaton::Emission& emission : location.emissions) {
            outputs[emission.output.index] = value(emission.value);
            if (!is_constant(automaton_.exprs[emission.value].op)) ++walked_.conditional;
        }
        std::size_t output = 0;
        for (const Id<Chart::Variable> id : chart_.variables.ids())
            if (chart_.variables[id].kind == Chart::VariableKind::Output &&
                outputs[output++] != state_.outputs[id.index])
                return "output " + chart_.variables[id].name;
        return {};
    }

    const Chart& chart_;
    const LocationAutomaton& automaton_;
    Walked& walked_;
    std::vector<std::size_t> elements_ = {};  ///< indexed by timer of the equations
    State state_ = {};
    Id<LocationAutomaton::Location> location_ = {};
    std::vector<std::int64_t> inputs_ = {};  ///< indexed by input of the automaton
};

/// If the chart has several Boolean inputs, adds the constraint that two of them are not true together.
void constrain(Chart& chart, Random& random) {
    std::vector<Id<Expr>> inputs;
    for (const Id<Chart::Variable> id : chart.variables.ids())
        if (chart.variables[id].kind == Chart::VariableKind::Input && chart.variables[id].type.boolean)
            inputs.push_back(chart.exprs.leaf(Op::Variable, id.index));
    if (inputs.size() < 2) return;
    const auto first = static_cast<std::size_t>(random_number(random, 0, static_cast<std::int64_t>(inputs.size()) - 2));
    chart.constraints.push_back({chart.exprs.negation(chart.exprs.conjunction(inputs[first], inputs[first + 1])), {}});
}

bool allowed(const Chart& chart, const std::vector<std::int64_t>& inputs) {
    return std::ranges::all_of(chart.constraints, [&](const Chart::Constraint& one) {
        return evaluate(chart.exprs, one.condition,
                        [&](const Expr& leaf) { return inputs[static_cast<std::size_t>(leaf.value)]; }) == 1;
    });
}

std::string walk(const Chart& chart, const Equations& equations, const LocationAutomaton& automaton, Random& random,
                 Walked& walked) {
    for (int run = 0; run < runs_per_chart; ++run) {
        Walk side_by_side(chart, equations, automaton, walked);
        std::vector<std::int64_t> inputs(chart.variables.size());
        bool ended = false;
        for (int k = 0; k < cycles_per_run && !ended; ++k) {
            for (const Id<Chart::Variable> id : chart.variables.ids())
                if (chart.variables[id].kind == Chart::VariableKind::Input && chance(random, 50))
                    inputs[id.index] =
                        random_number(random, chart.variables[id].type.low, chart.variables[id].type.high);
            if (!allowed(chart, inputs)) continue;
            if (std::string what = side_by_side.cycle_with(inputs, ended); !what.empty()) return what;
            if (chance(random, 40)) side_by_side.wait(500 * random_number(random, 1, 8));
        }
    }
    return {};
}

/// Replays the tests of every coverage criterion on the interpreter.
std::string tested(const Chart& chart, const MealyMachine& machine, Walked& walked) {
    Diagnostics diagnostics;
    for (const TestCover cover : {TestCover::Transitions, TestCover::Evolutions, TestCover::Locations})
        for (const bool one : {false, true}) {
            TestOptions options;
            options.cover = cover;
            options.one_cycle_each = one;
            options.max_pairs = 20'000;
            const auto test = test_sequence(machine, options, {}, diagnostics);
            if (!test || test->sequences.empty()) continue;
            for (const std::string& fault : verify(*test)) return "verify: " + fault;
            ++walked.tests;
            walked.several += test->sequences.size() > 1 ? 1 : 0;
            for (const TestSequence::Sequence& sequence : test->sequences)
                for (const TestSequence::Step& step : sequence.steps) walked.waiting += step.wait_ms != 0 ? 1 : 0;
            if (const auto wrong = disagreement(chart, *test))
                return std::string(word(cover)) + (one ? ", one cycle each: " : ": ") + *wrong;
        }
    return {};
}

/// Replays tests of the Mealy machine and of the minimized machine.
std::string tested(const Chart& chart, const LocationAutomaton& automaton, Walked& walked) {
    Diagnostics diagnostics;
    const auto machine = mealy_machine(automaton, {.max_states = 300}, diagnostics);
    if (!machine) return {};
    for (const std::string& fault : verify(*machine)) return "verify: " + fault;
    const auto least = minimised(*machine, {}, chart.origin, diagnostics);
    if (!least) return "there is no minimized machine";
    for (const std::string& fault : verify(*least)) return "verify of the minimized machine: " + fault;
    if (least->states.size() < machine->states.size()) ++walked.merged;
    if (std::string what = tested(chart, *machine, walked); !what.empty()) return what;
    if (std::string what = tested(chart, *least, walked); !what.empty()) return "minimized machine, " + what;
    return {};
}

std::string violation(const Chart& chart, std::uint64_t seed, ExecutionMode mode, Walked& walked) {
    Diagnostics diagnostics;
    const auto equations = derive(chart, diagnostics);
    if (!equations) return {};
    AutomatonOptions options;
    options.mode = mode;
    options.max_locations = 400;
    const auto found = location_automaton(*equations, options, diagnostics);
    if (!found) return ++walked.refused, "";
    for (const std::string& fault : verify(*found)) return "verify: " + fault;
    Random random(seed);
    if (std::string what = walk(chart, *equations, *found, random, walked); !what.empty()) return what;
    return tested(chart, *found, walked);
}

TEST(RandomizedAutomaton, AutomatonFollowsTheInterpreter) {
    Walked walked;
    for (int seed = 1; seed <= test_size(150); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        Chart chart = random_chart(random, seed % 2 == 0 ? TimedTerms::Steps : TimedTerms::Any);
        if (seed % 3 == 0) constrain(chart, random);
        walked.constrained += chart.constraints.empty() ? 0 : 1;
        for (const ExecutionMode mode : {ExecutionMode::StabilitySearch, ExecutionMode::EveryCycle}) {
            const std::uint64_t run_seed = random();
            if (violation(chart, run_seed, mode, walked).empty()) continue;
            Walked ignored;
            const Chart smallest = shrunk(
                chart, [&](const Chart& smaller) { return !violation(smaller, run_seed, mode, ignored).empty(); });
            FAIL() << "seed " << seed
                   << (mode == ExecutionMode::EveryCycle ? ", every cycle, " : ", stability search, ")
                   << violation(smallest, run_seed, mode, ignored) << "\n\n"
                   << chart_text(smallest);
        }
    }
    EXPECT_GT(walked.evolutions, 300);
    EXPECT_GT(walked.stays, 300);
    EXPECT_GT(walked.unstable, 5);
    EXPECT_GT(walked.conditional, 50);
    EXPECT_GT(walked.timed, 50);
    EXPECT_GT(walked.watched, 50);
    EXPECT_GT(walked.waiting, 50);
    EXPECT_GT(walked.merged, 20);
    EXPECT_GT(walked.constrained, 20);
    EXPECT_GT(walked.tests, 100);
    EXPECT_GT(walked.several, 20);
    EXPECT_LT(walked.refused, 2 * test_size(150) * 3 / 4);
}

}  // namespace
}  // namespace grafverif
