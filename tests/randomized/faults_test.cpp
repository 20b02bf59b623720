// SPDX-License-Identifier: MIT
// Compares `faults` with separate checks of all combinations, on random closed loops. The models of these checks are
// built from text: a fault that occurs at any time is a component whose text is the union of both behaviours, and a
// fault that is present from power-on replaces the component.
#include "pipeline/variants/faults.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include "grafverif/grafverif.hpp"
#include "ir/patterns.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t count) { return random() % count; }

template <class List>
auto one_of(Random& random, const List& list) {
    return list[below(random, std::size(list))];
}

/// A behaviour as text. `$` precedes each name of a location or clock, and is replaced by a prefix.
struct Behaviour {
    std::string clocks = {};
    std::vector<std::string> locations = {};  ///< the first location is initial
    std::string edges = {};
    std::string change = {};  ///< assignments and resets of the edge by which a fault occurs
};

std::string with_prefix(const std::string& text, const std::string& prefix) {
    std::string made;
    for (const char byte : text)
        if (byte == '$') made += prefix;
        else made += byte;
    return made;
}

std::string name_of(const std::string& location) { return location.substr(0, location.find(' ')); }

Behaviour mover(int low, int high) {
    return {"clock $t;",
            {"$idle", fmt::format("$moving invariant $t <= {}s", high), "$moved with OUT := true"},
            fmt::format("urgent $idle -> $moving when G do $t := 0;\n"
                        "timed $moving -> $moved when $t >= {}s do OUT := true;\n"
                        "urgent $moved -> $idle when !G do OUT := false;\n",
                        low),
            "$t := 0"};
}
Behaviour button(int gap) {
    return {
        "clock $t;", {"$idle"}, fmt::format("timed $idle -> $idle when $t >= {}s do OUT := !OUT, $t := 0;\n", gap), ""};
}
Behaviour stuck(bool value) {
    return {"", {fmt::format("$stuck with OUT := {}", value)}, "", fmt::format("OUT := {}", value)};
}
Behaviour frozen() { return {"", {"$frozen"}, "", ""}; }
Behaviour chatter() {
    return {"clock $t;",
            {"$chatter invariant $t <= 2s"},
            "timed $chatter -> $chatter when $t >= 1s do OUT := !OUT, $t := 0;\n",
            "$t := 0"};
}
/// A fault with its own variable and two locations, which sets its output to true at most twice.
Behaviour worn() {
    return {"variable $n: int 0..2; clock $t;",
            {"$off invariant $t <= 3s with OUT := false", "$on"},
            "timed $off -> $on when G && $n < 2 && $t == 3s do OUT := true, $n := $n + 1;\n"
            "timed $off -> $off when (!G || $n == 2) && $t == 3s do $t := 0;\n"
            "urgent $on -> $off when !G do OUT := false, $t := 0;\n",
            "OUT := false, $t := 0"};
}

std::string body(const Behaviour& behaviour, const std::string& prefix, bool initial) {
    std::string text = "    " + with_prefix(behaviour.clocks, prefix) + "\n";
    for (std::size_t k = 0; k < behaviour.locations.size(); ++k)
        text += fmt::format("    {}location {};\n", k == 0 && initial ? "initial " : "",
                            with_prefix(behaviour.locations[k], prefix));
    return text + with_prefix(behaviour.edges, prefix);
}

std::string component(const std::string& name, const std::string& body_text) {
    return fmt::format("component {}(input G; output OUT) {{\n{}}}\n", name, body_text);
}

struct Instance {
    std::string name = {}, input = {}, output = {};
    Behaviour normal = {};
};
struct Fault {
    std::string name = {};
    std::size_t of = 0;
    Behaviour behaviour = {};
};
struct Loop {
    std::string chart = {}, properties = {};
    std::vector<Instance> instances = {};
    std::vector<Fault> faults = {};
};

