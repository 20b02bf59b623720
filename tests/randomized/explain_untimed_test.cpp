// SPDX-License-Identifier: MIT
// Randomized tests of explanations of counterexamples in untimed models.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "check/lost_text.hpp"
#include "check/symbolic/symbolic.hpp"
#include "explain/inputs.hpp"
#include "grafverif/grafverif.hpp"
#include "ir/patterns.hpp"
#include "run/interpreter.hpp"
#include "run/project.hpp"
#include "run/replay.hpp"
#include "support/explicit_search.hpp"
#include "support/random_loop.hpp"
#include "support/row_counts.hpp"
#include "support/test_size.hpp"
#include "support/untimed_loop.hpp"

namespace grafverif {
namespace {

using System = TransitionSystem;

/// Returns the system of the loop, or nothing if the loop cannot be translated.
std::optional<System> system_for(const Model& model, const ScheduleOptions& options) {
    try {
        return untimed_loop(model, options);
    } catch (const std::invalid_argument&) {
        return {};
    }
}

bool is_possible(const Property& property) { return property.pattern == Pattern::AlwaysPossible; }

/// Searches `system` and checks only the requested properties. The memory limit bounds the time of the test.
SymbolicResult searched(const System& system, bool (*requested)(const Property&)) {
    SymbolicOptions options;
    options.witnesses = false;
    options.max_memory = std::uint64_t{3} << 20U;
    for (const Property& property : system.properties)
        if (requested(property)) options.properties.push_back(property.name);
    return options.properties.empty() ? SymbolicResult() : check_symbolic(system, options);
}

// -- the shortest change ----------------------------------------------------------------------------------------------

/// The changes of the free variables in a run of controllers alone. The class implements the definition in
/// explain/inputs.hpp, in the order of its sentences.
class Told {
public:
    struct Event {
        std::string name = {};
        std::size_t state = 0;
        auto operator<=>(const Event&) const = default;
    };

    Told(const System& system, const SystemRun& run) : system_(system), run_(run) {
        const auto& symbols = system.modules[system.main].symbols;
        for (const Id<System::Symbol> id : symbols.ids()) {
            const auto* const state = std::get_if<System::StateSymbol>(&symbols[id].kind);
            if (state != nullptr && !state->next) add(id);
        }
    }

    const std::vector<Event>& events() const { return events_; }

    /// True if the property fails in some state of the run.
    bool fails(const Property& property) const {
        std::size_t at = 0;
        const auto choose = [&](std::string_view path, Type) { return value_at(std::string(path), at); };
        SystemState state = first_state(system_, choose);
        while (good(state, property)) {
            if (++at == run_.states.size()) return false;
            state = step_taken(system_, state, choose).value();
        }
        return true;
    }

    /// Returns the states of the run without the events `left_out`, and the index of the state after which they repeat.
    /// Returns nothing if there is no such run.
    std::optional<std::pair<std::vector<SystemState>, std::size_t>> made_again(const std::set<Event>& left_out,
                                                                               const Property& property) const {
        std::map<std::string, std::int64_t> now;
        std::size_t at = 0;
        const auto choose = [&](std::string_view path, Type) {
            const std::string name(path);
            if (mover_variables_.contains(name)) return at < run_.states.size() ? value_at(name, at) : std::int64_t{1};
            if (at < run_.states.size()) now[name] = value(left_out, name, at, now);
            return now.at(name);
        };
        std::vector<SystemState> states = {first_state(system_, choose)};
        if (!is_allowed(system_, states[0])) return {};
        for (;;) {
            if (!good(states.back(), property)) return {};
            ++at;
            const auto next = step_taken(system_, states.back(), choose);
            if (!next || states.size() > 1500) return {};
            const auto behind =
                states.begin() + static_cast<std::ptrdiff_t>(std::min(states.size(), run_.states.size()));
            const auto known = std::find(behind, states.end(), *next);
            if (known != states.end()) return std::pair(states, static_cast<std::size_t>(known - states.begin()));
            states.push_back(*next);
        }
    }

private:
    std::int64_t value_at(const std::string& name, std::size_t state) const {
        return run_.states[state][symbol_.at(name)];
    }

