// SPDX-License-Identifier: MIT
// Tests compositional checking: dependences between processes, the subsystems that are omitted for each verdict, and
// the subsystems that cannot be omitted, so that the complete network is searched.
#include "check/decomposition/decomposition.hpp"

#include <gtest/gtest.h>

#include "ir/network_run.hpp"
#include "ir/network_subsystems.hpp"
#include "unit/check/networks.hpp"

namespace grafverif {
namespace {

/// A lamp that switches on after two units and off after one; `on` is its location l1.
struct Pulse {
    explicit Pulse(Sketch& s, const std::string& name = "lamp") {
        process = s.process(name, 2, 1);
        s.invariant(process, 0, {0, Op::LessEqual, 2});
        s.invariant(process, 1, {0, Op::LessEqual, 1});
        s.edge(process, {.from = 0, .to = 1, .when = {{0, Op::Equal, 2}}, .reset = {0}});
        s.edge(process, {.from = 1, .to = 0, .when = {{0, Op::Equal, 1}}, .reset = {0}});
    }
    Id<Network::Process> process = {};
};

/// Adds the properties of the lamp that every test checks.
void add_property_of(Sketch& s, const Pulse& lamp) {
    s.property("on", Pattern::LeadsTo, {s.at(lamp.process, 0), s.at(lamp.process, 1)});
    s.property("seen", Pattern::Reachable, {s.at(lamp.process, 1)});
    s.property("dark", Pattern::Always, {s.at(lamp.process, 0)});
    s.property("one", Pattern::ExactlyOneOf, {s.at(lamp.process, 0), s.at(lamp.process, 1)});
}

/// Checks that the verdicts with and without decomposition agree, including their runs.
TimedResult agreed_separately(const Network& network) {
    const TimedResult apart = check_timed_by_parts(network), whole = check_timed(network);
    for (const Verdict& given : apart.verdicts) {
        SCOPED_TRACE(given.property);
        EXPECT_EQ(given.outcome, verdict(whole, given.property).outcome);
        const auto property = std::ranges::find(network.properties, given.property, &Property::name);
        if (given.run && property != network.properties.end()) confirm(network, *property, given);
    }
    return apart;
}

bool apart(const TimedResult& result, const std::string& property) {
    return !verdict(result, property).scope.searched.empty();
}

TEST(Decomposition, VariableWrittenByOneProcessAndReadByAnotherConnectsThem) {
    Sketch s;
    const auto flag = s.boolean("flag"), constant = s.boolean("constant", true);
    const auto writer = s.process("writer", 1), reader = s.process("reader", 1), other = s.process("other", 1);
    s.edge(writer, {.set = {{flag, s.yes()}}});
    s.edge(reader, {.guard = s.op(Op::Equal, s.is(flag), s.is(constant))});
    s.edge(other, {.guard = s.is(constant)});
    const NetworkSubsystems parts = parts_of(s.network);
    EXPECT_EQ(parts.count, 2U);
    EXPECT_EQ(parts.of_process, (std::vector<std::uint32_t>{0, 0, 1}));
    EXPECT_EQ(parts.of_variable, (std::vector<std::uint32_t>{0, NetworkSubsystems::none}));
}

TEST(Decomposition, ScratchAndRaceFlagsDoNotConnectParts) {
    Sketch s;
    const auto race = s.boolean("race"), scratch = s.boolean("scratch");
    s.network.race = race;
    s.network.variables[scratch].scratch = true;
    for (const char* name : {"left", "right"}) {
        const auto process = s.process(name, 1);
        const auto own = s.boolean(std::string(name) + "_own");
        s.edge(process, {.set = {{scratch, s.is(own)}, {own, s.is(scratch)}, {race, s.is(race)}}});
    }
    s.process("statue", 1);
    EXPECT_EQ(parts_of(s.network).of_process, (std::vector<std::uint32_t>{0, 1, 0}));
}

TEST(Decomposition, TimelocksAreNotSearchedIfTheOptionsExcludeThem) {
    Sketch s;
    const Pulse lamp(s), other(s, "other");
    add_property_of(s, lamp);
    TimedOptions options;
    options.timelock = false;
    const TimedResult apart = check_timed_by_parts(s.network, options), whole = check_timed(s.network, options);
    ASSERT_EQ(apart.verdicts.size(), whole.verdicts.size());
    for (std::size_t k = 0; k < apart.verdicts.size(); ++k)
        EXPECT_EQ(apart.verdicts[k].property, whole.verdicts[k].property);
}

TEST(Decomposition, EachVerdictNamesItsOmittedParts) {
    Sketch s;
    const Pulse lamp(s), other(s, "other"), third(s, "third");
    add_property_of(s, lamp);
    const TimedResult result = agreed_separately(s.network);
    EXPECT_EQ(result.states, 15U);  // the state space is 3 times 5, not 5 times 5 times 5
    const SearchScope& scope = verdict(result, "on").scope;
    EXPECT_EQ(scope.searched, std::vector<std::string>{"lamp"});
    EXPECT_EQ(scope.left_out, (std::vector<std::string>{"other", "third"}));
    EXPECT_EQ(scope.because,
              "shares only time with the checked sub-loops, has no timelock and makes only finitely many moves within "
              "one instant");
    EXPECT_EQ(verdict(result, "seen").scope.because,
              "shares only time with the checked sub-loops and can let time pass forever");
    EXPECT_EQ(verdict(result, "one").scope.because,
              "shares only time with the checked sub-loops and adds no state to them");
    EXPECT_EQ(verdict(result, "no_timelock").scope.searched, (std::vector<std::string>{"lamp", "other", "third"}));
}

TEST(Decomposition, PropertyOfTwoPartsIsDecidedWithoutTheThird) {
    Sketch s;
    const Pulse left(s, "left"), middle(s, "middle"), right(s, "right");
    s.property("both", Pattern::Never, {s.network.exprs.conjunction(s.at(left.process, 1), s.at(right.process, 1))});
    const TimedResult result = agreed_separately(s.network);
    EXPECT_EQ(outcome_text(result, "both"), "violated");
    EXPECT_EQ(verdict(result, "both").scope.searched, (std::vector<std::string>{"left", "right"}));
    EXPECT_EQ(verdict(result, "both").scope.left_out, std::vector<std::string>{"middle"});
}

TEST(Decomposition, InfiniteInstantOfOnePartStarvesOthers) {
    Sketch s;
    const Pulse lamp(s);
    add_property_of(s, lamp);
    const auto toggle = s.boolean("toggle");
    s.edge(s.process("free", 1), {.set = {{toggle, s.no(s.is(toggle))}}});
    const TimedResult result = agreed_separately(s.network);
    EXPECT_EQ(outcome_text(result, "on"), "violated");
    EXPECT_FALSE(apart(result, "on"));
    EXPECT_EQ(verdict(result, "on").notes,
              std::vector<std::string>{"the complete loop was explored: `free` can move forever within one instant"});
    EXPECT_TRUE(apart(result, "seen") && apart(result, "dark") && apart(result, "one"));
}

TEST(Decomposition, TimelockOfOnePartBlocksOthers) {
    Sketch s;
    const Pulse lamp(s);
    add_property_of(s, lamp);
    const auto stuck = s.process("stuck", 2, 1);
    s.edge(stuck, {.from = 0, .to = 1, .reset = {0}});
    s.invariant(stuck, 1, {0, Op::LessEqual, 1});
    const TimedResult result = agreed_separately(s.network);
    EXPECT_EQ(outcome_text(result, "on"), "violated");
    EXPECT_FALSE(apart(result, "on"));
    EXPECT_TRUE(apart(result, "seen")) << "`stuck` may remain in its initial location, so time can pass forever";
    EXPECT_EQ(outcome_text(result, "no_timelock"), "violated");
}

TEST(Decomposition, PartThatStopsTimeLimitsTheRunsOfOthers) {
    Sketch s;
    const Pulse lamp(s);
    add_property_of(s, lamp);
    const auto brief = s.process("brief", 1, 1);
    s.invariant(brief, 0, {0, Op::LessEqual, 1});
    const TimedResult result = agreed_separately(s.network);
    EXPECT_EQ(outcome_text(result, "seen"), "violated");
    EXPECT_EQ(outcome_text(result, "dark"), "holds");
    EXPECT_FALSE(apart(result, "seen") || apart(result, "dark"));
    EXPECT_TRUE(apart(result, "one"));
}

TEST(Decomposition, DeadlocksAreCheckedPerPart) {
    Sketch s;
    const Pulse lamp(s);
    s.edge(s.process("once", 2), {.from = 0, .to = 1});
    s.property("alive", Pattern::NoDeadlock);
    EXPECT_EQ(outcome_text(check_timed(s.network), "alive"), "holds") << "the lamp can always move";
    const TimedResult result = check_timed_by_parts(s.network);
    EXPECT_EQ(outcome_text(result, "alive"), "violated");
    EXPECT_EQ(verdict(result, "alive").scope.searched, std::vector<std::string>{"once"});
    EXPECT_TRUE(replay(s.network, verdict(result, "alive").run.value()));
}

TEST(Decomposition, ErrorOfOnePartPreservesVerdictsThatDoNotNeedIt) {
    Sketch s;
    const Pulse lamp(s);
    add_property_of(s, lamp);
    const auto count = s.integer("count", 0, 1);
    const auto counter = s.process("counter", 1, 1);
    s.edge(
        counter,
        {.when = {{0, Op::GreaterEqual, 1}}, .set = {{count, s.op(Op::Plus, s.is(count), s.number(1))}}, .reset = {0}});
    s.property("low", Pattern::Never, {s.op(Op::Equal, s.is(count), s.number(1))});
    const TimedResult result = check_timed_by_parts(s.network);
    ASSERT_EQ(result.errors.size(), 1U);
    EXPECT_EQ(result.errors[0].process, counter);
    EXPECT_EQ(result.errors[0].variable, count);
    EXPECT_TRUE(replay(s.network, result.errors[0].run));
    EXPECT_EQ(outcome_text(result, "one"), "holds");
    EXPECT_EQ(outcome_text(result, "dark"), "violated");
    EXPECT_EQ(outcome_text(result, "low"), "violated");
    EXPECT_EQ(outcome_text(result, "on"), "unknown (faulty)");
}

/// Process `brief` can violate `dark` only after two units of time, when the faulty process is not quiescent.
TEST(Decomposition, ErrorOfOnePartInvalidatesVerdictsAboutQuiescentStates) {
    Sketch s;
    const auto brief = s.process("brief", 3, 1), breaking = s.process("breaking", 3, 1);
    s.invariant(brief, 0, {0, Op::LessEqual, 2});
    s.edge(brief, {.from = 0, .to = 1, .when = {{0, Op::Equal, 2}}});
    s.edge(brief, {.from = 1, .to = 2, .urgent = true});
    const auto full = s.integer("full", 0, 1, 1);
    s.invariant(breaking, 0, {0, Op::LessEqual, 1});
    s.invariant(breaking, 1, {0, Op::LessEqual, 3});
    s.edge(breaking, {.from = 0, .to = 1, .when = {{0, Op::Equal, 1}}});
    s.edge(breaking, {.from = 1, .to = 1, .set = {{full, s.op(Op::Plus, s.is(full), s.number(1))}}});
    s.edge(breaking, {.from = 1, .to = 2, .when = {{0, Op::Equal, 3}}});
    s.network.settled = s.no(s.at(breaking, 1));
    s.property("dark", Pattern::Never, {s.at(brief, 1)}, true);
    const TimedResult result = agreed_separately(s.network);
    EXPECT_EQ(outcome_text(result, "dark"), "unknown (faulty)");
    EXPECT_FALSE(apart(result, "dark"));
}

TEST(Decomposition, InexactVerdictOfOnePartDoesNotNeedTheCompleteNetwork) {
    Sketch s;
    const Pulse lamp(s), other(s, "other");
    const auto strict = s.process("strict", 2, 1);
    s.edge(strict, {.from = 0, .to = 1, .when = {{0, Op::Greater, 1}}, .reset = {0}});
    s.edge(strict, {.from = 1, .to = 0, .reset = {0}});
    s.property("again", Pattern::AlwaysPossible, {s.at(lamp.process, 1)});
    s.property("seldom", Pattern::Never, {s.network.exprs.conjunction(s.at(strict, 0), s.at(strict, 1))});
    s.property("alive", Pattern::NoDeadlock);
    TimedResult result = agreed_separately(s.network);
    EXPECT_EQ(outcome_text(result, "seldom"), "unknown (inexact)");
    EXPECT_TRUE(apart(result, "seldom"));
    EXPECT_EQ(outcome_text(result, "alive"), "unknown (inexact)");
    EXPECT_EQ(outcome_text(result, "no_timelock"), "unknown (inexact)");
    EXPECT_FALSE(apart(result, "again")) << "it is unknown whether `strict` has a timelock";

    Sketch t;
    const Pulse one(t, "one"), two(t, "two");
    t.property("again", Pattern::AlwaysPossible, {t.at(one.process, 1)});
    result = agreed_separately(t.network);
    EXPECT_EQ(outcome_text(result, "again"), "unknown (inexact)");
    EXPECT_EQ(result.states, 10U) << "5 states of each part";
}

TEST(Decomposition, PartThatIsTooLargeAloneIsNotSearchedWithOthers) {
    Sketch s;
    const Pulse lamp(s);
    add_property_of(s, lamp);
    const auto slow = s.process("slow", 1, 1);
    s.invariant(slow, 0, {0, Op::LessEqual, 50});
    s.edge(slow, {.when = {{0, Op::Equal, 50}}, .reset = {0}});
    s.property("there", Pattern::Always, {s.at(slow, 0)});
    s.property("alive", Pattern::NoDeadlock);
    const TimedResult result = check_timed_by_parts(s.network, {.max_states = 20});
    EXPECT_EQ(outcome_text(result, "one"), "holds");
    EXPECT_EQ(outcome_text(result, "there"), "unknown (bound)");
    EXPECT_TRUE(apart(result, "there"));
    EXPECT_TRUE(verdict(result, "there").notes.empty());
    EXPECT_TRUE(verdict(result, "alive").notes.empty());
}

TEST(Decomposition, RunWithAVeryLongPeriodIsNotShown) {
    Sketch s;
    const Pulse lamp(s);
    const auto never = s.boolean("never");
    s.edge(lamp.process, {.from = 1, .to = 1, .guard = s.is(never)});
    s.property("never", Pattern::Inevitable, {s.is(never)});
    for (const std::int64_t period : {97, 101, 103}) {
        const auto slow = s.process("slow" + std::to_string(period), 1, 1);
        s.invariant(slow, 0, {0, Op::LessEqual, period});
        s.edge(slow, {.when = {{0, Op::Equal, period}}, .reset = {0}});
    }
    const TimedResult result = check_timed_by_parts(s.network);
    EXPECT_EQ(outcome_text(result, "never"), "violated");
    EXPECT_FALSE(verdict(result, "never").run);
    EXPECT_EQ(verdict(result, "never").notes.size(), 1U);
}

TEST(Decomposition, ARunInWhichOthersMoveTooOftenIsNotShown) {
    Sketch s;
    const Pulse lamp(s);
    const auto slow = s.process("slow", 2, 1);
    s.invariant(slow, 0, {0, Op::LessEqual, 200'000});
    s.edge(slow, {.from = 0, .to = 1, .when = {{0, Op::Equal, 200'000}}});
    s.property("never", Pattern::Never, {s.at(slow, 1)});
    const TimedResult result = check_timed_by_parts(s.network);
    EXPECT_EQ(outcome_text(result, "never"), "violated");
    EXPECT_FALSE(verdict(result, "never").run);
    EXPECT_EQ(
        verdict(result, "never").notes,
        std::vector<std::string>{
            "no trace is given: with the moves of the other sub-loops, the trace would have more than 100,000 moves"});
}

/// One part stops time, and the other part counts for a long time within that instant.
TEST(Decomposition, FiniteRunNextToAVeryLongOneIsNotShown) {
    Sketch s;
    const auto brief = s.process("brief", 2, 1);
    s.invariant(brief, 0, {0, Op::LessEqual, 1});
    s.edge(brief, {.from = 0, .to = 0, .guard = s.no(s.yes())});
    s.property("ends", Pattern::Inevitable, {s.at(brief, 1)});
    const auto low = s.integer("low", 0, 400), high = s.integer("high", 0, 400);
    const auto counter = s.process("counter", 1);
    const auto more = [&](Id<Network::Variable> count) { return s.op(Op::Plus, s.is(count), s.number(1)); };
    s.edge(counter, {.guard = s.op(Op::Less, s.is(low), s.number(400)), .set = {{low, more(low)}}});
    s.edge(counter, {.guard = s.network.exprs.conjunction(s.op(Op::Equal, s.is(low), s.number(400)),
                                                          s.op(Op::Less, s.is(high), s.number(400))),
                     .set = {{low, s.number(0)}, {high, more(high)}}});
    const TimedResult result = check_timed_by_parts(s.network);
    EXPECT_EQ(outcome_text(result, "ends"), "violated");
    EXPECT_FALSE(verdict(result, "ends").run);
    EXPECT_EQ(
        verdict(result, "ends").notes,
        std::vector<std::string>{
            "no trace is given: with the moves of the other sub-loops, the trace would have more than 100,000 moves"});
}

TEST(Decomposition, BoundOfOneSearchIsReportedAsThatOfTheCompleteSearch) {
    Sketch s;
    const Pulse lamp(s), other(s, "other");
    add_property_of(s, lamp);
    const TimedResult result = check_timed_by_parts(s.network, {.max_states = 2});
    EXPECT_FALSE(result.complete);
    EXPECT_EQ(outcome_text(result, "on"), "unknown (bound)");
    const std::atomic<bool> stop = true;
    EXPECT_EQ(outcome_text(check_timed_by_parts(s.network, {.stop = &stop}), "one"), "unknown (stopped)");
}

}  // namespace
}  // namespace grafverif
