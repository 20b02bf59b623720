// SPDX-License-Identifier: MIT
// Randomized tests of PLC programs as controllers of closed loops. The verdicts of the timed engine agree with a search
// that steps the interpreter of programs and the automata of the plant. This search uses neither equations nor the
// network of the loop.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include "emit/uppaal/uppaal.hpp"
#include "grafverif/grafverif.hpp"
#include "plant/plant.hpp"
#include "run/program/interpreter.hpp"
#include "support/naive_tadd.hpp"
#include "support/random_scans.hpp"
#include "support/row_counts.hpp"
#include "support/test_size.hpp"
#include "support/uppaal_reader.hpp"

namespace grafverif {
namespace {

/// A random loop: its texts, and the rules that the search applies.
struct Case {
    RandomScans program = {};
    std::string loop = {};
    bool phased = false;
    std::int64_t least = 0, most = 0;  ///< bounds of the task cycle; 0: the cycle time is zero
};

constexpr const char* components = R"(
component toggle(output OUT; GAP = 2ms) {
    clock t;
    initial location idle;
    timed idle -> idle when t >= GAP do OUT := !OUT, t := 0;
}
component actuator(input ON; output DONE; D = 3ms) {
    clock t;
    initial location off;
    location moving invariant t <= D;
    location on with DONE := true;
    urgent off -> moving when ON do t := 0;
    urgent moving -> off when !ON;
    timed moving -> on when t == D do DONE := true;
    urgent on -> off when !ON do DONE := false;
}
)";

/// A state of the loop.
struct State {
    TaddState plant = {};
    ProgramRun run;
    int phase = -1;  ///< -1: before the first scan; 0: waiting; 1: scan begun; 2: inputs sampled; 3: program executed
    std::vector<std::int64_t> samples = {};
    std::int64_t since = 0;  ///< time since the last scan
    bool stable = false, requested = false;

    auto key() const {
        const std::vector<std::int64_t> cells(run.cells().begin(), run.cells().end());
        return std::tuple(plant, cells, phase, samples, since, stable, requested);
    }
};

class Search {
public:
    Search(const Case& of, const Program& program, const Network& plant) : case_(of), program_(program), tadd_(plant) {
        const ProgramRun run(program);
        for (std::size_t i = 0; i < run.layout().cells.size(); ++i) {
            const ProgramCell& cell = run.layout().cells[i];
            if (cell.input) inputs_.push_back(tadd_.variable_id(cell.name));
            if (cell.output) outputs_.emplace_back(tadd_.variable_id(cell.name), i);
        }
    }

    /// Visits every reachable state. Returns false if there are more than `most` states.
    bool run(std::size_t most, const std::function<void(const State&)>& visit) {
        add({tadd_.initial(), ProgramRun(program_)});
        for (; !open_.empty(); open_.pop_front()) {
            if (seen_.size() > most) return false;
            visit(open_.front());
            expand(State(open_.front()));
        }
        return true;
    }
    bool is_faulty() const { return faulty_; }
    std::size_t states() const { return seen_.size(); }

    std::int64_t value(const State& state, const std::string& name) const {
        const auto& cells = state.run.layout().cells;
        for (std::size_t i = 0; i < cells.size(); ++i)
            if (cells[i].name == name && !cells[i].input && !cells[i].output) return state.run.cells()[i];
        return tadd_.variable(state.plant, name);
    }
    bool is_at(const State& state, const std::string& process, const std::string& location) const {
        return tadd_.location(state.plant, process) == location;
    }

private:
    void add(State state) {
        if (seen_.insert(state.key()).second) open_.push_back(std::move(state));
    }

    bool timed() const { return case_.most > 0; }

    void expand(const State& from) {
        bool passes = false;
        for (TaddMove& move : tadd_.successors(from.plant)) {
            if (move.delay()) {
                passes = true;
                continue;
            }
            State next = from;
            next.requested = next.requested || requests(move);
            next.plant = std::move(move.next);
            add(std::move(next));
        }
        const bool waits = from.phase == 0 && (timed() || (from.stable && !from.requested));
        if (passes && waits && (!timed() || from.since < case_.most)) {
            State next = from;
            next.plant = tadd_.successors(from.plant).back().next;
            if (timed()) ++next.since;
            add(std::move(next));
        }
        step_plc(from);
    }

