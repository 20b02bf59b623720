// SPDX-License-Identifier: MIT
// Compares supervisors with a naive game and with all other supervisors, on random plants with one hidden bit. On
// random loops, two engines verify the charts with the added conditions.
#include "check/supervise/supervise.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <iostream>
#include <set>
#include <sstream>

#include "pipeline/variants/supervise.hpp"
#include "support/print_model.hpp"
#include "support/random_chart.hpp"
#include "support/random_loop.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

using System = TransitionSystem;

// The bits of a state are the observable and the unobservable bit of the plant, two steps, and an output. The choices
// are the evolution of the chart, the direction of the plant, and the permissions of two transitions and of the output.
enum Bit { Input, Hidden, Step1, Step2, Out, Evolves, Branch, May1, May2, MayOut };
constexpr unsigned states = 32, permitted = 8;
constexpr unsigned all_permitted = permitted - 1;

struct Toy {
    System system = {};
    Supervision requested = {};
    std::array<Id<Expr>, 10> bit = {};
    std::array<Id<Expr>, 5> next = {};  ///< the next value of each bit of a state
    Id<Expr> fires1 = {}, fires2 = {};

    /// Evaluates `term`. The bits of `may` are the permissions of transition 1, of transition 2 and of the output.
    bool value(Id<Expr> term, unsigned state, bool evolves = false, bool branch = false, unsigned may = 0) const {
        return *evaluate(system.exprs, term, [&](const Expr& leaf) -> std::int64_t {
            const auto index = static_cast<unsigned>(leaf.value);
            if (index < Evolves) return (state >> index) & 1U;
            if (index == Evolves) return evolves ? 1 : 0;
            if (index == Branch) return branch ? 1 : 0;
            return (may >> (index - May1)) & 1U;
        }) != 0;
    }
    unsigned after(unsigned state, bool evolves, bool branch, unsigned may) const {
        unsigned to = 0;
        for (unsigned index = 0; index < 5; ++index)
            to |= (value(next[index], state, evolves, branch, may) ? 1U : 0U) << index;
        return to;
    }
};

Id<Expr> random_term(Exprs& exprs, Random& random, std::initializer_list<Id<Expr>> over) {
    std::vector<Id<Expr>> terms;
    for (const Id<Expr> leaf : over)
        if (chance(random, 60)) terms.push_back(chance(random, 50) ? leaf : exprs.negation(leaf));
    if (terms.empty()) return exprs.constant(chance(random, 70));
    return chance(random, 50) ? exprs.conjunction(terms) : exprs.disjunction(terms);
}

Toy random_toy(Random& random) {
    Toy toy;
    System& system = toy.system;
    Exprs& exprs = system.exprs;
    system.name = "toy";
    system.main = system.modules.add({.name = "main"});
    Table<System::Symbol>& symbols = system.modules[system.main].symbols;
    const char* const names[] = {"a", "h", "x1", "x2", "o", "evolves", "way", "may1", "may2", "mayo"};
    for (unsigned index = 0; index < 10; ++index) {
        const auto kind = index < Evolves ? decltype(System::Symbol::kind)(System::StateSymbol{})
                                          : decltype(System::Symbol::kind)(System::ChoiceSymbol{});
        toy.bit[index] = exprs.leaf(Op::Variable, symbols.add({names[index], Type{}, kind, "", {}}).index);
    }
    const auto& [a, h, x1, x2, o, evolves, branch, may1, may2, mayo] = toy.bit;
    toy.fires1 = exprs.conjunction(std::vector{may1, x1, random_term(exprs, random, {a, x2})});
    toy.fires2 = exprs.conjunction(std::vector{may2, exprs.negation(x1), random_term(exprs, random, {a, x2})});
    const Id<Expr> to1 = exprs.disjunction(toy.fires2, exprs.conjunction(x1, exprs.negation(toy.fires1)));
    const Id<Expr> to2 = chance(random, 50) ? exprs.apply(Op::NotEqual, x2, toy.fires1)
                                            : exprs.disjunction(exprs.conjunction(x2, exprs.negation(toy.fires2)),
                                                                exprs.conjunction(toy.fires1, a));
    const Id<Expr> out = exprs.conjunction(std::vector{mayo, to1, random_term(exprs, random, {a, to2})});
    const Id<Expr> to_h = exprs.conditional(branch, random_term(exprs, random, {a, h, o}), h);
    const Id<Expr> to_a = exprs.conditional(branch, random_term(exprs, random, {h, o}), a);
    toy.next = {exprs.conditional(evolves, a, to_a), exprs.conditional(evolves, h, to_h),
                exprs.conditional(evolves, to1, x1), exprs.conditional(evolves, to2, x2),
                exprs.conditional(evolves, out, o)};
    for (unsigned index = 0; index < 5; ++index)
        symbols[{index}].kind = System::StateSymbol{exprs.constant(index == Step1), toy.next[index]};
    system.settled = exprs.constant(true);
    Supervision::Controller chart;
    chart.evolves = evolves;
    chart.seen = {a, x1, x2};
    chart.permissions = {{{May1}, false, toy.fires1, {}}, {{May2}, false, toy.fires2, {}}, {{MayOut}, true, o, {1}}};
    toy.requested.controllers = {chart};
    toy.requested.bad = {exprs.conjunction(chance(random, 50) ? a : h, random_term(exprs, random, {x1, x2, o, h}))};
    toy.requested.marked = chance(random, 70) ? exprs.conjunction(x1, exprs.negation(x2)) : exprs.conjunction(x1, h);
    return toy;
}

