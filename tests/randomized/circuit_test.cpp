// SPDX-License-Identifier: MIT
// Compares a circuit, its AIGER text and its BTOR2 text with the transition system from which they were generated;
// independent readers read the texts. Each run that satisfies the constraints must be a run of the system. The
// properties must hold exactly in the states in which their terms hold, and every state must be reached.
#include "circuit/circuit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <set>

#include "check/evidence.hpp"
#include "emit/aiger/aiger.hpp"
#include "emit/btor2/btor2.hpp"
#include "support/explicit_search.hpp"
#include "support/random_loop.hpp"
#include "support/random_system.hpp"
#include "support/read_aiger.hpp"
#include "support/read_btor2.hpp"
#include "support/test_size.hpp"
#include "support/untimed_loop.hpp"

namespace grafverif {
namespace {

using System = TransitionSystem;

struct Seen {
    std::size_t systems = 0, steps = 0, targets = 0, hits = 0, starts = 0;
};

/// A random run of the circuit, which tries inputs until the current state satisfies the
/// constraints ("is possible"), and then executes a step.
class Walk {
public:
    Walk(const Circuit& circuit, Random& random) : circuit_(circuit), random_(random), values_(circuit.gates.size()) {}

    /// Tries random inputs; returns true if a possible state was found.
    bool look() {
        for (int tries = 0; tries < 200; ++tries) {
            given_.assign(circuit_.inputs.size(), false);
            for (std::size_t i = 0; i < given_.size(); ++i)
                values_[circuit_.inputs[i].node] = given_[i] = chance(random_, 50);
            evaluate_gates(circuit_, values_);
            if (!value_of(values_, circuit_.possible)) continue;
            inputs.push_back(given_);
            return true;
        }
        return false;
    }
    void step() {
        std::vector<bool> next;
        for (const Circuit::Latch& latch : circuit_.latches) next.push_back(value_of(values_, latch.next));
        for (std::size_t i = 0; i < next.size(); ++i) values_[circuit_.latches[i].node] = next[i];
    }
    const NodeValues& values() const { return values_; }

