// SPDX-License-Identifier: MIT
// Compares the novelty search, which prefers states in rare situations, with a breadth-first search of the same number
// of states.
#include "check/inputs/novelty.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "check/timed/timed.hpp"
#include "support/read_loop.hpp"
#include "unit/check/networks.hpp"

namespace grafverif {
namespace {

/// Returns a loop with a chart of `steps` steps. Successive steps wait for different buttons, of four in total; a
/// movement of the plant takes 2 s.
std::string chain(int steps, const std::string& property) {
    std::string text =
        "component slow(input P; output S) { clock t; initial location off; location going invariant t <= 2s; "
        "location on; urgent off -> going when P do t := 0; timed going -> on when t == 2s do S := true; "
        "urgent on -> off when !P do S := false; }\n"
        "grafcet c { input B0, B1, B2, B3, S; output Q;\n";
    for (int step = 0; step <= steps; ++step)
        text += (step == 0 ? "initial step " : "step ") + std::to_string(step) + (step % 2 == 1 ? " { Q; }\n" : ";\n");
    for (int step = 0; step < steps; ++step)
        text += "transition t" + std::to_string(step) + ": " + std::to_string(step) + " -> " +
                std::to_string(step + 1) + " when B" + std::to_string(step % 4) + (step % 2 == 1 ? " && S" : " && !S") +
                ";\n";
    text += "}\nclosed_loop l { controller c; plant Lamp = slow(P = Q, S = S);\n";
    for (const char* const button : {"0", "1", "2", "3"})
        text += std::string("environment E") + button + " = push_button(OUT = B" + button + ", GAP = 1s);\n";
    return text + "property p: " + property + ";\n}\n";
}

struct Searched {
    explicit Searched(const std::string& text)
        : network(expand(read_loop(text).network)),
          search(network, {*network.properties.begin()}, abstractable_processes(network)) {}

    const Network network;
    NoveltySearch search;
};

TEST(Novelty, FindsARunThatABreadthFirstSearchOfAsManyStatesDoesNot) {
    constexpr std::size_t bound = 20'000;
    Searched loop(chain(8, "reachable X8"));
    loop.search.run({.states = bound});
    const auto run = loop.search.run_of(0);
    ASSERT_TRUE(run);
    EXPECT_TRUE(replay(loop.network, *run));
    const TimedResult breadth_first =
        check_timed(loop.network, {.max_states = bound, .timelock = false, .covering = false});
    EXPECT_EQ(breadth_first.verdicts.front().outcome, Outcome::Unknown);
}

TEST(Novelty, ContinuesWithTheNextBound) {
    Searched loop(chain(8, "never X8"));
    EXPECT_TRUE(loop.search.run({.states = 100}));
    EXPECT_FALSE(loop.search.run_of(0));
    EXPECT_FALSE(loop.search.run({.states = 1'000'000})) << "every property has a run";
    EXPECT_TRUE(loop.search.run_of(0));
}

TEST(Novelty, FindsARunThatWaitsForeverForTheResponse) {
    for (const std::string property : {"X4 leads to X7", "inevitable X7"}) {
        Searched loop(chain(8, property));
        EXPECT_FALSE(loop.search.run({.states = 100'000})) << "the property has a run: " << property;
        const auto run = loop.search.run_of(0);
        ASSERT_TRUE(run) << property;
        EXPECT_EQ(run->loop, run->moves.size() - 1) << "the last delay repeats forever";
        EXPECT_TRUE(replay(loop.network, *run));
    }
}

TEST(Novelty, FindsNoStateOfRestWhileAMovementIsInProgress) {
    // In step 1, the movement of the plant takes 2 s, so that time cannot pass forever without S.
    Searched loop(chain(2, "Q leads to S || !Q"));
    EXPECT_FALSE(loop.search.run({.states = 1'000'000})) << "all states";
    EXPECT_FALSE(loop.search.run_of(0));
}

TEST(Novelty, AwaitsNoResponseThatHasOccurred) {
    // The chart can rest in step 1, in which Q is true.
    Searched loop(chain(1, "Q leads to X1"));
    EXPECT_FALSE(loop.search.run({.states = 1'000'000})) << "all states";
    EXPECT_FALSE(loop.search.run_of(0));
}

TEST(Novelty, EndsEachRunWithARaceOfStoredActions) {
    const auto text = [](const std::string& property) {
        return "grafcet c { input B; internal C: int 0..2 = 0; initial step 0; step 1 { C := 1 on activation; }\n"
               "initial step 10; step 11 { C := 2 on activation; } step 12;\n"
               "transition a: 0 -> 1 when B; transition b: 10 -> 11 when B; transition d: 11 -> 12 when X1; }\n"
               "closed_loop l { controller c; environment E = push_button(OUT = B); property p: " +
               property + "; }\n";
    };
    for (const std::string property : {"never c.X12", "reachable c.X12", "c.X11 leads to c.X0"}) {
        Searched loop(text(property));
        EXPECT_FALSE(loop.search.run({.states = 100'000})) << "all states";
        EXPECT_FALSE(loop.search.run_of(0)) << property;
    }
}

TEST(Novelty, EndsWithItsMemory) {
    Searched loop(chain(8, "never X8"));
    EXPECT_FALSE(loop.search.run({.states = 1'000'000, .bytes = 100'000}));
    EXPECT_FALSE(loop.search.run_of(0));
    EXPECT_LT(loop.search.states(), 5'000U);
}

TEST(Novelty, EndsWithAllStates) {
    Searched loop(chain(1, "reachable X0 && X1"));
    EXPECT_FALSE(loop.search.run({.states = 1'000'000}));
    EXPECT_FALSE(loop.search.run_of(0));
}

}  // namespace
}  // namespace grafverif
