// SPDX-License-Identifier: MIT
// Compares `tune` with separate checks of the model at each point, by the public interface, on random closed loops with
// constants. The constants occur as lower bounds, upper bounds and exact times of components, as ranges of variables,
// and as numbers and durations in properties. Some values cause timelocks and deadlocks.
#include "pipeline/variants/tune.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <random>

#include "explain/violation.hpp"
#include "grafverif/grafverif.hpp"
#include "report/charts/tuning.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

const char* const components = R"(
component late(input G; output OUT; LOW = 1s, HIGH = 1s) {
    clock t;
    initial location idle;
    location moving invariant t <= HIGH;
    location moved with OUT := true;
    urgent idle -> moving when G do t := 0;
    timed moving -> moved when t >= LOW do OUT := true;
    urgent moved -> idle when !G do OUT := false;
}
component window(input G; output OUT; LOW = 1s, HIGH = 1s) {
    clock t;
    initial location idle;
    location open;
    location hit with OUT := true;
    urgent idle -> open when G do t := 0;
    timed open -> hit when t >= LOW && t <= HIGH do OUT := true;
    urgent open -> idle when !G;
    urgent hit -> idle when !G do OUT := false;
}
component tally(input G; output N: int 0..TOP = 0, FULL; TOP = 2, PERIOD = 1s) {
    clock t;
    initial location idle;
    location counting invariant t <= PERIOD;
    urgent idle -> counting when G && N < TOP do t := 0;
    timed counting -> idle when t == PERIOD && N + 1 < TOP do N := N + 1;
    timed counting -> idle when t == PERIOD && N + 1 >= TOP do N := TOP, FULL := true;
}
component brief(input G; output OUT; LOW = 1s, HIGH = 1s) {
    clock t;
    initial location idle;
    location moving invariant t < HIGH;
    location moved with OUT := true;
    urgent idle -> moving when G do t := 0;
    timed moving -> moved when t > LOW do OUT := true;
    urgent moved -> idle when !G do OUT := false;
}
component spill(input G; output N: int 0..2 = 0; PERIOD = 1s) {
    clock t;
    initial location idle;
    location running invariant t <= PERIOD;
    urgent idle -> running when G do t := 0;
    timed running -> idle when t == PERIOD do N := N + 1;
}
)";

using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t count) { return random() % count; }

template <class List>
auto one_of(Random& random, const List& list) {
    return list[below(random, std::size(list))];
}

