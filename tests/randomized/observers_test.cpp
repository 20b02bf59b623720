// SPDX-License-Identifier: MIT
// Compares observers with the sentences that they check. A loop with an observer has exactly the runs of the loop
// without it. On each run the observer can fail if and only if the run violates the formula of
// docs/reference/properties.md, which the test evaluates naively on the states of the run.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>

#include "compose/observe.hpp"
#include "support/random_sentence.hpp"
#include "support/random_walk.hpp"
#include "support/test_size.hpp"
#include "unit/compose/hand_chart.hpp"

namespace grafverif {
namespace {

using Truth = std::vector<bool>;

// -- formulas on finite maximal runs: required events must occur, and prohibitions apply until the end of the run -----

Truth each(std::size_t size, const std::function<bool(std::size_t)>& value) {
    Truth made(size);
    for (std::size_t i = 0; i < size; ++i) made[i] = value(i);
    return made;
}
Truth operator!(const Truth& a) {
    return each(a.size(), [&](std::size_t i) { return !a[i]; });
}
Truth operator&(const Truth& a, const Truth& b) {
    return each(a.size(), [&](std::size_t i) { return a[i] && b[i]; });
}
Truth operator|(const Truth& a, const Truth& b) {
    return each(a.size(), [&](std::size_t i) { return a[i] || b[i]; });
}
Truth operator>>(const Truth& a, const Truth& b) { return (!a) | b; }
Truth backwards(const Truth& a, const Truth& b, bool at_the_end) {
    Truth made(a.size());
    for (std::size_t i = a.size(); i-- > 0;) made[i] = b[i] || (a[i] && (i + 1 < a.size() ? made[i + 1] : at_the_end));
    return made;
}
Truth until(const Truth& a, const Truth& b) { return backwards(a, b, false); }
Truth weak(const Truth& a, const Truth& b) { return backwards(a, b, true); }
Truth F(const Truth& a) { return until(Truth(a.size(), true), a); }
Truth G(const Truth& a) { return weak(a, Truth(a.size(), false)); }

/// The part of a run on which a property depends.
struct Seen {
    /// Time at which each checked state begins and ends, in time units.
    std::vector<std::int64_t> begin = {}, end = {};
    std::vector<Truth> operands = {};  ///< indexed by operand and checked state
    std::int64_t over = 0;             ///< the end of the run, in time units
};

/// Evaluates `p at most count times`. The formula generalizes that of the pattern catalogue for a
/// count of two: phases without p and with p alternate.
bool holds_counted(const Sentence& watch, const Seen& seen) {
    using enum Sentence::Scope;
    if (seen.begin.empty()) return true;
    const Truth none(seen.begin.size(), false), p = seen.operands[0];
    const Truth r = watch.scope == Globally ? none : seen.operands[1];
    const Truth s = watch.scope >= Between ? seen.operands[2] : r;
    const auto phases = [&](Truth inner, const Truth& closes) {
        for (std::int64_t i = 0; i < watch.count; ++i)
            inner = until((!p) & (!closes), closes | until(p & (!closes), closes | inner));
        return inner;
    };
    Truth open = G(!p);  // for a count of 2, the formula is !p W (p W (!p W (p W G !p)))
    for (std::int64_t i = 0; i < watch.count; ++i) open = weak(!p, weak(p, open));
    if (watch.scope == Globally) return open[0];
    if (watch.scope == Before) return (F(r) >> phases(until(!p, r), r))[0];
    if (watch.scope == After) return (F(r) >> until(!r, r & open))[0];
    if (watch.scope == Between) return G((r & F(s)) >> phases(until(!p, s), s))[0];
    return G(r >> phases(weak(!p, s) | G(p), s))[0];
}

bool holds_untimed(const Sentence& watch, const Seen& seen) {
    if (watch.count > 0) return holds_counted(watch, seen);
    using enum Sentence::Scope;
    if (seen.begin.empty()) return true;
    const Truth none(seen.begin.size(), false);
    const auto operand = [&](std::size_t k) { return k < seen.operands.size() ? seen.operands[k] : none; };
    const bool pair = watch.kind == Sentence::Kind::Response || watch.kind == Sentence::Kind::Precedence;
    const Truth q = operand(1), r = operand(pair ? 2 : 1), s = operand(pair ? 3 : 2), opens = r & !s;
    const Truth p = watch.kind == Sentence::Kind::Universality ? !operand(0) : operand(0);
    switch (watch.kind) {
    case Sentence::Kind::Absence:
    case Sentence::Kind::Universality:
        if (watch.scope == Before) return (F(r) >> until(!p, r))[0];
        if (watch.scope == After) return G(r >> G(!p))[0];
        if (watch.scope == Between) return G((opens & F(s)) >> until(!p, s))[0];
        return G(opens >> weak(!p, s))[0];
    case Sentence::Kind::Existence:
        if (watch.scope == Before) return weak(!r, p & !r)[0];
        if (watch.scope == After) return (G(!r) | F(r & F(p)))[0];
        if (watch.scope == Between) return G(opens >> weak(!s, p & !s))[0];
        return G(opens >> until(!s, p & !s))[0];
    case Sentence::Kind::Response:
        if (watch.scope == Before) return (F(r) >> until(p >> until(!r, q & !r), r))[0];
        if (watch.scope == After) return G(r >> G(p >> F(q)))[0];
        if (watch.scope == Between) return G((opens & F(s)) >> until(p >> until(!s, q & !s), s))[0];
        return G(opens >> weak(p >> until(!s, q & !s), s))[0];
    default:
        if (watch.scope == Globally) return weak(!q, p)[0];
        if (watch.scope == Before) return (F(r) >> until(!q, p | r))[0];
        if (watch.scope == After) return weak(!r, r & weak(!q, p))[0];
        if (watch.scope == Between) return G((opens & F(s)) >> until(!q, p | s))[0];
        return G(opens >> weak(!q, p | s))[0];
    }
}

/// The states from..to-1 of a run within a scope. If `closed`, the scope ends at state `to` of the run.
struct Window {
    std::size_t from = 0, to = 0;
    bool closed = false;
};

/// Returns a scope for each state that opens a scope. Scopes that must be closed are included only if they are closed.
std::vector<Window> windows(Sentence::Scope scope, const Seen& seen, std::size_t operands) {
    using enum Sentence::Scope;
    const std::size_t size = seen.begin.size();
    if (scope == Globally) return {{0, size, false}};
    const Truth& r = seen.operands[operands];
    const Truth& s = seen.operands[scope == Between || scope == AfterUntil ? operands + 1 : operands];
    std::vector<Window> found;
    for (std::size_t i = 0; i < size; ++i) {
        if (scope == Before ? i > 0 : !r[i] || (scope != After && s[i])) continue;
        std::size_t to = i;
        while (to < size && (scope == After || !s[to])) ++to;
        const bool closed = to < size;
        if (closed || scope == After || scope == AfterUntil) found.push_back({i, to, closed});
    }
    return found;
}

/// Evaluates sentences with a duration in a scope.
bool holds_within(const Sentence& watch, std::int64_t d, const Seen& seen) {
    const bool response = watch.kind == Sentence::Kind::Response;
    const Truth& p = seen.operands[0];
    const Truth wanted = response ? seen.operands[1] : watch.kind == Sentence::Kind::HoldsAtMost ? !p : p;
    for (const Window& in : windows(watch.scope, seen, response ? 2 : 1))
        for (std::size_t i = in.from; i < in.to; ++i) {
            const std::int64_t until = seen.begin[i] + d;
            if (response ? !p[i] : wanted[i]) continue;
            bool comes = !in.closed && seen.over <= until;
            if (!response && in.closed) comes = seen.begin[in.to] <= until;
            for (std::size_t j = i; j < in.to; ++j) comes = comes || (wanted[j] && seen.begin[j] <= until);
            if (!comes) return false;
        }
    return true;
}

bool holds_timed(const Sentence& watch, std::int64_t d, const Seen& seen) {
    if (watch.scope != Sentence::Scope::Globally) return holds_within(watch, d, seen);
    const std::size_t size = seen.begin.size();
    const Truth &p = seen.operands[0], &q = seen.operands.back();
    /// True if a state with `wanted` begins at index `from` or later, and at most d after `time`.
    const auto comes = [&](std::int64_t time, std::size_t from, const Truth& wanted) {
        if (seen.over <= time + d) return true;
        for (std::size_t j = from; j < size; ++j)
            if (wanted[j] && seen.begin[j] <= time + d) return true;
        return false;
    };
    const auto rises = [&](std::size_t i) { return p[i] && (i == 0 || !p[i - 1]); };
    switch (watch.kind) {
    case Sentence::Kind::Response:
        for (std::size_t i = 0; i < size; ++i)
            if (p[i] && !comes(seen.begin[i], i, q)) return false;
        return true;
    case Sentence::Kind::Recurrence:
        if (!comes(0, 0, p)) return false;
        for (std::size_t i = 1; i < size; ++i)
            if (p[i - 1] && !p[i] && !comes(seen.begin[i], i, p)) return false;
        return true;
    case Sentence::Kind::HoldsFor:
    case Sentence::Kind::HoldsAtMost:
        for (std::size_t i = 0; i < size; ++i) {
            if (!rises(i)) continue;
            std::size_t j = i;
            while (j < size && p[j]) ++j;
            const std::int64_t lasted = (j < size ? seen.begin[j] : seen.over) - seen.begin[i];
            if (watch.kind == Sentence::Kind::HoldsFor ? j < size && lasted < d : lasted > d) return false;
        }
        return true;
    default:  // the pattern is `p at most d since q`
        for (std::size_t i = 0; i < size; ++i) {
            if (!p[i] || q[i]) continue;
            std::size_t j = i;
            while (j > 0 && !q[j - 1]) --j;  // the first state without q after the last state with q
            if (j == 0 || seen.end[i] - seen.begin[j] > d) return false;
        }
        return true;
    }
}

// -- lockstep execution
// -------------------------------------------------------------------------------------------------

class Pair {
public:
    Pair(const Network& network, const RandomSentence& sentence)
        : plain_(network),
          watched_(observed(network, watched(network))),
          sentence_(sentence),
          observer_(static_cast<std::uint32_t>(watched_.processes.size() - 1)),
          state_(initial_state(plain_)),
          watched_state_(initial_state(watched_)) {
        const Network::Template& automaton = watched_.templates[watched_.processes[{observer_}].automaton];
        for (const Id<Network::Location> id : automaton.locations.ids())
            if (automaton.locations[id].name == "failed") failed_ = id;
            else if (automaton.locations[id].name == "spoilt") spoilt_ = id;
        seen_.operands.resize(sentence.property.operands.size());
        arrive();
    }

