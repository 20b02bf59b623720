// SPDX-License-Identifier: MIT
// Tests proofs that time passes and that a state remains possible, on loops that are small enough to show which
// premises each proof needs.
#include "check/inputs/possible.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "check/inputs/inputs.hpp"
#include "check/inputs/required_states.hpp"
#include "check/inputs/response.hpp"
#include "check/inputs/resting.hpp"
#include "support/read_loop.hpp"
#include "unit/check/networks.hpp"

namespace grafverif {
namespace {

const std::string plant_components =
    "component follower(input P; output S) { clock t; initial location off; location going invariant t <= 2s; "
    "location on; urgent off -> going when P do t := 0; urgent going -> off when !P; timed going -> on when P && "
    "t == 2s do S := true; urgent on -> off when !P do S := false; }\n"
    "component stuck(input P; output S) { clock t; initial location off; location going invariant t <= 2s; "
    "location on; urgent off -> going when P do t := 0; timed going -> on when P && t == 2s do S := true; }\n"
    "component echo(input P; output S) { initial location off; location on; urgent off -> on when P do S := true; "
    "urgent on -> off when !P do S := false; }\n"
    "component sensor(input P; output S) { initial location off; location on; urgent off -> on when P do S := true; "
    "urgent on -> off when !P do S := false; }\n"
    "component spin(input P; output S) { clock t; initial location off; location on; urgent off -> on when P; "
    "urgent on -> off when P; timed on -> off when t >= 1s do S := !S, t := 0; }\n"
    "component counter(input P; output S) { variable N: int 0..3; clock t; initial location any; "
    "timed any -> any when P && t >= 1s do N := N + 1, S := true, t := 0; }\n";

/// Returns a loop of a chart, a button A and the plant `plant`, whose order is Q and whose sensor is D.
std::string with_plant(const std::string& plant, const std::string& property = "always possible X1") {
    return plant_components +
           "grafcet c { input A, D; output Q; initial step 0; step 1 { Q; } step 2; transition t0: 0 -> 1 when A; "
           "transition t1: 1 -> 2 when D; transition t2: 2 -> 0 when !A; }\nclosed_loop l { controller c; " +
           plant + " environment EA = push_button(OUT = A); property p: " + property + "; }\n";
}

Network network_of(const std::string& text) { return expand(read_loop(text).network); }

TEST(LetsTimePass, HoldsForInstancesThatEndEachMovement) {
    EXPECT_TRUE(lets_time_pass(network_of(with_plant("plant Fol = follower(P = Q, S = D);"))));
}

TEST(LetsTimePass, FailsIfABoundMayNotBeLeft) {
    const Network network = network_of(with_plant("plant Fol = stuck(P = Q, S = D);"));
    EXPECT_FALSE(lets_time_pass(network));
    EXPECT_TRUE(lets_time_pass(network, {.ignore_bounds = true}));
}

TEST(LetsTimePass, FailsIfAnInputFollowsAnOutputAtOnce) {
    const Network network = network_of(with_plant("plant Fol = echo(P = Q, S = D);"));
    EXPECT_FALSE(lets_time_pass(network));
    EXPECT_TRUE(lets_time_pass(network, {.ignore_outputs = true}));
}

TEST(LetsTimePass, AllowsAnInstanceThatOnlyAnotherInstanceReads) {
    EXPECT_TRUE(
        lets_time_pass(network_of(with_plant("plant Copy = echo(P = Q, S = B); plant Fol = follower(P = B, S = D);"))));
    EXPECT_TRUE(lets_time_pass(
        network_of(with_plant("plant Fol = follower(P = Q, S = B); plant Seen = sensor(P = B, S = D);"))));
}

TEST(LetsTimePass, FailsIfAnInstanceMovesForeverInAnInstant) {
    const Network network = network_of(with_plant("plant Fol = spin(P = Q, S = D);"));
    EXPECT_FALSE(lets_time_pass(network));
    EXPECT_TRUE(lets_time_pass(network, {.ignore_moves = true}));
}

TEST(LetsTimePass, FailsIfAnInstanceMayLeaveItsRange) {
    EXPECT_FALSE(lets_time_pass(network_of(with_plant("plant Fol = counter(P = Q, S = D);"))));
}

TEST(LetsTimePass, FailsIfAnInstanceChangesAVariableThatItReadsAndOthersWrite) {
    Sketch sketch;
    const auto shared = sketch.boolean("v");
    const auto turning = sketch.process("turning", 2), other = sketch.process("other", 1);
    const Id<Expr> no = sketch.no(sketch.yes());
    sketch.edge(
        turning,
        {.from = 0, .to = 1, .urgent = true, .guard = sketch.no(sketch.is(shared)), .set = {{shared, sketch.yes()}}});
    sketch.edge(turning, {.from = 1, .to = 0, .urgent = true, .guard = sketch.is(shared), .set = {{shared, no}}});
    sketch.edge(other, {.from = 0, .to = 0, .set = {{shared, no}}});
    EXPECT_FALSE(lets_time_pass(expand(sketch.network)));
}

TEST(LetsTimePass, FailsIfAnEdgeOfAPlcIsNotUrgent) {
    Network network = network_of(with_plant("plant Fol = follower(P = Q, S = D);"));
    const Id<Network::Process> plc = network.controllers[Id<Network::Controller>{0}].process;
    for (Network::Edge& edge : network.templates[network.processes[plc].automaton].edges) edge.urgent = false;
    EXPECT_FALSE(lets_time_pass(network));
    EXPECT_FALSE(takes_time(network));
}

TEST(LetsTimePass, KnowsTimersByTheirRequests) {
    const std::string timed =
        "grafcet c { input A; initial step 0; step 1; transition t0: 0 -> 1 when A && 2s/X0; transition t1: 1 -> 0 "
        "when !A; }\nclosed_loop l { controller c; environment EA = push_button(OUT = A); }\n";
    EXPECT_TRUE(lets_time_pass(network_of(timed)));
}

/// True if the proof succeeds on the first property of the loop.
bool is_proved(const std::string& text, const InputAblations& ablations = {}) {
    const Network network = network_of(text);
    PossibleProof proof(network, abstractable_processes(network), ablations);
    return proof.proves(network.properties[Id<Property>{0}], {}) == true;
}

TEST(PossibleProof, ReturnsToAStepThroughAPlant) {
    EXPECT_TRUE(is_proved(with_plant("plant Fol = follower(P = Q, S = D);")));
    EXPECT_TRUE(is_proved(with_plant("plant Fol = follower(P = Q, S = D);", "always possible X1 && D")))
        << "both are true in the instant in which the sensor changes";
    EXPECT_FALSE(is_proved(with_plant("plant Fol = follower(P = Q, S = D);", "always possible X1 && D at stable")));
}

TEST(PossibleProof, FailsIfAStepIsLeftForGood) {
    const std::string text =
        "grafcet c { input A; initial step 0; step 1; transition t0: 0 -> 1 when A; }\nclosed_loop l { controller c; "
        "environment EA = push_button(OUT = A); property p: always possible X0; property q: always possible X1; }\n";
    EXPECT_FALSE(is_proved(text));
    const Network network = network_of(text);
    PossibleProof proof(network, abstractable_processes(network));
    EXPECT_EQ(proof.proves(network.properties[Id<Property>{1}], {}), true);
}

/// Returns a loop with a plant of two clocks. In the location `both`, the bound that is reached first decides the next
/// location; this is always the bound of t, so S never becomes true.
std::string race(const std::string& property) {
    return "component two(input P; output S, F) { clock t, u; initial location off; location one invariant t <= 2s; "
           "location both invariant u <= 2s && t <= 2s; location good; location bad; "
           "urgent off -> one when P do t := 0; timed one -> both when t >= 1s do u := 0; "
           "timed both -> good when u == 2s do S := true; timed both -> bad when t == 2s do F := true; "
           "urgent bad -> off when !P do F := false; }\n"
           "grafcet c { input A, S, F; output Q; initial step 0; step 1 { Q; } step 2; transition t0: 0 -> 1 when A; "
           "transition t1: 1 -> 2 when S; transition t2: 1 -> 0 when F; transition t3: 2 -> 1 when !S; }\n"
           "closed_loop l { controller c; plant Two = two(P = Q, S = S, F = F); "
           "environment EA = push_button(OUT = A); property p: " +
           property + "; }\n";
}

TEST(PossibleProof, NeedsAnEdgeForEachBound) {
    EXPECT_FALSE(is_proved(race("always possible X2")));
    EXPECT_TRUE(is_proved(race("always possible X2"), {.one_bound = true}))
        << "the test would not detect that the premise is violated";
    EXPECT_TRUE(is_proved(race("always possible X2 || F")));
}

/// The only edge of the plant that leaves `wait` and sets S is enabled while t <= 1s; t may exceed 1s in `wait`.
TEST(PossibleProof, NeedsAnEdgeThatIsPossibleForAllValuesOfTheClocks) {
    const std::string text =
        "component early(input P; output S) { clock t; initial location off; location wait; "
        "urgent off -> wait when P do t := 0; timed wait -> off when t <= 1s do S := true; }\n" +
        with_plant("plant Fol = early(P = Q, S = D);", "always possible X2");
    EXPECT_FALSE(is_proved(text));
    EXPECT_TRUE(is_proved(text, {.any_edge = true})) << "the test would not detect that the premise is violated";
}

/// Returns a loop of a chart with an emergency stop E, which activates step 0, and the plant `plant` with the order Q and
/// the sensor D.
std::string with_stop(const std::string& plant, const std::string& property) {
    return plant_components +
           "component latch(input P; output S) { clock t; initial location off; location idle; location on; "
           "urgent off -> on when P do S := true; timed off -> idle when t >= 1s do t := 0; "
           "timed idle -> off when t >= 1s do t := 0; }\n"
           "grafcet c { input A, E, D; output Q; initial step 0; step 1 { Q; } step 2; step 3; "
           "transition t0: 0 -> 1 when A && !E; transition t1: 1 -> 2 when D && !E; transition t2: 2 -> 3 when A && "
           "!E; "
           "transition t3: 3 -> 0 when !A || E; transition e1: 1 -> 0 when E; transition e2: 2 -> 0 when E; }\n"
           "closed_loop l { controller c; " +
           plant +
           " environment EA = push_button(OUT = A); environment EE = emergency_stop(OUT = E); property p: " + property +
           "; }\n";
}

TEST(PossibleProof, UsesAHomingSequence) {
    const std::string two = "plant Fol = follower(P = Q, S = D); plant Other = follower(P = Q, S = F);";
    const Network network = network_of(with_stop(two, "always possible X3"));
    const Property& property = network.properties[Id<Property>{0}];
    PossibleProof proof(network, abstractable_processes(network));
    PossibleProof without(network, abstractable_processes(network), {.without_homing = true});
    EXPECT_EQ(proof.proves(property, {}), true);
    EXPECT_EQ(proof.sequence(), (std::vector<std::string>{"`E` becomes true", "`A` becomes true"}));
    EXPECT_EQ(without.proves(property, {}), true);
    EXPECT_TRUE(without.sequence().empty());
    EXPECT_LT(proof.states(), without.states());
}

TEST(PossibleProof, RequiresTheStatesThatAProcessNeedNotLeave) {
    const std::string text = with_stop("plant Fol = latch(P = Q, S = D);", "always possible !D");
    EXPECT_FALSE(is_proved(text));
    EXPECT_TRUE(is_proved(text, {.leave_freely = true})) << "the test would not detect that the premise is violated";
}

/// Returns a loop in which step 1 is activated if A is pressed for 2 s, and is never left while D is false.
Network after_a_delay(const std::string& property) {
    return network_of(
        "component latch(input P; output S) { initial location off; location on; "
        "urgent off -> on when P do S := true; }\n"
        "grafcet c { input A, D; output Q; initial step 0; step 1 { Q; } step 2; "
        "transition t0: 0 -> 1 when 2s/A; transition t1: 1 -> 2 when D; }\n"
        "closed_loop l { controller c; plant P = latch(P = Q, S = D); "
        "environment EA = push_button(OUT = A); property p: " +
        property + "; }\n");
}

TEST(PossibleProof, ConsidersTheMovesOfTimers) {
    for (const char* property : {"always possible X0", "always possible X1", "always possible false && X1"}) {
        const Network network = after_a_delay(property);
        PossibleProof proof(network, abstractable_processes(network));
        EXPECT_EQ(proof.proves(network.properties[Id<Property>{0}], {}), false) << property;
    }
    const Network network = after_a_delay("always possible X2");
    PossibleProof proof(network, abstractable_processes(network));
    EXPECT_EQ(proof.proves(network.properties[Id<Property>{0}], {}), true);
}

/// After the homing sequence, time passes in some required state, and the timer of A may be running.
TEST(RequiredStates, ContainAllStatesOfTimers) {
    const Network network = after_a_delay("always possible X2");
    const std::vector<AbstractableProcess> instances = abstractable_processes(network);
    RequiredStates required(network, instances, panel_levels(network, instances, {}), true, {});
    ASSERT_EQ(required.find({}), true);
    const timed::Machine machine(network);
    timed::Moves moves;
    std::set<std::int64_t> locations;  // locations of the timer in required states in which time passes
    const auto timer = std::ranges::find(network.processes, Network::ProcessKind::Timer, &Network::Process::kind);
    ASSERT_NE(timer, network.processes.end());
    const auto index = static_cast<std::size_t>(timer - network.processes.begin());
    EXPECT_TRUE(required.each(machine.layout(), {}, [&](const timed::Word* words) {
        machine.expand(words, moves);
        if (!moves.urgent) locations.insert(machine.layout().locations[index].get(words));
    }));
    EXPECT_GE(locations.size(), 2U);
}

/// The moves of the emergency stop do not request a cycle of the PLC, so the chart may remain in step 1.
TEST(PossibleProof, UsesOnlyMovesAfterWhichACycleBegins) {
    Network network = network_of(with_stop("plant Fol = latch(P = Q, S = D);", "always possible X0"));
    const auto stop = std::ranges::find(network.processes, std::string("EE"), &Network::Process::name);
    const auto button = std::ranges::find(network.processes, std::string("EA"), &Network::Process::name);
    ASSERT_NE(stop, network.processes.end());
    ASSERT_NE(button, network.processes.end());
    for (const auto process : {stop, button})
        for (Network::Edge& edge : network.templates[process->automaton].edges)
            std::erase_if(edge.assignments, [&](const Network::Assignment& assignment) {
                const auto target = static_cast<std::uint32_t>(network.exprs[assignment.target].value);
                return network.variables[Id<Network::Variable>{target}].role == Network::Role::Flag;
            });
    const auto proves = [&](const InputAblations& ablations) {
        PossibleProof proof(network, abstractable_processes(network), ablations);
        return proof.proves(network.properties[Id<Property>{0}], {});
    };
    EXPECT_EQ(proves({}), false);
    EXPECT_EQ(proves({.need_not_begin_cycle = true}), true) << "the test would not detect the violation";
}

/// Returns the result of prove_response for the first property of the loop.
ResponseResult response(const std::string& text) {
    const Network network = network_of(text);
    return prove_response(network, abstractable_processes(network), network.properties[Id<Property>{0}], {});
}

TEST(ProveResponse, UsesThatALocationWithABoundIsLeft) {
    EXPECT_EQ(response(with_plant("plant Fol = follower(P = Q, S = D);", "X1 leads to X2")).holds, true);
    EXPECT_EQ(response(with_plant("plant Fol = follower(P = Q, S = D);", "X2 leads to X0")).holds, false)
        << "the button may stay pressed";
    EXPECT_EQ(response(with_plant("plant Fol = follower(P = Q, S = D);", "A leads to X1")).holds, false)
        << "the button may be released before the PLC samples it";
    EXPECT_EQ(response(with_plant("plant Fol = follower(P = Q, S = D);", "inevitable X0")).holds, true);
    EXPECT_EQ(response(with_plant("plant Fol = follower(P = Q, S = D);", "inevitable X1")).holds, false);
}

TEST(ProveResponse, UsesThatATimerExpires) {
    const std::string text =
        "grafcet c { input A; initial step 0; step 1; step 2; transition t0: 0 -> 1 when A; transition t1: 1 -> 2 when "
        "2s/X1; transition t2: 2 -> 0 when A; }\nclosed_loop l { controller c; environment EA = push_button(OUT = A); "
        "property p: X1 leads to X2; }\n";
    EXPECT_EQ(response(text).holds, true);
}

/// Two followers D and E: each step of the chart waits for one of them. The first abstraction stores neither.
TEST(ProveResponse, StoresEachInstanceOnlyInTheSituationsThatNeedIt) {
    const std::string text =
        plant_components +
        "grafcet c { input A, D, E; output Q, R; initial step 0; step 1 { Q; } step 2 { R; } step 3; "
        "transition t0: 0 -> 1 when A; transition t1: 1 -> 2 when D; transition t2: 2 -> 3 when E; "
        "transition t3: 3 -> 0 when !A && !D && !E; }\nclosed_loop l { controller c; plant First = "
        "follower(P = Q, S = D); plant Second = follower(P = R, S = E); environment EA = "
        "push_button(OUT = A); property p: X1 leads to X3; }\n";
    const ResponseResult result = response(text);
    EXPECT_EQ(result.holds, true);
    EXPECT_EQ(result.refinements, 2U);
    EXPECT_EQ(response(text + " ").states, result.states) << "the result is not deterministic";
}

TEST(ProveResponse, ExploresAllStatesOfALoopWithTwoPlcs) {
    const std::string text = "grafcet d { input A, D; output R; initial step 0 { R if A && D; } }\n" +
                             with_plant("controller d; plant Fol = follower(P = Q, S = D);", "c.X1 leads to c.X2");
    const ResponseResult result = response(text);
    EXPECT_EQ(result.holds, true);
    EXPECT_EQ(result.refinements, 0U);
}

TEST(ProveResponse, MarksAPremiseThatIsNeverTrue) {
    const ResponseResult result = response(with_plant("plant Fol = follower(P = Q, S = D);", "X1 && X2 leads to X0"));
    EXPECT_EQ(result.holds, true);
    EXPECT_TRUE(result.vacuous);
}

TEST(TakesTime, FailsIfAnInputMayChangeForeverInAnInstant) {
    const std::string text = with_plant("plant Fol = follower(P = Q, S = D);");
    EXPECT_TRUE(takes_time(network_of(text)));
    std::string free = text;
    free.replace(free.find("push_button"), 11, "free");
    EXPECT_FALSE(takes_time(network_of(free)));
}

TEST(PossibleProof, EndsAtItsLimitOfStates) {
    const Network network = network_of(with_plant("plant Fol = follower(P = Q, S = D);"));
    PossibleProof proof(network, abstractable_processes(network));
    EXPECT_EQ(proof.proves(network.properties[Id<Property>{0}], {.states = 5}), std::nullopt);
    EXPECT_EQ(proof.proves(network.properties[Id<Property>{0}], {}), true) << "another call continues the search";
}

TEST(PossibleProof, ContinuesAfterALimitIsReached) {
    const Network network = network_of(with_plant("plant Fol = follower(P = Q, S = D);"));
    const Property& property = network.properties[Id<Property>{0}];
    PossibleProof uninterrupted(network, abstractable_processes(network), {.without_homing = true});
    ASSERT_EQ(uninterrupted.proves(property, {}), true);
    PossibleProof proof(network, abstractable_processes(network), {.without_homing = true});
    std::size_t limits = 0;
    std::optional<bool> proved;
    for (std::size_t states = 2; !proved; ++states, ++limits) {
        ASSERT_LE(states, 2 * uninterrupted.states());
        proved = proof.proves(property, {.states = states});
    }
    EXPECT_EQ(proved, true);
    EXPECT_GT(limits, 10U);
    EXPECT_EQ(proof.states(), uninterrupted.states()) << "no state is explored twice";
}

}  // namespace
}  // namespace grafverif
