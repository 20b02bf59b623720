// SPDX-License-Identifier: MIT
// Compares compositional checking of untimed models with checking the complete model, on random networks of two to four
// independent parts, in abstract and in discrete time. Each premise is omitted once, to show that the comparison
// detects the omission.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "check/decomposition/interleaved.hpp"
#include "check/decomposition/preservation.hpp"
#include "check/decomposition/subsystem_searches.hpp"
#include "check/portfolio.hpp"
#include "check/symbolic/interleaving_premises.hpp"
#include "ir/subsystems.hpp"
#include "pipeline/check.hpp"
#include "run/project.hpp"
#include "run/replay.hpp"
#include "schedule/network.hpp"
#include "support/random_subsystems.hpp"
#include "support/read_loop.hpp"
#include "support/row_counts.hpp"
#include "support/run_transition_system.hpp"
#include "support/test_size.hpp"
#include "support/untimed_loop.hpp"

namespace grafverif {
namespace {

using System = TransitionSystem;
using Counts = std::map<std::string, int>;

/// Returns a loop with the same properties as the network.
ClosedLoop loop_around(const Network& network) {
    ClosedLoop loop;
    loop.name = network.name;
    for (const Network::Variable& variable : network.variables) loop.shared.add({variable.name, variable.type});
    const auto leaf = [&](const Expr& node) {
        ClosedLoop::Symbol symbol = ClosedLoop::SharedSymbol{{static_cast<std::uint32_t>(node.value)}};
        if (node.op == Op::At) symbol = ClosedLoop::LocationSymbol{{at_process(node)}, {at_location(node)}};
        return loop.exprs.leaf(Op::Variable, loop.symbols.add(symbol).index);
    };
    for (Property property : network.properties) {
        const bool race = network.race.valid() && property.pattern == Pattern::Never &&
                          network.exprs[property.operands[0]].op == Op::Variable &&
                          network.exprs[property.operands[0]].value == network.race.index;
        if (race) continue;  // every model already contains the property about races
        for (Id<Expr>& operand : property.operands) operand = translate(network.exprs, operand, loop.exprs, leaf);
        loop.properties.add(std::move(property));
    }
    return loop;
}

System random_system(Random& random, int parts, TimeModel time) {
    Network network = random_parts(random, parts);
    query_subsystems(network, random);
    Diagnostics diagnostics;
    const ScheduleOptions options{.plant = PlantApproach::Automata, .time = time};
    return schedule_network({}, loop_around(network), {}, network, options, diagnostics).value();
}

/// Follows `run`, which contains only the values of the symbols of the main module: computes the set of complete states
/// to which it may lead. An empty set means that `run` is not a run of the system.
class Follower {
public:
    Follower(const System& system, const SystemRun& run) : system_(system) {
        std::vector<SystemState> here = like(first_states(system).value(), run.states.front());
        for (std::size_t i = 0; i < run.states.size(); ++i) {
            if (i > 0) here = like(after(here), run.states[i]);
            if (i == run.loop) loop_ = here;
        }
        end_ = run.loop && like(after(here), run.states[*run.loop]).empty() ? std::vector<SystemState>{} : here;
    }
    const std::vector<SystemState>& end() const { return end_; }

private:
    std::vector<SystemState> after(const std::vector<SystemState>& states) const {
        std::vector<SystemState> all;
        for (const SystemState& state : states) {
            std::vector<SystemState> next = successors(system_, state).value();
            std::ranges::move(next, std::back_inserter(all));
        }
        return all;
    }
    std::vector<SystemState> like(std::vector<SystemState> states, const std::vector<std::int64_t>& seen) const {
        const Table<System::Symbol>& symbols = system_.modules[system_.main].symbols;
        std::ranges::sort(states);
        states.erase(std::ranges::unique(states).begin(), states.end());
        std::erase_if(states, [&](const SystemState& state) {
            return !std::ranges::all_of(symbols.ids(), [&](Id<System::Symbol> id) {
                return !is_state(symbols[id]) || value_of(system_, state, symbols[id].name) == seen[id.index];
            });
        });
        return states;
    }
    bool is_state(const System::Symbol& symbol) const {
        if (const auto* member = std::get_if<System::MemberSymbol>(&symbol.kind))
            return is_state(system_.modules[system_.instances[member->instance].module].symbols[member->symbol]);
        return std::holds_alternative<System::StateSymbol>(symbol.kind);
    }