    /// Performs an event that is possible in both networks; returns false if there is none.
    bool move(Random& random) {
        std::vector<Fire> choices = enabled(plain_, state_), watched_choices = enabled(watched_, watched_state_);
        std::erase_if(watched_choices, [&](const Fire& fire) { return fire.process.index == observer_; });
        EXPECT_EQ(choices, watched_choices);
        const Leeway window = leeway(plain_, state_), other = leeway(watched_, watched_state_);
        EXPECT_EQ(window.may_pass, other.may_pass);
        EXPECT_EQ(window.limit, other.limit);
        const auto count = static_cast<std::int64_t>(choices.size()) + (window.may_pass ? 2 : 0);
        if (count == 0 || testing::Test::HasFailure()) return false;
        const auto drawn = static_cast<std::size_t>(random_number(random, 0, count - 1));
        Move move = Delay{random_number(random, 1, std::clamp<std::int64_t>(window.limit.value_or(5), 1, 5))};
        if (drawn < choices.size()) move = choices[drawn];
        const auto done = perform(plain_, state_, move).result;
        EXPECT_EQ(perform(watched_, watched_state_, move).result, done);
        if (done != Step::Result::Done) return false;
        if (spoilt_concurrently_) perform(watched_, *spoilt_concurrently_, move);
        look_where_spoilt();
        if (const auto* delay = std::get_if<Delay>(&move)) {
            time_ += delay->units;
            note_failure();
        } else {
            leave();
            arrive();
        }
        return true;
    }

