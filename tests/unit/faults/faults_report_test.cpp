// SPDX-License-Identifier: MIT
// Tests how results of a fault analysis are written: unknown combinations, unproved minimality, and fault trees.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "report/charts/faults.hpp"

namespace grafverif {
namespace {

/// Returns results with a property whose combination of faults may not be minimal, a property that is violated without
/// faults, and two undeclared properties.
FaultAnalysis analysis() {
    FaultAnalysis made;
    made.model = "station";
    made.order = 2;
    made.faults = {{"_A"}, {"B"}, {"C"}};
    FaultAnalysis::Row row{.property = "p", .pattern = Pattern::Reachable, .without_faults = Outcome::Holds};
    row.minimal = {{.faults = {0, 1}, .unknown_subsets = {{0}, {1}}}};
    row.open = {{{0}, "stopped"}, {{1}, "stopped"}};
    row.non_monotone = {{{0, 1}, {0, 1, 2}}};
    made.rows.push_back(row);
    made.rows.push_back({.property = "q", .without_faults = Outcome::Violated});
    made.rows.push_back({.property = "no_timelock", .declared = false, .without_faults = Outcome::Unknown});
    made.rows.push_back({.property = "no_deadlock", .declared = false, .without_faults = Outcome::Holds});
    return made;
}

TEST(FaultsReport, TextStatesWhatIsUnknown) {
    std::ostringstream out;
    print_faults(analysis(), false, out);
    const std::string text = out.str();
    for (const char* const part : {"p            _A + B (minimality is unproved: _A, B have an unknown verdict)\n",
                                   "q            violated without faults\n", "no_timelock  unknown without faults\n",
                                   "p: unknown for 2 combinations\n    _A: stopped\n"})
        EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
    EXPECT_EQ(text.find("no_deadlock"), std::string::npos) << text;
    EXPECT_EQ(text.find("leads to no violation"), std::string::npos) << text;
}

TEST(FaultsReport, OnlyAViolatedReachableHasNoRunThatSatisfiesTheProperty) {
    const std::string absent = "no run reaches a state that satisfies the property";
    FaultAnalysis made = analysis();
    const auto text = [&] {
        std::ostringstream out;
        print_faults(made, false, out);
        return out.str();
    };
    EXPECT_NE(text().find(absent), std::string::npos);
    made.rows.front().pattern = Pattern::Never;
    EXPECT_EQ(text().find(absent), std::string::npos);
    EXPECT_NE(text().find("p: violated with _A + B\n    no trace is given\n"), std::string::npos) << text();
    made.rows.front().minimal.front().result.verdict.notes = {"no trace is given: the trace has too many moves"};
    EXPECT_NE(text().find("\n    no trace is given: the trace has too many moves\n"), std::string::npos) << text();
}

TEST(FaultsReport, JsonHasUnknownSubsetsAndTruthValues) {
    FaultAnalysis made = analysis();
    made.faults[0].visible = {.newly_true = {"X9"}, .always_shown = Outcome::Holds};
    made.faults[1].visible = {.newly_true = {"X9"}, .always_shown = Outcome::Violated};
    made.faults[2].visible = {.newly_true = {"X9"}, .always_shown = Outcome::Unknown};
    const auto json = nlohmann::json::parse(faults_json(made, {}));
    EXPECT_EQ(json.at("properties").at(0).at("minimal").at(0).at("unknown_subsets"),
              nlohmann::json::array({nlohmann::json::array({"_A"}), nlohmann::json::array({"B"})}));
    EXPECT_EQ(json.at("faults").at(0).at("always_shown"), true);
    EXPECT_EQ(json.at("faults").at(1).at("always_shown"), false);
    EXPECT_EQ(json.at("faults").at(2).at("always_shown"), nullptr);
    EXPECT_EQ(json.at("faults").at(2).at("observer"), nullptr);
}

TEST(FaultsReport, StatesWhenAFaultIsDetected) {
    FaultAnalysis made = analysis();
    made.faults[0].visible = {.newly_true = {"X9"}, .detected = Outcome::Holds, .within_ms = 9500, .decided = true};
    made.faults[1].visible = {
        .newly_true = {"X9"}, .always_shown = Outcome::Holds, .detected = Outcome::Violated, .decided = true};
    made.faults[2].visible = {.newly_true = {"X9"},
                              .always_shown = Outcome::Violated,
                              .detected = Outcome::Violated,
                              .observer = FaultAnalysis::Observer{"property o: never A && B;", Outcome::Holds, 2000},
                              .decided = true};
    const std::string shown = "true in some state with this fault, but never without faults: X9; ";
    using Sentences = std::vector<std::string>;
    EXPECT_EQ(effects_of(made, 0).visible, (Sentences{shown + "in every run, at most 9.5 s after the fault"}));
    EXPECT_EQ(effects_of(made, 1).visible,
              (Sentences{shown + "in every run, if the fault is present from power-on, but not if it occurs later"}));
    EXPECT_EQ(effects_of(made, 2).visible,
              (Sentences{shown + "not in every run with the fault",
                         "proposed observer, violated in every run, at most 2 s after the fault: "
                         "property o: never A && B;"}));
    made.faults[2].visible.observer->declared = "o";
    EXPECT_EQ(effects_of(made, 2).visible.back(),
              "declared observer, violated in every run, at most 2 s after the fault: o");
    made.faults[2].visible.observer->declared.clear();
    made.faults[2].visible.observer->in_every_run = Outcome::Violated;
    EXPECT_EQ(effects_of(made, 2).visible.back(),
              "proposed observer, violated in some run with the fault: property o: never A && B;");
    const auto faults = nlohmann::json::parse(faults_json(made, {})).at("faults");
    EXPECT_EQ(faults.at(0).at("detected"), true);
    EXPECT_EQ(faults.at(0).at("within"), 9.5);
    EXPECT_EQ(faults.at(2).at("detected"), false);
    EXPECT_EQ(faults.at(2).at("within"), nullptr);
    EXPECT_EQ(faults.at(2).at("observer"),
              nlohmann::json::parse(R"({"property": "property o: never A && B;", "declared": null,
                                                                    "in_every_run": false, "within": 2.0})"));
}

TEST(FaultsReport, AFaultTreeStatesWhatItOmits) {
    const std::string xml = open_psa_of(analysis());
    for (const char* const part :
         {"<!-- only combinations of at most 2 faults -->\n", "<!-- omitted: q is violated without faults -->\n",
          "<!-- omitted: no_timelock is unknown without faults -->\n", "<!-- incomplete: p is unknown for _A, B -->\n",
          "<!-- _A + B: minimality is unproved: _A, B have an unknown verdict -->\n",
          "<!-- not monotone: _A + B leads to a violation of p, _A + B + C does not -->\n",
          "<label>_A:  behaves as </label>"})
        EXPECT_NE(xml.find(part), std::string::npos) << part << '\n' << xml;
}

}  // namespace
}  // namespace grafverif