Loop random_loop(Random& random) {
    Loop loop;
    const std::vector<std::string> conditions{"START",       "!START",   "D1",           "!D1",   "D2",
                                              "rise(START)", "rise(D1)", "fall(D2)",     "2s/X1", "1s/X2",
                                              "D1 && !D2",   "D1 || D2", "START && !D1", "3s/X1"};
    const auto condition = [&] { return one_of(random, conditions); };
    const std::vector<std::string> actions{";", " { P; }", " { Q; }", " { P; Q; }"};
    loop.chart = "grafcet chart {\n    input START, D1, D2;\n    output P, Q;\n    initial step 0;\n";
    for (int step = 1; step <= 2; ++step) loop.chart += fmt::format("    step {}{}\n", step, one_of(random, actions));
    loop.chart += fmt::format(
        "    transition t0: 0 -> 1 when {};\n    transition t1: 1 -> 2 when {};\n"
        "    transition t2: 2 -> 0 when {};\n}}\n",
        condition(), condition(), condition());
    const auto time = [&] { return static_cast<int>(1 + below(random, 3)); };
    loop.instances = {
        {"S", "P", "START", button(time())}, {"L", "P", "D1", mover(1, time())}, {"M", "Q", "D2", mover(1, time())}};
    const std::vector<Behaviour> behaviours{stuck(false), stuck(true), frozen(), chatter(), worn(), mover(4, 4)};
    const std::size_t count = 3 + below(random, 3);
    for (std::size_t k = 0; k < count; ++k)
        loop.faults.push_back({"f" + std::to_string(k), below(random, 3), one_of(random, behaviours)});
    const std::vector<std::string> states{"P",  "Q",      "X0",       "X1",       "X2",   "D1",
                                          "D2", "P && Q", "D1 && D2", "P && !D1", "START"};
    const auto state = [&] { return one_of(random, states); };
    int number = 0;
    const auto property = [&](const std::string& what) {
        loop.properties += fmt::format("    property p{}: {};\n", ++number, what);
    };
    for (int k = 0; k < 3; ++k) property("never " + state() + " && " + state());
    property("always " + state() + " || " + state());
    property("reachable " + state() + " && " + state());
    property("reachable all steps");
    property(state() + " leads to " + state());
    property("inevitable " + state());
    property("no deadlock");
    property("always possible " + state());
    property(fmt::format("{} leads to {} within {}s", state(), state(), 2 + below(random, 5)));
    property(fmt::format("{} precedes {}", state(), state()));
    property("never " + state() + " && " + state() + " at stable");
    const std::vector<std::string> inputs{"START", "D1", "D2"};
    property("inevitable !" + one_of(random, inputs));
    property(fmt::format("!{} precedes {}", one_of(random, inputs), state()));
    property("never D1 && D2 && " + state());
    property("never START && D1 && " + state());
    property("reachable D1");
    property("reachable D2");
    return loop;
}

enum class Presence { Absent, AnyTime, PowerOn };

/// Returns the loop as text, in which the components include the behaviour of the faults according to `presence`. If
/// `declared`, the text declares the faults with `fault` instead.
std::string text_of(const Loop& loop, const std::vector<Presence>& presence, bool declared = false) {
    std::string text = loop.chart, plant;
    for (std::size_t k = 0; k < loop.instances.size(); ++k) {
        const Instance& instance = loop.instances[k];
        std::string content = body(instance.normal, "", true);
        for (std::size_t f = 0; f < loop.faults.size(); ++f) {
            const Fault& fault = loop.faults[f];
            if (declared || fault.of != k || presence[f] == Presence::Absent) continue;
            if (presence[f] == Presence::PowerOn) {
                content = body(fault.behaviour, "", true);
                continue;
            }
            const std::string prefix = fault.name + "_";
            content = body(fault.behaviour, prefix, false) + content;
            const std::string change = with_prefix(fault.behaviour.change, prefix);
            for (const std::string& location : instance.normal.locations)
                content += fmt::format("    timed {} -> {}{}{};\n", with_prefix(name_of(location), ""),
                                       with_prefix(name_of(fault.behaviour.locations.front()), prefix),
                                       change.empty() ? "" : " do ", change);
        }
        text += component("C" + std::to_string(k), content);
        plant +=
            fmt::format("    plant {} = C{}(G = {}, OUT = {});\n", instance.name, k, instance.input, instance.output);
    }
    for (const Fault& fault : loop.faults) {
        if (!declared) continue;
        text += component("F" + fault.name, body(fault.behaviour, "", true));
        plant += fmt::format("    fault {} of {}: F{}();\n", fault.name, loop.instances[fault.of].name, fault.name);
    }
    return text + "closed_loop loop {\n    controller chart;\n    time unit 1s;\n" + plant + loop.properties + "}\n";
}

struct Seen {
    int combinations = 0, minimal = 0, of_two = 0, non_monotone = 0, unknown = 0, from_power_on = 0, hidden = 0;
};

