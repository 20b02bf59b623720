// SPDX-License-Identifier: MIT
// Compares proofs of `leads to` and `inevitable` on abstractions with the complete search, on random loops with several
// plants. Each premise of the refinements is omitted once, to show that the comparison detects the omission.
#include "check/inputs/response.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "check/inputs/evolutions.hpp"
#include "check/inputs/resting.hpp"
#include "support/random_chart.hpp"
#include "support/read_loop.hpp"
#include "support/row_counts.hpp"
#include "support/test_size.hpp"
#include "unit/check/networks.hpp"

namespace grafverif {
namespace {

constexpr std::uint64_t complete_limit = 60'000;

const std::string plants =
    "component follower(input P; output S) { clock t; initial location off; location going invariant t <= 2s; location "
    "on; urgent off -> going when P do t := 0; urgent going -> off when !P; timed going -> on when P && t == 2s do S "
    ":= "
    "true; urgent on -> off when !P do S := false; }\n"
    "component keeper(input P; output S) { clock t; initial location off; location going invariant t <= 1s; location "
    "on; "
    "urgent off -> going when P do t := 0; timed going -> on when t == 1s do S := true; timed on -> off when t >= 2s "
    "&& !P "
    "do S := false, t := 0; }\n"
    "component mover(input P; output S) { clock t; initial location a; location b with S := true; timed a -> b when P "
    "&& "
    "t >= 1s do S := true, t := 0; timed b -> a when t >= 1s do S := false, t := 0; }\n"
    "component latch(input P; output S) { initial location off; location on; urgent off -> on when P do S := true; }\n"
    "component axis(input L, R; output AL, AR) { clock t; initial location l with AL := true; location r with AR := "
    "true; "
    "location lr invariant t <= 2s; location rl invariant t <= 1s; location mid; urgent l -> lr when R && !L do AL := "
    "false, t := 0; timed lr -> r when R && t == 2s do AR := true; urgent lr -> mid when !R; urgent mid -> lr when R "
    "&& !L "
    "do t := 0; urgent mid -> rl when L && !R do t := 0; urgent r -> rl when L && !R do AR := false, t := 0; timed rl "
    "-> l "
    "when L && t == 1s do AL := true; urgent rl -> mid when !L; }\n";

class LoopText {
public:
    explicit LoopText(Random& random) : random_(random), steps_(random_number(random, 3, 5)) {}

    std::string text() {
        const std::int64_t count = random_number(random_, 1, 3);
        for (std::int64_t i = 0; i < count; ++i) add_plant(i);
        std::string chart;
        for (std::int64_t i = 0; i < steps_; ++i)
            chart += fmt::format("{}step {} {{ {} }} ", i == 0 ? "initial " : "", i, actions());
        for (std::int64_t i = 0; i < steps_; ++i) {
            chart += fmt::format("transition t{}: {} -> {} when {}; ", i, i, (i + 1) % steps_, condition());
            if (chance(random_, 35))
                chart += fmt::format("transition u{}: {} -> {} when {}; ", i, i, step(), condition());
        }
        std::string properties;
        for (int i = 0; i < 4; ++i) {
            const std::string q =
                one_of({active(), active() + " || " + active(), "!" + active(), sensor(), "!" + sensor()});
            const std::string p = one_of({active(), active(), sensor(), active() + " && " + input()});
            properties +=
                fmt::format("property p{}: {};\n", i, chance(random_, 15) ? "inevitable " + q : p + " leads to " + q);
        }
        return fmt::format(
            "{}grafcet c {{ input A, B, {}; output {}; internal N: int 0..2 = 0; internal F: bool = false; {}}}\n"
            "closed_loop l {{ controller c{}; {}environment EA = push_button(OUT = A, GAP = 1s); environment EB = {}; "
            "{}}}\n",
            plants, fmt::join(sensors_, ", "), fmt::join(orders_, ", "), chart,
            one_of({"", " with every_cycle", " with stability_search"}), instances_,
            one_of({"push_button(OUT = B, GAP = 1s)", "emergency_stop(OUT = B, UNLATCH = 1s)"}), properties);
    }

private:
    void add_plant(std::int64_t i) {
        const std::string component = one_of({"follower", "follower", "keeper", "mover", "latch", "axis"});
        if (component == "axis") {
            instances_ += fmt::format("plant I{0} = axis(L = Q{0}, R = R{0}, AL = D{0}, AR = E{0}); ", i);
            sensors_.push_back(fmt::format("E{}", i));
            orders_.push_back(fmt::format("R{}", i));
        } else {
            // Some instances read the sensor of the previous instance instead of an order.
            const bool is_chained = i > 0 && chance(random_, 20);
            instances_ += fmt::format("plant I{0} = {1}(P = {2}, S = D{0}); ", i, component,
                                      is_chained ? sensors_.back() : fmt::format("Q{}", i));
        }
        sensors_.push_back(fmt::format("D{}", i));
        orders_.push_back(fmt::format("Q{}", i));
    }