    void check_verdict() {
        leave();
        const Sentence& watch = sentence_.property.watch;
        const bool holds =
            sentence_.duration > 0 ? holds_timed(watch, sentence_.duration, seen_) : holds_untimed(watch, seen_);
        const Property& requested = watched_.properties.begin()[0];
        const bool here = value(watched_, watched_state_, requested.operands[0]).value_or(0) != 0;
        EXPECT_EQ(!holds, failed_possible_ || (requested.pattern == Pattern::LeadsTo && here))
            << "kind " << static_cast<int>(watch.kind) << ", scope " << static_cast<int>(watch.scope) << ", "
            << sentence_.duration << (sentence_.property.at_stable ? " at stable" : "");
        violated = !holds;
    }

    bool violated = false;

private:
    const Network::Edge* watching(const Fire& fire) const {
        if (fire.process.index != observer_) return nullptr;
        return &watched_.templates[watched_.processes[fire.process].automaton].edges[fire.edge];
    }
    bool fails(const Fire& fire) const { return watching(fire) != nullptr && watching(fire)->to == failed_; }
    void note_failure() {
        const std::vector<Fire> choices = enabled(watched_, watched_state_);
        failed_possible_ =
            failed_possible_ || std::ranges::any_of(choices, [&](const Fire& fire) { return fails(fire); });
        for (const Fire& fire : choices) {
            const Network::Edge* const edge = watching(fire);
            if (edge == nullptr || edge->urgent || edge->to != spoilt_ || spoilt_concurrently_) continue;
            spoilt_concurrently_ = watched_state_;
            perform(watched_, *spoilt_concurrently_, fire);
            look_where_spoilt();
        }
    }
    /// Takes the urgent edges of the observer after its time limit has expired. The observer then fails if the scope is
    /// closed.
    void look_where_spoilt() {
        for (bool looks = spoilt_concurrently_.has_value(); looks;) {
            looks = false;
            for (const Fire& fire : enabled(watched_, *spoilt_concurrently_)) {
                if (watching(fire) == nullptr || !watching(fire)->urgent) continue;
                perform(watched_, *spoilt_concurrently_, fire);
                looks = true;
                break;
            }
            failed_possible_ = failed_possible_ || spoilt_concurrently_->locations[observer_] == failed_;
        }
    }