/// The verdicts of a separate check, in one search of the complete network.
std::map<std::string, Verdict> verdicts_of(const std::string& text) {
    ParseResult read = read_string(text, "loop.grafcet");
    EXPECT_TRUE(read.model.has_value()) << read.diagnostics_text() << text;
    if (!read.model) return {};
    const auto report =
        check(*read.model, *find_loop(*read.model, "loop"), {}, {.whole = true, .jobs = 1}, read.diagnostics);
    EXPECT_TRUE(report.has_value()) << read.diagnostics_text();
    std::map<std::string, Verdict> found;
    if (report)
        for (const PropertyResult& result : report->answers) found[result.verdict.property] = result.verdict;
    return found;
}

/// Verdicts of all combinations of at most two faults, from separate checks.
class NaiveFaults {
public:
    NaiveFaults(const Loop& loop, Seen& seen) : loop_(loop), seen_(seen) {
        for (std::size_t a = 0; a < loop.faults.size(); ++a) {
            add({a});
            for (std::size_t b = a + 1; b < loop.faults.size(); ++b)
                if (loop.faults[a].of != loop.faults[b].of) add({a, b});
        }
    }

    const std::set<FaultSet>& combinations() const { return combinations_; }

    /// A combination of faults violates a property about all runs if some subset of it violates the property in the
    /// model in which the other faults never occur.
    Outcome outcome(const FaultSet& faults, const FaultAnalysis::Row& row) const {
        const Outcome own = outcomes_.at({faults, row.property});
        if (row.pattern == Pattern::Reachable || row.pattern == Pattern::ReachableAllSteps || faults.size() == 1)
            return own;
        std::set<Outcome> all{own};
        for (const std::size_t fault : faults) all.insert(outcomes_.at({{fault}, row.property}));
        for (const Outcome each : {Outcome::Violated, Outcome::Unknown})
            if (all.contains(each)) {
                if (own == Outcome::Holds) ++seen_.hidden;
                return each;
            }
        return own;
    }

private:
    void add(const FaultSet& faults) {
        combinations_.insert(faults);
        ++seen_.combinations;
        const std::size_t all = (std::size_t{1} << faults.size()) - 1;
        std::map<std::string, Verdict> late;
        for (std::size_t present = 0; present <= all; ++present) {
            std::vector<Presence> presence(loop_.faults.size(), Presence::Absent);
            for (std::size_t k = 0; k < faults.size(); ++k)
                presence[faults[k]] = (present >> k & 1U) != 0 ? Presence::PowerOn : Presence::AnyTime;
            const auto found = verdicts_of(text_of(loop_, presence));
            if (present == 0) late = found;
            for (const auto& [name, verdict] : found) note(faults, name, verdict, present, all, late);
        }
    }

    /// `present == 0`: the faults may occur at any time; `present == all`: all are present from power-on.
    void note(const FaultSet& faults, const std::string& name, const Verdict& verdict, std::size_t present,
              std::size_t all, const std::map<std::string, Verdict>& late) {
        const bool existence = verdict.pattern == Pattern::Reachable || verdict.pattern == Pattern::ReachableAllSteps;
        if (existence && present != all) return;
        const auto [known, fresh] = outcomes_.try_emplace({faults, name}, verdict.outcome);
        // If faults from power-on violate a property of states, the same faults at any time also
        // violate the property.
        const bool of_states = is_about_all_states(verdict.pattern) && name != "p11" && name != "p12" && name != "p15";
        if (!fresh && of_states && verdict.outcome == Outcome::Violated) {
            EXPECT_EQ(word(late.at(name).outcome), "violated") << name;
        }
        if (fresh || known->second == Outcome::Violated) return;
        if (verdict.outcome == Outcome::Violated) {
            known->second = Outcome::Violated;
            ++seen_.from_power_on;
        } else if (verdict.outcome == Outcome::Unknown) {
            known->second = Outcome::Unknown;
        }
    }

    const Loop& loop_;
    Seen& seen_;
    std::set<FaultSet> combinations_ = {};
    std::map<std::pair<FaultSet, std::string>, Outcome> outcomes_ = {};
};

