// SPDX-License-Identifier: MIT
// Prints location automata, Mealy machines and test sequences as plain text and JSON (for test sequences as CSV, see
// test_csv.hpp).
//
// AutomatonCounts contains the numbers of locations and evolutions, including INIT (the controller after power-on,
// before its first cycle) and its outgoing evolutions. `unstable` is the number of pairs of a location and an input
// combination from which the chart reaches no stable situation, without INIT. `unstable_from_init` is the number of
// such input combinations for INIT.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

#include "grafverif/ir/location_automaton.hpp"
#include "grafverif/ir/mealy.hpp"
#include "grafverif/ir/test_sequence.hpp"

namespace grafverif {

struct AutomatonCounts {
    std::size_t locations = 0, evolutions = 0, evolutions_from_init = 0;
    std::optional<std::uint64_t> unstable = 0, unstable_from_init = 0;  ///< empty if too large to represent
};
AutomatonCounts counts(const LocationAutomaton& automaton);

/// Returns the number of states times the number of input combinations, or nullopt if the product is too large to
/// represent.
std::optional<std::uint64_t> transition_count(const MealyMachine& machine);

/// Returns the text of a condition of the automaton or machine, such as `s and not h1`.
std::string condition_text(const LocationAutomaton& automaton, Id<Expr> condition);
std::string condition_text(const MealyMachine& machine, Id<Expr> condition);

/// Returns the text of an output in a location, such as `V1 if s and not h1` or `SPEED = 2`.
std::string emission_text(const LocationAutomaton& automaton, const LocationAutomaton::Emission& emission);
/// Returns the nonzero outputs as text such as `V1, SPEED = 2`, or the text `none` if all outputs are zero.
std::string result_text(const MealyMachine& machine, Id<MealyMachine::OutputWord> answer, std::string_view none);

/// Prints a summary of the automaton or machine. If `details` is true, also prints each location and evolution, or each
/// state and transition.
void print_automaton(std::ostream& out, const LocationAutomaton& automaton, bool details);
void print_mealy(std::ostream& out, const MealyMachine& machine, bool details);

/// Prints an object `{"name", "mode", "locations", "evolutions", "evolutions_from_init", "unstable",
/// "unstable_from_init"}`; with details also `"inputs", "outputs", "assumed", "location_table": [{"location",
/// "situation", "values", "outputs"}], "evolution_table": [{"from", "to", "condition", "restarted"}],
/// "instability_table": [{"from", "condition", "witness", "cycle"}]`; location 0 is INIT.
void print_automaton_json(std::ostream& out, const LocationAutomaton& automaton, bool details);

/// Prints an object `{"name", "mode", "states", "transitions", "unstable_pairs", "combinations", "initial"}`; with
/// details also `"inputs", "outputs", "assumed", "activation", "state_table", "transition_table": [{"from", "to",
/// "condition", "outputs", "wait_ms"}], "unstable_table"`.
void print_mealy_json(std::ostream& out, const MealyMachine& machine, bool details);

/// Prints an object `{"chart", "mode", "cover", "hold", "steps", "lower_bound", "proven_least", "covered", "to_cover",
/// "inputs", "outputs", "sequences": [[{"step", "wait_ms", "cycles", "inputs": {}, "outputs": {}, "situation"}]]}`;
/// step 0 is the scan that activates the initial steps.
void print_test_json(std::ostream& out, const TestSequence& test);

/// Returns one sentence that states the length of the test, its coverage, and whether the length is proved to be
/// minimal.
std::string summary(const TestSequence& test);

}  // namespace grafverif