    /// Lets the observer check the state, before time can pass or another event can occur.
    void arrive() {
        for (int looks = 0;; ++looks) {
            note_failure();
            std::vector<Fire> choices = enabled(watched_, watched_state_);
            const bool away = watched_state_.locations[observer_] == failed_;
            std::erase_if(choices, [&](const Fire& fire) {
                const Network::Edge& edge =
                    watched_.templates[watched_.processes[fire.process].automaton].edges[fire.edge];
                return fire.process.index == observer_ && !edge.urgent;
            });
            const bool looking =
                std::ranges::any_of(choices, [&](const Fire& fire) { return fire.process.index == observer_; });
            if (!looking) {
                ASSERT_EQ(looks, 1) << "the observer must read every state exactly once";
                break;
            }
            ASSERT_EQ(choices.size(), 1U) << (away ? "away" : "");
            ASSERT_FALSE(leeway(watched_, watched_state_).may_pass);
            ASSERT_EQ(perform(watched_, watched_state_, choices.front()).result, Step::Result::Done);
        }
        for (std::size_t i = 0; i < state_.locations.size(); ++i)
            ASSERT_EQ(state_.locations[i], watched_state_.locations[i]);
        for (std::size_t i = 0; i < state_.variables.size(); ++i)
            ASSERT_EQ(state_.variables[i], watched_state_.variables[i]);
        is_considered_ = !sentence_.property.at_stable || value(plain_, state_, plain_.settled).value() != 0;
        if (!is_considered_) return;
        seen_.begin.push_back(time_);
        for (std::size_t k = 0; k < seen_.operands.size(); ++k)
            seen_.operands[k].push_back(value(plain_, state_, sentence_.property.operands[k]).value() != 0);
    }
    void leave() {
        if (is_considered_) seen_.end.push_back(time_);
        is_considered_ = false;
        seen_.over = time_;
    }

    const Network& plain_;
    Network watched_;
    const RandomSentence& sentence_;
    std::uint32_t observer_;
    Id<Network::Location> failed_ = {}, spoilt_ = {};
    NetworkState state_, watched_state_;
    std::optional<NetworkState> spoilt_concurrently_ = {};
    Seen seen_ = {};
    std::int64_t time_ = 0;
    bool is_considered_ = false, failed_possible_ = false;
};

TEST(RandomizedObservers, CheckEveryStateOfEveryRunAndFailIfTheirSentenceIsViolated) {
    // Numbers of satisfying and violating runs, by kind and scope.
    std::map<std::pair<int, int>, std::pair<int, int>> met;
    for (int seed = 1; seed <= test_size(320); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const Model model = random_loop(random);
        Diagnostics diagnostics;
        for (const Chart& chart : model.charts) derive(chart, diagnostics);
        if (diagnostics.has_errors()) continue;
        Network network = composed(model);
        for (int requested = 0; requested < 6; ++requested) {
            const RandomSentence sentence = random_sentence(network, random);
            network.properties = {};
            network.properties.add(sentence.property);
            Pair pair(network, sentence);
            for (int moves = 0; moves < 60 && pair.move(random);) ++moves;
            pair.check_verdict();
            if (HasFailure()) return;
            const Sentence& watch = sentence.property.watch;
            const int kind = static_cast<int>(watch.kind) + (watch.duration_ms > 0 ? 10 : 0);
            auto& [hold, violated] = met[{kind, static_cast<int>(watch.scope)}];
            ++(pair.violated ? violated : hold);
        }
    }
    // Six patterns without a duration occur in four scopes, and two of these also without a scope.
    // Five patterns with a duration occur without a scope, and three of these also in four scopes.
    EXPECT_EQ(met.size(), 6U * 4U + 2U + 5U + 3U * 4U);
    std::map<int, std::pair<int, int>> kinds, scopes;
    for (const auto& [of, counts] : met)
        for (auto* sums : {&kinds[of.first], &scopes[of.second]}) {
            sums->first += counts.first;
            sums->second += counts.second;
        }
    for (const auto* sums : {&kinds, &scopes})
        for (const auto& [of, counts] : *sums) {
            EXPECT_GT(counts.first, 0) << of;
            EXPECT_GT(counts.second, 0) << of;
        }
}

}  // namespace
}  // namespace grafverif