void compare_row(const FaultAnalysis::Row& row, const NaiveFaults& naive, Seen& seen) {
    if (row.without_faults != Outcome::Holds || !row.declared) return;
    std::set<FaultSet> minimal, restoring, expected, expected_restoring, open;
    for (const FaultAnalysis::Cut& cut : row.minimal) {
        minimal.insert(cut.faults);
        EXPECT_TRUE(cut.result.trace.has_value() || row.pattern == Pattern::Reachable ||
                    row.pattern == Pattern::ReachableAllSteps);
    }
    for (const FaultAnalysis::NonMonotone& each : row.non_monotone) restoring.insert(each.holding);
    for (const FaultAnalysis::Open& each : row.open) open.insert(each.faults);
    for (const FaultSet& faults : naive.combinations()) {
        const Outcome outcome = naive.outcome(faults, row);
        if (outcome == Outcome::Unknown) return void(++seen.unknown);  // integer time is inexact for this property
        const bool has_violating_subset = faults.size() == 2 && std::ranges::any_of(faults, [&](std::size_t fault) {
                                              return naive.outcome({fault}, row) == Outcome::Violated;
                                          });
        if (outcome == Outcome::Violated && !has_violating_subset) expected.insert(faults);
        if (outcome == Outcome::Holds && has_violating_subset) expected_restoring.insert(faults);
    }
    EXPECT_EQ(minimal, expected) << row.property;
    EXPECT_EQ(restoring, expected_restoring) << row.property;
    EXPECT_EQ(open, std::set<FaultSet>{}) << row.property;
    seen.minimal += static_cast<int>(minimal.size());
    seen.non_monotone += static_cast<int>(restoring.size());
    for (const FaultSet& faults : minimal) seen.of_two += faults.size() == 2 ? 1 : 0;
}

/// Checks that the verdicts do not depend on the limit of the first search; this limit determines
/// the order of the searches.
void compare_schedules(const Model& model, Id<ClosedLoop> loop, std::uint64_t first_states,
                       const FaultAnalysis& usual) {
    Diagnostics diagnostics;
    const auto found = analysed_faults(
        model, loop, {.order = 2, .visible = false, .first_states = first_states, .jobs = 1}, diagnostics);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->failures, std::vector<std::string>{});
    ASSERT_EQ(found->rows.size(), usual.rows.size());
    const auto sets = [](const FaultAnalysis::Row& row) {
        std::vector<FaultSet> all;
        for (const FaultAnalysis::Cut& cut : row.minimal) all.push_back(cut.faults);
        for (const FaultAnalysis::NonMonotone& each : row.non_monotone) all.push_back(each.holding);
        for (const FaultAnalysis::Open& each : row.open) all.push_back(each.faults);
        return std::tuple(row.property, row.without_faults, row.minimal.size(), row.open.size(), all);
    };
    for (std::size_t k = 0; k < found->rows.size(); ++k) EXPECT_EQ(sets(found->rows[k]), sets(usual.rows[k]));
}

void compare(std::uint64_t seed, Seen& seen) {
    Random random(seed);
    const Loop loop = random_loop(random);
    const std::string text = text_of(loop, {}, true);
    ParseResult read = read_string(text, "loop.grafcet");
    ASSERT_TRUE(read.model.has_value()) << read.diagnostics_text() << text;
    const Id<ClosedLoop> id = *find_loop(*read.model, "loop");
    const auto found = analysed_faults(*read.model, id, {.order = 2, .jobs = 1}, read.diagnostics);
    ASSERT_TRUE(found.has_value()) << read.diagnostics_text();
    EXPECT_EQ(found->failures, std::vector<std::string>{});
    EXPECT_EQ(found->combinations, combination_count(read.model->loops[id], 2));
    compare_schedules(*read.model, id, seed % 2 == 0 ? 20 : 200, *found);
    const NaiveFaults naive(loop, seen);
    EXPECT_EQ(naive.combinations().size(), found->combinations);
    for (const FaultAnalysis::Row& row : found->rows) compare_row(row, naive, seen);
    if (testing::Test::HasFailure()) std::printf("%s\n", text.c_str());
}

TEST(RandomizedFaults, MinimalCombinationsAreThoseOfSeparateChecks) {
    Seen seen;
    const int cases = test_size(40);
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(cases); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        compare(seed, seen);
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(seen.minimal, cases);
    EXPECT_GT(seen.of_two, 0);
    EXPECT_GT(seen.non_monotone, 0);
    EXPECT_GT(seen.from_power_on, 0);
    EXPECT_GT(seen.hidden, 0);
    if (std::getenv("GRAFVERIF_TEST_COUNTS") != nullptr)
        std::printf(
            "%d combinations, %d minimal, %d of two faults, %d not monotone, %d from power-on, %d hidden, "
            "%d unknown\n",
            seen.combinations, seen.minimal, seen.of_two, seen.non_monotone, seen.from_power_on, seen.hidden,
            seen.unknown);
}

}  // namespace
}  // namespace grafverif