// -- the naive game ---------------------------------------------------------------------------------------------------

struct Naive {
    const Toy& toy;
    std::vector<bool> lost = std::vector<bool>(states);
    std::vector<bool> reached = std::vector<bool>(states);

    explicit Naive(const Toy& of) : toy(of) {
        reached[1U << Step1] = true;
        for (bool more = true; more;) {
            more = false;
            for (unsigned state = 0; state < states; ++state)
                for (unsigned branch = 0; reached[state] && branch < 2 + permitted; ++branch) {
                    const unsigned to =
                        branch < 2 ? toy.after(state, false, branch == 1, 0) : evolved(state, branch - 2);
                    more = more || !reached[to];
                    reached[to] = true;
                }
        }
        for (unsigned state = 0; state < states; ++state) lost[state] = toy.value(toy.requested.bad[0], state);
        for (bool more = true; more;) more = lose_helpless() || lose_blocked();
    }
    unsigned evolved(unsigned state, unsigned may) const { return toy.after(state, true, false, may); }
    bool allowed(unsigned state, unsigned may) const { return !lost[evolved(state, may)]; }

    bool lose_helpless() {
        bool more = false;
        for (unsigned state = 0; state < states; ++state) {
            if (lost[state]) continue;
            bool exit_path = false;
            for (unsigned may = 0; may < permitted; ++may) exit_path = exit_path || allowed(state, may);
            lost[state] =
                !exit_path || lost[toy.after(state, false, false, 0)] || lost[toy.after(state, false, true, 0)];
            more = more || lost[state];
        }
        return more;
    }
    bool lose_blocked() {
        std::vector<bool> returns(states);
        for (bool more = true; more;) {
            more = false;
            for (unsigned state = 0; state < states; ++state) {
                if (lost[state] || returns[state]) continue;
                bool branch = toy.value(toy.requested.marked, state) || returns[toy.after(state, false, false, 0)] ||
                              returns[toy.after(state, false, true, 0)];
                for (unsigned may = 0; may < permitted; ++may) branch = branch || returns[evolved(state, may)];
                returns[state] = branch;
                more = more || branch;
            }
        }
        bool more = false;
        for (unsigned state = 0; state < states; ++state)
            if (!lost[state] && !returns[state]) lost[state] = more = true;
        return more;
    }

    /// Returns `may` with the permissions added that have no effect in `state`.
    unsigned normal(unsigned state, unsigned may) const {
        for (const unsigned index : {0U, 1U})
            if (!toy.value(index == 0 ? toy.fires1 : toy.fires2, state, true, false, all_permitted)) may |= 1U << index;
        if (evolved(state, may | 4U) == evolved(state, may & 3U)) may |= 4U;
        return may;
    }
};

// -- supervisors as tables --------------------------------------------------------------------------------------------

unsigned sight(unsigned state) { return (state & 1U) | ((state >> 1U) & 6U); }

/// A bit set for each permission: the observations for which it is granted.
using Policy = std::array<unsigned, 3>;

unsigned chosen(const Toy& toy, const Policy& policy, unsigned state) {
    unsigned may = 4;
    for (const unsigned index : {0U, 1U}) may |= ((policy[index] >> sight(state)) & 1U) << index;
    if (((policy[2] >> sight(toy.after(state, true, false, may))) & 1U) == 0) may &= 3U;
    return may;
}

struct Closed {
    std::set<std::pair<unsigned, unsigned>> evolutions = {};
    bool safe = true, returns = true;
};