    bool requests(const TaddMove& move) const {
        const Network& network = tadd_.network();
        const Network::Process& process = network.processes[move.process];
        for (const auto& assignment : network.templates[process.automaton].edges[move.edge].assignments) {
            const auto parameter = static_cast<std::size_t>(network.exprs[assignment.target].value);
            const auto variable = std::get<Id<Network::Variable>>(process.arguments[parameter]);
            if (std::ranges::find(inputs_, variable) != inputs_.end()) return true;
        }
        return false;
    }

    void step_plc(State next) {
        switch (next.phase) {
        case -1:
            sample(next);
            if (!execute(next, 0)) return;
            return write(std::move(next));
        case 0:
            if (timed() ? next.since < case_.least : next.stable && !next.requested) return;
            next.requested = false;
            if (!case_.phased) {
                sample(next);
                if (!execute(next, case_.most)) return;
                return write(std::move(next));
            }
            break;
        case 1: sample(next); break;
        case 2:
            if (!execute(next, case_.most)) return;
            break;
        default: return write(std::move(next));
        }
        ++next.phase;
        add(std::move(next));
    }

    void sample(State& state) const {
        state.samples.clear();
        for (const Id<Network::Variable> input : inputs_) state.samples.push_back(state.plant.variables[input.index]);
    }

    bool execute(State& state, std::int64_t elapsed) {
        const std::vector<std::int64_t> before = kept(state);
        state.run.scan(state.samples, elapsed);
        state.samples.clear();
        if (state.phase >= 0) state.stable = kept(state) == before;
        faulty_ = faulty_ || state.run.fault();
        return !state.run.fault();
    }

    static std::vector<std::int64_t> kept(const State& state) {
        std::vector<std::int64_t> values;
        for (std::size_t i = 0; i < state.run.cells().size(); ++i) {
            const ProgramCell& cell = state.run.layout().cells[i];
            if (!cell.input && !cell.temporary && !cell.constant) values.push_back(state.run.cells()[i]);
        }
        return values;
    }

    void write(State next) {
        for (const auto& [variable, cell] : outputs_) next.plant.variables[variable.index] = next.run.cells()[cell];
        next.phase = 0;
        next.since = 0;
        add(std::move(next));
    }

