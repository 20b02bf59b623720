// SPDX-License-Identifier: MIT
// Tests the timed engine on a small network for each kind of property, and for each reason for an unknown verdict.
#include "check/timed/timed.hpp"

#include <gtest/gtest.h>

#include "unit/check/networks.hpp"

namespace grafverif {
namespace {

using Moves = std::vector<Move>;

Fire fire(std::uint32_t process, std::uint32_t edge) { return {{process}, {edge}}; }

std::optional<Run> shown(Moves moves, std::optional<std::size_t> loop = {}) { return Run{std::move(moves), loop}; }

/// A switch that may be operated every two units, and a lamp that follows it immediately.
struct Lamp {
    Sketch s = {};
    Id<Network::Variable> on = s.boolean("on"), lit = s.boolean("lit");
    Id<Network::Process> hand = s.process("hand", 1, 1), bulb = s.process("bulb", 2);

    Lamp() {
        s.edge(hand, {.when = {{0, Op::GreaterEqual, 2}}, .set = {{on, s.no(s.is(on))}}, .reset = {0}});
        s.edge(bulb, {.from = 0, .to = 1, .urgent = true, .guard = s.is(on), .set = {{lit, s.yes()}}});
        s.edge(bulb, {.from = 1, .to = 0, .urgent = true, .guard = s.no(s.is(on)), .set = {{lit, s.no(s.yes())}}});
        s.network.settled = s.op(Op::Equal, s.is(on), s.is(lit));
    }
};

TEST(TimedEngine, DecidesPropertiesOfSingleStates) {
    Lamp lamp;
    Sketch& s = lamp.s;
    const Id<Expr> follows = s.op(Op::Equal, s.is(lamp.on), s.is(lamp.lit));
    s.property("follows", Pattern::Always, {follows});
    s.property("follows_at_stable", Pattern::Always, {follows}, true);
    s.property("never_lit", Pattern::Never, {s.is(lamp.lit)});
    s.property("can_be_lit", Pattern::Reachable, {s.is(lamp.lit)});
    s.property("lit_away", Pattern::Reachable, {s.network.exprs.conjunction(s.is(lamp.lit), s.at(lamp.bulb, 0))});
    s.property("one", Pattern::ExactlyOneOf, {s.at(lamp.bulb, 0), s.is(lamp.lit)});
    s.property("other", Pattern::ExactlyOneOf, {s.is(lamp.on), s.is(lamp.lit)});
    const TimedResult result = checked(s.network);
    EXPECT_EQ(outcome_text(result, "follows"), "violated");
    EXPECT_EQ(outcome_text(result, "follows_at_stable"), "holds");
    EXPECT_EQ(outcome_text(result, "never_lit"), "violated");
    EXPECT_EQ(outcome_text(result, "can_be_lit"), "holds");
    EXPECT_EQ(outcome_text(result, "lit_away"), "violated");
    EXPECT_FALSE(verdict(result, "lit_away").run);
    EXPECT_EQ(outcome_text(result, "one"), "holds");
    EXPECT_EQ(outcome_text(result, "other"), "violated");
    EXPECT_EQ(outcome_text(result, "no_timelock"), "holds");
    EXPECT_FALSE(verdict(result, "no_timelock").declared);
    EXPECT_TRUE(result.time_passes);
}

TEST(TimedEngine, RejectsStatesOfTooManyWords) {
    for (const bool too_wide : {false, true}) {
        Sketch s;
        constexpr std::int64_t of_its_own_word = std::int64_t{1} << 33U;
        for (int k = 0; k < (too_wide ? 1 << 16 : 1000); ++k) s.integer("v" + std::to_string(k), 0, of_its_own_word, 0);
        const Id<Network::Variable> last = s.integer("last", 0, of_its_own_word, 0);
        s.edge(s.process("p", 1),
               {.urgent = true, .guard = s.op(Op::Equal, s.is(last), s.number(0)), .set = {{last, s.number(7)}}});
        s.property("first_changes", Pattern::Reachable, {s.op(Op::Equal, s.is({0}), s.number(7))});
        const Verdict found = verdict(checked(s.network), "first_changes");
        EXPECT_EQ(found.outcome, too_wide ? Outcome::Unknown : Outcome::Violated);
        EXPECT_EQ(found.obstacle, too_wide ? UnknownReason::Unsupported : UnknownReason::None);
    }
}

TEST(TimedEngine, GivesShortestRunsCountingADelayAsOneStep) {
    Lamp lamp;
    lamp.s.property("dark", Pattern::Never, {lamp.s.is(lamp.lit)});
    const TimedResult result = checked(lamp.s.network);
    EXPECT_EQ(verdict(result, "dark").run->moves, (Moves{Delay{2}, fire(0, 0), fire(1, 0)}));
}

TEST(TimedEngine, PrefersOneLongDelayToManyMoves) {
    Sketch s;
    const auto late = s.boolean("late");
    const auto p = s.process("p", 4, 1);
    // Four edges without a delay set `late`. One edge after a delay of fifty units also sets `late`.
    s.edge(p, {.from = 0, .to = 1});
    s.edge(p, {.from = 1, .to = 2});
    s.edge(p, {.from = 2, .to = 3});
    s.edge(p, {.from = 3, .to = 3, .guard = s.no(s.is(late)), .set = {{late, s.yes()}}});
    s.edge(
        p,
        {.from = 0, .to = 0, .guard = s.no(s.is(late)), .when = {{0, Op::GreaterEqual, 50}}, .set = {{late, s.yes()}}});
    s.property("late", Pattern::Reachable, {s.is(late)});
    EXPECT_EQ(verdict(checked(s.network), "late").run->moves, (Moves{Delay{50}, fire(0, 4)}));
}

TEST(TimedEngine, LetsNoTimePassWhileAnUrgentEdgeWaits) {
    Sketch s;
    const auto p = s.process("p", 2), q = s.process("q", 2, 1);
    s.edge(p, {.from = 0, .to = 1, .urgent = true});
    s.edge(q, {.from = 0, .to = 1, .when = {{0, Op::GreaterEqual, 1}}});
    s.property("overtaken", Pattern::Reachable, {s.network.exprs.conjunction(s.at(p, 0), s.at(q, 1))});
    s.property("after", Pattern::Reachable, {s.network.exprs.conjunction(s.at(p, 1), s.at(q, 1))});
    const TimedResult result = checked(s.network);
    EXPECT_EQ(outcome_text(result, "overtaken"), "violated");
    EXPECT_EQ(outcome_text(result, "after"), "holds");
}

TEST(TimedEngine, CountsStayingForeverAsARun) {
    Lamp lamp;
    lamp.s.property("lit", Pattern::Inevitable, {lamp.s.is(lamp.lit)});
    const Verdict found = verdict(checked(lamp.s.network), "lit");
    EXPECT_EQ(found.outcome, Outcome::Violated);
    ASSERT_TRUE(found.run->loop);
    EXPECT_EQ(Moves(found.run->moves.begin() + static_cast<std::ptrdiff_t>(*found.run->loop), found.run->moves.end()),
              (Moves{Delay{1}}));
}

/// Returns a process that leaves both l0 and l1 within two units, and therefore alternates between them forever.
Sketch pendulum() {
    Sketch s;
    const auto p = s.process("p", 2, 1);
    s.invariant(p, 0, {0, Op::LessEqual, 2});
    s.invariant(p, 1, {0, Op::LessEqual, 2});
    s.edge(p, {.from = 0, .to = 1, .reset = {0}});
    s.edge(p, {.from = 1, .to = 0, .reset = {0}});
    return s;
}

TEST(TimedEngine, DecidesLivenessIfEveryBoundForcesAnEdge) {
    Sketch s = pendulum();
    s.property("there", Pattern::Inevitable, {s.at({0}, 1)});
    s.property("back", Pattern::LeadsTo, {s.at({0}, 1), s.at({0}, 0)});
    s.property("itself", Pattern::LeadsTo, {s.at({0}, 1), s.at({0}, 1)});
    s.property("nothing", Pattern::LeadsTo, {s.no(s.yes()), s.at({0}, 0)});
    s.property("deadlock", Pattern::NoDeadlock);
    const TimedResult result = checked(s.network);
    EXPECT_EQ(outcome_text(result, "there"), "holds");
    EXPECT_EQ(outcome_text(result, "back"), "holds");
    EXPECT_EQ(outcome_text(result, "itself"), "holds");
    EXPECT_EQ(outcome_text(result, "nothing"), "holds, vacuous");
    EXPECT_EQ(outcome_text(result, "deadlock"), "holds");
    EXPECT_EQ(outcome_text(result, "no_timelock"), "holds");
}

TEST(TimedEngine, ShowsALassoIfALoopAvoidsTheGoal) {
    Sketch s = pendulum();
    s.edge({0}, {.from = 1, .to = 1, .reset = {0}});
    s.property("back", Pattern::LeadsTo, {s.at({0}, 1), s.at({0}, 0)});
    const Verdict found = verdict(checked(s.network), "back");
    EXPECT_EQ(found.outcome, Outcome::Violated);
    EXPECT_EQ(found.run, shown({fire(0, 0), fire(0, 2)}, 1));
}

TEST(TimedEngine, ShowsDeadlocks) {
    Sketch s = pendulum();
    const auto broken = s.boolean("broken");
    s.network.templates[{0}].edges[{1}].guard = s.no(s.is(broken));
    s.edge({0}, {.from = 0, .to = 1, .set = {{broken, s.yes()}}, .reset = {0}});
    s.property("back", Pattern::LeadsTo, {s.at({0}, 1), s.at({0}, 0)});
    s.property("deadlock", Pattern::NoDeadlock);
    const TimedResult result = checked(s.network);
    EXPECT_EQ(verdict(result, "back").run, shown({fire(0, 2), Delay{2}}));
    EXPECT_EQ(verdict(result, "deadlock").run, shown({fire(0, 2)}));
    EXPECT_EQ(outcome_text(result, "no_timelock"), "violated");
}

TEST(TimedEngine, DistinguishesALivelockOfUrgentEdgesFromADeadlock) {
    Sketch s;
    const auto cycle = s.process("plc", 2);
    s.edge(cycle, {.from = 0, .to = 1, .urgent = true});
    s.edge(cycle, {.from = 1, .to = 0, .urgent = true});
    s.property("deadlock", Pattern::NoDeadlock);
    s.property("anything", Pattern::Never, {s.no(s.yes())});
    const TimedResult result = checked(s.network);
    EXPECT_EQ(outcome_text(result, "deadlock"), "holds, vacuous");
    EXPECT_EQ(outcome_text(result, "anything"), "holds, vacuous");
    EXPECT_EQ(outcome_text(result, "no_timelock"), "violated");
    EXPECT_EQ(verdict(result, "no_timelock").run, shown({fire(0, 0), fire(0, 1)}, 0));
    EXPECT_FALSE(result.time_passes);
}

/// Returns a network with a timelock between integer times: no run is blocked at integer times, but a run is blocked at
/// x = 1.5, y = 2.
Sketch hidden_lock() {
    Sketch s;
    const auto p = s.process("p", 3, 2);  // the clocks are x and y
    s.invariant(p, 0, {1, Op::LessEqual, 2});
    s.invariant(p, 1, {1, Op::LessEqual, 2});
    s.edge(p, {.from = 0, .to = 1, .reset = {0}});
    s.edge(p, {.from = 1, .to = 2, .when = {{0, Op::LessEqual, 1}}});
    s.edge(p, {.from = 1, .to = 2, .when = {{0, Op::GreaterEqual, 2}}});
    s.edge(p, {.from = 2, .to = 2});
    return s;
}

TEST(TimedEngine, DoesNotProvePropertiesThatATimelockBetweenTicksViolates) {
    Sketch s = hidden_lock();
    s.property("on", Pattern::Inevitable, {s.at({0}, 2)});
    s.property("deadlock", Pattern::NoDeadlock);
    s.property("reach", Pattern::Reachable, {s.at({0}, 2)});
    const TimedResult result = checked(s.network);
    EXPECT_EQ(outcome_text(result, "on"), "unknown (inexact)");
    EXPECT_EQ(outcome_text(result, "deadlock"), "unknown (inexact)");
    EXPECT_EQ(outcome_text(result, "no_timelock"), "unknown (inexact)");
    EXPECT_EQ(outcome_text(result, "reach"), "holds");
    EXPECT_NE(verdict(result, "on").reason.find("`p.l1`"), std::string::npos) << verdict(result, "on").reason;
    // With half units the timelock is at an integer time.
    EXPECT_EQ(outcome_text(checked(refined(s.network, 2)), "on"), "violated");
}

TEST(TimedEngine, GivesNoLivenessVerdictOnOperandsWithoutAValue) {
    Sketch s;
    const auto n = s.integer("n", 0, 3, 1);
    const auto p = s.process("p", 2);
    s.edge(p, {.from = 0, .to = 1, .set = {{n, s.number(0)}}});
    const Id<Expr> broken = s.op(Op::Equal, s.op(Op::Divide, s.number(3), s.is(n)), s.number(1));
    s.property("left", Pattern::LeadsTo, {broken, s.at(p, 1)});
    s.property("right", Pattern::LeadsTo, {s.at(p, 0), broken});
    s.property("inevitable", Pattern::Inevitable, {broken});
    s.property("possible", Pattern::AlwaysPossible, {broken});
    const TimedResult result = checked(s.network);
    for (const char* property : {"left", "right", "inevitable", "possible"})
        EXPECT_EQ(outcome_text(result, property), "unknown (faulty)") << property;
}

TEST(TimedEngine, RequiresMoreOfABoundForTimeThanForRuns) {
    // At the bound, the process must leave its location, but two of the edges lead to a location with the same bound
    // and do not reset the clock. No run ends, but the engine cannot exclude that time stops.
    Sketch s;
    const auto p = s.process("p", 2, 2);
    s.invariant(p, 0, {0, Op::LessEqual, 2});
    s.invariant(p, 1, {0, Op::LessEqual, 2});
    s.edge(p, {.from = 0, .to = 1});
    s.edge(p, {.from = 1, .to = 0});
    s.edge(p, {.from = 1, .to = 0, .when = {{1, Op::GreaterEqual, 1}}, .reset = {0, 1}});
    s.property("deadlock", Pattern::NoDeadlock);
    s.property("there", Pattern::Inevitable, {s.at(p, 1)});
    const TimedResult result = checked(s.network);
    EXPECT_EQ(outcome_text(result, "deadlock"), "holds");
    EXPECT_EQ(outcome_text(result, "there"), "holds");
    EXPECT_EQ(outcome_text(result, "no_timelock"), "unknown (inexact)");
}

TEST(TimedEngine, RequiresThatUrgentEdgesAloneLeadToStatesInWhichTimePasses) {
    // The only edge that leaves the urgent loop is not urgent. This edge proves `no timelock` in integer time, but the
    // condition for dense time requires urgent edges alone to leave the loop.
    Sketch s;
    const auto p = s.process("p", 2);
    s.edge(p, {.from = 0, .to = 0, .urgent = true});
    s.edge(p, {.from = 0, .to = 1});
    const TimedResult result = checked(s.network);
    EXPECT_EQ(outcome_text(result, "no_timelock"), "unknown (inexact)");
}

TEST(TimedEngine, StrictConstraintsGiveOneSidedVerdicts) {
    Sketch s;
    const auto p = s.process("p", 2, 1);
    s.edge(p, {.from = 0, .to = 1, .when = {{0, Op::Greater, 2}}});
    s.edge(p, {.from = 0, .to = 0, .when = {{0, Op::Less, 1}}});
    s.property("there", Pattern::Reachable, {s.at(p, 1)});
    s.property("anywhere", Pattern::Always, {s.yes()});
    const TimedResult result = checked(s.network);
    EXPECT_EQ(outcome_text(result, "there"), "holds");
    EXPECT_EQ(outcome_text(result, "anywhere"), "unknown (inexact)");
    EXPECT_NE(verdict(result, "anywhere").reason.find("strict constraint on clock `c0` of `p`, edge `l0 -> l1`"),
              std::string::npos)
        << verdict(result, "anywhere").reason;
}

TEST(TimedEngine, StopsIfAVariableLeavesItsRange) {
    Sketch s;
    const auto n = s.integer("n", 0, 3);
    const auto p = s.process("p", 1);
    s.edge(p, {.set = {{n, s.op(Op::Plus, s.is(n), s.number(1))}}});
    s.property("small", Pattern::Always, {s.op(Op::LessEqual, s.is(n), s.number(3))});
    s.property("two", Pattern::Reachable, {s.op(Op::Equal, s.is(n), s.number(2))});
    s.property("never_two", Pattern::Never, {s.op(Op::Equal, s.is(n), s.number(2))});
    s.property("deadlock", Pattern::NoDeadlock);
    const TimedResult result = checked(s.network);
    EXPECT_EQ(result.states, 4u);
    EXPECT_EQ(outcome_text(result, "small"), "unknown (faulty)");
    EXPECT_EQ(outcome_text(result, "two"), "holds");
    EXPECT_EQ(outcome_text(result, "never_two"), "violated");
    EXPECT_EQ(outcome_text(result, "deadlock"), "unknown (faulty)");
    ASSERT_EQ(result.errors.size(), 1u);
    EXPECT_EQ(result.errors[0].kind, ModelError::Kind::OutOfRange);
    EXPECT_EQ(result.errors[0].variable, n);
    EXPECT_EQ(result.errors[0].run.moves, Moves(3, fire(0, 0)));
}

TEST(TimedEngine, StopsAtUndefinedValues) {
    Sketch s;
    const auto n = s.integer("n", 0, 3, 1);
    const auto p = s.process("p", 1);
    s.edge(p, {.guard = s.op(Op::Greater, s.is(n), s.number(0)), .set = {{n, s.op(Op::Minus, s.is(n), s.number(1))}}});
    s.edge(p, {.guard = s.op(Op::Equal, s.op(Op::Divide, s.number(3), s.is(n)), s.number(3))});
    const TimedResult result = checked(s.network);
    ASSERT_EQ(result.errors.size(), 1u);
    EXPECT_EQ(result.errors[0].kind, ModelError::Kind::NoValue);
    EXPECT_EQ(result.errors[0].edge, Id<Network::Edge>{1});
}

TEST(TimedEngine, StopsIfStoredActionsRace) {
    Sketch s;
    s.network.race = s.boolean("race");
    const auto p = s.process("p", 3);
    s.edge(p, {.from = 0, .to = 1});
    s.edge(p, {.from = 1, .to = 2, .set = {{s.network.race, s.yes()}}});
    s.edge(p, {.from = 2, .to = 0});
    s.property("no_race", Pattern::Never, {s.is(s.network.race)});
    s.property("anything", Pattern::Always, {s.yes()});
    const TimedResult result = checked(s.network);
    EXPECT_EQ(outcome_text(result, "no_race"), "violated");
    EXPECT_EQ(outcome_text(result, "anything"), "unknown (faulty)");
    ASSERT_EQ(result.errors.size(), 1u);
    EXPECT_EQ(result.errors[0].kind, ModelError::Kind::ActionRace);
    EXPECT_EQ(result.errors[0].run.moves, (Moves{fire(0, 0), fire(0, 1)}));
}

/// Returns a counter of twenty bits, which has a million states.
Sketch counter() {
    Sketch s;
    const auto n = s.integer("n", 0, 32767), m = s.integer("m", 0, 31);
    const auto p = s.process("p", 1);
    const auto last = s.op(Op::Equal, s.is(n), s.number(32767));
    s.edge(p, {.guard = s.no(last), .set = {{n, s.op(Op::Plus, s.is(n), s.number(1))}}});
    s.edge(p, {.guard = s.network.exprs.conjunction(last, s.op(Op::Less, s.is(m), s.number(31))),
               .set = {{n, s.number(0)}, {m, s.op(Op::Plus, s.is(m), s.number(1))}}});
    s.property("end", Pattern::Reachable, {s.network.exprs.conjunction(last, s.op(Op::Equal, s.is(m), s.number(31)))});
    s.property("three", Pattern::Reachable, {s.op(Op::Equal, s.is(n), s.number(3))});
    return s;
}

TEST(TimedEngine, NamesTheBoundThatEndedTheSearch) {
    const Sketch s = counter();
    const TimedResult few = checked(s.network, {.max_states = 1000});
    EXPECT_EQ(outcome_text(few, "end"), "unknown (bound)");
    EXPECT_EQ(outcome_text(few, "three"), "holds");
    EXPECT_EQ(outcome_text(few, "no_timelock"), "unknown (bound)");
    EXPECT_EQ(few.states, 1000u);
    EXPECT_FALSE(few.complete);
    EXPECT_EQ(outcome_text(checked(s.network, {.max_memory = 1U << 20U}), "end"), "unknown (memory)");
    const TimedResult late = checked(s.network, {.deadline = std::chrono::steady_clock::now()});
    EXPECT_EQ(outcome_text(late, "end"), "unknown (stopped)");
    EXPECT_EQ(verdict(late, "end").reason, "stopped before the exploration");
    EXPECT_FALSE(late.profile) << "one state is not sufficient for a profile";
    const std::atomic<bool> stop = true;
    EXPECT_EQ(outcome_text(checked(s.network, {.stop = &stop}), "end"), "unknown (stopped)");
}

TEST(TimedEngine, ReachesTheLastOfAMillionStates) {
    Sketch s = counter();
    s.network.properties = {};
    s.property("last", Pattern::Reachable, {s.op(Op::Equal, s.is({1}), s.number(31))});
    const TimedResult result = check_timed(s.network);
    EXPECT_EQ(outcome_text(result, "last"), "holds");
    EXPECT_EQ(result.states, 1u << 20U);
    EXPECT_EQ(verdict(result, "last").run->moves.size(), 31u * 32768u);
}

TEST(TimedEngine, ReportsProgressAndStopsOnRequest) {
    const Sketch s = counter();
    std::atomic<bool> stop = false;
    const TimedResult result = check_timed(s.network, {.stop = &stop, .progress = [&](const TimedProgress& now) {
                                                           EXPECT_GT(now.states, 0u);
                                                           stop = true;
                                                       }});
    EXPECT_LE(result.states, 1u << 20U);
}

TEST(TimedEngine, RepeatedCheckGivesTheSameResult) {
    Lamp lamp;
    lamp.s.property("dark", Pattern::Never, {lamp.s.is(lamp.lit)});
    lamp.s.property("lit", Pattern::LeadsTo, {lamp.s.is(lamp.on), lamp.s.no(lamp.s.is(lamp.on))});
    TimedResult first = check_timed(lamp.s.network), second = check_timed(lamp.s.network);
    for (TimedResult* result : {&first, &second})
        for (Verdict& verdict : result->verdicts) verdict.seconds = 0;
    EXPECT_EQ(first.verdicts, second.verdicts);
    EXPECT_EQ(first.transitions, second.transitions);
}

TEST(TimedEngine, DecidesOnlySelectedProperties) {
    Lamp lamp;
    lamp.s.property("a", Pattern::Always, {lamp.s.yes()});
    lamp.s.property("b", Pattern::Always, {lamp.s.yes()});
    const TimedResult result = checked(lamp.s.network, {.properties = {"b"}});
    ASSERT_EQ(result.verdicts.size(), 2u);
    EXPECT_EQ(result.verdicts[0].property, "b");
    EXPECT_EQ(result.verdicts[1].property, "no_timelock");
}

TEST(TimedEngine, ExpandsTheStepsOfAReachabilityProperty) {
    Sketch s;
    const auto one = s.network.variables.add({.name = "X_1", .role = Network::Role::Step, .initial = 1});
    const auto two = s.network.variables.add({.name = "X_2", .role = Network::Role::Step});
    const auto three = s.network.variables.add({.name = "X_3", .role = Network::Role::Step});
    const auto p = s.process("p", 2);
    s.network.controllers.add(
        {.words = {.name = "press", .steps = {{{"", "1"}, one}, {{"G2", "2"}, two}, {{"", "3"}, three}}},
         .process = p,
         .waiting = {0},
         .stable = s.boolean("stable")});
    s.edge(p, {.from = 0, .to = 1, .set = {{one, s.no(s.yes())}, {two, s.yes()}}});
    s.property("S", Pattern::ReachableAllSteps);
    const TimedResult result = checked(s.network);
    EXPECT_EQ(outcome_text(result, "S.X1"), "holds");
    EXPECT_EQ(outcome_text(result, "S.G2.X2"), "holds");
    EXPECT_EQ(outcome_text(result, "S.X3"), "violated");
}

TEST(TimedEngine, ListsElementsThatItDoesNotRead) {
    Lamp lamp;
    lamp.s.network.properties.add({.name = "raw", .pattern = Pattern::RawUppaal, .raw = "A[] not deadlock"});
    lamp.s.property("possible", Pattern::AlwaysPossible, {lamp.s.is(lamp.lit)});
    lamp.s.property("impossible", Pattern::AlwaysPossible, {lamp.s.no(lamp.s.yes())});
    const TimedResult result = checked(lamp.s.network);
    EXPECT_EQ(outcome_text(result, "raw"), "unknown (unsupported)");
    EXPECT_EQ(outcome_text(result, "possible"), "unknown (inexact)");
    EXPECT_EQ(outcome_text(result, "impossible"), "violated");
}

TEST(TimedEngine, ChecksDeadlocksAtStableInQuiescentStatesOnly) {
    Sketch s;
    const auto p = s.process("p", 3);
    s.edge(p, {.from = 0, .to = 1});
    s.property("anywhere", Pattern::NoDeadlock);
    s.property("settled", Pattern::NoDeadlock, {}, true);
    s.property("time", Pattern::NoTimelock, {}, true);
    s.network.settled = s.no(s.at(p, 1));  // the run ends in l1
    TimedResult result = checked(s.network);
    EXPECT_EQ(outcome_text(result, "anywhere"), "violated");
    EXPECT_EQ(outcome_text(result, "settled"), "holds");
    EXPECT_EQ(outcome_text(result, "time"), "holds");
    s.network.settled = s.at(p, 1);
    EXPECT_EQ(outcome_text(checked(s.network), "settled"), "violated");
    s.edge(p, {.from = 1, .to = 2, .urgent = true});
    s.edge(p, {.from = 2, .to = 1, .urgent = true});
    EXPECT_EQ(outcome_text(checked(s.network), "time"), "violated");
}

TEST(TimedEngine, PropertiesWithoutAQuiescentStateAreVacuous) {
    Lamp lamp;
    lamp.s.network.settled = lamp.s.no(lamp.s.yes());
    lamp.s.property("stable", Pattern::Always, {lamp.s.no(lamp.s.yes())}, true);
    EXPECT_EQ(outcome_text(checked(lamp.s.network), "stable"), "holds, vacuous");
}

/// Returns a network with bits that become true within one instant in any order.
Sketch rising(std::uint32_t bits) {
    Sketch s;
    std::vector<Id<Expr>> all;
    for (std::uint32_t k = 0; k < bits; ++k) {
        const auto bit = s.boolean("b" + std::to_string(k));
        const auto p = s.process("p" + std::to_string(k), 2);
        s.edge(p, {.from = 0, .to = 1, .urgent = true, .set = {{bit, s.yes()}}});
        all.push_back(s.is(bit));
    }
    const auto watcher = s.process("w", 2);
    s.edge(watcher, {.from = 0, .to = 1, .guard = s.network.exprs.conjunction(all)});
    s.property("all", Pattern::Inevitable, {s.network.exprs.conjunction(all)});
    s.property("seen", Pattern::Inevitable, {s.at(watcher, 1)});
    s.property("first_then_last", Pattern::LeadsTo, {all.front(), all.back()});
    s.property("possible", Pattern::AlwaysPossible, {s.at(watcher, 1)});
    s.property("impossible", Pattern::AlwaysPossible, {s.no(all.front())});
    s.property("deadlock", Pattern::NoDeadlock);
    return s;
}

TEST(TimedEngine, GivesTheSameVerdictsWithAndWithoutItsLinks) {
    const TimedResult few = checked(rising(4).network), many = checked(rising(12).network, {.keep_links = false});
    for (const char* property : {"all", "seen", "first_then_last", "possible", "impossible", "deadlock", "no_timelock"})
        EXPECT_EQ(outcome_text(few, property), outcome_text(many, property)) << property;
    EXPECT_EQ(outcome_text(many, "all"), "holds");
    EXPECT_EQ(outcome_text(many, "seen"), "violated");
    EXPECT_EQ(outcome_text(many, "possible"), "holds");
    EXPECT_EQ(outcome_text(many, "impossible"), "violated");
    EXPECT_EQ(outcome_text(many, "deadlock"), "violated");
    EXPECT_EQ(outcome_text(many, "no_timelock"), "holds");
}

TEST(TimedEngine, EvaluatesTermsFarLargerThanTheirSharedForm) {
    // Each level reads the level below twice, so that there are 2^30 leaves.
    Sketch s;
    const auto a = s.boolean("a"), b = s.boolean("b"), parity = s.boolean("parity");
    Id<Expr> term = s.is(a);
    for (int level = 0; level < 30; ++level) term = s.op(Op::Equal, term, s.op(Op::NotEqual, s.is(b), term));
    const auto p = s.process("p", 4);
    s.edge(p, {.from = 0, .to = 1, .set = {{parity, term}}});
    s.edge(p, {.from = 1, .to = 2, .set = {{b, s.yes()}}});
    s.edge(p, {.from = 2, .to = 3, .guard = term, .set = {{parity, term}}});
    s.property("before", Pattern::Reachable, {s.network.exprs.conjunction(s.at(p, 1), s.is(parity))});
    s.property("after", Pattern::Reachable, {s.at(p, 3)});
    const TimedResult result = check_timed(s.network);
    // t == (b != t) is equivalent to !b.
    EXPECT_EQ(outcome_text(result, "before"), "holds");
    EXPECT_EQ(outcome_text(result, "after"), "violated");
}

TEST(TimedEngine, IgnoresClocksThatAreNotReadBeforeTheirNextReset) {
    Sketch s;
    const auto p = s.process("p", 2, 1);
    s.invariant(p, 1, {0, Op::LessEqual, 100});
    s.edge(p, {.from = 0, .to = 1, .reset = {0}});
    s.edge(p, {.from = 1, .to = 0, .when = {{0, Op::Equal, 100}}});
    EXPECT_EQ(checked(s.network).states, 102u);  // l0 has one state, and l1 has the states 0 to 100
}

}  // namespace
}  // namespace grafverif