Closed closed(const Toy& toy, const Policy& policy) {
    Closed made;
    std::vector<unsigned> order{1U << Step1};
    std::set<unsigned> seen{order[0]};
    std::array<std::set<unsigned>, states> before;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const unsigned state = order[i];
        made.safe = made.safe && !toy.value(toy.requested.bad[0], state);
        const unsigned evolved = toy.after(state, true, false, chosen(toy, policy, state));
        made.evolutions.emplace(state, evolved);
        for (const unsigned to : {evolved, toy.after(state, false, false, 0), toy.after(state, false, true, 0)}) {
            before[to].insert(state);
            if (seen.insert(to).second) order.push_back(to);
        }
    }
    std::set<unsigned> returning;
    for (const unsigned state : order)
        if (toy.value(toy.requested.marked, state)) returning.insert(state);
    for (bool more = true; more;) {
        more = false;
        for (const unsigned state : std::set<unsigned>(returning))
            for (const unsigned from : before[state]) more = returning.insert(from).second || more;
    }
    made.returns = returning.size() == order.size();
    return made;
}

bool holds(const Supervisor::Condition& condition, unsigned at) {
    const auto literal = [&](const Supervisor::Literal& each) { return (((at >> each.seen) & 1U) != 0) == each.value; };
    return condition.all ? std::ranges::all_of(condition.terms,
                                               [&](const auto& term) { return std::ranges::any_of(term, literal); })
                         : std::ranges::any_of(condition.terms,
                                               [&](const auto& term) { return std::ranges::all_of(term, literal); });
}

Policy policy_of(const Supervisor& found) {
    Policy policy{0xFF, 0xFF, 0xFF};
    for (const Supervisor::Condition& condition : found.conditions)
        for (unsigned at = 0; at < 8; ++at)
            if (!holds(condition, at)) policy[condition.permission] &= ~(1U << at);
    return policy;
}

struct Counts {
    int none = 0, unknown = 0, free = 0, least = 0, several = 0, cautious = 0, others = 0, disabled = 0, lost = 0;
};

/// Checks the reported elements that the conditions disable, observations that they make unreachable, and properties
/// that are violated without the conditions.
void expect_losses(const Toy& toy, const Supervisor& found, const Policy& policy, Counts& counts) {
    const Closed restricted = closed(toy, policy), free = closed(toy, {0xFF, 0xFF, 0xFF});
    if (found.conditions.empty()) {
        EXPECT_TRUE(free.safe);
        return;
    }
    EXPECT_EQ(found.violated, std::vector<bool>{!free.safe});
    for (std::size_t index = 0; index < 3; ++index) {
        bool given = false, refused = false;
        for (const auto& [state, evolved] : restricted.evolutions) {
            const unsigned from = state, here = chosen(toy, policy, state), bit = 1U << index;
            const auto effect = [&](unsigned may) {
                if (index == 2) return ((toy.after(from, true, false, may) >> Out) & 1U) != 0;
                return toy.value(index == 0 ? toy.fires1 : toy.fires2, from, true, false, may);
            };
            given = given || effect(here);
            refused = refused || (!effect(here) && effect(here | bit));
        }
        const bool disabled =
            std::ranges::find(found.disabled, Supervisor::Selection{0, index}) != found.disabled.end();
        EXPECT_EQ(disabled, refused && !given) << "permission " << index;
        counts.disabled += disabled ? 1 : 0;
    }
    const Bit seen[] = {Input, Step1, Step2};
    for (std::size_t index = 0; index < 3; ++index) {
        const auto reaches = [&](const Closed& loop) {
            return std::ranges::any_of(loop.evolutions,
                                       [&](const auto& each) { return ((each.first >> seen[index]) & 1U) != 0; });
        };
        const bool lost = std::ranges::find(found.newly_unreachable, Supervisor::Observation{0, index}) !=
                          found.newly_unreachable.end();
        EXPECT_EQ(lost, reaches(free) && !reaches(restricted)) << "observation " << index;
        counts.lost += lost ? 1 : 0;
    }
}

void expect_claim(const Toy& toy, const Naive& naive, const Supervisor& found, const Policy& policy, Counts& counts) {
    for (const auto& [state, evolved] : closed(toy, policy).evolutions) {
        const unsigned here = naive.normal(state, chosen(toy, policy, state));
        for (unsigned may = 0; may < permitted; ++may) {
            const unsigned other = naive.normal(state, may);
            if (!naive.allowed(state, may)) continue;
            if (found.claim == Supervisor::Permissiveness::Least) {
                EXPECT_EQ(other & ~here, 0U) << "in state " << state;
            }
            if (found.claim == Supervisor::Permissiveness::Several) {
                EXPECT_TRUE((here & ~other) != 0 || other == here) << "in state " << state;
            }
        }
    }
    if (found.claim != Supervisor::Permissiveness::Least) return;
    std::vector<std::pair<unsigned, unsigned>> refused;
    for (unsigned index = 0; index < 3; ++index)
        for (unsigned at = 0; at < 8; ++at)
            if (((policy[index] >> at) & 1U) == 0) refused.emplace_back(index, at);
    const Closed restricted = closed(toy, policy);
    for (unsigned more = 1; refused.size() < 9 && more < (1U << refused.size()); ++more) {
        Policy wider = policy;
        for (std::size_t i = 0; i < refused.size(); ++i)
            if (((more >> i) & 1U) != 0) wider[refused[i].first] |= 1U << refused[i].second;
        const Closed other = closed(toy, wider);
        ++counts.others;
        EXPECT_TRUE(!other.safe || !other.returns || other.evolutions == restricted.evolutions)
            << "a less restrictive policy satisfies the property";
    }
}