    void add(Id<System::Symbol> id) {
        const System::Symbol& symbol = system_.modules[system_.main].symbols[id];
        symbol_[symbol.name] = id.index;
        rest_[symbol.name] = symbol.type.low > 0 ? symbol.type.low : symbol.type.high < 0 ? symbol.type.high : 0;
        for (const System::Controller& controller : system_.controllers) {
            for (const System::Named& input : controller.words.inputs)
                if (input.variable == id) return add_input(symbol.name);
            for (const auto& timer : controller.words.timers) {
                if (timer.end != id) continue;
                times_.insert(symbol.name);
                return add_time(symbol.name);
            }
        }
        mover_variables_.insert(symbol.name);
    }

    void add_input(const std::string& name) {
        for (std::size_t state = 0; state < run_.states.size(); ++state)
            if (value_at(name, state) != (state == 0 ? rest_[name] : value_at(name, state - 1)))
                events_.push_back({name, state});
    }

    void add_time(const std::string& name) {
        for (std::size_t state = 0; state < run_.states.size(); ++state)
            if (value_at(name, state) != 0 && (state == 0 || value_at(name, state - 1) == 0))
                events_.push_back({name, state});
    }

    /// Returns the value of `name` in a state of the run without the events `left_out`. `before` is the previous value.
    std::int64_t value(const std::set<Event>& left_out, const std::string& name, std::size_t state,
                       const std::map<std::string, std::int64_t>& before) const {
        const Event* last = nullptr;
        for (const Event& event : events_)
            if (event.name == name && event.state <= state && (last == nullptr || last->state < event.state))
                last = &event;
        if (times_.contains(name)) return last != nullptr && left_out.contains(*last) ? 0 : value_at(name, state);
        if (last != nullptr && last->state == state && !left_out.contains(*last)) return value_at(name, state);
        return state == 0 ? rest_.at(name) : before.at(name);
    }

    bool good(const SystemState& state, const Property& property) const {
        if (property.at_stable && value_of(system_, state, system_.settled) == 0) return true;
        const auto holding = std::ranges::count_if(
            property.operands, [&](Id<Expr> operand) { return value_of(system_, state, operand) != 0; });
        return property.pattern == Pattern::Never ? holding == 0 : holding == 1;
    }

