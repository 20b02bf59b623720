// SPDX-License-Identifier: MIT
// Tests localization: the fragments of a network, hand-written abstractions, and the results of searches.
#include "check/localization/localization.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "check/localization/faults.hpp"
#include "check/shares.hpp"
#include "support/read_loop.hpp"
#include "unit/check/networks.hpp"

namespace grafverif {
namespace {

Network line() { return expand(read_sample("transfer_line/transfer_line.grafcet").network); }

/// Checks the network by localization without a preceding search of the complete network, which would decide the
/// property.
TimedResult by_cells(const Network& network, TimedOptions options = {}) {
    options.max_states = 100'000;
    return check_timed_by_cells(network, options, {.whole = 10, .local = 100'000});
}

TEST(Localization, FragmentIsAPartialChartWithItsExclusiveInstances) {
    const Network network = line();
    const NetworkFragments cells = cells_of(network);
    EXPECT_EQ(cells.names, (std::vector<std::string>{"cell[1]", "cell[2]", "cell[3]", "Buffer[1]", "Buffer[2]"}));
    const auto cell_of = [&](const std::string& process) {
        for (const Id<Network::Process> id : network.processes.ids())
            if (network.processes[id].name == process) return cells.of_process[id.index];
        return NetworkFragments::none;
    };
    EXPECT_EQ(cell_of("Clamp_Sen[2]"), 1U);
    EXPECT_EQ(cell_of("Bringer"), 0U) << "through Buffer[0]";
    EXPECT_EQ(cell_of("PLC"), NetworkFragments::none);
}

TEST(Localization, AbstractionKeepsItsFragmentAndTheEffectsOfTheRest) {
    const Network network = line();
    const NetworkFragments cells = cells_of(network);
    const LocalNetwork local = localized(network, cells, {1}, {});
    ASSERT_TRUE(local.made);
    EXPECT_EQ(verify(local.network), std::vector<std::string>{});
    std::vector<std::string> names;
    for (const Network::Process& process : local.network.processes) names.push_back(process.name);
    EXPECT_EQ(names, (std::vector<std::string>{"Clamp[2]", "Clamp_Sen[2]", "Drill[2]", "Drill_Sen[2]", "PLC", "rest"}));
    EXPECT_EQ(local.borders, (std::vector<std::uint32_t>{3, 4})) << "the buffers";
    EXPECT_EQ(local.tied, (std::vector<std::uint32_t>{0, 2, 3, 4})) << "the charts are included because of `stable`";
    EXPECT_EQ(local.network.templates[{5}].edges.size(), 1U) << "this edge causes a cycle of the PLC";
}

TEST(Localization, FragmentOfAPlcWithManyTimersIsSearched) {
    std::string text =
        "grafcet c {\ninput E; output L;\npartial GS { initial step S0; step S1 { force GP := {}; } "
        "transition s0: S0 -> S1 when E; transition s1: S1 -> S0 when !E; }\npartial GP {\n";
    for (int step = 0; step < 6; ++step) {
        const std::string name = std::to_string(step), next = std::to_string((step + 1) % 6);
        text += (step == 0 ? "initial step " : "step ") + name + ";\ntransition t" + name + ": " + name + " -> " +
                next + " when 1s/X" + name + ";\n";
    }
    text +=
        "}\n}\nclosed_loop station {\ncontroller c;\nenvironment Stop = push_button(OUT = E);\n"
        "property one: exactly one of {GS.XS0, GS.XS1};\n}\n";
    const Verdict found = verdict(by_cells(expand(read_loop(text).network)), "one");
    EXPECT_EQ(found.outcome, Outcome::Holds);
    EXPECT_EQ(found.scope.searched, std::vector<std::string>{"GS"});
}

TEST(Localization, UrgentEdgeStopsTimeOnlyIfEveryFreeValueEnablesIt) {
    Sketch s;
    const auto x = s.boolean("x"), done = s.boolean("done");
    const auto a = s.process("A", 1), b = s.process("B", 2, 1);
    s.edge(a, {.set = {{x, s.no(s.is(x))}}});
    s.edge(b, {.urgent = true, .guard = s.is(x), .set = {{done, s.yes()}}});
    s.edge(b, {.to = 1, .when = {{0, Op::GreaterEqual, 2}}});
    s.property("late", Pattern::Never, {s.at(b, 1)});
    s.property("p", Pattern::Reachable, {s.at(b, 1)});
    const Network network = expand(s.network);
    const LocalNetwork local = localized(network, cells_of(network), {1}, {});
    for (const Network::Template& automaton : local.network.templates)
        for (const Network::Edge& edge : automaton.edges) EXPECT_FALSE(edge.urgent);
    EXPECT_EQ(outcome_text(by_cells(network), "late"), outcome_text(check_timed(network), "late"));
    EXPECT_EQ(outcome_text(by_cells(network), "p"), "holds");
}

TEST(Localization, PropertyGuaranteedByANeighbourAddsTheNeighbour) {
    Sketch s;
    const auto x = s.boolean("x"), y = s.boolean("y");
    const auto a = s.process("A", 2, 1), b = s.process("B", 1), c = s.process("C", 1, 1);
    // The edge that writes x is never enabled.
    s.edge(a, {.to = 1, .when = {{0, Op::GreaterEqual, 1}}});
    s.edge(a, {.from = 1, .guard = s.network.exprs.constant(false), .set = {{x, s.yes()}}});
    s.edge(b, {.guard = s.is(x), .set = {{y, s.yes()}}});
    s.edge(c, {.when = {{0, Op::Equal, 1}}, .reset = {0}});
    s.edge(c, {.when = {{0, Op::Equal, 2}}, .reset = {0}});
    s.property("never_y", Pattern::Never, {s.is(y)});
    const Verdict found =
        verdict(check_timed_by_cells(expand(s.network), {}, {.whole = 2, .local = 100}, {}, check_timed), "never_y");
    EXPECT_EQ(found.outcome, Outcome::Holds);
    EXPECT_EQ(found.scope.searched, (std::vector<std::string>{"A", "B"}));
    EXPECT_EQ(found.scope.left_out, (std::vector<std::string>{"C"}));
}

TEST(Localization, LocalizationLeavesTimeForTheCompleteSearchAndIsMentionedIfThatIsStopped) {
    Sketch s;
    const auto x = s.boolean("x");
    const auto a = s.process("A", 1, 1), b = s.process("B", 2, 1), c = s.process("C", 1, 1);
    s.edge(a, {.when = {{0, Op::Equal, 1}}, .set = {{x, s.no(s.is(x))}}, .reset = {0}});
    s.edge(b, {.to = 1, .guard = s.is(x)});
    s.edge(c, {.when = {{0, Op::Equal, 2}}, .reset = {0}});
    s.property("never_there", Pattern::Never, {s.at(b, 1)});
    const auto now = std::chrono::steady_clock::now();
    TimedOptions options;
    options.deadline = now + std::chrono::hours(1);
    EXPECT_LT(*share_of(options.deadline, 3), now + std::chrono::minutes(25));
    std::vector<Deadline> deadlines;
    const auto whole = [&](const Network& network, TimedOptions how) {
        deadlines.push_back(how.deadline);
        if (deadlines.size() > 1) how.deadline = now;  // the second search has no time left
        return check_timed(network, how);
    };
    const TimedResult found = check_timed_by_cells(expand(s.network), options, {.whole = 2, .local = 100}, {}, whole);
    EXPECT_EQ(deadlines, (std::vector<Deadline>{options.deadline, options.deadline}));
    const Verdict& verdict = grafverif::verdict(found, "never_there");
    EXPECT_EQ(verdict.obstacle, UnknownReason::Stopped);
    EXPECT_EQ(verdict.reason, "stopped after 4 states; localization explored 14 states before this search");
}

TEST(Localization, InvariantOfANeighbourExcludesItsViolation) {
    Sketch s;
    const auto x = s.boolean("x"), y = s.boolean("y"), z = s.boolean("z");
    const auto a = s.process("A", 1, 1), b = s.process("B", 1), c = s.process("C", 1, 1);
    s.edge(a, {.when = {{0, Op::GreaterEqual, 1}}, .set = {{x, s.no(s.is(x))}, {y, s.is(x)}}, .reset = {0}});
    s.edge(b, {.guard = s.op(Op::NotEqual, s.is(x), s.is(y)), .set = {{z, s.yes()}}});
    s.edge(c, {.when = {{0, Op::Equal, 1}}, .reset = {0}});
    s.property("as_one", Pattern::Always, {s.op(Op::Equal, s.is(x), s.is(y))});
    s.property("never_z", Pattern::Never, {s.is(z)});
    const TimedResult found = check_timed_by_cells(expand(s.network), {}, {.whole = 2, .local = 100}, {}, check_timed);
    EXPECT_EQ(outcome_text(found, "as_one"), outcome_text(check_timed(s.network), "as_one"));
    EXPECT_EQ(outcome_text(found, "never_z"), "holds");
    const SearchScope scope = verdict(found, "never_z").scope;
    EXPECT_EQ(scope.searched, std::vector<std::string>{"B"});
    EXPECT_EQ(scope.because,
              "may have any behaviour that satisfies the proved property as_one; this is an over-approximation");
}

TEST(Localization, SmallSearchDoesNotWaitForALargeOne) {
    Sketch s;
    const auto n = s.integer("n", 0, 199), m = s.integer("m", 0, 199);
    const auto x = s.boolean("x"), y = s.boolean("y");
    const auto a = s.process("A", 1), b = s.process("B", 1, 1), c = s.process("C", 1, 1);
    for (const auto variable : {n, m})
        s.edge(a, {.guard = s.op(Op::Less, s.is(variable), s.number(199)),
                   .set = {{variable, s.op(Op::Plus, s.is(variable), s.number(1))}}});
    s.edge(b, {.when = {{0, Op::GreaterEqual, 1}}, .set = {{x, s.no(s.is(x))}, {y, s.is(x)}}, .reset = {0}});
    s.edge(c, {.when = {{0, Op::Equal, 1}}, .reset = {0}});
    s.property("large", Pattern::Never, {s.op(Op::Greater, s.op(Op::Plus, s.is(n), s.is(m)), s.number(398))});
    s.property("small", Pattern::Always, {s.op(Op::Equal, s.is(x), s.is(y))});
    const TimedOptions options;
    CellSearch search(expand(s.network), options, {.whole = 2}, {}, check_timed);
    search.begin();
    const auto outcome = [&](const char* property) { return verdict(search.found(), property).outcome; };
    EXPECT_EQ(outcome("small"), Outcome::Holds);
    EXPECT_EQ(outcome("large"), Outcome::Unknown);
    const std::uint64_t states = search.found().states;
    EXPECT_TRUE(search.refine(search_rounds[0], {})) << "an earlier round had the same bound";
    EXPECT_EQ(search.found().states, states);
    EXPECT_TRUE(search.refine(search_rounds[1], std::chrono::steady_clock::now())) << "no time is left";
    EXPECT_EQ(outcome("large"), Outcome::Unknown);
    EXPECT_FALSE(search.refine(search_rounds[2], {}));
    EXPECT_EQ(outcome("large"), Outcome::Holds);
}

TEST(Localization, NoVerdictIfAnotherFragmentMayHaveAModelError) {
    Sketch s;
    const auto x = s.boolean("x"), wake = s.boolean("wake");
    const auto n = s.integer("n", 0, 2);
    const auto a = s.process("A", 1, 1), b = s.process("B", 1, 1);
    s.edge(a, {.when = {{0, Op::GreaterEqual, 1}}, .set = {{x, s.no(s.is(x))}, {wake, s.yes()}}, .reset = {0}});
    s.edge(b, {.guard = s.is(x),
               .when = {{0, Op::GreaterEqual, 1}},
               .set = {{n, s.op(Op::Plus, s.is(n), s.number(1))}},
               .reset = {0}});
    s.property("x", Pattern::Always, {s.network.exprs.disjunction(s.is(x), s.no(s.is(x)))});
    s.property("at", Pattern::Always, {s.at(a, 0)});
    EXPECT_EQ(cells_that_may_err(expand(s.network), cells_of(expand(s.network))), std::set<std::uint32_t>{1});
    const TimedResult found = by_cells(s.network);
    EXPECT_EQ(outcome_text(found, "at"), "unknown (faulty)");
    EXPECT_EQ(found.errors.size(), 1U);
}

TEST(Localization, GuardThatKeepsAValueInRangeIsDetected) {
    Sketch s;
    const auto n = s.integer("n", 0, 2), m = s.integer("m", 0, 2);
    const auto a = s.process("A", 1);
    s.edge(a, {.guard = s.op(Op::Less, s.is(n), s.number(2)), .set = {{n, s.op(Op::Plus, s.is(n), s.number(1))}}});
    EXPECT_TRUE(cells_that_may_err(expand(s.network), cells_of(expand(s.network))).empty());
    s.edge(a, {.guard = s.op(Op::Less, s.is(m), s.number(2)),  // m := 2 makes this bound useless
               .set = {{m, s.number(2)}, {n, s.is(m)}, {m, s.op(Op::Plus, s.is(m), s.number(1))}}});
    EXPECT_EQ(cells_that_may_err(expand(s.network), cells_of(expand(s.network))).size(), 1U);
    EXPECT_TRUE(terms_have_values(expand(s.network)));
    s.edge(a, {.set = {{n, s.op(Op::Divide, s.number(2), s.is(m))}}});
    EXPECT_FALSE(terms_have_values(expand(s.network)));
}

/// Returns a network of three periodic clocks with the property that `race` is never true. If `by_b`, process B has an
/// edge that sets `race` if `x` is true, and an edge that would set `x` but is never enabled; otherwise no edge sets
/// `race`.
Network may_race(bool by_b) {
    Sketch s;
    const auto race = s.boolean("race"), x = s.boolean("x");
    s.network.race = race;
    for (const char* name : {"A", "B", "C"}) {
        const auto process = s.process(name, 1, 1);
        s.edge(process, {.when = {{0, Op::GreaterEqual, 1}}, .reset = {0}});
        s.edge(process, {.when = {{0, Op::GreaterEqual, 2}}, .reset = {0}});
        if (*name == 'B' && by_b) {
            s.edge(process, {.guard = s.is(x), .set = {{race, s.network.exprs.disjunction(s.is(race), s.is(x))}}});
            s.edge(process, {.guard = s.network.exprs.constant(false), .set = {{x, s.yes()}}});
        }
    }
    s.property("none", Pattern::Never, {s.is(race)});
    return expand(s.network);
}

TEST(Localization, RaceVerdictNamesTheSearchedFragmentsAndTheReason) {
    for (const bool by_b : {false, true}) {
        const Verdict found =
            verdict(check_timed_by_cells(may_race(by_b), {}, {.whole = 3, .local = 100}, {}, check_timed), "none");
        EXPECT_EQ(found.outcome, Outcome::Holds);
        EXPECT_TRUE(found.scope.cells);
        EXPECT_EQ(found.scope.searched, by_b ? std::vector<std::string>{"B"} : std::vector<std::string>{});
        EXPECT_EQ(found.scope.left_out,
                  by_b ? (std::vector<std::string>{"A", "C"}) : (std::vector<std::string>{"A", "B", "C"}));
        EXPECT_EQ(found.scope.because, "cannot have a model error");
        EXPECT_EQ(found.states.empty(), !by_b) << found.states;
    }
}

TEST(Localization, VerdictsNoteHowFarTimelocksWereSearched) {
    const auto note = [](const TimedResult& result, const char* property) {
        const std::vector<std::string>& notes = verdict(result, property).notes;
        return notes.empty() ? "" : notes.back();
    };
    const std::string looked = "timelocks were searched only in the first ";
    TimedResult found = by_cells(line(), {.properties = {"held[2]"}});
    EXPECT_EQ(outcome_text(found, "no_timelock"), "unknown (bound)");
    EXPECT_EQ(note(found, "held[2]"),
              looked + verdict(found, "no_timelock").states + " states; declare `no timelock` to search all states");
    found = by_cells(read_sample("testing_station/testing_station.grafcet").network);
    for (const Verdict& each : found.verdicts)
        for (const std::string& said : each.notes) EXPECT_FALSE(said.starts_with(looked)) << each.property;
}

TEST(Localization, ResultsOfTheFirstSearchRemainIfTheNextIsStopped) {
    Sketch s;
    const auto x = s.boolean("x"), y = s.boolean("y");
    for (const auto variable : {x, y}) {
        const auto process = s.process(variable == x ? "A" : "B", 1, 1);
        s.edge(process, {.when = {{0, Op::GreaterEqual, 1}}, .set = {{variable, s.no(s.is(variable))}}, .reset = {0}});
        s.edge(process, {.guard = s.is(x), .when = {{0, Op::Equal, 1}}, .set = {{variable, s.no(s.is(y))}}});
    }
    s.property("soon", Pattern::Never, {s.is(x)});
    s.property("in_the_end", Pattern::Inevitable, {s.is(y)});
    const std::atomic<bool> stop = true;
    int looks = 0;
    const WholeSearch stopped_then = [&](const Network& network, TimedOptions options) {
        if (++looks > 1) options.stop = &stop;
        return check_timed(network, options);
    };
    const TimedResult found = check_timed_by_cells(s.network, {}, {.whole = 5, .local = 5}, {}, stopped_then);
    EXPECT_EQ(looks, 2);
    EXPECT_EQ(outcome_text(found, "soon"), "violated");
    EXPECT_EQ(outcome_text(found, "in_the_end"), "unknown (stopped)");
}

TEST(Localization, UnrequestedVerdictDoesNotNeedTheCompleteNetwork) {
    const TimedResult found = by_cells(line(), {.properties = {"held[2]"}});
    EXPECT_EQ(outcome_text(found, "held[2]"), "holds");
    EXPECT_FALSE(verdict(found, "no_timelock").declared);
    EXPECT_EQ(verdict(found, "no_timelock").outcome, Outcome::Unknown);
}

TEST(Localization, NumberOfTransitionsOfASearchIsLimited) {
    const TimedResult limited = check_timed(line(), {.max_transitions = 1000, .timelock = false});
    EXPECT_FALSE(limited.complete);
    EXPECT_GE(limited.transitions, 1000U);
    EXPECT_LT(limited.transitions, 1200U) << "the edges of the last expanded state";
    const auto scope_of = [](std::uint64_t transitions) {
        const TimedResult found = check_timed_by_cells(line(), {.properties = {"held[2]"}, .max_states = 100'000},
                                                       {.whole = 10, .local = 100'000, .transitions = transitions});
        return verdict(found, "held[2]").scope.cells;
    };
    EXPECT_TRUE(scope_of(8));
    EXPECT_TRUE(scope_of(0)) << "the last round has no such limit";
}

}  // namespace
}  // namespace grafverif