    std::vector<std::vector<bool>> inputs = {};

private:
    const Circuit& circuit_;
    Random& random_;
    NodeValues values_;
    std::vector<bool> given_ = {};
};

/// Compares the values of the properties in `circuit` in one state with those of the terms of the system.
void expect_targets(const System& system, FlatSystem& flat, const Circuit& circuit, const NodeValues& values,
                    const std::vector<std::int64_t>& state, Seen& seen) {
    const auto value = [&](Id<Expr> term) {
        return evaluate(flat.exprs, term,
                        [&](const Expr& leaf) { return state[static_cast<std::size_t>(leaf.value)]; });
    };
    for (const Circuit::Target& target : circuit.targets) {
        const Property& property = system.properties[target.about];
        if (!target.justice.empty() || target.undefined != Gates::no) continue;
        std::int64_t count = 0;
        for (const Id<Expr> operand : property.operands) count += value(flattened(system, flat, operand)).value();
        const bool settled = !property.at_stable || value(flattened(system, flat, system.settled)).value() != 0;
        const bool found = property.pattern == Pattern::Always         ? count == 0
                           : property.pattern == Pattern::ExactlyOneOf ? count != 1
                                                                       : count != 0;
        ASSERT_EQ(value_of(values, target.bad), settled && found) << property.name;
        ++seen.targets;
        if (settled && found) ++seen.hits;
    }
}

/// Checks that the text is equivalent to the circuit in every step.
void expect_same_text(const Circuit& circuit, const aiger::AigerText& written,
                      const std::vector<aiger::AigerProperty>& requested,
                      const std::vector<std::vector<bool>>& inputs) {
    const AigerFile file = read_aiger(written.text);
    ASSERT_EQ(file.error_text, "") << written.text;
    std::vector<std::vector<bool>> given;
    for (const std::vector<bool>& step : inputs) {
        given.emplace_back();
        for (const std::size_t input : written.inputs) given.back().push_back(step[input]);
    }
    const auto run = aiger_run(file, given);
    NodeValues values(circuit.gates.size());
    for (std::size_t step = 0; step < run.size(); ++step) {
        for (std::size_t i = 0; i < circuit.inputs.size(); ++i) values[circuit.inputs[i].node] = inputs[step][i];
        evaluate_gates(circuit, values);
        std::size_t bad = 0, list = 0;
        for (const aiger::AigerProperty& question : requested) {
            if (question.justice.empty()) {
                ASSERT_EQ(aiger_value(run[step], file.bads[bad++]), value_of(values, question.bad)) << question.name;
                continue;
            }
            for (std::size_t i = 0; i < question.justice.size(); ++i)
                ASSERT_EQ(aiger_value(run[step], file.justice[list][i]), value_of(values, question.justice[i]));
            ++list;
        }
        std::vector<bool> next;
        for (const Circuit::Latch& latch : circuit.latches) next.push_back(value_of(values, latch.next));
        for (std::size_t i = 0; i < next.size(); ++i) values[circuit.latches[i].node] = next[i];
    }
}

/// Checks that the bit vectors in the text represent the bits of the circuit in every state.
void expect_same_words(const System& system, const FlatSystem& flat, const Circuit& circuit,
                       const std::vector<std::vector<bool>>& inputs) {
    const btor2::Btor2Text written = btor2::written(system);
    Btor2File file(written.text);
    ASSERT_EQ(file.error_text(), "") << written.text;
    const auto states = states_of(circuit, inputs);
    std::map<std::string, std::size_t> places;
    for (const Id<FlatSystem::Variable> id : flat.variables.ids()) places[flat.variables[id].name] = id.index;
    NodeValues values(circuit.gates.size());
    for (std::size_t step = 0; step < inputs.size(); ++step) {
        for (std::size_t i = 0; i < circuit.inputs.size(); ++i) values[circuit.inputs[i].node] = inputs[step][i];
        evaluate_gates(circuit, values);
        const std::vector<bool> bad = file.step([&](std::string name) {
            const bool at_first = name.ends_with(".first");
            if (at_first) name.resize(name.size() - std::string_view(".first").size());
            const std::int64_t value = states[at_first ? 0 : step][places.at(name)];
            return flat.variables[{static_cast<std::uint32_t>(places.at(name))}].type.boolean ? -value : value;
        });
        for (const Circuit::Target& target : circuit.targets) {
            if (!target.justice.empty() || target.undefined != Gates::no) continue;
            const auto place = std::ranges::find(file.bads(), system.properties[target.about].name);
            ASSERT_NE(place, file.bads().end());
            ASSERT_EQ(bad[static_cast<std::size_t>(place - file.bads().begin())], value_of(values, target.bad))
                << *place << " in step " << step << "\n"
                << written.text;
        }
        std::vector<bool> next;
        for (const Circuit::Latch& latch : circuit.latches) next.push_back(value_of(values, latch.next));
        for (std::size_t i = 0; i < next.size(); ++i) values[circuit.latches[i].node] = next[i];
    }
}

void compare(const System& system, Random& random, Seen& seen) {
    FlatSystem flat = flattened(system);
    const Circuit circuit = circuit_of(system, flat).circuit;
    ASSERT_EQ(verify(circuit), std::vector<std::string>{});
    const auto graph = explored(system, 300);
    if (!graph || !graph->total) return;
    ++seen.systems;
    Property any{.name = "any", .pattern = Pattern::Reachable, .operands = {}};
    System with = system;
    any.operands = {with.exprs.constant(true)};
    FlatSystem flat_with = flattened(with);
    for (int run = 0; run < 6; ++run) {
        Walk walk(circuit, random);
        for (int step = 0; step < 8 && walk.look(); ++step) {
            const auto states = states_of(circuit, walk.inputs);
            ASSERT_NO_FATAL_FAILURE(expect_targets(system, flat, circuit, walk.values(), states.back(), seen));
            ASSERT_EQ(doubt(with, flat_with, any, {states, {}}), "");
            ++seen.steps;
            walk.step();
        }
        if (!walk.inputs.empty()) ++seen.starts;
        ASSERT_NO_FATAL_FAILURE(expect_same_words(system, flat, circuit, walk.inputs));
        const std::vector<aiger::AigerProperty> requested = aiger::queries_of(system, flat, circuit);
        for (const aiger::Form form : {aiger::Form::Ascii, aiger::Form::Binary})
            for (const aiger::Extent extent : {aiger::Extent::Whole, aiger::Extent::Cone})
                ASSERT_NO_FATAL_FAILURE(expect_same_text(circuit, aiger::written(circuit, requested, form, extent),
                                                         requested, walk.inputs));
    }
}

TEST(RandomizedCircuit, MakesTheStepsOfRandomSystemsAndItsTextTheSame) {
    Seen seen;
    for (int seed = 1; seed <= test_size(200); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        System system = random_system(random);
        ask_more(system, random);
        ASSERT_NO_FATAL_FAILURE(compare(system, random, seen));
    }
    std::cout << seen.systems << " systems, " << seen.steps << " steps, " << seen.targets << " targets, " << seen.hits
              << " of them reached\n";
    EXPECT_GT(seen.steps, seen.systems);
    EXPECT_GT(seen.hits, seen.targets / 10);
}

TEST(RandomizedCircuit, MakesTheStepsOfRandomLoops) {
    Seen seen;
    for (int seed = 1; seed <= test_size(3); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        for (System& system : untimed_models(random_loop(random))) {
            SCOPED_TRACE(system.scope);
            ask_more(system, random);
            ASSERT_NO_FATAL_FAILURE(compare(system, random, seen));
        }
    }
    std::cout << seen.systems << " systems, " << seen.steps << " steps, " << seen.starts << " runs\n";
    EXPECT_GT(seen.steps, 0u);
}

/// Checks that the encoding of integers as bits has exactly the values of their ranges, and that steps preserve these
/// values.
TEST(RandomizedCircuit, WordsHoldTheValuesOfTheirRanges) {
    for (const Type type : {integer_type(-3, 4), integer_type(-4, 3), integer_type(0, 5), integer_type(7, 7),
                            integer_type(5, 9), integer_type(1000, 1003), integer_type(-9, -8), Type{}}) {
        System system;
        system.name = "one";
        system.main = system.modules.add({"main", {}, {}, {}});
        system.modules[system.main].symbols.add({"free", type, System::StateSymbol{}, "", {}});
        const auto leaf = system.exprs.leaf(Op::Variable, 0);
        system.modules[system.main].symbols.add({"kept", type, System::StateSymbol{{}, leaf}, "", {}});
        system.modules[system.main].symbols.add({"last", type, System::StateSymbol{leaf, leaf}, "", {}});
        FlatSystem flat = flattened(system);
        const Circuit circuit = circuit_of(system, flat).circuit;
        Random random(3);
        std::set<std::int64_t> values;
        for (int run = 0; run < 200; ++run) {
            Walk walk(circuit, random);
            for (int step = 0; step < 2; ++step) {
                ASSERT_TRUE(walk.look());
                walk.step();
            }
            const auto states = states_of(circuit, walk.inputs);
            values.insert(states[0][0]);
            EXPECT_EQ(states[0][2], states[0][0]);
            EXPECT_EQ(states[1][1], states[0][0]);
            EXPECT_EQ(states[1][2], states[0][0]);
        }
        EXPECT_EQ(*values.begin(), type.low);
        EXPECT_EQ(*values.rbegin(), type.high);
        EXPECT_EQ(values.size(), static_cast<std::size_t>(type.high - type.low + 1));
    }
}

}  // namespace
}  // namespace grafverif
