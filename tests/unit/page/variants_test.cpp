// SPDX-License-Identifier: MIT
// Tests the pages of `faults` and `tune`: results for each property, and the data of the runs.
#include <algorithm>
#include <functional>

#include "content.hpp"
#include "pipeline/variants/faults.hpp"
#include "pipeline/variants/tune.hpp"
#include "pipeline/variants/tune_points.hpp"

namespace grafverif {
namespace {

const std::string lamp = R"(
grafcet lamp_control {
    input ON, OFF;
    output LAMP;

    initial step 0;
    step 1 { LAMP; }

    transition t0: 0 -> 1 when ON && !OFF;
    transition t1: 1 -> 0 when OFF;
}

component stuck(output OUT; VALUE: bool) {
    initial location stuck with OUT := VALUE;
}

component switch(output OUT; NEVER = false) {
    clock t;

    initial location switch;
    location pressed;

    timed switch -> pressed when t >= 1s && !NEVER do OUT := true, t := 0;
    timed pressed -> switch when t >= 1s do OUT := false, t := 0;
}

closed_loop room {
    controller lamp_control;

    environment On = switch(OUT = ON);
    environment Off = switch(OUT = OFF, NEVER = true);

    fault On_dead of On: stuck(VALUE = false);
    fault Off_held of Off: stuck(VALUE = true);

    property never_both "not both": never ON && OFF;
    property lit: reachable X1;
    property comes: inevitable LAMP after ON;
    property dark expected violated: never LAMP;
    property rare: never X0 && LAMP && OFF at stable;
}
)";

std::string data_text(const std::string& page) {
    return between(page, "<script type=\"application/json\" id=\"data\">", "</script>");
}

/// Returns the page of a fault analysis of the first loop of `text`, after `change` has changed the results.
Made page_of_faults(
    const std::string& text, std::size_t order,
    const std::function<void(FaultAnalysis&)>& change = [](FaultAnalysis&) {}) {
    Made made{read_string(text, "room.grafcet")};
    EXPECT_TRUE(made.reading.model) << made.reading.diagnostics_text();
    PageContent content = drawn_content(*made.reading.model, made.reading.sources, {0});
    content.faults = analysed_faults(*made.reading.model, {0}, {.order = order, .jobs = 1}, made.reading.diagnostics);
    EXPECT_TRUE(content.faults) << made.reading.diagnostics_text();
    change(*content.faults);
    content.report.model = content.faults->model;
    content.report.settings = content.faults->settings;
    made.page = page_of(content);
    made.data = nlohmann::json::parse(data_text(made.page));
    return made;
}

const nlohmann::json* run_called(const nlohmann::json& data, const std::string& name) {
    const auto& runs = data.at("runs");
    const auto found = std::ranges::find_if(runs, [&](const auto& run) { return run.at("name") == name; });
    return found == runs.end() ? nullptr : &*found;
}

TEST(FaultsPage, ShowsTheCombinationsOfEachPropertyAndTheEffectsOfEachFault) {
    const std::string page = page_of_faults(lamp, 2).page;
    for (const char* const part :
         {"<section id=\"faults\"><h2>Faults</h2>", "id=\"property-never_both\" open",
          "<button type=\"button\" class=\"play\" data-run=\"never_both: Off_held\"",
          "<strong>On_dead</strong><span class=\"remark\"> present from power-on; no run reaches a state that "
          "satisfies the property</span>",
          "violated without faults, as expected", "<details class=\"property ok\" id=\"property-rare\">",
          "holds for all combinations of at most 2 faults", "Effects of each fault (FMEA)",
          "leads to a violation of never_both, lit"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    for (const char* const absent : {"id=\"verdicts\"", "id=\"equations\"", "id=\"coverage\"", "property-no_timelock"})
        EXPECT_EQ(page.find(absent), std::string::npos) << absent;
    EXPECT_EQ(page, page_of_faults(lamp, 2).page);
}

// The instance of a fault that is present from power-on begins in a location of the fault. OFF is true at power-on only
// if the switch is held from power-on.
TEST(FaultsPage, RunsBeginInTheLocationsOfTheFaultsFromPowerOn) {
    std::string text = lamp;
    text.insert(text.find("    property rare"), "    property released: inevitable !OFF;\n");
    const Made made = page_of_faults(text, 1);
    for (const bool from_power_on : {false, true}) {
        const auto* const run = run_called(made.data, from_power_on ? "released: Off_held" : "never_both: Off_held");
        ASSERT_NE(run, nullptr);
        std::size_t instances = 0, values = 0;
        for (const auto& instance : run->at("run").at("instances")) {
            const std::string name = instance.at("name");
            if (!run->at("initial").contains(name)) continue;  // the observer of a property
            const auto initial = run->at("initial").at(name).get<std::size_t>();
            EXPECT_EQ(instance.at("locations").at(initial), from_power_on && name == "Off" ? "Off_held" : "switch");
            ++instances;
        }
        EXPECT_EQ(instances, 2U);
        for (const auto& value : run->at("run").at("moments").at(0).at("values"))
            if (run->at("run").at("signals").at(value.at(0).get<std::size_t>()).at("name") == "OFF") {
                EXPECT_EQ(value.at(1), from_power_on ? 1 : 0);
                ++values;
            }
        EXPECT_EQ(values, 1U);
    }
}

TEST(FaultsPage, OnlyAViolatedReachableHasNoRunThatSatisfiesTheProperty) {
    const Made made = page_of_faults(lamp, 1, [](FaultAnalysis& analysis) {
        for (FaultAnalysis::Row& row : analysis.rows)
            for (FaultAnalysis::Cut& cut : row.minimal) {
                if (row.property != "never_both") continue;
                cut.result.trace.reset();
                cut.result.verdict.notes = {"no trace is given: the trace has too many moves"};
            }
    });
    EXPECT_NE(
        made.page.find("<strong>Off_held</strong><span class=\"remark\"> no trace is given: the trace has too many "
                       "moves</span>"),
        std::string::npos);
    EXPECT_EQ(count_of(made.page, "no run reaches a state that satisfies the property"), 2U);
}

// The analysis does not state whether the fault of a model error is present from power-on.
TEST(FaultsPage, TheFirstLocationIsUnknownInTheRunOfAModelError) {
    std::string text = lamp;
    text.replace(text.find("closed_loop"), 0,
                 "component level(output P: int 0..3) {\n    initial location still;\n}\n\n"
                 "component runaway(output P: int 0..3) {\n    clock t;\n\n    initial location rising invariant t <= "
                 "1s;\n\n    timed rising -> rising when t == 1s do P := P + 1, t := 0;\n}\n\n");
    text.replace(text.find("    fault On_dead"), 0,
                 "    plant Level = level(P = P);\n    fault Up of Level: runaway();\n");
    const Made made = page_of_faults(text, 1);
    const auto* const run = run_called(made.data, "model error 1");
    ASSERT_NE(run, nullptr);
    EXPECT_TRUE(run->at("initial").at("Level").is_null());
    EXPECT_EQ(run->at("initial").at("On"), 0);
    EXPECT_NE(made.page.find("<strong>Model error.</strong>"), std::string::npos);
    EXPECT_NE(made.page.find("<details class=\"property unknown\" id=\"property-rare\""), std::string::npos);
}

TEST(FaultsPage, NamesOfTheUserAreText) {
    std::string text = lamp;
    text.replace(text.find("\"not both\""), 10, "\"</script><b>x\"");
    const std::string page = page_of_faults(text, 1).page;
    EXPECT_EQ(count_of(page, "<script"), 2U);
    EXPECT_EQ(page.find("<b>x"), std::string::npos);
}

const std::string press_loop = R"(
grafcet clamping(input START, DOWN; output LOWER; PAUSE = 2s) {
    initial step 0;
    step 1 { LOWER; }
    step 2;

    transition t0: 0 -> 1 when START;
    transition t1: 1 -> 2 when DOWN;
    transition t2: 2 -> 0 when PAUSE/X2;
}

component drive(input ON; output THERE; SLOWEST = 1s) {
    clock t;

    initial location rest;
    location moving invariant t <= SLOWEST;
    location there with THERE := true;

    urgent rest -> moving when ON do t := 0;
    timed moving -> there do THERE := true;
    urgent there -> rest when !ON do THERE := false;
}

closed_loop press {
    constant RAM = 3s, LIMIT = 5s;
    controller Clamping = clamping(START = START, DOWN = DOWN, LOWER = LOWER, PAUSE = LIMIT);

    environment Start = push_button(OUT = START, GAP = 1s);
    plant Ram = drive(ON = LOWER, THERE = DOWN, SLOWEST = RAM);

    property prompt: LOWER leads to DOWN within LIMIT;
    property moves: no deadlock;
}
)";

/// Returns the page about the values of constants of the first loop of `text`, after `change` has changed the results.
Made page_of_tuning(
    const std::string& text, std::vector<TunedConstant> constants, std::size_t runs = 24, bool every_point = false,
    const std::function<void(Tuning&)>& change = [](Tuning&) {}) {
    Made made{read_string(text, "press.grafcet")};
    EXPECT_TRUE(made.reading.model) << made.reading.diagnostics_text();
    const Model& model = *made.reading.model;
    const Id<Source> main = *made.reading.sources.ids().begin();
    TuneRequest request{.constants = std::move(constants), .jobs = 1, .runs = runs, .every_point = every_point};
    PageContent content = drawn_content(model, made.reading.sources, {0});
    content.tuning = tuned(model, {0}, main, made.reading.sources, request, made.reading.diagnostics);
    EXPECT_TRUE(content.tuning) << made.reading.diagnostics_text();
    for (const Tuning::Row& row : content.tuning->rows)
        for (const auto& [point, _] : row.runs) {
            Sources sources;
            content.point_models.emplace(point, *model_at(*content.tuning, point, main, made.reading.sources, {},
                                                          sources, made.reading.diagnostics));
        }
    EXPECT_EQ(content.tuning->failures, std::vector<std::string>{});
    change(*content.tuning);
    made.page = page_of(content);
    made.data = nlohmann::json::parse(data_text(made.page));
    return made;
}

constexpr auto duration = NamedConstant::Kind::Duration;

TEST(TuningPage, ShowsAMapOfTwoConstantsWithTheCurrentValues) {
    const Made made = page_of_tuning(
        press_loop, {{"RAM", duration, 1000, 6000, 1000, 3000}, {"LIMIT", duration, 2000, 6000, 1000, 5000}});
    for (const char* const part :
         {"<section id=\"tuning\">", "RAM = 1s..6s in steps of 1s; current value 3s", "RAM ↓  LIMIT →",
          "<td class=\"holds current\" title=\"RAM = 3s, LIMIT = 5s: holds (current values)\" aria-current=\"true\">✓",
          "violated at RAM = 6s, 3s above the current value 3s", "holds at 20, violated at 10 of 30 points"})
        EXPECT_NE(made.page.find(part), std::string::npos) << part;
    EXPECT_EQ(count_of(made.page, "<td class=\"violated"), 10U) << "RAM > LIMIT";
    EXPECT_EQ(count_of(made.page, "<td class=\"holds"), 20U);
    EXPECT_EQ(count_of(made.page, "aria-current"), 1U);
}

// The explanation of a run reads the property and the charts of its point. The explanation shows,
// independently of the engine, that the run violates the property at this point.
void expect_runs_of_each_point(bool every_point) {
    const Made made = page_of_tuning(
        press_loop, {{"RAM", duration, 1000, 6000, 1000, 3000}, {"LIMIT", duration, 2000, 6000, 1000, 5000}}, 24,
        every_point);
    std::set<std::string> names;
    for (const auto& run : made.data.at("runs")) {
        const std::string name = run.at("name");
        names.insert(name);
        const std::string limit = between(name + ";", "LIMIT = ", "s;");
        ASSERT_FALSE(run.at("violation").is_null()) << name;
        const std::string words = run.at("violation").at("steps").dump();
        const auto& steps = run.at("violation").at("steps");
        const auto& moments = run.at("run").at("moments");
        const std::int64_t begin = moments.at(steps.at(0).at("moment").get<std::size_t>()).at("time");
        EXPECT_NE(words.find(std::to_string(begin / 1000 + std::stoi(limit)) + " s"), std::string::npos)
            << name << words;
        const auto& chart = made.data.at("charts").at(run.at("charts").at(0).get<std::size_t>());
        EXPECT_EQ(chart.at("figure"), "chart-0");
        EXPECT_NE(chart.dump().find(limit + "s/X2"), std::string::npos) << name << chart.at("terms").dump();
    }
    EXPECT_EQ(names.size(), 10U);
    EXPECT_TRUE(names.contains("prompt: RAM = 6s, LIMIT = 5s"));
    EXPECT_EQ(count_of(made.page, "data-run=\"prompt: "), 10U);
}

TEST(TuningPage, EachRunViolatesThePropertyWithTheValuesOfItsPoint) { expect_runs_of_each_point(false); }
TEST(TuningPage, RunsOfSeparateChecksViolateThePropertyToo) { expect_runs_of_each_point(true); }

TEST(TuningPage, TheRunForTheCurrentValuesIsThatOfTheirCheck) {
    std::string text = press_loop;
    text.replace(text.find("RAM = 3s"), 8, "RAM = 7s");
    const Made made = page_of_tuning(text, {{"RAM", duration, 5000, 8000, 1000, 7000}});
    ASSERT_EQ(made.data.at("runs").size(), 3U);
    EXPECT_NE(run_called(made.data, "prompt: RAM = 7s"), nullptr);
    EXPECT_NE(made.page.find("<td class=\"violated current\""), std::string::npos);
}

TEST(TuningPage, OneConstantIsARowAndThreeConstantsAreATable) {
    const Made row = page_of_tuning(press_loop, {{"RAM", duration, 3000, 6000, 1000, 3000}});
    EXPECT_EQ(count_of(row.page, "<table class=\"map\">"), 1U);
    EXPECT_EQ(count_of(row.page, "<td class=\"violated"), 1U);
    std::string text = press_loop;
    text.replace(text.find("LIMIT = 5s;"), 11, "LIMIT = 5s, GAP = 1s;");
    text.replace(text.find("GAP = 1s);"), 10, "GAP = GAP);");
    const Made table = page_of_tuning(text, {{"RAM", duration, 3000, 6000, 1000, 3000},
                                             {"LIMIT", duration, 5000, 6000, 1000, 5000},
                                             {"GAP", duration, 1000, 2000, 1000, 1000}});
    EXPECT_EQ(count_of(table.page, "<table class=\"map\">"), 0U);
    EXPECT_NE(table.page.find("<td>6s</td>\n<td>5s</td>\n<td>1s..2s</td>\n<td>violated</td>"), std::string::npos);
    EXPECT_EQ(count_of(table.page, "data-run=\"prompt: "), 2U);
}

TEST(TuningPage, RunsAreThoseNearestToTheCurrentValues) {
    const Made made = page_of_tuning(press_loop, {{"RAM", duration, 1000, 12000, 1000, 3000}}, 2);
    ASSERT_EQ(made.data.at("runs").size(), 2U);
    EXPECT_EQ(made.data.at("runs").at(0).at("name"), "prompt: RAM = 6s");
    EXPECT_EQ(made.data.at("runs").at(1).at("name"), "prompt: RAM = 7s");
    EXPECT_EQ(count_of(made.page, "<td class=\"violated"), 7U);
    const Made far = page_of_tuning(press_loop, {{"RAM", duration, 1000, 12000, 1000, 13000}}, 2);
    ASSERT_EQ(far.data.at("runs").size(), 2U);
    EXPECT_EQ(far.data.at("runs").at(0).at("name"), "prompt: RAM = 11s");
    EXPECT_EQ(far.data.at("runs").at(1).at("name"), "prompt: RAM = 12s");
}

const std::string heads = R"(
grafcet head(input GO; output VALVE) {
    initial step 0;
    step 1 { VALVE; }

    transition t0: 0 -> 1 when GO;
    transition t1: 1 -> 0 when !GO;
}

closed_loop line {
    constant N = 2, GAP = 1s;

    for i in 1..N {
        controller Head[i] = head(GO = GO[i], VALVE = VALVE[i]);
        environment Go[i] = push_button(OUT = GO[i], GAP = GAP);
    }
    property closed: never VALVE[1];
}
)";

// The drawings of the page show the controllers for the current values only.
TEST(TuningPage, RunsOfLoopsWithOtherControllersAreOmitted) {
    const char* const omitted = "The page does not contain the runs at these points.";
    const Made made = page_of_tuning(heads, {{"N", NamedConstant::Kind::Integer, 1, 3, 1, 2}});
    EXPECT_NE(made.page.find("violated at 3 of 3 points"), std::string::npos);
    ASSERT_EQ(made.data.at("runs").size(), 1U);
    EXPECT_EQ(made.data.at("runs").at(0).at("name"), "closed: N = 2");
    EXPECT_EQ(made.data.at("runs").at(0).at("charts"), nlohmann::json::parse("[0, 1]"));
    EXPECT_EQ(count_of(made.page, "data-run="), 1U);
    EXPECT_NE(made.page.find(omitted), std::string::npos);
    const Made same = page_of_tuning(heads, {{"GAP", duration, 1000, 3000, 1000, 1000}});
    EXPECT_EQ(same.data.at("runs").size(), 3U);
    EXPECT_EQ(same.page.find(omitted), std::string::npos);
}

const std::string positive = "<p class=\"glance ok\">", unknown = "<p class=\"glance unknown\">";

TEST(TuningPage, TheSummaryIsPositiveOnlyIfThereIsAPropertyAndEachVerdictIsKnown) {
    const std::vector<TunedConstant> constants = {{"RAM", duration, 1000, 3000, 1000, 3000}};
    EXPECT_NE(page_of_tuning(press_loop, constants).page.find(positive), std::string::npos);
    const Made open = page_of_tuning(press_loop, constants, 24, false, [](Tuning& tuning) {
        for (Tuning::Row& row : tuning.rows)
            if (!row.declared) row.verdicts.back() = {};
    });
    EXPECT_NE(open.page.find(unknown + "<strong>1 property is unknown at some grid point."), std::string::npos);
    EXPECT_NE(open.page.find("id=\"property-no_timelock\""), std::string::npos) << "the page shows what is unknown";
    std::string text = press_loop;
    const std::size_t first = text.find("    property prompt");
    text.erase(first, text.find("}", first) - first);
    EXPECT_NE(page_of_tuning(text, constants).page.find(unknown + "<strong>There are no properties."),
              std::string::npos);
}

TEST(TuningPage, AnUnknownVerdictHasNoMargins) {
    const char* const sentence = "On the grid, a change of a single constant does not change this verdict.";
    const std::vector<TunedConstant> constants = {{"RAM", duration, 1000, 3000, 1000, 3000}};
    EXPECT_EQ(count_of(page_of_tuning(press_loop, constants).page, sentence), 2U);
    const Made open = page_of_tuning(press_loop, constants, 24, false, [](Tuning& tuning) {
        for (Tuning::Row& row : tuning.rows) {
            row.current = {};
            for (PointVerdict& verdict : row.verdicts) verdict = {};
        }
    });
    EXPECT_EQ(count_of(open.page, sentence), 0U);
    EXPECT_EQ(count_of(open.page, "Verdict with the current values: unknown: not checked."), 3U);
}

}  // namespace
}  // namespace grafverif