/// Returns a loop with the constants A, B (durations) and N (a number).
std::string random_text(Random& random) {
    const std::vector<std::string> times{"A", "B", "A", "B", "2s", "3s"};
    const auto time = [&] { return one_of(random, times); };
    const std::vector<std::string> conditions{"START",     "!START",      "D1",           "!D1",   "D2",
                                              "FULL",      "rise(START)", "2s/X1",        "1s/X2", "true",
                                              "D1 && !D2", "D1 || D2",    "START && !D1", "3s/X1"};
    const auto condition = [&] { return one_of(random, conditions); };
    std::string text = std::string(components) + "grafcet chart {\n    input START, D1, D2, FULL;\n    output P, Q;\n";
    const std::vector<std::string> actions{"", "{ P; }", "{ Q; }", "{ P; Q; }"};
    text += "    initial step 0;\n";
    for (int step = 1; step <= 2; ++step) {
        const std::string action = one_of(random, actions);
        text += fmt::format("    step {}{}\n", step, action.empty() ? ";" : " " + action);
    }
    text += fmt::format("    transition t0: 0 -> 1 when {};\n    transition t1: 1 -> 2 when {};\n", condition(),
                        condition());
    text += fmt::format("    transition t2: 2 -> 0 when {};\n", condition());
    text += "}\nclosed_loop loop {\n    controller chart;\n    constant A = 2s, B = 3s, N = 2;\n";
    text += fmt::format("    environment S = push_button(OUT = START, GAP = {});\n", time());
    text += fmt::format("    plant L = {}(G = P, OUT = D1, LOW = {}, HIGH = {});\n",
                        below(random, 2) == 0 ? "late" : "window", time(), time());
    text += fmt::format("    plant M = {}(G = Q, OUT = D2, LOW = {}, HIGH = {});\n",
                        one_of(random, std::vector<std::string>{"window", "late", "late", "brief"}), time(), time());
    text += fmt::format("    plant T = tally(G = P, N = COUNT, FULL = FULL, TOP = {}, PERIOD = {});\n",
                        below(random, 2) == 0 ? "N" : "2", time());
    if (below(random, 6) == 0) text += fmt::format("    plant E = spill(G = Q, N = SPILT, PERIOD = {});\n", time());
    const std::vector<std::string> states{"P",  "Q",      "X0",        "X1",         "X2",       "D1",
                                          "D2", "P && Q", "COUNT > N", "COUNT == 1", "D1 && D2", "P && !D1"};
    const auto state = [&] { return one_of(random, states); };
    int number = 0;
    const auto property = [&](const std::string& what) {
        text += fmt::format("    property p{}: {};\n", ++number, what);
    };
    property("never " + state() + " && " + state());
    property("always " + state() + " || " + state());
    property("reachable " + state() + " && " + state());
    property(state() + " leads to " + state());
    property("inevitable " + state());
    property("no deadlock");
    property("exactly one of {X0, X1, X2}");
    if (below(random, 3) == 0) property("always possible " + state());
    if (below(random, 2) == 0) property(fmt::format("{} leads to {} within {}", state(), state(), time()));
    if (below(random, 3) == 0) property(fmt::format("{} holds for {}", state(), time()));
    if (below(random, 3) == 0) property("never " + state() + " at stable");
    if (below(random, 3) == 0) property("reachable all steps");
    if (below(random, 5) == 0) property("no timelock at stable");
    return text + "}\n";
}

struct Read {
    ParseResult result = {};
    Id<ClosedLoop> loop = {};
};

std::optional<Read> read(const std::string& text, const std::map<std::string, std::string>& constants) {
    Read made{read_string(text, "loop.grafcet", {.constants = constants})};
    if (!made.result.model) return {};
    made.loop = *find_loop(*made.result.model, "loop");
    return made;
}

struct Seen {
    int loops = 0, verdicts = 0, holds = 0, violated = 0, fewer = 0, faulty = 0, runs = 0, watched_runs = 0, traces = 0;
    std::size_t points = 0, checks = 0;
};

std::optional<Tuning> tuned_at(const Read& read, const std::vector<TunedConstant>& constants, bool every_point,
                               unsigned jobs) {
    Diagnostics diagnostics;
    const TuneRequest request{.constants = constants, .jobs = jobs, .runs = 1000, .every_point = every_point};
    return tuned(*read.result.model, read.loop, *read.result.sources.ids().begin(), read.result.sources, request,
                 diagnostics);
}

/// Checks the run at a point: it must belong to a violated property. If the property has an observer, the run must
/// violate the property with the values of the constants at this point. The command has already replayed each run on
/// the charts of its point.
void compare_run(const Tuning::Row& row, std::size_t point, const Read& at, Seen& seen) {
    const auto found = row.runs.find(point);
    if (found == row.runs.end()) return;
    ++seen.runs;
    EXPECT_EQ(word(row.verdicts[point].outcome), "violated") << row.property;
    ASSERT_TRUE(found->second.trace.has_value());
    for (const Property& property : at.result.model->loops[at.loop].properties) {
        if (property.name != row.property || property.pattern != Pattern::Watched) continue;
        ++seen.watched_runs;
        EXPECT_TRUE(violation_of(property.watch, {"a", "b"}, *found->second.trace).has_value()) << row.property;
    }
}