    const Case& case_;
    const Program& program_;
    NaiveTadd tadd_;
    std::vector<Id<Network::Variable>> inputs_ = {};
    std::vector<std::pair<Id<Network::Variable>, std::size_t>> outputs_ = {};
    std::set<decltype(std::declval<State>().key())> seen_ = {};
    std::deque<State> open_ = {};
    bool faulty_ = false;
};

/// A condition as text of a property, and its value in a state of the search.
struct Condition {
    std::string text = {};
    std::function<bool(const Search&, const State&)> holds = {};
};

Condition random_literal(Random& random, const RandomScans& program) {
    const auto any = [&](const std::vector<std::string>& names) {
        return names[static_cast<std::size_t>(random_number(random, 0, static_cast<std::int64_t>(names.size()) - 1))];
    };
    if (chance(random, 15)) {
        const std::string location = any({"off", "moving", "on"});
        return {"M in " + location,
                [location](const Search& search, const State& state) { return search.is_at(state, "M", location); }};
    }
    if (chance(random, 20)) {
        const std::string name = any(program.integers);
        const std::int64_t number = random_number(random, -3, 3);
        return {fmt::format("{} == {}", name, number), [name, number](const Search& search, const State& state) {
                    return search.value(state, name) == number;
                }};
    }
    std::vector<std::string> names = program.booleans;
    names.insert(names.end(), {"a", "B", "q0", "q1"});
    const std::string name = any(names);
    const bool negated = chance(random, 50);
    return {(negated ? "!" : "") + (chance(random, 20) && name.find('.') != std::string::npos ? "p." + name : name),
            [name, negated](const Search& search, const State& state) {
                return (search.value(state, name) != 0) != negated;
            }};
}

std::vector<Condition> random_conditions(Random& random, const RandomScans& program) {
    std::vector<Condition> conditions;
    for (int i = 0; i < 6; ++i) {
        Condition one = random_literal(random, program), two = random_literal(random, program);
        const bool both = chance(random, 60);
        conditions.push_back({fmt::format("{} {} {}", one.text, both ? "&&" : "||", two.text),
                              [one, two, both](const Search& search, const State& state) {
                                  const bool first = one.holds(search, state), second = two.holds(search, state);
                                  return both ? first && second : first || second;
                              }});
    }
    return conditions;
}

Case random_case(Random& random, const std::vector<Condition>& conditions, RandomScans program, bool timers) {
    Case made{.program = std::move(program)};
    made.phased = chance(random, 50);
    const bool chart = made.program.text.find("STEP") != std::string::npos;
    if (timers || chart || chance(random, 60)) made.least = made.most = random_number(random, 1, 3);
    if (!made.program.timers && made.most > 0) made.most += random_number(random, 0, 1);
    std::string cycle;
    if (made.most > 0)
        cycle = made.least == made.most ? fmt::format(" every {}ms", made.least)
                                        : fmt::format(" every {}ms..{}ms", made.least, made.most);
    made.loop = fmt::format(
        "program p = \"p.st\";\n{}closed_loop l {{\n    controller p{};\n    grain {};\n    time unit 1ms;\n"
        "    environment A = toggle(OUT = a, GAP = {}ms);\n    plant M = actuator(ON = q0, DONE = B, D = {}ms);\n",
        components, cycle, made.phased ? "phased" : "atomic", random_number(random, 1, 3), random_number(random, 1, 3));
    for (std::size_t i = 0; i < conditions.size(); ++i)
        made.loop += fmt::format("    property never_{}: never {};\n    property reach_{}: reachable {};\n", i,
                                 conditions[i].text, i, conditions[i].text);
    made.loop += "}\n";
    return made;
}

class RandomizedProgramLoop : public testing::Test {
protected:
    void compare(int seed) {
        Random random(static_cast<unsigned>(seed));
        const bool timers = chance(random, 70);
        RandomScans program = random_scans(random, timers, 1);
        const auto conditions = random_conditions(random, program);
        const bool has_timers = program.timers;
        const Case made = random_case(random, conditions, std::move(program), has_timers);
        SCOPED_TRACE(fmt::format("seed {}\n{}\n{}", seed, made.program.text, made.loop));
        ReadOptions reading_options;
        reading_options.load = [&](const std::string&, std::string&) { return std::optional(made.program.text); };
        ParseResult reading = read_string(made.loop, "loop.grafcet", reading_options);
        ASSERT_TRUE(reading.model) << reading.diagnostics_text();
        const ClosedLoop& loop = reading.model->loops[{0}];
        const auto plant_network = plant(*reading.model, loop, reading.diagnostics);
        ASSERT_TRUE(plant_network);
        Search search(made, *reading.model->charts[{0}].program, *plant_network);
        std::vector<bool> met(conditions.size());
        const bool complete = search.run(20'000, [&](const State& state) {
            for (std::size_t i = 0; i < conditions.size(); ++i) met[i] = met[i] || conditions[i].holds(search, state);
        });
        ++seen_[complete ? "complete searches" : "searches that are too large"];
        if (!complete) return;
        const auto report = check(*reading.model, {0}, {}, {}, reading.diagnostics);
        ASSERT_TRUE(report) << reading.diagnostics_text();
        EXPECT_EQ(report->failures, std::vector<std::string>());
        EXPECT_EQ(!report->error_traces.empty(), search.is_faulty());
        for (std::size_t i = 0; i < conditions.size(); ++i) {
            expect(*report, fmt::format("never_{}", i), met[i] ? Outcome::Violated : Outcome::Holds,
                   search.is_faulty());
            expect(*report, fmt::format("reach_{}", i), met[i] ? Outcome::Holds : Outcome::Violated,
                   search.is_faulty());
        }
        count(made, search);
        if (!search.is_faulty() && seed % 3 == 0) compare_exports(*reading.model, conditions, met);
    }

