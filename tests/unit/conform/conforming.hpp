// SPDX-License-Identifier: MIT
// Converts charts to automata, machines and sequences, and converts these to text.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "conform/automaton.hpp"
#include "conform/mealy.hpp"
#include "conform/test_sequence.hpp"
#include "support/play.hpp"
#include "syntax/print/automaton.hpp"

namespace grafverif {

inline constexpr ExecutionMode search = ExecutionMode::StabilitySearch, every_cycle = ExecutionMode::EveryCycle;

/// Returns the chart of samples/tanks with the additional declarations `more`.
inline std::string tanks(const std::string& more = {}) {
    return "input s, h1, h2, l1, l2; output V1, V2, W1, W2;" + more +
           "initial step 1; step 2 { V1; } step 3 { W1; } step 4; step 5 { V2; } step 6 { W2; } step 7;"
           "transition t1: 1 -> 2, 5 when s; transition t2: 2 -> 3 when h1; transition t3: 3 -> 4 when !l1;"
           "transition t4: 5 -> 6 when h2; transition t5: 6 -> 7 when !l2; transition t6: 4, 7 -> 1 when true;";
}

/// A full tank is not empty.
inline constexpr const char* full_is_not_empty = "constraint !h1 || l1; constraint !h2 || l2;";

inline LocationAutomaton automaton(const Equations& equations, ExecutionMode mode = ExecutionMode::StabilitySearch) {
    Diagnostics diagnostics;
    AutomatonOptions options;
    options.mode = mode;
    auto found = location_automaton(equations, options, diagnostics);
    if (!found) {
        ADD_FAILURE() << diagnostics.all().front().message;
        return {};
    }
    EXPECT_EQ(verify(*found), std::vector<std::string>{});
    return std::move(*found);
}

inline LocationAutomaton automaton(const std::string& text, ExecutionMode mode = ExecutionMode::StabilitySearch) {
    return automaton(equations(text), mode);
}

inline MealyMachine machine(const LocationAutomaton& automaton) {
    Diagnostics diagnostics;
    auto found = mealy_machine(automaton, {}, diagnostics);
    if (!found) {
        ADD_FAILURE() << diagnostics.all().front().message;
        return {};
    }
    EXPECT_EQ(verify(*found), std::vector<std::string>{});
    return std::move(*found);
}

inline MealyMachine least(const MealyMachine& machine) {
    Diagnostics diagnostics;
    auto found = minimised(machine, {}, {}, diagnostics);
    if (!found) {
        ADD_FAILURE() << diagnostics.all().front().message;
        return {};
    }
    EXPECT_EQ(verify(*found), std::vector<std::string>{});
    return std::move(*found);
}

inline TestSequence test_of(const MealyMachine& machine, TestCover cover = TestCover::Transitions,
                            bool one_cycle_each = false) {
    Diagnostics diagnostics;
    TestOptions options;
    options.cover = cover;
    options.one_cycle_each = one_cycle_each;
    auto found = test_sequence(machine, options, {}, diagnostics);
    if (!found) {
        ADD_FAILURE() << diagnostics.all().front().message;
        return {};
    }
    EXPECT_EQ(verify(*found), std::vector<std::string>{});
    return std::move(*found);
}

/// Returns the message of location_automaton for a chart that it rejects, with its code.
inline std::string refusal(const std::string& text, AutomatonOptions options = {}) {
    Diagnostics diagnostics;
    if (location_automaton(equations(text), options, diagnostics)) return "no error";
    return '[' + diagnostics.all().front().code + "] " + diagnostics.all().front().message;
}

}  // namespace grafverif
