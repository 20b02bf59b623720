// SPDX-License-Identifier: MIT
// Compares the timed engine with the reference semantics on random networks. The discrete states must be equal, and the
// verdicts must be those of a naive fixpoint on the explicit graph. A finer time unit does not change `holds` or
// `violated`.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

#include "support/naive_tadd.hpp"
#include "support/random_loop.hpp"
#include "support/random_network.hpp"
#include "support/read_loop.hpp"
#include "support/test_size.hpp"
#include "unit/check/networks.hpp"

namespace grafverif {
namespace {

/// Every reachable state with its moves, computed by the reference semantics.
struct Explored {
    std::vector<TaddState> states = {};
    std::vector<std::vector<std::size_t>> next = {}, actions = {};
    std::vector<bool> passes = {}, acts = {}, faulty = {};
    std::vector<std::size_t> later = {};  // the successor after one unit of time
    bool any_fault = false;
};

std::optional<Explored> explored(const NaiveTadd& tadd, std::size_t limit) {
    Explored all;
    std::map<TaddState, std::size_t> numbers;
    const auto number = [&](const TaddState& state) {
        const auto [place, fresh] = numbers.emplace(state, all.states.size());
        if (fresh) all.states.push_back(state);
        return place->second;
    };
    number(tadd.initial());
    for (std::size_t i = 0; i < all.states.size(); ++i) {
        if (all.states.size() > limit) return {};
        all.next.emplace_back();
        all.actions.emplace_back();
        all.passes.push_back(false);
        all.acts.push_back(false);
        all.faulty.push_back(false);
        all.later.push_back(i);
        if (const Id<Network::Variable> race = tadd.network().race;
            race.valid() && all.states[i].variables[race.index] != 0) {
            all.faulty[i] = all.any_fault = true;
            continue;
        }
        for (const TaddMove& move : tadd.successors(TaddState(all.states[i]))) {
            if (move.out_of_range) {
                all.faulty[i] = all.any_fault = true;
                continue;
            }
            const std::size_t next = number(move.next);
            all.next[i].push_back(next);
            (move.delay() ? all.passes : all.acts)[i] = true;
            if (move.delay()) all.later[i] = next;
            else all.actions[i].push_back(next);
        }
    }
    return all;
}

/// Returns the states from which `met` holds at some time on every maximal run. A state with a model error counts as
/// met.
std::vector<bool> inevitable(const Explored& all, std::vector<bool> met) {
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < all.states.size(); ++i) {
            const bool leads =
                !all.next[i].empty() && std::ranges::all_of(all.next[i], [&](std::size_t next) { return met[next]; });
            if (met[i] || !(leads || all.faulty[i])) continue;
            met[i] = changed = true;
        }
    }
    return met;
}

/// Returns the states from which a state of `goal` is reachable by moves that `by` admits.
template <class By>
std::vector<bool> possible(const Explored& all, std::vector<bool> goal, const By& by) {
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < all.states.size(); ++i) {
            if (goal[i]) continue;
            for (const std::size_t next : all.next[i]) goal[i] = goal[i] || (goal[next] && by(i, next));
            changed = changed || goal[i];
        }
    }
    return goal;
}