/// Compares the verdicts with those of a separate check of each point.
void compare_with_checks(const std::string& text, const Tuning& tuning, Seen& seen) {
    for (std::size_t point = 0; point < tuning.points; ++point) {
        std::map<std::string, std::string> constants;
        const auto indices = tuning.indices(point);
        for (std::size_t k = 0; k < indices.size(); ++k)
            constants[tuning.constants[k].name] =
                value_text(tuning.constants[k], tuning.constants[k].value(indices[k]));
        auto at = read(text, constants);
        ASSERT_TRUE(at.has_value());
        const auto report = check(*at->result.model, at->loop, {}, {.jobs = 1}, at->result.diagnostics);
        ASSERT_TRUE(report.has_value());
        ASSERT_EQ(report->answers.size(), tuning.rows.size());
        for (std::size_t row = 0; row < tuning.rows.size(); ++row) {
            const Verdict& verdict = report->answers[row].verdict;
            ASSERT_EQ(verdict.property, tuning.rows[row].property);
            if (verdict.obstacle == UnknownReason::Inexact) continue;  // the time unit of `tune` may be finer
            EXPECT_EQ(word(tuning.rows[row].verdicts[point].outcome), word(verdict.outcome))
                << verdict.property << " at " << point_text(tuning, point) << ": " << verdict.reason;
            compare_run(tuning.rows[row], point, *at, seen);
            if (verdict.outcome == Outcome::Violated && report->answers[row].trace) ++seen.traces;
            ++seen.verdicts;
            seen.holds += verdict.outcome == Outcome::Holds ? 1 : 0;
            seen.violated += verdict.outcome == Outcome::Violated ? 1 : 0;
            seen.faulty += verdict.obstacle == UnknownReason::Faulty ? 1 : 0;
        }
    }
}

void compare(std::uint64_t seed, Seen& seen) {
    Random random(seed);
    const std::string text = random_text(random);
    const auto model = read(text, {});
    ASSERT_TRUE(model.has_value());
    const NamedConstant::Kind duration = NamedConstant::Kind::Duration;
    std::vector<TunedConstant> constants;
    if (below(random, 4) != 0) constants.push_back({"A", duration, 1000, 5000, 1000, 2000});
    if (constants.empty() || below(random, 2) == 0) constants.push_back({"B", duration, 500, 3500, 1500, 3000});
    else constants.push_back({"N", NamedConstant::Kind::Integer, 1, 3, 1, 2});
    const auto tuning = tuned_at(*model, constants, false, 1);
    ASSERT_TRUE(tuning.has_value());
    EXPECT_EQ(tuning->failures, std::vector<std::string>{});
    compare_with_checks(text, *tuning, seen);
    const auto parallel = tuned_at(*model, constants, false, 3);
    for (std::size_t row = 0; row < tuning->rows.size(); ++row)
        EXPECT_EQ(tuning->rows[row].verdicts, parallel->rows[row].verdicts);
    EXPECT_EQ(tuning->checks, parallel->checks);
    ++seen.loops;
    seen.points += tuning->points;
    seen.checks += tuning->checks;
    seen.fewer += tuning->checks < tuning->points ? 1 : 0;
    if (testing::Test::HasFailure()) std::printf("%s\n", text.c_str());
}

TEST(RandomizedTune, EveryVerdictIsTheVerdictOfASeparateCheck) {
    Seen seen;
    const int cases = test_size(24);
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(cases); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        compare(seed, seen);
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(seen.fewer, cases / 4);
    EXPECT_GT(seen.holds, seen.verdicts / 10);
    EXPECT_GT(seen.violated, seen.verdicts / 10);
    EXPECT_EQ(seen.runs, seen.traces) << "each violation that has a run in a separate check has one";
    EXPECT_GT(seen.watched_runs, 0);
    if (std::getenv("GRAFVERIF_TEST_COUNTS") != nullptr)
        std::printf(
            "%d loops, %zu points, %zu checks, %d with fewer checks; %d verdicts, %d hold, %d violated, %d faulty\n",
            seen.loops, seen.points, seen.checks, seen.fewer, seen.verdicts, seen.holds, seen.violated, seen.faulty);
}

}  // namespace
}  // namespace grafverif