    /// Compares the UPPAAL project and the model in discrete time with the network and with the search.
    void compare_exports(const Model& model, const std::vector<Condition>& conditions, const std::vector<bool>& met) {
        Diagnostics diagnostics;
        const auto network = network_of(model, {0}, ModelOptions{}, diagnostics);
        ASSERT_TRUE(network);
        Network lowered = uppaal::lower(*network);
        for (Network::Variable& variable : lowered.variables)  // names that are valid in UPPAAL without changes
            std::ranges::replace_if(
                variable.name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
        std::ostringstream project;
        uppaal::emit(lowered, project);
        EXPECT_EQ(test::comparable_text(test::read_uppaal(project.str())),
                  test::comparable_text(test::as_read_back(lowered)));
        ++seen_["UPPAAL projects"];
        ModelOptions discrete;
        discrete.untimed.plant = PlantApproach::Automata;
        discrete.untimed.time = TimeModel::Discrete;
        CheckOptions options{.witnesses = false};
        options.limits.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(2);
        const auto report = check_untimed(model, Id<ClosedLoop>{0}, discrete, options, diagnostics);
        if (!report) {  // a symbolic model supports at most 4096 values of a variable
            EXPECT_EQ(diagnostics.all().front().code, "too-wide") << diagnostics.all().front().message;
            return;
        }
        EXPECT_EQ(report->failures, std::vector<std::string>());
        for (const PropertyResult& answer : report->answers) {
            if (answer.verdict.outcome == Outcome::Unknown || !answer.verdict.property.starts_with("reach_")) continue;
            const std::size_t index = std::stoul(answer.verdict.property.substr(6));
            ASSERT_LT(index, conditions.size());
            EXPECT_EQ(answer.verdict.outcome == Outcome::Holds, met[index]) << conditions[index].text;
            ++seen_["verdicts in discrete time"];
        }
    }

    /// If `faulty`, a verdict about all states may be unknown, because it depends on states after a
    /// run-time fault.
    void expect(const Report& report, const std::string& name, Outcome outcome, bool faulty) {
        const auto answer =
            std::ranges::find(report.answers, name, [](const PropertyResult& one) { return one.verdict.property; });
        ASSERT_NE(answer, report.answers.end());
        ++seen_[std::string(word(answer->verdict.outcome))];
        if (answer->trace) ++seen_["replayed traces"];
        const bool universal = (outcome == Outcome::Holds) == name.starts_with("never");
        if (faulty && universal && answer->verdict.outcome == Outcome::Unknown) return;
        EXPECT_EQ(answer->verdict.outcome, outcome) << name << ": " << answer->verdict.reason;
    }

    void count(const Case& made, const Search& search) {
        ++seen_[made.program.timers ? "loops with timers" : "loops without timers"];
        ++seen_[made.most == 0 ? "cycle time zero" : made.least == made.most ? "fixed cycles" : "variable cycles"];
        ++seen_[made.phased ? "phased" : "atomic"];
        if (made.program.text.find("STEP") != std::string::npos) ++seen_["charts"];
        if (search.is_faulty()) ++seen_["faults"];
        seen_["states"] += static_cast<int>(search.states());
    }

    std::map<std::string, int> seen_ = {};
};

TEST_F(RandomizedProgramLoop, TimedEngineAgreesWithSearchThatStepsTheInterpreter) {
    const int cases = test_size(60);
    for (int seed = 1; seed <= cases && !HasFailure(); ++seed) compare(seed);
    print_counts(seen_);
    for (const char* what : {"loops with timers", "loops without timers", "cycle time zero", "fixed cycles",
                             "variable cycles", "phased", "atomic", "charts", "faults"})
        EXPECT_GT(seen_[what], 0) << what;
    EXPECT_GT(seen_["replayed traces"], cases);
    EXPECT_GT(seen_["UPPAAL projects"], 0);
    EXPECT_GT(seen_["verdicts in discrete time"], 0);
}

// -- charts and their Structured Text ---------------------------------------------------------------------------------

constexpr const char* level = R"(
component level(output OUT: int LOW..HIGH = START; LOW, HIGH, START, GAP = 2ms) {
    clock t;
    initial location idle;
    timed idle -> idle when t >= GAP && OUT < HIGH do OUT := OUT + 1, t := 0;
    timed idle -> idle when t >= GAP && OUT > LOW do OUT := OUT - 1, t := 0;
}
)";