    std::string one_of(const std::vector<std::string>& from) {
        return from[static_cast<std::size_t>(random_number(random_, 0, static_cast<std::int64_t>(from.size()) - 1))];
    }
    std::int64_t step() { return random_number(random_, 0, steps_ - 1); }
    std::string active() { return fmt::format("X{}", step()); }
    std::string sensor() { return one_of(sensors_); }
    std::string input() { return chance(random_, 75) ? sensor() : one_of({"A", "B"}); }

    std::string actions() {
        std::string made;
        for (const std::string& order : orders_)
            if (chance(random_, 40)) made += order + (chance(random_, 20) ? " if " + input() : "") + "; ";
        if (chance(random_, 10)) made += "N := (N + 1) % 3 on activation; ";
        if (chance(random_, 10)) made += "F := !F on activation; ";
        return made;
    }
    std::string condition() {
        const std::string atom = (chance(random_, 40) ? "!" : "") + input();
        if (chance(random_, 20)) return atom + one_of({" && ", " || "}) + (chance(random_, 50) ? "!" : "") + input();
        if (chance(random_, 10)) return "rise(" + input() + ")";
        if (chance(random_, 15)) return fmt::format("{}s/{}", random_number(random_, 1, 2), active());
        if (chance(random_, 10)) return atom + one_of({" && N == 1", " || F", " && !F"});
        return atom;
    }

    Random& random_;
    const std::int64_t steps_;
    std::string instances_ = {};
    std::vector<std::string> sensors_ = {}, orders_ = {};
};

/// Returns the properties of a random loop that are proved although the complete search finds a violation.
std::vector<std::string> wrong_proofs(std::uint64_t seed, const InputAblations& ablations,
                                      std::map<std::string, int>& seen) {
    Random random(seed);
    const Grain grain = chance(random, 50) ? Grain::Atomic : Grain::Phased;
    const std::string text = LoopText(random).text();
    const Network network = expand(read_loop(text, {.grain = grain}).network);
    const std::vector<AbstractableProcess> instances = abstractable_processes(network);
    if (!lets_time_pass(network) || !takes_time(network) || evolutions_end(network, instances, {}) != true) {
        ++seen["loops without a premise"];
        return {};
    }
    std::vector<std::string> wrong;
    for (const Property& property : network.properties) {
        const ResponseResult result = prove_response(network, instances, property, {.states = 50'000}, ablations);
        const std::string word = !result.holds ? "limit" : *result.holds ? "proved" : "not proved";
        ++seen[word + (result.refinements > 0 ? " with refinements" : " without refinements")];
        if (result.holds != true) continue;
        bool is_wrong = false;
        for (const std::int64_t factor : {1, 2, 3}) {
            const TimedResult complete =
                check_timed(refined(network, factor), {.properties = {property.name}, .max_states = complete_limit});
            if (complete.complete) ++seen["complete searches"];
            is_wrong = is_wrong || complete.verdicts.front().outcome == Outcome::Violated;
            EXPECT_FALSE(result.vacuous && complete.verdicts.front().outcome == Outcome::Holds &&
                         !complete.verdicts.front().vacuous)
                << text << property.name;
            if (!complete.complete || is_wrong) break;
        }
        if (is_wrong) wrong.push_back(property.name + " of\n" + text);
    }
    return wrong;
}

TEST(ProveResponse, ProvesNothingThatTheCompleteSearchRefutes) {
    std::map<std::string, int> seen;
    for (int seed = 1; seed <= test_size(150) && !testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        EXPECT_EQ(wrong_proofs(static_cast<std::uint64_t>(seed), {}, seen), std::vector<std::string>());
    }
    print_counts(seen);
    EXPECT_GT(seen["proved with refinements"], test_size(10));
    EXPECT_GT(seen["not proved with refinements"], test_size(10));
    EXPECT_GT(seen["complete searches"], test_size(50));
}

TEST(ProveResponse, EachPremiseOfRefinementsIsNeeded) {
    struct Premise {
        const char* name = "";
        bool InputAblations::*omitted = nullptr;
        std::uint64_t first = 1001;  // seed of the first loop
    };
    std::map<std::string, int> seen;
    for (const Premise& premise : {Premise{"a process may be in any state", &InputAblations::start_initially, 1151},
                                   Premise{"all situations are explored", &InputAblations::one_situation, 1051}}) {
        InputAblations ablations;
        ablations.*premise.omitted = true;
        std::uint64_t seed = premise.first;
        while (seed < premise.first + 200 && wrong_proofs(seed, ablations, seen).empty()) ++seed;
        EXPECT_LT(seed, premise.first + 200) << premise.name;
        seen[premise.name] = static_cast<int>(seed);
    }
    print_counts(seen);
}

}  // namespace
}  // namespace grafverif