    const System& system_;
    const SystemRun& run_;
    std::map<std::string, std::uint32_t> symbol_ = {};
    std::map<std::string, std::int64_t> rest_ = {};
    std::set<std::string> times_ = {}, mover_variables_ = {};
    std::vector<Event> events_ = {};
};

/// True if no two time conditions on one step contradict each other in the run (run/replay.hpp).
bool is_timely(const System& system, const std::pair<std::vector<SystemState>, std::size_t>& made) {
    SystemRun run{{}, made.second};
    for (const SystemState& state : made.first) {
        std::vector<std::int64_t>& values = run.states.emplace_back();
        for (const System::Symbol& symbol : system.modules[system.main].symbols)
            values.push_back(value_of(system, state, symbol.name));
    }
    return !untimely(project(system, run));
}

/// Returns the sets of events without which the property does not fail on the run.
std::vector<std::set<Told::Event>> sets_that_mend(const System& system, const SystemRun& run, const Told& value_at,
                                                  const Property& property) {
    const bool any = untimely(project(system, run)).has_value();
    std::vector<std::set<Told::Event>> found;
    for (std::size_t bits = 1; bits < std::size_t{1} << value_at.events().size(); ++bits) {
        std::set<Told::Event> left_out;
        for (std::size_t k = 0; k < value_at.events().size(); ++k)
            if ((bits >> k & 1U) != 0) left_out.insert(value_at.events()[k]);
        const auto made = value_at.made_again(left_out, property);
        if (made && (any || is_timely(system, *made))) found.push_back(std::move(left_out));
    }
    return found;
}

/// Returns a run of controllers alone whose inputs change occasionally, or nothing if a constraint forbids it.
std::optional<SystemRun> random_run(const System& system, Random& random) {
    std::map<std::string, std::int64_t> now;
    const auto choose = [&](std::string_view path, Type type) {
        std::int64_t& value = now.emplace(path, std::clamp<std::int64_t>(0, type.low, type.high)).first->second;
        if (chance(random, 25)) value = random_number(random, type.low, type.high);
        return value;
    };
    const auto length = random_number(random, 1, 7);
    SystemRun run;
    std::optional<SystemState> state = first_state(system, choose);
    if (!is_allowed(system, *state)) return {};
    while (state) {
        std::vector<std::int64_t>& values = run.states.emplace_back();
        for (const System::Symbol& symbol : system.modules[system.main].symbols)
            values.push_back(value_of(system, *state, symbol.name));
        if (std::ssize(run.states) == length) return run;
        state = step_taken(system, *state, choose);
    }
    return {};
}

bool is_time(const System& system, Id<System::Symbol> symbol) {
    return std::ranges::any_of(system.controllers, [&](const System::Controller& controller) {
        const auto& timers = controller.words.timers;
        return std::ranges::any_of(timers, [&](const auto& timer) { return timer.end == symbol; });
    });
}

/// Checks that the set of events that fewest_input_changes omits is one of the smallest sets of
/// input and timer events without which the property does not fail.
void expect_fewest(const System& system, const std::vector<const Chart*>& charts, const Property& property,
                   const SystemRun& run, std::map<std::string, int>& counts) {
    const Told value_at(system, run);
    if (value_at.events().size() > 6 || !value_at.fails(property)) return;
    const InputChange change = fewest_input_changes(system, property, run, 10'000'000);
    ASSERT_EQ(change.events.size(), value_at.events().size());
    ASSERT_FALSE(change.exhausted);
    const auto mending = sets_that_mend(system, run, value_at, property);
    ASSERT_EQ(change.left_out.has_value(), !mending.empty());
    if (!change.left_out) {
        ++counts["no omission prevents the violation"];
        return;
    }
    const Table<System::Symbol>& symbols = system.modules[system.main].symbols;
    std::set<Told::Event> left_out;
    for (const InputChange::ChoiceEvent& event : *change.left_out) {
        left_out.insert({symbols[event.symbol].name, event.state});
        counts["times"] += is_time(system, event.symbol) ? 1 : 0;
    }
    const auto size = [](const auto& set) { return set.size(); };
    EXPECT_EQ(left_out.size(), std::ranges::min(mending, {}, size).size());
    const auto again = value_at.made_again(left_out, property);
    ASSERT_TRUE(again);
    ASSERT_EQ(change.run.states.size(), again->first.size());
    EXPECT_EQ(change.run.loop, again->second);
    for (std::size_t state = 0; state < again->first.size(); ++state)
        for (const Id<System::Symbol> id : symbols.ids())
            ASSERT_EQ(change.run.states[state][id.index], value_of(system, again->first[state], symbols[id].name));
    // The changed run must agree with the interpreter.
    if (const auto wrong = disagreement(project(system, change.run), charts)) FAIL() << wrong->what;
    ++counts[left_out.size() > 1 ? "several changes" : "one change"];
    ++counts[charts.size() > 1 ? "two controllers" : "one controller"];
}

TEST(RandomizedExplainUntimed, FewestInputChangesAgreeWithExhaustiveReplayByTheReferenceSemantics) {
    std::map<std::string, int> counts;
    for (int seed = 1; seed <= test_size(800); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const Model model = random_loop_asked(random, 8);
        const PlantApproach plant = seed % 3 == 0 ? PlantApproach::Constraints : PlantApproach::None;
        const auto system = system_for(model, {.plant = plant});
        if (!system) continue;
        std::vector<const Chart*> charts;
        for (const ClosedLoop::Controller& controller : model.loops[{0}].controllers)
            charts.push_back(&model.charts[controller.chart]);
        for (int walk = 0; walk < 3; ++walk) {
            const auto run = random_run(*system, random);
            if (!run) continue;
            for (const Property& property : system->properties)
                if (is_about_all_states(property.pattern)) expect_fewest(*system, charts, property, *run, counts);
            counts["constraints"] += plant == PlantApproach::Constraints ? 1 : 0;
        }
        if (HasFatalFailure()) return;
    }
    print_counts(counts);
    for (const char* what : {"no omission prevents the violation", "several changes", "one change", "times",
                             "two controllers", "one controller", "constraints"})
        EXPECT_GT(counts[what], 0) << what;
}

// -- the point of no return -------------------------------------------------------------------------------------------

/// Returns the last two states of a run of controllers alone.
std::vector<SystemState> last_two(const System& system, const SystemRun& run) {
    const auto& symbols = system.modules[system.main].symbols;
    std::size_t at = 0;
    const auto choose = [&](std::string_view path, Type) {
        const auto symbol = std::ranges::find(symbols, path, &System::Symbol::name);
        return run.states[at][static_cast<std::size_t>(symbol - symbols.begin())];
    };
    std::vector<SystemState> states = {first_state(system, choose)};
    for (at = 1; at < run.states.size(); ++at) states.push_back(step_taken(system, states.back(), choose).value());
    if (states.size() > 2) states.erase(states.begin(), states.end() - 2);
    return states;
}

TEST(RandomizedExplainUntimed, DeadTransitionsAreNeverClearedAfterThePointOfNoReturn) {
    std::map<std::string, int> counts;
    for (int seed = 1; seed <= test_size(60); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const Model model = random_loop_asked(random, 10);
        const auto system = system_for(model, {});
        if (!system) continue;
        const SymbolicResult result = searched(*system, is_possible);
        std::optional<SystemGraph> graph;
        for (std::size_t k = 0; k < result.verdicts.size(); ++k) {
            const Verdict& verdict = result.verdicts[k];
            if (verdict.pattern != Pattern::AlwaysPossible || verdict.outcome != Outcome::Violated) continue;
            if (!graph) graph = explored(*system, 1500);
            if (!graph) break;
            const Property& property = system->properties[verdict.about];
            const StateSet goal = operand_sets(*system, *graph, property).front();
            const auto behind = [&](const SystemState& from) {
                StateSet seen(graph->states.size());
                std::vector<std::size_t> open = {
                    static_cast<std::size_t>(std::ranges::find(graph->states, from) - graph->states.begin())};
                while (!open.empty()) {
                    const std::size_t state = open.back();
                    open.pop_back();
                    if (seen[state]) continue;
                    seen[state] = true;
                    for (const std::size_t next : graph->successors[state]) open.push_back(next);
                }
                return seen;
            };
            const auto meets_goal = [&](const StateSet& states) {
                for (std::size_t state = 0; state < states.size(); ++state)
                    if (states[state] && goal[state]) return true;
                return false;
            };
            const std::vector<SystemState> ends = last_two(*system, result.runs[k].value());
            const StateSet dead = behind(ends.back());
            EXPECT_FALSE(meets_goal(dead));
            EXPECT_TRUE(ends.size() == 1 || meets_goal(behind(ends.front())));
            const auto note = std::ranges::find_if(verdict.notes,
                                                   [](const std::string& each) { return each.starts_with(dead_text); });
            const std::string words = (note == verdict.notes.end() ? "" : *note) + ",";
            for (const System::Controller& controller : system->controllers)
                for (const System::Named& transition : controller.words.transitions) {
                    bool cleared = false;
                    for (std::size_t state = 0; state < dead.size() && !cleared; ++state)
                        cleared = dead[state] &&
                                  (!controller.evolves.valid() ||
                                   value_of(*system, graph->states[state], controller.evolves) != 0) &&
                                  value_of(*system, graph->states[state],
                                           system->modules[system->main].symbols[transition.variable].name) != 0;
                    const std::string name =
                        " " + (system->controllers.size() > 1 ? controller.words.name + "." : "") + transition.name;
                    const bool named =
                        words.find(name + ",") != std::string::npos || words.find(name + " (") != std::string::npos;
                    EXPECT_EQ(named, !cleared) << name << ": " << words;
                    ++counts[named ? "never cleared again" : "cleared again"];
                }
        }
    }
    print_counts(counts);
    EXPECT_GT(counts["never cleared again"], 0);
    EXPECT_GT(counts["cleared again"], 0);
}

// -- a chart alone ----------------------------------------------------------------------------------------------------

/// Executes the chart evolution by evolution without the changes `left_out`; returns true if the chart becomes stable
/// in every instant of the run.
bool settles_without(const Chart& chart,
                     const std::vector<std::pair<std::int64_t, std::vector<std::int64_t>>>& instants,
                     const std::set<std::pair<std::size_t, std::size_t>>& left_out) {
    State state = power_on(chart);
    std::vector<std::int64_t> now(chart.variables.size());
    for (const Id<Chart::Variable> id : chart.variables.ids())
        now[id.index] = std::clamp<std::int64_t>(0, chart.variables[id].type.low, chart.variables[id].type.high);
    const std::vector<std::int64_t> rest = now;
    for (std::size_t k = 0; k < instants.size(); ++k) {
        const auto& before = k == 0 ? rest : instants[k - 1].second;
        for (std::size_t v = 0; v < now.size(); ++v)
            if (instants[k].second[v] != before[v] && !left_out.contains({k, v})) now[v] = instants[k].second[v];
        if (k > 0) state = pass_time(state, instants[k].first - instants[k - 1].first);
        bool stable = false;
        for (int evolutions = 0; !stable; ++evolutions) {
            const Evolution made = evolve(chart, state, now, time_conditions(chart, state));
            if (made.race || made.fault || evolutions > 300) return false;
            state = made.state;
            stable = made.stable;
        }
    }
    return true;
}

TEST(RandomizedExplainUntimed, FewestChangesWithoutWhichAChartIsStableAgreeWithEnumeration) {
    std::map<std::string, int> counts;
    for (int seed = 1; seed <= test_size(150); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        Model model;
        model.charts.add(random_chart(random));
        const Chart& chart = *model.charts.begin();
        Diagnostics diagnostics;
        CheckOptions options;
        options.properties = {"stabilises"};
        const auto report = check_untimed(model, Id<Chart>{0}, {ExecutionMode::StabilitySearch}, options, diagnostics);
        if (!report || report->answers.empty() || !report->answers[0].trace) continue;
        const ChartRun& run = *report->answers[0].trace;
        std::vector<std::pair<std::int64_t, std::vector<std::int64_t>>> instants;
        for (std::size_t moment = 1; moment < run.moments.size(); ++moment) {
            std::vector<std::int64_t> values(chart.variables.size());
            std::size_t place = 0;
            for (const Id<Chart::Variable> id : chart.variables.ids())
                if (chart.variables[id].kind == Chart::VariableKind::Input)
                    values[id.index] = run.moments[moment].after.values[run.controllers.begin()->inputs[place++].index];
                else
                    values[id.index] =
                        std::clamp<std::int64_t>(0, chart.variables[id].type.low, chart.variables[id].type.high);
            if (instants.empty() || instants.back() != std::pair(run.moments[moment].after.time_ms, values))
                instants.emplace_back(run.moments[moment].after.time_ms, values);
        }
        std::vector<std::pair<std::size_t, std::size_t>> events;
        for (std::size_t k = 0; k < instants.size(); ++k)
            for (const Id<Chart::Variable> v : chart.variables.ids()) {
                const Type& type = chart.variables[v].type;
                const std::int64_t before =
                    k == 0 ? std::clamp<std::int64_t>(0, type.low, type.high) : instants[k - 1].second[v.index];
                if (instants[k].second[v.index] != before) events.emplace_back(k, v.index);
            }
        if (events.size() > 6) continue;
        std::size_t least = events.size() + 1;
        for (std::size_t bits = 1; bits < std::size_t{1} << events.size(); ++bits) {
            std::set<std::pair<std::size_t, std::size_t>> left_out;
            for (std::size_t k = 0; k < events.size(); ++k)
                if ((bits >> k & 1U) != 0) left_out.insert(events[k]);
            if (settles_without(chart, instants, left_out)) least = std::min(least, left_out.size());
        }
        EXPECT_EQ(run.counterfactual_values.size(), least <= events.size() ? least : 0) << chart_text(chart);
        ++counts[least <= events.size() ? "becomes stable without" : "never becomes stable"];
    }
    print_counts(counts);
    EXPECT_GT(counts["becomes stable without"], 0);
}

}  // namespace
}  // namespace grafverif