/// Returns the loop of a controller that is declared by `declaration`, with one plant instance per input.
std::string loop_of(const Chart& chart, const std::string& declaration, const std::string& mode, Random random) {
    std::string text = declaration + components + level + "closed_loop l {\n    controller " + chart.name +
                       " every 2ms" + mode + ";\n    time unit 1ms;\n";
    std::vector<std::string> literals;
    for (const Chart::Variable& variable : chart.variables) {
        const bool input = variable.kind == Chart::VariableKind::Input;
        if (input && variable.type.boolean)
            text += fmt::format("    environment E_{0} = toggle(OUT = {0}, GAP = {1}ms);\n", variable.name,
                                random_number(random, 1, 3));
        else if (input)
            text += fmt::format("    environment E_{0} = level(OUT = {0}, LOW = {1}, HIGH = {2}, START = {3});\n",
                                variable.name, variable.type.low, variable.type.high, variable.initial);
        if (variable.kind == Chart::VariableKind::Internal) continue;
        for (const std::int64_t value : {std::int64_t{0}, std::int64_t{1}})
            literals.push_back(variable.type.boolean ? (value != 0 ? "" : "!") + variable.name
                                                     : fmt::format("{} == {}", variable.name, value));
    }
    for (int i = 0; i < 6 && !literals.empty(); ++i) {
        const auto any = [&] {
            return literals[static_cast<std::size_t>(
                random_number(random, 0, static_cast<std::int64_t>(literals.size()) - 1))];
        };
        const std::string condition = any() + " && " + any() + " && " + any();
        text += fmt::format("    property reach_{}: reachable {};\n    property soon_{}: {} leads to {};\n", i,
                            condition, i, any(), any());
    }
    return text + "}\n";
}

/// Returns the outcomes by property, or nothing if the loop is rejected, has model errors or is too large.
std::optional<std::map<std::string, Outcome>> outcomes(const std::string& loop, const std::string& program) {
    ReadOptions options;
    options.load = [&](const std::string&, std::string&) { return std::optional(program); };
    ParseResult reading = read_string(loop, "loop.grafcet", options);
    EXPECT_TRUE(reading.model) << reading.diagnostics_text() << loop << program;
    if (!reading.model) return {};
    CheckOptions check_options{.witnesses = false};
    check_options.limits.states = 60'000;
    const auto report = check(*reading.model, {0}, {}, check_options, reading.diagnostics);
    EXPECT_TRUE(report) << reading.diagnostics_text() << loop << program;
    if (!report || !report->error_traces.empty()) return {};
    EXPECT_EQ(report->failures, std::vector<std::string>());
    std::map<std::string, Outcome> found;
    for (const PropertyResult& answer : report->answers) {
        if (answer.verdict.outcome == Outcome::Unknown && answer.verdict.declared) return {};
        if (answer.verdict.declared && answer.verdict.property != "no_race")
            found[answer.verdict.property] = answer.verdict.outcome;
    }
    return found;
}

TEST(RandomizedProgramLoopText, ChartAndItsStructuredTextHaveEqualVerdicts) {
    std::map<std::string, int> seen;
    const int cases = test_size(60);
    for (int seed = 1; seed <= cases && !testing::Test::HasFailure(); ++seed) {
        Random random(static_cast<unsigned>(seed));
        const Chart chart = tidied(random_chart(random, TimedTerms::Steps));
        const bool timed = !chart.time_conditions.empty() ||
                           std::ranges::any_of(chart.continuous, [](const Chart::ContinuousAction& action) {
                               return action.delay_ms > 0 || action.limit_ms > 0;
                           });
        if (timed || !read_string(chart_text(chart), "chart.grafcet").model) continue;
        Model model;
        const Id<Chart> id = model.charts.add(chart);
        Diagnostics diagnostics;
        const auto equations = equations_of(model, id, diagnostics);
        if (!equations) continue;
        const auto text = structured_text_of(*equations, ExecutionMode::EveryCycle, diagnostics);
        if (!text) continue;
        const auto of_chart = outcomes(loop_of(chart, chart_text(chart), " with every_cycle", random), "");
        if (!of_chart) continue;
        const std::string declaration = "program " + chart.name + " = \"chart.st\";\n";
        const auto of_text = outcomes(loop_of(chart, declaration, "", random), *text);
        if (!of_text) {
            ++seen["texts with too many states"];
            continue;
        }
        EXPECT_EQ(*of_text, *of_chart) << "seed " << seed << '\n' << chart_text(chart) << *text;
        for (const auto& [name, outcome] : *of_chart) ++seen[outcome == Outcome::Holds ? "holds" : "violated"];
        ++seen["charts"];
    }
    print_counts(seen);
    for (const char* what : {"charts", "holds", "violated"}) EXPECT_GT(seen[what], 0) << what;
    EXPECT_LT(seen["texts with too many states"], seen["charts"]);
}

}  // namespace
}  // namespace grafverif
