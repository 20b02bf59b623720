// SPDX-License-Identifier: MIT
// Tests the detection of faults: the longest time until steps and outputs show a fault, and proposed properties.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "pipeline/check.hpp"
#include "pipeline/models.hpp"
#include "pipeline/variants/fault_detection.hpp"
#include "pipeline/variants/fault_model.hpp"
#include "pipeline/variants/faults.hpp"

namespace grafverif {
namespace {

/// A gate that opens when REMOTE is pressed. Step 3 reports a gate that does not open within WATCH.
std::string driveway(const std::string& more, const std::string& watch = "8s") {
    return fmt::format(R"(
grafcet gate_control {{
    input REMOTE, S1, S2;
    output MOTOR, GREEN, WARNING;

    initial step 0;
    step 1 {{ MOTOR; }}
    step 2 {{ MOTOR; GREEN; }}
    step 3 {{ WARNING; }}
    step 4;

    transition t0: 0 -> 1 when REMOTE;
    transition t1: 1 -> 2 when S1 && S2;
    transition t2: 2 -> 4 when 4s/X2;
    transition t3: 1 -> 3 when {0}/X1;
    transition t4: 4 -> 0 when 2s/X4;
}}

component gate(input MOTOR; output OPEN) {{
    clock t;

    initial location closed;
    location opening invariant t <= 5s;
    location open;

    urgent closed -> opening when MOTOR do t := 0;
    timed opening -> open when t >= 3s do OPEN := true;
    urgent opening -> closed when !MOTOR;
    urgent open -> closed when !MOTOR do OPEN := false;
}}

component sensor(input X; output OUT) {{
    initial location sensor;

    urgent sensor -> sensor when OUT != X do OUT := X;
}}

component stuck(output OUT; VALUE: bool) {{
    initial location stuck with OUT := VALUE;
}}

component impatient(output OUT) {{
    clock t;

    initial location off invariant t <= 2s;
    location on invariant t <= 1s;

    timed off -> on when t >= 1s do OUT := true, t := 0;
    timed on -> off when t == 1s do OUT := false, t := 0;
}}

closed_loop driveway {{
    controller gate_control;

    environment Remote = impatient(OUT = REMOTE);
    plant Gate = gate(MOTOR = MOTOR, OPEN = OPEN);
    plant First = sensor(X = OPEN, OUT = S1);
    plant Second = sensor(X = OPEN, OUT = S2);

    fault Motor_dead of Gate: gate(MOTOR = false);
    fault First_0 of First: stuck(VALUE = false);
    fault First_1 of First: stuck(VALUE = true);

    property safe: never GREEN && !OPEN;
{1}}}
)",
                       watch, more);
}

struct Analysed {
    ParseResult read = {};
    FaultAnalysis analysis = {};
};

Analysed analysed(const std::string& text, FaultsRequest request = {}) {
    Analysed made{read_string(text, "driveway.grafcet")};
    if (!made.read.model) {
        ADD_FAILURE() << made.read.diagnostics_text();
        return made;
    }
    request.jobs = 1;
    const auto found =
        analysed_faults(*made.read.model, *find_loop(*made.read.model, "driveway"), request, made.read.diagnostics);
    if (!found) ADD_FAILURE() << made.read.diagnostics_text();
    else made.analysis = *found;
    EXPECT_EQ(made.analysis.failures, std::vector<std::string>{});
    return made;
}

/// Decides with the observer of a property whether WARNING always follows the fault within `within_ms`.
Outcome warned_within(const ParseResult& read, std::uint32_t fault, std::int64_t within_ms) {
    const Id<ClosedLoop> loop = *find_loop(*read.model, "driveway");
    const Model model = with_faults(*read.model, loop, {{.fault = {fault}, .announced = true}});
    Diagnostics diagnostics;
    Network network = *network_of(model, loop, ModelOptions{}, diagnostics);
    const std::string instance = model.loops[loop].instances[read.model->loops[loop].faults[{fault}].of].name;
    Id<Expr> occurs, warning;
    for (const Id<Network::Process> id : network.processes.ids())
        if (network.processes[id].name == instance)
            occurs = network.exprs.at(
                id.index,
                static_cast<std::uint32_t>(network.templates[network.processes[id].automaton].locations.size() - 1));
    for (const ControllerSignal& each : controller_signals(network, false))
        if (each.name == "WARNING") warning = network.exprs.leaf(Op::Variable, each.variable.index);
    network.properties = {};
    network.properties.add({.name = "p",
                            .pattern = Pattern::Watched,
                            .operands = {occurs, warning},
                            .watch = {.kind = Sentence::Kind::Response, .duration_ms = within_ms}});
    return check(loop_to_check(model, loop, network), CheckOptions{.properties = {"p"}})
        .answers.front()
        .verdict.outcome;
}

TEST(FaultDetection, ReportsTheLongestTimeToTheWarning) {
    for (const char* const watch : {"6s", "8s", "11s"}) {
        SCOPED_TRACE(watch);
        const Analysed found = analysed(driveway("", watch));
        const FaultAnalysis::Visible& visible = found.analysis.faults[1].visible;
        EXPECT_EQ(visible.newly_true, (std::vector<std::string>{"WARNING", "X3"}));
        EXPECT_EQ(visible.detected, Outcome::Holds);
        ASSERT_TRUE(visible.within_ms.has_value());
        EXPECT_EQ(warned_within(found.read, 1, *visible.within_ms), Outcome::Holds);
        EXPECT_EQ(warned_within(found.read, 1, *visible.within_ms - 1000), Outcome::Violated);
        EXPECT_FALSE(visible.observer.has_value());
    }
}

/// If the motor fails while the gate is open, the sensors report an open gate forever.
TEST(FaultDetection, IsViolatedIfSomeRunDoesNotShowTheFault) {
    const Analysed found = analysed(driveway(""));
    const FaultAnalysis::Visible& dead = found.analysis.faults[0].visible;
    EXPECT_EQ(dead.newly_true, (std::vector<std::string>{"WARNING", "X3"}));
    EXPECT_EQ(dead.detected, Outcome::Violated);
    EXPECT_FALSE(dead.within_ms.has_value());
}

/// The gate opens in time, and the warning is never given: nothing shows the hidden fault of the first sensor.
TEST(FaultDetection, ProposesAPropertyThatRevealsAHiddenFault) {
    const Analysed found = analysed(driveway(""));
    const FaultAnalysis::Visible& hidden = found.analysis.faults[2].visible;
    EXPECT_TRUE(hidden.newly_true.empty());
    EXPECT_EQ(hidden.detected, Outcome::Unknown);
    ASSERT_TRUE(hidden.observer.has_value());
    EXPECT_EQ(hidden.observer->property, "property detects_First_1: never S1 && !S2 at stable;");
    const Analysed pasted = analysed(driveway("    " + hidden.observer->property + "\n"), {.visible = false});
    const auto row = std::ranges::find(pasted.analysis.rows, "detects_First_1", &FaultAnalysis::Row::property);
    ASSERT_NE(row, pasted.analysis.rows.end());
    EXPECT_EQ(row->without_faults, Outcome::Holds);
    EXPECT_TRUE(std::ranges::any_of(row->minimal, [](const auto& cut) { return cut.faults == FaultSet{2}; }));
}

/// The loop already declares the condition that would be proposed, in an equivalent form.
/// Declarations of other conditions, or for other states, do not count.
TEST(FaultDetection, StatesADeclaredPropertyInsteadOfProposingIt) {
    for (const char* const text : {"never S1 && !S2 at stable", "never !S2 && S1 at stable",
                                   "always S1 => S2 at stable", "always !(S1 && !S2) at stable"}) {
        SCOPED_TRACE(text);
        const Analysed found = analysed(driveway(
            fmt::format("    property other: never S1 && S2 && !OPEN at stable;\n    property both: {};\n", text)));
        const FaultAnalysis::Visible& hidden = found.analysis.faults[2].visible;
        ASSERT_TRUE(hidden.observer.has_value());
        EXPECT_EQ(hidden.observer->declared, "both");
        EXPECT_EQ(hidden.observer->property, "property both: never S1 && !S2 at stable;");
    }
    for (const char* const text : {"never S1 && !S2", "never S1 && !S2 && OPEN at stable", "never S1 && S2 at stable",
                                   "never S1 at stable", "reachable S1 && !S2 at stable"}) {
        SCOPED_TRACE(text);
        const Analysed found = analysed(driveway(fmt::format("    property both: {};\n", text)));
        const FaultAnalysis::Visible& hidden = found.analysis.faults[2].visible;
        ASSERT_TRUE(hidden.observer.has_value());
        EXPECT_EQ(hidden.observer->declared, "");
        EXPECT_EQ(hidden.observer->property, "property detects_First_1: never S1 && !S2 at stable;");
    }
}

/// If BLOCKED is true, the gate is never opened. Only the fault makes BLOCKED true; a second
/// literal would be superfluous.
TEST(FaultDetection, ProposesOneLiteralIfItIsTrueOnlyWithTheFault) {
    std::string text = driveway(
        "    plant Guard = unused(OUT = BLOCKED);\n    fault Guard_1 of Guard: stuck(VALUE = true);\n"
        "    property detects_Guard_1: never GREEN && BLOCKED;\n");
    text.replace(text.find("REMOTE, S1"), 6, "BLOCKED, REMOTE");
    text.replace(text.find("when REMOTE"), 11, "when REMOTE && !BLOCKED");
    text.insert(text.find("component stuck"), "component unused(output OUT: bool) { initial location unused; }\n");
    const Analysed found = analysed(text);
    const auto blocked = std::ranges::find(found.analysis.faults, "Guard_1", &FaultAnalysis::Fault::name);
    ASSERT_NE(blocked, found.analysis.faults.end());
    EXPECT_TRUE(blocked->visible.newly_true.empty());
    ASSERT_TRUE(blocked->visible.observer.has_value());
    // The loop already has a property `detects_Guard_1`.
    EXPECT_EQ(blocked->visible.observer->property, "property detects_Guard_1_2: never BLOCKED at stable;");
    EXPECT_EQ(blocked->visible.observer->in_every_run, Outcome::Holds);
    EXPECT_EQ(blocked->visible.observer_limit, "");
    const auto pasted = text.replace(text.find("    property safe"), 0, "    " + blocked->visible.observer->property);
    EXPECT_TRUE(read_string(pasted, "driveway.grafcet").model.has_value());
}

/// With a strict constraint, a search in integer time proves neither the visible effects nor that a property holds
/// without faults.
TEST(FaultDetection, ProposesNoPropertyWithoutAProofInDenseTime) {
    std::string text = driveway("");
    text.replace(text.find("when t >= 3s do OPEN"), 12, "when t > 2s");
    const Analysed found = analysed(text);
    EXPECT_FALSE(found.analysis.faults[2].visible.decided);
    EXPECT_FALSE(found.analysis.faults[2].visible.observer.has_value());
}

TEST(FaultDetection, NamesPropertiesForIndexedFaults) {
    const Analysed found = analysed(driveway("    for i in 1..2 { fault Again[i] of First: stuck(VALUE = true); }\n"));
    for (const FaultAnalysis::Fault& fault : found.analysis.faults) {
        if (!fault.name.starts_with("Again[")) continue;
        ASSERT_TRUE(fault.visible.observer.has_value());
        EXPECT_EQ(fault.visible.observer->property,
                  fmt::format("property detects_Again_{}: never S1 && !S2 at stable;", fault.name[6]));
    }
    EXPECT_EQ(found.analysis.faults.size(), 5U);
}

TEST(FaultDetection, StatesTheLimitOfTheSearchForAProperty) {
    const Analysed found = analysed(driveway(""));
    // No condition is true in every run in which the motor fails, and more conditions than those tried are candidates.
    const FaultAnalysis::Visible& dead = found.analysis.faults[0].visible;
    ASSERT_TRUE(dead.observer.has_value());
    EXPECT_EQ(dead.observer->in_every_run, Outcome::Violated);
    EXPECT_TRUE(dead.observer_limit.starts_with("the search for an observer tried 6 of ")) << dead.observer_limit;
    FaultsRequest request;
    request.first_states = 50;
    const Analysed limited = analysed(driveway(""), request);
    const FaultAnalysis::Visible& hidden = limited.analysis.faults[2].visible;
    EXPECT_TRUE(hidden.decided);
    EXPECT_EQ(hidden.observer_limit, "the search for an observer ended at 50 states");
}

TEST(FaultDetection, IsUnknownAtALimit) {
    FaultsRequest request;
    request.first_states = 10;
    for (const FaultAnalysis::Fault& fault : analysed(driveway(""), request).analysis.faults) {
        EXPECT_FALSE(fault.visible.within_ms.has_value());
        EXPECT_FALSE(fault.visible.observer.has_value());
    }
}

TEST(FaultDetection, TheLocationOfAnAnnouncedFaultIsTheLast) {
    const ParseResult read = read_string(driveway(""), "driveway.grafcet");
    ASSERT_TRUE(read.model.has_value()) << read.diagnostics_text();
    const Id<ClosedLoop> loop = *find_loop(*read.model, "driveway");
    const Model made = with_faults(*read.model, loop, {{.fault = {2}, .announced = true}});
    EXPECT_EQ(verify(made), std::vector<std::string>{});
    const Component& sensor = made.components[made.loops[loop].instances[Id<ClosedLoop::Instance>{2}].component];
    ASSERT_EQ(sensor.locations.size(), 3u);
    EXPECT_EQ(sensor.locations[Id<Component::Location>{2}].name, "First_1_occurs");
}

}  // namespace
}  // namespace grafverif