void expect_run(const Toy& toy, const Naive& naive, const Supervisor& found) {
    ASSERT_TRUE(found.run);
    std::vector<unsigned> run;
    for (const std::vector<std::int64_t>& values : found.run->states) {
        unsigned& state = run.emplace_back(0);
        for (unsigned index = 0; index < 5; ++index) state |= static_cast<unsigned>(values[index]) << index;
        EXPECT_TRUE(naive.lost[state]);
    }
    EXPECT_EQ(run.front(), 1U << Step1);
    EXPECT_EQ(toy.value(toy.requested.bad[0], run.back()), !found.blocked);
    for (std::size_t i = 0; i + 1 < run.size(); ++i) {
        const bool moves =
            run[i + 1] == toy.after(run[i], false, false, 0) || run[i + 1] == toy.after(run[i], false, true, 0);
        bool helpless = run[i + 1] == naive.evolved(run[i], all_permitted);
        for (unsigned may = 0; may < permitted; ++may) helpless = helpless && !naive.allowed(run[i], may);
        EXPECT_TRUE(moves || helpless);
    }
}

TEST(RandomizedSupervise, ConditionsAgreeWithANaiveGameAndAreLeastRestrictive) {
    Counts counts;
    for (int seed = 1; seed <= test_size(400); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const Toy toy = random_toy(random);
        ASSERT_EQ(verify(toy.system), std::vector<std::string>{});
        const Naive naive(toy);
        const Supervisor found = supervisor_of(toy.system, toy.requested);
        ASSERT_EQ(found.outcome == Supervisor::Outcome::None, naive.lost[1U << Step1]) << found.reason;
        if (found.outcome == Supervisor::Outcome::None) {
            ++counts.none;
            expect_run(toy, naive, found);
        } else if (found.outcome == Supervisor::Outcome::Unknown) {
            ++counts.unknown;
        } else {
            const Policy policy = policy_of(found);
            const Closed restricted = closed(toy, policy);
            EXPECT_TRUE(restricted.safe);
            EXPECT_TRUE(restricted.returns);
            expect_claim(toy, naive, found, policy, counts);
            expect_losses(toy, found, policy, counts);
            ++(found.conditions.empty()                             ? counts.free
               : found.claim == Supervisor::Permissiveness::Least   ? counts.least
               : found.claim == Supervisor::Permissiveness::Several ? counts.several
                                                                    : counts.cautious);
        }
        if (testing::Test::HasFailure()) return;
    }
    std::cout << counts.none << " without a supervisor, " << counts.unknown << " unknown, " << counts.free
              << " without restrictions, " << counts.least << " least, " << counts.several << " of several, "
              << counts.cautious << " cautious, " << counts.others << " other policies tested, " << counts.disabled
              << " disabled, " << counts.lost << " lost\n";
    EXPECT_GT(std::min({counts.none, counts.least, counts.cautious}), 3);
    EXPECT_GT(counts.several, 0);
    EXPECT_GT(counts.disabled, 3);
    EXPECT_GT(counts.lost, 3);
}

TEST(RandomizedSupervise, ConditionsForRandomLoopsAreProvedByBothEngines) {
    int found = 0, none = 0, unknown = 0;
    for (int seed = 1; seed <= test_size(8); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        std::ostringstream text;
        print(text, random_loop(random));
        ParseResult reading = read_string(std::move(text).str(), "loop.grafcet");
        if (!reading.model) continue;  // a chart that cannot be written as text
        SuperviseRequest request;
        request.limits.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(300);
        std::string doing;
        request.limits.progress = [&doing](const Progress& now) { doing = now.words(); };
        const auto made = supervised(*reading.model, {0}, {0}, reading.sources, request, reading.diagnostics);
        if (!made) continue;  // the property is not about states
        EXPECT_TRUE(made->outcome == Supervisor::Outcome::Unknown || !doing.empty()) << "the progress is reported";
        EXPECT_EQ(made->failures, std::vector<std::string>{});
        ++(made->outcome == Supervisor::Outcome::Found  ? found
           : made->outcome == Supervisor::Outcome::None ? none
                                                        : unknown);
        if (testing::Test::HasFailure()) return;
    }
    std::cout << found << " found, " << none << " without a supervisor, " << unknown << " unknown\n";
}

}  // namespace
}  // namespace grafverif