    const System& system_;
    std::vector<SystemState> loop_ = {}, end_ = {};
};

/// Checks that the run is a run of the complete model and proves the verdict on the property.
void confirm(const System& system, const Property& property, const SystemRun& run) {
    EXPECT_FALSE(Follower(system, run).end().empty()) << "it is not a run of the complete model";
    const auto holds = [&](std::size_t state, std::size_t operand) {
        return value_in(system, run.states[state], property.operands[operand]) != 0;
    };
    const std::size_t last = run.states.size() - 1;
    const bool settled = !property.at_stable || value_in(system, run.states[last], system.settled) != 0;
    std::size_t kept = 0;  // index of the state from which on the run avoids the goal
    if (property.pattern == Pattern::LeadsTo)
        for (std::size_t state = 0; state <= last; ++state)
            if (holds(state, 1) && settled) kept = state + 1;
    switch (property.pattern) {
    case Pattern::Always: EXPECT_TRUE(settled && !holds(last, 0)); break;
    case Pattern::Never:
    case Pattern::Reachable: EXPECT_TRUE(settled && holds(last, 0)); break;
    case Pattern::Inevitable:
        ASSERT_TRUE(run.loop);
        for (std::size_t state = 0; state <= last && !property.at_stable; ++state) EXPECT_FALSE(holds(state, 0));
        break;
    case Pattern::LeadsTo: {
        ASSERT_TRUE(run.loop);
        if (property.at_stable) break;
        EXPECT_LE(kept, *run.loop);
        bool requested = false;
        for (std::size_t state = kept; state <= last; ++state) requested = requested || holds(state, 0);
        EXPECT_TRUE(requested);
        break;
    }
    default: break;
    }
}

std::string claim(const Property& property, const Verdict& verdict) {
    return std::to_string(static_cast<int>(property.pattern)) + (property.at_stable ? " at stable " : " ") +
           std::string(word(verdict.outcome)) + (verdict.scope.searched.empty() ? ", whole" : ", apart");
}

void compare(const SymbolicResult& apart, const SymbolicResult& whole, const System& system, Counts& seen) {
    EXPECT_EQ(apart.fault.has_value(), whole.fault.has_value());
    EXPECT_EQ(apart.verdicts.size(), whole.verdicts.size());
    for (std::size_t i = 0; i < std::min(apart.verdicts.size(), whole.verdicts.size()); ++i) {
        const Verdict &here = apart.verdicts[i], &there = whole.verdicts[i];
        const Property& property = system.properties[here.about];
        SCOPED_TRACE(property.name + ": " + claim(property, here) + ", complete model " +
                     std::string(word(there.outcome)));
        ++seen[claim(property, here)];
        EXPECT_EQ(here.property, there.property);
        if (apart.runs[i]) confirm(system, property, *apart.runs[i]);
        if (apart.runs[i]) ++seen["runs"];
        // The property `can_move` of each part is stronger than that of the complete model.
        if (!property.operands.empty() && property.operands[0] == system.parts.can_move) {
            EXPECT_FALSE(here.outcome == Outcome::Holds && there.outcome == Outcome::Violated);
            continue;
        }
        EXPECT_EQ(here.outcome, there.outcome);
        EXPECT_EQ(here.vacuous, there.vacuous);
        EXPECT_EQ(apart.runs[i].has_value(), whole.runs[i].has_value());
    }
}

SymbolicResult compare(const System& system, Counts& seen) {
    SymbolicResult apart = check_symbolic_by_parts(system);
    compare(apart, check_symbolic(system), system, seen);
    return apart;
}

TEST(RandomizedInterleaving, CompositionalChecksGiveTheVerdictsAndRunsOfTheCompleteModel) {
    Counts seen;
    const auto cases = static_cast<std::uint64_t>(test_size(60));
    for (std::uint64_t seed = 1; seed <= cases && !HasFailure(); ++seed)
        for (const TimeModel time : {TimeModel::Abstract, TimeModel::Discrete}) {
            SCOPED_TRACE("seed " + std::to_string(seed) + (time == TimeModel::Discrete ? ", discrete" : ""));
            Random random(seed);
            const System system = random_system(random, static_cast<int>(random_number(random, 2, 3)), time);
            ASSERT_GE(system.parts.each.size(), 2U);
            compare(system, seen);
        }
    EXPECT_GT(seen["runs"], test_size(60));
    print_counts(seen);
}

TEST(RandomizedInterleaving, RunsOfCompositionalChecksReplayOnAllCharts) {
    Counts seen;
    const auto loops = static_cast<std::uint64_t>(test_size(4));
    for (std::uint64_t seed = 1; seed <= loops && !HasFailure(); ++seed)
        for (const TimeModel time : {TimeModel::Abstract, TimeModel::Discrete}) {
            SCOPED_TRACE("seed " + std::to_string(seed) + (time == TimeModel::Discrete ? ", discrete" : ""));
            Random random(seed);
            const LoopUnderTest loop = read_loop(loop_of_plcs(random, 2), {.grain = Grain::Atomic});
            const System system =
                untimed_loop(loop.model, {.plant = PlantApproach::Automata, .time = time}, Grain::Atomic);
            ASSERT_EQ(system.parts.each.size(), 2U);
            for (const auto& run : compare(system, seen).runs) {
                if (!run) continue;
                const auto wrong = disagreement(project(system, *run), loop.charts());
                EXPECT_FALSE(wrong) << replay_failure("a run", *wrong);
            }
        }
    EXPECT_GT(seen["runs"], test_size(4));
    print_counts(seen);
}

TEST(RandomizedInterleaving, PortfolioGivesTheVerdictsAndRunsOfTheCompleteModel) {
    Counts seen;
    const auto cases = static_cast<std::uint64_t>(test_size(10));
    for (std::uint64_t seed = 1; seed <= cases && !HasFailure(); ++seed)
        for (const TimeModel time : {TimeModel::Abstract, TimeModel::Discrete}) {
            SCOPED_TRACE("seed " + std::to_string(seed) + (time == TimeModel::Discrete ? ", discrete" : ""));
            Random random(seed);
            const System system = random_system(random, static_cast<int>(random_number(random, 2, 3)), time);
            const SymbolicResult whole = check_symbolic(system);
            const PdrResult together = check_together(system);
            EXPECT_EQ(together.failures, std::vector<std::string>{});
            compare({together.verdicts, together.runs, together.fault}, whole, system, seen);
        }
    EXPECT_GT(seen["runs"], test_size(10));
    print_counts(seen);
}

/// A premise that the test omits: it is assumed to hold for every omitted subsystem.
struct Premise {
    const char* name = "";
    void (*grant)(OmittedSubsystem&) = nullptr;
};
const Premise premises[] = {
    {"the others can let time pass forever", [](OmittedSubsystem& other) { other.diverges = true; }},
    {"the others have no timelock", [](OmittedSubsystem& other) { other.never_locks = true; }},
    {"the others become quiescent", [](OmittedSubsystem& other) { other.rests = true; }},
    {"the others are quiescent when time passes", [](OmittedSubsystem& other) { other.settles = true; }},
};

/// A part of a system: the verdicts on the properties that read only this part, and the premises that the part fulfils
/// if it is omitted.
struct Alone {
    SymbolicResult result = {};
    OmittedSubsystem as = {};
};

Alone alone(const System& system, std::uint32_t part, const std::vector<Id<Property>>& requested) {
    System made = with_parts(system, {part});
    for (const Id<Property> id : requested) made.properties.add(system.properties[id]);
    const SymbolicOptions options;
    symbolic::Check check(made, options);
    Alone found{check.result(), {.name = system.parts.each[part].name, .searched = true}};
    symbolic::InterleavingPremises interleaving(made, check, system.parts.waits, {system.parts.each[part].moves});
    const bool timed = system.parts.can_wait.valid();
    found.as.never_locks = !timed || interleaving.never_locks();
    found.as.diverges = !timed || interleaving.diverges();
    found.as.rests = interleaving.rests();
    const Bdd settled = check.meaning(made, made.settled);
    found.as.settles =
        timed ? (interleaving.ready() & ~settled).is_false() : !(interleaving.reached() & settled).is_false();
    return found;
}

/// Computes the verdicts of one part for the complete model under all premises but one.
void leave_out(const System& system, Counts& tried, Counts& failed) {
    const SymbolicOptions options;
    const SubsystemSearches parts(system, options);
    const SymbolicResult whole = check_symbolic(system);
    for (const std::uint32_t part : parts.all()) {
        std::vector<Id<Property>> requested;
        for (const Id<Property> id : system.properties.ids())
            if (!parts.about_each(system.properties[id]) &&
                parts.reads(system.properties[id].operands) == PartList{part})
                requested.push_back(id);
        const Alone here = alone(system, part, requested);
        std::vector<OmittedSubsystem> others;
        for (const std::uint32_t other : parts.others({part})) others.push_back(alone(system, other, {}).as);
        for (std::size_t i = 0; i < requested.size(); ++i) {
            const Property& property = system.properties[requested[i]];
            const Verdict &apart = here.result.verdicts[i], &there = whole.verdicts[requested[i].index];
            const bool differs = apart.outcome != there.outcome || apart.vacuous != there.vacuous;
            const auto stands = [&](const Premise* granted) {
                std::vector<OmittedSubsystem> seen = others;
                std::vector<const OmittedSubsystem*> all;
                for (OmittedSubsystem& other : seen) {
                    if (granted != nullptr) granted->grant(other);
                    all.push_back(&other);
                }
                return (parts.timed() ? preservation_obstacle : untimed_preservation_obstacle)(apart,
                                                                                               property.at_stable, all)
                    .empty();
            };
            const std::string time = parts.timed() ? "discrete: " : "abstract: ";
            const bool comes_apart = !property.at_stable || settled_separately(property.pattern);
            EXPECT_FALSE(stands(nullptr) && comes_apart && differs) << property.name;
            if (stands(nullptr) && !comes_apart && ++tried[time + "quiescence at the end"] != 0 && differs)
                ++failed[time + "quiescence at the end"];
            if (stands(nullptr) || !comes_apart) continue;
            for (const Premise& premise : premises) {
                if (!stands(&premise)) continue;
                ++tried[time + premise.name];
                if (differs) ++failed[time + premise.name];
            }
        }
    }
}

TEST(RandomizedInterleaving, EachPremiseIsNeeded) {
    Counts tried, failed;
    const auto cases = static_cast<std::uint64_t>(test_size(400));
    for (std::uint64_t seed = 1; seed <= cases && !HasFailure(); ++seed)
        for (const TimeModel time : {TimeModel::Abstract, TimeModel::Discrete}) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            Random random(1'000'000 + seed);
            leave_out(random_system(random, 2, time), tried, failed);
        }
    Counts counts;
    for (const auto& [what, count] : tried) {
        counts[what + ": omitted"] = count;
        counts[what + ": wrong verdicts"] = failed[what];
        const bool rare = what.ends_with(premises[1].name) && count < 3000;
        EXPECT_TRUE(failed[what] > 0 || rare) << what << " of " << count;
    }
    print_counts(counts);
}

}  // namespace
}  // namespace grafverif
