// SPDX-License-Identifier: MIT
// Tests which previous values a PLC stores after dead values have been cleared.
#include "ir/network/dead_values.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "ir/network/variables.hpp"
#include "ir/slots.hpp"
#include "support/read_loop.hpp"

namespace grafverif {
namespace {

/// Maps each previous value to the variables that its assignment in `evolve` reads.
using Stored = std::map<std::string, std::set<std::string>>;

/// Returns the assignments of previous values after dead values have been cleared.
Stored cleared(const std::string& body, const std::string& rest = "", Grain grain = Grain::Phased) {
    Network network = expand(read_loop("grafcet c { input A, B; output Q; internal M: bool = false; " + body +
                                           " }\nclosed_loop l { controller c; environment EA = push_button(OUT = A); "
                                           "environment EB = push_button(OUT = B); " +
                                           rest + " }\n",
                                       {.grain = grain})
                                 .network);
    const Id<Network::Controller> id = *network.controllers.ids().begin();
    clear_dead_values(network, id);
    const Network::Controller& controller = network.controllers[id];
    const Slots slots(network, controller.process);
    Stored stored;
    for (const Network::Assignment& assignment : slots.automaton.procedures[controller.evolve].assignments) {
        const Network::Variable& target = network.variables[variable_of(network.exprs, assignment.target)];
        if (target.role != Network::Role::Previous) continue;
        std::set<std::string>& read = stored[target.name];
        each_variable(network.exprs, assignment.value,
                      [&](Id<Network::Variable> variable) { read.insert(network.variables[variable].name); });
    }
    return stored;
}

/// Returns a chart of two steps.
std::string two_steps(const std::string& forth, const std::string& back = "!B") {
    return "initial step 0; step 1; transition t0: 0 -> 1 when " + forth + "; transition t1: 1 -> 0 when " + back + ";";
}

TEST(DeadValues, AreStoredOnlyIfTheNextCycleCanReadThem) {
    EXPECT_EQ(cleared(two_steps("rise(A) && B")), Stored({{"P_A", {"A_sample", "X_0"}}}));
    EXPECT_EQ(cleared(two_steps("rise(A)", "fall(A)")), Stored({{"P_A", {"A_sample", "X_0", "X_1"}}}));
    EXPECT_EQ(cleared(two_steps("rise(A)"), "", Grain::Atomic), Stored({{"P_A", {"A", "X_0"}}}))
        << "the atomic grain has no samples";
}

TEST(DeadValues, AreNotClearedIfATermReadsThemInEachSituation) {
    EXPECT_EQ(cleared("initial step 0; transition t0: -> 0 when rise(A);"), Stored({{"P_A", {"A_sample"}}}))
        << "a source transition is always enabled";
}

TEST(DeadValues, OfAnEventAreReadWhileItsStepIsActive) {
    EXPECT_EQ(cleared("initial step 0; step 1 { M := true on event rise(A); } transition t0: 0 -> 1 when B; "
                      "transition t1: 1 -> 0 when M;"),
              Stored({{"P_A", {"A_sample", "X_1"}}}));
}

TEST(DeadValues, AreNotClearedIfATermThatReadsThemCanBeUndefined) {
    EXPECT_EQ(cleared("internal N: int 0..3 = 0; " + two_steps("(rise(A) || 2 / N == 1) && B")),
              Stored({{"P_A", {"A_sample"}}}));
}

TEST(DeadValues, OfTwoReadersAreClearedIfBothStepsAreInactive) {
    EXPECT_EQ(
        cleared("initial step 0; step 1; step 2; transition t0: 0 -> 1 when rise(A); transition t1: 1 -> 2 when B; "
                "transition t2: 2 -> 0 when !rise(A);"),
        Stored({{"P_A", {"A_sample", "X_0", "X_2"}}}));
}

}  // namespace
}  // namespace grafverif
