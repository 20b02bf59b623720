// SPDX-License-Identifier: MIT
// Tests that the state store returns stored states unchanged, finds them again, and omits only variables without
// effect.
#include "check/timed/store/store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "check/timed/layout.hpp"
#include "check/timed/store/packed_states.hpp"
#include "support/read_loop.hpp"

namespace grafverif::timed {
namespace {

/// Returns a pseudorandom number of up to `bits` bits.
std::uint32_t some(std::uint64_t seed, unsigned bits) {
    seed = (seed + 1) * 0x9E3779B97F4A7C15U;
    return static_cast<std::uint32_t>((seed ^ seed >> 29U) * 0xBF58476D1CE4E5B9U >> (64U - bits));
}

TEST(Pairs, AreNumberedInTheOrderOfInsertionAndFoundAgain) {
    for (const auto& [low, high] : {std::pair{8U, 12U}, std::pair{32U, 32U}, std::pair{1U, 32U}, std::pair{20U, 1U}}) {
        SCOPED_TRACE(std::to_string(low) + " and " + std::to_string(high) + " bits");
        Pairs pairs(6);
        std::map<Word, std::uint32_t> expected;
        std::vector<Word> order;
        for (std::uint64_t i = 0; i < 40'000; ++i) {
            const Word pair = Pairs::pair(some(2 * i, low), some(2 * i + 1, high));
            ASSERT_EQ(pairs.find(pair), expected.contains(pair) ? expected.at(pair) : Pairs::none);
            const bool fresh = expected.emplace(pair, static_cast<std::uint32_t>(order.size())).second;
            if (fresh) order.push_back(pair);
            const Pairs::Interned interned = pairs.intern(pair);
            ASSERT_EQ(interned.fresh, fresh);
            ASSERT_EQ(interned.number, expected.at(pair));
        }
        ASSERT_EQ(pairs.size(), order.size());
        for (std::uint32_t number = 0; number < order.size(); ++number) {
            ASSERT_EQ(pairs[number], order[number]);
            ASSERT_EQ(pairs.find(order[number]), number);
        }
    }
}

TEST(Pairs, AppendedAreFoundOnceTheyAreIndexed) {
    Pairs pairs(6);
    std::uint64_t made = 0;
    for (const std::uint32_t more : {1U, 700U, 3U, 30'000U, 5'000U}) {
        const auto first = static_cast<std::uint32_t>(pairs.size());
        // The reserved memory is less than the states need.
        for (unsigned member = 0; member < 3; ++member) pairs.free_memory(more / 2, {member, 3});
        for (std::uint32_t i = 0; i < more; ++i) ASSERT_EQ(pairs.append(made++ * 0x10001), first + i);
        ASSERT_EQ(pairs.find((made - 1) * 0x10001), Pairs::none);
        // Each member of the thread pool inserts the states of its shards, in reverse order.
        for (unsigned member = 0; member < 3; ++member)
            for (std::uint32_t number = first + more; number-- != first;)
                if (pairs.shard_of(pairs[number]) % 3 == member) pairs.index(pairs[number], number);
        for (std::uint64_t i = 0; i < made; ++i) ASSERT_EQ(pairs.find(i * 0x10001), i);
    }
}

TEST(Store, ReturnsEveryStateOfEachSize) {
    for (const unsigned halves : {1U, 2U, 3U, 5U, 6U, 11U, 16U}) {
        SCOPED_TRACE(halves);
        Layout layout{.locations = {},
                      .variables = {},
                      .clocks = {},
                      .stored = (halves + 1) / 2,
                      .words = (halves + 1) / 2,
                      .halves = halves};
        if (halves > 5) layout.seams = {1, 3};
        Store store(layout);
        std::vector<std::vector<Word>> states;
        Unfolded before, now;
        for (std::uint64_t i = 0; i < 3000; ++i) {
            std::vector<Word> words(layout.words, 0);
            for (unsigned half = 0; half < halves; ++half)
                words[half / 2] |= Word{some(i / (1 + half % 7) * 31 + half, 5 + half % 28)} << (half % 2 * 32);
            const bool known = store.find(words.data(), now) != Store::none;
            const Pairs::Interned interned = store.roots().intern(store.fold(words.data(), before, now));
            ASSERT_EQ(interned.fresh, !known);
            if (interned.fresh) states.push_back(words);
            ASSERT_EQ(states[interned.number], words);
            std::swap(before, now);
        }
        ASSERT_GT(states.size(), 10U);
        Unfolded unfolded;
        for (std::uint32_t state = 0; state < states.size(); ++state) {
            const std::uint32_t other = some(state, 20) % static_cast<std::uint32_t>(states.size());
            for (const std::uint32_t at : {state, other}) {
                store.load(at, unfolded);
                ASSERT_EQ(unfolded.words, states[at]);
            }
            ASSERT_EQ(store.find(states[state].data(), now), state);
        }
    }
}

TEST(PackedStates, AreNumberedInTheOrderOfInsertionAndFoundAgain) {
    for (const std::size_t words : {1U, 3U, 8U}) {
        PackedStates states(words);
        std::map<std::vector<Word>, std::uint32_t> expected;
        std::vector<const Word*> addresses;
        for (std::uint64_t i = 0; i < 30'000; ++i) {
            std::vector<Word> state(words, 7);
            state.front() = some(i, 14);
            state.back() = (state.back() << 32U) ^ some(i, 14);
            const auto [known, is_new] = expected.emplace(state, static_cast<std::uint32_t>(addresses.size()));
            ASSERT_EQ(states.contains(state.data()), !is_new);
            const PackedStates::Added added = states.add(state.data());
            ASSERT_EQ(added.is_new, is_new);
            ASSERT_EQ(added.state, known->second);
            if (is_new) addresses.push_back(states.words(added.state));
        }
        ASSERT_EQ(states.size(), expected.size());
        for (const auto& [state, number] : expected) {
            ASSERT_EQ(std::vector<Word>(states.words(number), states.words(number) + words), state);
            ASSERT_EQ(states.words(number), addresses[number]) << "states do not move";
        }
        ASSERT_GE(states.bytes(), expected.size() * (words + 1) * sizeof(Word));
    }
}

/// `counts` only counts, and `copies` only copies it. The value of `leaves` may leave its range, the chart reads `read`,
/// and `read` depends on `feeds`. A plant copies R. Nothing depends on step 2, but the analysis of dead values may read
/// every step.
TEST(UnreadVariables, AffectNoGuardNoModelErrorAndNoOtherProcess) {
    const std::string text = R"(
        component memo(input P; output S) {
            clock t;
            initial location any;
            timed any -> any when t >= 1s do S := P, t := 0;
        }
        grafcet c {
            input A, D;
            output LAMP, R;
            internal counts: int 0..9 = 0;
            internal copies: int 0..9 = 0;
            internal leaves: int 0..9 = 0;
            internal read: int 0..9 = 0;
            internal feeds: int 0..9 = 0;
            initial step 0;
            step 1 {
                LAMP;
                R;
                counts := (counts + 1) % 10 on activation;
                copies := counts on activation;
                leaves := leaves + 1 on activation;
                read := feeds on activation;
                feeds := (feeds + 1) % 10 on activation;
            }
            step 2;
            transition t0: 0 -> 1 when A && read < 9;
            transition t1: 1 -> 0 when !A;
            transition t2: 0 -> 2 when !A && read == 9;
        }
        closed_loop l {
            controller c;
            plant M = memo(P = R, S = D);
            environment EA = push_button(OUT = A);
        })";
    const Network network = expand(read_loop(text).network);
    const VariableSet unread = unread_variables(network);
    const auto is_unread = [&](const std::string& name) {
        const auto found = std::ranges::find(network.variables, name, &Network::Variable::name);
        EXPECT_NE(found, network.variables.end()) << name;
        return found != network.variables.end() && unread[static_cast<std::size_t>(found - network.variables.begin())];
    };
    for (const char* const name : {"counts", "copies", "LAMP"}) EXPECT_TRUE(is_unread(name)) << name;
    for (const char* const name : {"leaves", "read", "feeds", "A", "R"}) EXPECT_FALSE(is_unread(name)) << name;
    for (const Id<Network::Variable> id : network.variables.ids())
        EXPECT_FALSE(unread[id.index] && network.variables[id].role == Network::Role::Step)
            << network.variables[id].name;
}

}  // namespace
}  // namespace grafverif::timed