/// True if the property holds in integer time. If it holds in a model with a model error, the test draws no conclusion.
bool naive_verdict(const NaiveTadd& tadd, const Explored& all, const Property& property) {
    const auto where = [&](std::size_t operand) {
        std::vector<bool> set;
        for (const TaddState& state : all.states)
            set.push_back((!property.at_stable || tadd.settled(state)) &&
                          tadd.holds(property.operands[operand], state));
        return set;
    };
    const auto everywhere = [&](const auto& test) {
        for (std::size_t i = 0; i < all.states.size(); ++i)
            if (!test(i)) return false;
        return true;
    };
    const auto is_considered = [&](std::size_t i) { return !property.at_stable || tadd.settled(all.states[i]); };
    switch (property.pattern) {
    case Pattern::Always:
        return everywhere(
            [&](std::size_t i) { return !is_considered(i) || tadd.holds(property.operands[0], all.states[i]); });
    case Pattern::Never: return everywhere([&, p = where(0)](std::size_t i) { return !p[i]; });
    case Pattern::Reachable: return !everywhere([&, p = where(0)](std::size_t i) { return !p[i]; });
    case Pattern::ExactlyOneOf:
        return everywhere([&](std::size_t i) {
            return !is_considered(i) || std::ranges::count_if(property.operands, [&](Id<Expr> p) {
                                            return tadd.holds(p, all.states[i]);
                                        }) == 1;
        });
    case Pattern::Inevitable: return inevitable(all, where(0))[0];
    case Pattern::LeadsTo: {
        const std::vector<bool> p = where(0), q = inevitable(all, where(1));
        return everywhere([&](std::size_t i) { return !p[i] || q[i]; });
    }
    case Pattern::NoDeadlock:
        return everywhere([&](std::size_t i) {
            if (!is_considered(i)) return true;
            std::set<std::size_t> seen;
            for (; seen.insert(i).second; i = all.later[i])
                if (all.acts[i] || all.faulty[i]) return true;
            return false;
        });
    case Pattern::NoTimelock: {
        std::vector<bool> goal = all.passes;
        for (std::size_t i = 0; i < goal.size(); ++i) goal[i] = goal[i] || all.faulty[i];
        const auto flows = possible(all, goal, [](std::size_t, std::size_t) { return true; });
        return everywhere([&](std::size_t i) { return !is_considered(i) || flows[i]; });
    }
    case Pattern::AlwaysPossible: {
        std::vector<bool> goal = where(0);
        for (std::size_t i = 0; i < goal.size(); ++i) goal[i] = goal[i] || all.faulty[i];
        const auto reaches = possible(all, goal, [](std::size_t, std::size_t) { return true; });
        return everywhere([&](std::size_t i) { return reaches[i]; });
    }
    case Pattern::ReachableAllSteps:
    case Pattern::Watched:
    case Pattern::RawUppaal:
    case Pattern::RawCtl:
    case Pattern::RawLtl: break;
    }
    return true;
}

/// Returns the least number of moves to a state of `goal`. A delay of any length counts as one move. The search is
/// breadth-first over pairs of a state and a flag, which is true if the last move was a delay.
std::optional<std::size_t> fewest_moves(const Explored& all, const std::vector<bool>& goal) {
    std::set<std::pair<std::size_t, bool>> seen, level = {{0, false}};
    for (std::size_t moves = 0; !level.empty(); ++moves) {
        std::vector<std::pair<std::size_t, bool>> open(level.begin(), level.end());
        for (std::size_t i = 0; i < open.size(); ++i) {  // a continued delay is not a further move
            const auto [state, waited] = open[i];
            if (waited && all.passes[state] && level.emplace(all.later[state], true).second)
                open.emplace_back(all.later[state], true);
        }
        std::set<std::pair<std::size_t, bool>> next;
        for (const auto& [state, waited] : level) {
            if (goal[state]) return moves;
            if (!seen.emplace(state, waited).second) continue;
            for (const std::size_t other : all.actions[state])
                if (!seen.contains({other, false})) next.emplace(other, false);
            if (all.passes[state] && !seen.contains({all.later[state], true})) next.emplace(all.later[state], true);
        }
        level = std::move(next);
    }
    return {};
}

bool about_all_states(Pattern pattern) {
    return pattern != Pattern::Reachable && pattern != Pattern::ReachableAllSteps;
}

