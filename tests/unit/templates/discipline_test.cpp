// SPDX-License-Identifier: MIT
// Tests the modelling rules of the paper CEP13, section 4.4, on all reachable states of every component, for all
// inputs.
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "library.hpp"

namespace grafverif {
namespace {

/// Constants that keep the state space of a component small, and the values of its integer inputs.
struct Setting {
    std::map<std::string, std::int64_t> constants = {};
    std::string initially = {};
    std::int64_t highest_input = 1;
};

Setting setting(const std::string& name) {
    if (name == "position_sensors_2") return {{{"X_IN_max", 1}, {"X_OUT_min", 3}}, "in", 4};
    if (name == "position_sensors_3")
        return {{{"X_IN_max", 1}, {"X_MID_min", 3}, {"X_MID_max", 3}, {"X_OUT_min", 5}}, "in", 6};
    if (name == "level_sensors") return {{{"LOW_min", 1}, {"HIGH_min", 3}}, "empty", 4};
    if (name == "tank_level") return {{{"LEVEL_max", 5}, {"D_LEVEL", 2}}};
    if (name == "free_integer") return {{{"HIGH", 3}}};
    if (name == "rotary_selector") return {{{"POSITIONS", 3}}};
    if (name == "lift_car") return {{{"TOP", 2}}};
    if (name == "cylinder_5_3" || name == "cylinder_5_3_stuck" || name == "cylinder_monostable")
        return {{{"X_max", 5}, {"D_X", 2}}};
    return {};
}

/// The states that a single component can reach while its inputs change at arbitrary times. `out_of_range` is true if a
/// move causes a model error.
struct Closure {
    std::set<TaddState> states = {};
    bool out_of_range = false;
};

std::vector<TaddState> with_other_inputs(const Network& network, const Component& component, const Setting& setting,
                                         const TaddState& state) {
    std::vector<TaddState> found;
    const NaiveTadd tadd(network);
    for (const Component::Parameter& parameter : component.parameters) {
        if (parameter.kind != Component::ParameterKind::Input) continue;
        const bool boolean = parameter.value == Component::ValueKind::Boolean;
        for (std::int64_t value = 0; value <= (boolean ? 1 : setting.highest_input); ++value) {
            found.push_back(state);
            found.back().variables[tadd.variable_id(parameter.name).index] = value;
        }
    }
    return found;
}

Closure closure(const Network& network, const Component& component, const Setting& setting) {
    const NaiveTadd tadd(network);
    TaddState first = tadd.initial();
    for (const Component::Parameter& parameter : component.parameters)
        if (parameter.kind == Component::ParameterKind::Input)
            first.variables[tadd.variable_id(parameter.name).index] = 0;
    Closure result;
    std::deque<TaddState> open{first};
    result.states.insert(first);
    const auto visit = [&](const TaddState& state) {
        if (result.states.insert(state).second) open.push_back(state);
    };
    for (; !open.empty(); open.pop_front()) {
        const TaddState state = open.front();
        for (const TaddState& other : with_other_inputs(network, component, setting, state)) visit(other);
        for (const TaddMove& move : tadd.successors(state)) {
            if (move.out_of_range) result.out_of_range = true;
            else visit(move.next);
        }
    }
    return result;
}

/// True if every run of urgent edges from `state` leads within `depth` moves to a state from which time can pass. If no
/// urgent edge is enabled, it is sufficient that some run leads to such a state.
bool time_passes(const NaiveTadd& tadd, const TaddState& state, std::size_t depth) {
    if (depth == 0) return false;
    bool can_pass = false;
    for (const TaddMove& move : tadd.successors(state)) {
        if (move.delay()) return true;
        const Network& network = tadd.network();
        const Network::Edge& edge = network.templates[network.processes[move.process].automaton].edges[move.edge];
        const bool later = time_passes(tadd, move.next, depth - 1);
        if (edge.urgent && !later) return false;
        can_pass = can_pass || later;
    }
    return can_pass;
}

bool is_urgent_edge(const Network& network, const TaddMove& move) {
    return !move.delay() && network.templates[network.processes[move.process].automaton].edges[move.edge].urgent;
}

class EveryComponent : public testing::TestWithParam<std::string> {
protected:
    const Component component = library_component(GetParam());
    const Setting chosen = setting(GetParam());
    const Network network = lone_component(component, chosen.constants, chosen.initially);
    const NaiveTadd tadd{network};
    const Closure all = closure(network, component, chosen);
};

TEST_P(EveryComponent, HasTheNameOfItsFileAndASummary) {
    EXPECT_EQ(component.name, GetParam());
    EXPECT_GE(component.summary.size(), 20U);
    EXPECT_TRUE(component.summary.ends_with('.')) << component.summary;
    EXPECT_TRUE(verify(component).empty());
}

TEST_P(EveryComponent, ReachesEachOfItsLocations) {
    std::set<std::string> reached;
    for (const TaddState& state : all.states) reached.insert(tadd.location(state, "it"));
    // The location `sliding` is reachable only if ENDLESS is true.
    if (GetParam() == "part_feeder") reached.insert("sliding");
    for (const Component::Location& location : component.locations)
        EXPECT_TRUE(reached.contains(location.name)) << location.name;
}

TEST_P(EveryComponent, KeepsItsVariablesInTheirRanges) { EXPECT_FALSE(all.out_of_range); }

TEST_P(EveryComponent, LetsTimePassFromEveryState) {
    for (const TaddState& state : all.states) ASSERT_TRUE(time_passes(tadd, state, 12)) << tadd.location(state, "it");
}

TEST_P(EveryComponent, LeavesNoChoiceBetweenInstantaneousMoves) {
    for (const TaddState& state : all.states) {
        std::set<TaddState> next;
        for (const TaddMove& move : tadd.successors(state))
            if (is_urgent_edge(network, move)) next.insert(move.next);
        EXPECT_LE(next.size(), 1U) << tadd.location(state, "it");
    }
}

TEST_P(EveryComponent, IsEitherInstantaneousOrTimedNeverBoth) {
    for (const Component::Edge& edge : component.edges) {
        if (edge.urgent) {
            EXPECT_TRUE(edge.constraint.empty());
            continue;
        }
        const bool forced = !component.locations[edge.from].invariant.empty();
        EXPECT_TRUE(!forced || !edge.constraint.empty())
            << "an edge from a location with an invariant has no time constraint";
    }
}

TEST_P(EveryComponent, StartsItsClockWithEachMovement) {
    for (const Component::Edge& edge : component.edges)
        for (const Component::ClockConstraint& bound : component.locations[edge.to].invariant)
            EXPECT_TRUE(std::ranges::find(edge.resets, bound.clock) != edge.resets.end())
                << component.locations[edge.from].name << " -> " << component.locations[edge.to].name;
}

TEST_P(EveryComponent, HasNoMovementEndWhileSomethingInstantaneousIsDue) {
    for (const TaddState& state : all.states) {
        if (!tadd.urgent_enabled(state)) continue;
        for (const TaddMove& move : tadd.successors(state)) {
            const Network::Template& automaton = *network.templates.begin();
            const Network::Edge& edge = automaton.edges[move.edge];
            EXPECT_TRUE(edge.urgent || automaton.locations[edge.from].invariant.empty()) << tadd.location(state, "it");
        }
    }
}

TEST_P(EveryComponent, StartsInEachLocationWithTheOutputsItHasThere) {
    const auto outputs = [&](const NaiveTadd& automaton, const TaddState& state) {
        std::vector<std::int64_t> values;
        for (const Component::Parameter& parameter : component.parameters)
            if (parameter.kind == Component::ParameterKind::Output && parameter.value == Component::ValueKind::Boolean)
                values.push_back(automaton.variable(state, parameter.name));
        return values;
    };
    std::map<std::string, std::set<std::vector<std::int64_t>>> seen;
    for (const TaddState& state : all.states) seen[tadd.location(state, "it")].insert(outputs(tadd, state));
    for (const Component::Location& location : component.locations) {
        const Network started = lone_component(component, chosen.constants, location.name);
        const NaiveTadd automaton(started);
        if (seen.contains(location.name)) {
            EXPECT_TRUE(seen[location.name].contains(outputs(automaton, automaton.initial()))) << location.name;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Library, EveryComponent, testing::ValuesIn(library_names()),
                         [](const testing::TestParamInfo<std::string>& parameter) { return parameter.param; });

TEST(PartFeederWithoutEnd, LetsTimePassFromEveryState) {
    const Component component = library_component("part_feeder");
    const Network network = lone_component(component, {{"ENDLESS", 1}});
    const NaiveTadd tadd(network);
    bool slides = false;
    for (const TaddState& state : closure(network, component, {}).states) {
        EXPECT_TRUE(time_passes(tadd, state, 12));
        slides = slides || tadd.location(state, "it") == "sliding";
    }
    EXPECT_TRUE(slides);
}

}  // namespace
}  // namespace grafverif