/// Adds at least one property of each pattern that is decided without an observer, with random terms over the network.
void add_queries(Network& network, Random& random) {
    std::vector<Id<Expr>> terms;
    for (const Id<Network::Variable> id : network.variables.ids())
        if (network.variables[id].type.boolean && !network.variables[id].scratch)
            terms.push_back(network.exprs.leaf(Op::Variable, id.index));
    for (const Id<Network::Process> process : network.processes.ids())
        terms.push_back(network.exprs.at(process.index, 0));
    const auto term = [&] {
        Id<Expr> one =
            terms[static_cast<std::size_t>(random_number(random, 0, static_cast<std::int64_t>(terms.size()) - 1))];
        if (chance(random, 30)) one = network.exprs.disjunction(one, terms.front());
        return chance(random, 40) ? network.exprs.negation(one) : one;
    };
    int count = 0;
    const auto add = [&](Pattern pattern, std::vector<Id<Expr>> operands) {
        const bool stable = network.settled.valid() && chance(random, 30);
        network.properties.add({.name = "q" + std::to_string(count++),
                                .pattern = pattern,
                                .operands = std::move(operands),
                                .at_stable = stable});
    };
    for (const Pattern pattern :
         {Pattern::Always, Pattern::Never, Pattern::Reachable, Pattern::Inevitable, Pattern::AlwaysPossible})
        add(pattern, {term()});
    for (int k = 0; k < 3; ++k) add(Pattern::LeadsTo, {term(), term()});
    add(Pattern::Inevitable, {term()});
    add(Pattern::ExactlyOneOf, {term(), term()});
    add(Pattern::NoDeadlock, {});
    add(Pattern::NoTimelock, {});
}

struct Seen {
    int compared = 0;
    std::map<std::string, int> outcomes = {};
};

void compare(const Network& network, const NaiveTadd& tadd, const Explored& all, const TimedResult& result,
             Seen& seen) {
    for (const Property& property : network.properties) {
        if (property.pattern == Pattern::ReachableAllSteps || property.pattern >= Pattern::RawUppaal) continue;
        SCOPED_TRACE("property " + property.name + ", pattern " + std::to_string(static_cast<int>(property.pattern)));
        const Verdict& given = verdict(result, property.name);
        ++seen.outcomes[std::to_string(static_cast<int>(property.pattern)) + " " + outcome_text(result, property.name)];
        const bool holds = naive_verdict(tadd, all, property);
        if (given.outcome != Outcome::Unknown) EXPECT_EQ(given.outcome == Outcome::Holds, holds);
        else if (given.obstacle == UnknownReason::Faulty) EXPECT_EQ(holds, about_all_states(property.pattern));
        else EXPECT_EQ(given.obstacle, UnknownReason::Inexact) << given.reason;
        if (!given.run || (property.pattern != Pattern::Never && property.pattern != Pattern::Reachable)) continue;
        std::vector<bool> goal;
        for (const TaddState& state : all.states)
            goal.push_back((!property.at_stable || tadd.settled(state)) && tadd.holds(property.operands[0], state));
        EXPECT_EQ(given.run->moves.size(), fewest_moves(all, goal)) << "the run is not shortest";
    }
    ++seen.compared;
}

/// Checks that searches with any number of threads find the same states in the same order, with the same verdicts.
void compare_jobs(const Network& network, const TimedResult& one, bool links) {
    for (const unsigned jobs : {2U, 3U, 5U}) {
        SCOPED_TRACE(std::to_string(jobs) + " threads");
        const TimedResult several = check_timed(network, {.jobs = jobs, .slice = 1, .keep_links = links});
        EXPECT_EQ(several.states, one.states);
        EXPECT_EQ(several.transitions, one.transitions);
        EXPECT_EQ(several.time_passes, one.time_passes);
        ASSERT_EQ(several.verdicts.size(), one.verdicts.size());
        for (std::size_t i = 0; i < one.verdicts.size(); ++i) {
            const Verdict &given = one.verdicts[i], &found = several.verdicts[i];
            EXPECT_EQ(outcome_text(several, given.property), outcome_text(one, given.property));
            EXPECT_EQ(std::tie(found.reason, found.notes, found.vacuous),
                      std::tie(given.reason, given.notes, given.vacuous));
            EXPECT_EQ(found.run, given.run) << given.property;
        }
        ASSERT_EQ(several.errors.size(), one.errors.size());
        for (std::size_t i = 0; i < one.errors.size(); ++i) EXPECT_EQ(several.errors[i].run, one.errors[i].run);
    }
}

/// Checks that `holds` and `violated` are the same at a finer time unit. An unknown verdict may become `violated` or
/// remain unknown at a finer unit, but must not become `holds`.
void compare_units(const Network& network, const TimedResult& result) {
    for (const std::int64_t factor : {2, 3}) {
        const TimedResult finer = checked(refined(network, factor), {.max_states = 200'000});
        if (!finer.complete) continue;
        for (const Verdict& given : result.verdicts) {
            SCOPED_TRACE(given.property + " in units " + std::to_string(factor) +
                         " times as fine: " + outcome_text(finer, given.property));
            if (given.outcome != Outcome::Unknown)
                EXPECT_EQ(outcome_text(result, given.property), outcome_text(finer, given.property));
            else EXPECT_NE(verdict(finer, given.property).outcome, Outcome::Holds);
        }
    }
}

/// Returns the network without strict constraints.
Network closed(Network network) {
    const auto close = [](std::vector<Network::ClockConstraint>& constraints) {
        for (Network::ClockConstraint& constraint : constraints) {
            if (constraint.relation == Op::Less) constraint.relation = Op::LessEqual;
            if (constraint.relation == Op::Greater) constraint.relation = Op::GreaterEqual;
        }
    };
    for (Network::Template& automaton : network.templates) {
        for (Network::Location& location : automaton.locations) close(location.invariant);
        for (Network::Edge& edge : automaton.edges) close(edge.constraint);
    }
    return network;
}

std::set<std::pair<std::vector<std::uint32_t>, std::vector<std::int64_t>>> discrete(const Explored& all) {
    std::set<std::pair<std::vector<std::uint32_t>, std::vector<std::int64_t>>> set;
    for (const TaddState& state : all.states) set.emplace(state.locations, state.variables);
    return set;
}

/// Checks that the engine reaches exactly the discrete states of the reference semantics.
void compare_states(Network network, const Explored& all) {
    const auto states = discrete(all);
    if (states.size() > 60) return;
    network.properties = {};
    std::vector<Id<Expr>> ones;
    for (const auto& [locations, variables] : states) {
        std::vector<Id<Expr>> conjuncts;
        for (std::uint32_t process = 0; process < locations.size(); ++process)
            conjuncts.push_back(network.exprs.at(process, locations[process]));
        for (const Id<Network::Variable> id : network.variables.ids()) {
            if (network.variables[id].scratch) continue;
            const Id<Expr> leaf = network.exprs.leaf(Op::Variable, id.index);
            const std::int64_t is = variables[id.index];
            if (!network.variables[id].type.boolean)
                conjuncts.push_back(network.exprs.apply(Op::Equal, leaf, network.exprs.integer(is)));
            else conjuncts.push_back(is != 0 ? leaf : network.exprs.negation(leaf));
        }
        ones.push_back(network.exprs.conjunction(conjuncts));
        network.properties.add(
            {.name = "s" + std::to_string(ones.size()), .pattern = Pattern::Reachable, .operands = {ones.back()}});
    }
    network.properties.add({.name = "all", .pattern = Pattern::ExactlyOneOf, .operands = ones});
    const TimedResult result = check_timed(network);
    for (const Property& property : network.properties) {
        if (property.pattern == Pattern::Reachable)
            EXPECT_EQ(outcome_text(result, property.name), "holds") << property.name;
        else EXPECT_NE(verdict(result, property.name).outcome, Outcome::Violated);
    }
}

void compare_all(Network network, Random& random, Seen& seen) {
    add_queries(network, random);
    const NaiveTadd tadd(network);
    const auto all = explored(tadd, 3000);
    if (!all) return;
    const TimedResult result = checked(network);
    EXPECT_TRUE(result.complete);
    EXPECT_LE(result.states, all->states.size());
    const TimedResult sparing = check_timed(network, {.keep_links = false});
    for (const Verdict& given : result.verdicts)
        EXPECT_EQ(outcome_text(result, given.property), outcome_text(sparing, given.property));
    compare(network, tadd, *all, result, seen);
    compare_jobs(network, result, true);
    compare_jobs(network, sparing, false);
    compare_units(network, result);
    compare_states(network, *all);
}

void report(const Seen& seen) {
    for (const auto& [outcome, count] : seen.outcomes) testing::Test::RecordProperty("outcome " + outcome, count);
    if (std::getenv("GRAFVERIF_TEST_COUNTS") == nullptr) return;
    printf("%6d compared\n", seen.compared);
    for (const auto& [outcome, count] : seen.outcomes) printf("%6d %s\n", count, outcome.c_str());
}

TEST(RandomizedTimedEngine, RandomNetworksHaveTheStatesAndVerdictsOfTheReferenceSemantics) {
    Seen seen;
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(test_size(150)); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Network network = random_network(random);
        compare_all(seed % 3 == 0 ? network : closed(network), random, seen);
        if (testing::Test::HasFailure()) break;
    }
    EXPECT_GT(seen.compared, test_size(150) / 2);
    report(seen);
}

TEST(RandomizedTimedEngine, RandomClosedLoopsHaveTheStatesAndVerdictsOfTheReferenceSemantics) {
    Seen seen;
    const auto loops = static_cast<std::uint64_t>(test_size(60));
    for (std::uint64_t seed = 1; seed <= loops; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Model model = random_loop(random);
        try {
            compare_all(composed_loop(model, {.grain = seed % 2 == 0 ? Grain::Atomic : Grain::Phased}).network, random,
                        seen);
        } catch (const std::invalid_argument&) {
            continue;  // compose rejects this loop
        }
        if (testing::Test::HasFailure()) break;
    }
    EXPECT_GT(seen.compared, test_size(60) / 4);
    report(seen);
}

/// Returns a term that is true in the discrete state, over the variables that networks of both grains have. These are
/// the variables of the chart and of the plant, and the locations of all processes except the controllers.
Id<Expr> same_state(Network& network, const Network& other, const TaddState& state) {
    std::map<std::string, Id<Network::Variable>> variables;
    for (const Id<Network::Variable> id : network.variables.ids())
        if (!network.variables[id].scratch) variables.emplace(network.variables[id].name, id);
    std::vector<Id<Expr>> conjuncts = {network.settled};
    for (const Id<Network::Variable> id : other.variables.ids()) {
        const auto found = variables.find(other.variables[id].name);
        if (other.variables[id].scratch || found == variables.end()) continue;
        const Id<Expr> leaf = network.exprs.leaf(Op::Variable, found->second.index);
        const std::int64_t is = state.variables[id.index];
        if (!other.variables[id].type.boolean)
            conjuncts.push_back(network.exprs.apply(Op::Equal, leaf, network.exprs.integer(is)));
        else conjuncts.push_back(is != 0 ? leaf : network.exprs.negation(leaf));
    }
    for (const Id<Network::Process> id : other.processes.ids())
        if (other.processes[id].kind != Network::ProcessKind::Controller)
            conjuncts.push_back(network.exprs.at(id.index, state.locations[id.index]));
    return network.exprs.conjunction(conjuncts);
}

TEST(RandomizedTimedEngine, EveryQuiescentStateOfGrainAtomicIsReachedInGrainPhased) {
    int compared = 0;
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(test_size(40)); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Model model = random_loop(random);
        try {
            const Network atomic = composed_loop(model, {.grain = Grain::Atomic}).network;
            Network phased = composed_loop(model, {.grain = Grain::Phased}).network;
            const NaiveTadd tadd(atomic);
            const auto all = explored(tadd, 1000);
            if (!all || all->any_fault) continue;
            phased.properties = {};
            std::set<std::uint32_t> requested;
            for (const TaddState& state : all->states) {
                if (!tadd.settled(state)) continue;
                const Id<Expr> term = same_state(phased, atomic, state);
                if (!requested.insert(term.index).second || requested.size() > 200) continue;
                phased.properties.add({.name = "s" + std::to_string(requested.size()),
                                       .pattern = Pattern::Reachable,
                                       .operands = {term}});
            }
            const TimedResult result = check_timed(phased, {.max_states = 300'000, .profile = ProfileFor::All});
            for (const Property& property : phased.properties) EXPECT_EQ(outcome_text(result, property.name), "holds");
            if (result.complete && result.errors.empty() && result.profile->sampled == result.states) {
                EXPECT_LE(check_timed(atomic).states, result.states - result.profile->inside_cycles);
            }
            ++compared;
        } catch (const std::invalid_argument&) {
            continue;  // compose rejects this loop
        }
        if (testing::Test::HasFailure()) break;
    }
    EXPECT_GT(compared, test_size(40) / 5);
}

}  // namespace
}  // namespace grafverif
