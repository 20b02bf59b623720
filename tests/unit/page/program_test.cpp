// SPDX-License-Identifier: MIT
// Tests the page of a loop whose controller is a PLC program: its lines, the values of its scans, and its chart.
#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

#include "content.hpp"
#include "ir/program/interface.hpp"
#include "page/listing.hpp"
#include "page/scans.hpp"
#include "pipeline/program/check.hpp"

namespace grafverif {
namespace {

using Data = nlohmann::json;

/// Generates the page of a loop with a program, as `report` does.
Made page_of_loop(const std::string& loop, const std::string& program, const std::string& file) {
    ReadOptions options;
    options.load = [&](const std::string&, std::string&) { return std::optional(program); };
    Made made{read_string("program plc = \"" + file + "\";\nclosed_loop l {\n" + loop + "}\n", "l.grafcet", options)};
    EXPECT_TRUE(made.reading.model) << made.reading.diagnostics_text();
    if (!made.reading.model) return made;
    Diagnostics& diagnostics = made.reading.diagnostics;
    auto content = page_content(*made.reading.model, made.reading.sources, {0}, {}, {}, {}, diagnostics);
    EXPECT_TRUE(content) << made.reading.diagnostics_text();
    if (!content) return made;
    content->report = *check(*made.reading.model, {0}, {}, {}, diagnostics);
    EXPECT_EQ(content->report.failures, std::vector<std::string>());
    made.page = page_of(*content);
    made.data = Data::parse(between(made.page, "id=\"data\">", "</script>"), nullptr, false);
    return made;
}

const Data& run_of(const Made& made, const std::string& name) {
    for (const Data& run : made.data["runs"])
        if (run["name"] == name) return run;
    throw std::runtime_error("no run " + name);
}

/// Returns, for each scan of the run, the index of its event, and the value of each point that the scan evaluated.
std::vector<std::pair<std::size_t, std::map<std::size_t, Data>>> scans_of(const Data& run) {
    std::vector<std::pair<std::size_t, std::map<std::size_t, Data>>> scans;
    std::map<std::size_t, Data> values;
    for (const Data& scan : run["scans"][0]) {
        for (const Data& change : scan[1])
            if (change[1].is_null()) values.erase(change[0]);
            else values[change[0]] = change;
        scans.emplace_back(scan[0], values);
    }
    return scans;
}

/// Returns the value of a signal after an event of the run.
std::int64_t signal_after(const Data& run, const std::string& name, std::size_t event) {
    std::int64_t value = 0;
    const Data& signals = run["run"]["signals"];
    for (std::size_t m = 0; m <= event; ++m)
        for (const Data& change : run["run"]["moments"][m]["values"]) {
            if (signals[change[0].get<std::size_t>()]["name"] == name) value = change[1];
        }
    return value;
}

/// Returns the points with the role `role` on the line that contains `text`.
std::vector<std::size_t> points_on(const Made& made, const std::string& program, const std::string& text,
                                   const std::string& role) {
    std::vector<std::size_t> found;
    const auto line =
        std::count(program.begin(), program.begin() + static_cast<std::ptrdiff_t>(program.find(text)), '\n');
    const Data& points = made.data["charts"][0]["program"]["points"];
    for (std::size_t k = 0; k < points.size(); ++k)
        if (points[k]["line"] == line && points[k]["role"] == role) found.push_back(k);
    return found;
}

const std::string counters = R"(TYPE Mode : (Off, Slow, Fast); END_TYPE
FUNCTION Twice : INT
VAR_INPUT N : INT; END_VAR
Twice := 2 * N;
END_FUNCTION
FUNCTION_BLOCK Counter
VAR_INPUT Up : BOOL; END_VAR
VAR_OUTPUT Sum : INT; END_VAR
VAR Edge : R_TRIG; END_VAR
Edge(CLK := Up);
IF Edge.Q AND Sum < 3 THEN
    Sum := Sum + 1;
ELSE
    Sum := Sum;
END_IF
END_FUNCTION_BLOCK
PROGRAM Main
VAR_INPUT A, B : BOOL; END_VAR
VAR_OUTPUT Lamp : BOOL; END_VAR
VAR First, Second : Counter; I, Total : INT; State : Mode; END_VAR
First(Up := A);
Second(Up := B);
Total := 0;
FOR I := 1 TO 3 DO Total := Total + I; END_FOR
CASE Twice(First.Sum) OF
    0: State := Off;
    2: State := Slow;
ELSE
    State := Fast; // </script><b>"&" end
END_CASE
Lamp := State = Fast AND Second.Sum = 1;
END_PROGRAM
)";
const std::string counter_loop = R"(    controller plc every 10ms;
    environment A = free(OUT = A);
    environment B = free(OUT = B);
    property dark "the lamp is never lit": never Lamp;
    property counted: reachable First.Sum == 2;
)";

TEST(ProgramPage, ValuesOfTheStatementsAgreeWithTheRun) {
    const Made made = page_of_loop(counter_loop, counters, "plc.st");
    for (const char* const name : {"dark", "counted"}) {
        const Data& run = run_of(made, name);
        const auto lamp = points_on(made, counters, "Lamp := State", "result");
        ASSERT_EQ(lamp.size(), 1U);
        const auto sums = points_on(made, counters, "Sum := Sum + 1", "result");
        ASSERT_FALSE(sums.empty());
        std::size_t compared = 0;
        for (const auto& [event, values] : scans_of(run)) {
            EXPECT_EQ(values.at(lamp.front())[1], signal_after(run, "Lamp_image", event));
            for (const std::size_t sum : sums) {
                if (!values.contains(sum)) continue;
                const Data& instance = made.data["charts"][0]["program"]["points"][sum]["instance"];
                const std::string block =
                    made.data["charts"][0]["program"]["instances"][instance.get<std::size_t>()]["name"];
                EXPECT_EQ(values.at(sum)[1], signal_after(run, block + ".Sum", event)) << block;
                ++compared;
            }
        }
        EXPECT_GT(compared, 0U);
    }
}

TEST(ProgramPage, EachScanEvaluatesExactlyOneBranch) {
    const Made made = page_of_loop(counter_loop, counters, "plc.st");
    std::size_t branches = 0;
    for (const auto& [event, values] : scans_of(run_of(made, "dark"))) {
        const auto evaluated = [&](const char* line, const char* role) {
            std::size_t count = 0;
            for (const std::size_t point : points_on(made, counters, line, role))
                count += values.contains(point) ? 1U : 0U;
            return count;
        };
        EXPECT_EQ(evaluated("IF Edge.Q", "condition"), 2U) << "two instances";
        EXPECT_EQ(evaluated("Sum := Sum + 1", "result") + evaluated("Sum := Sum;", "result"), 2U);
        EXPECT_EQ(evaluated("State := Off", "result") + evaluated("State := Slow", "result") +
                      evaluated("State := Fast", "result"),
                  1U);
        branches += evaluated("Sum := Sum + 1", "result");
    }
    EXPECT_EQ(branches, 3U) << "two presses of A, and one of B";
}

TEST(ProgramPage, CountsRepeatedEvaluationsAndNamesValues) {
    const Made made = page_of_loop(counter_loop, counters, "plc.st");
    const auto total = points_on(made, counters, "FOR I := 1", "result");
    const Data& points = made.data["charts"][0]["program"]["points"];
    const auto scans = scans_of(run_of(made, "dark"));
    ASSERT_EQ(total.size(), 2U);
    for (const std::size_t point : total) {
        const Data& change = scans.front().second.at(point);
        ASSERT_EQ(change.size(), 3U) << change;
        EXPECT_EQ(change[2], 3) << "three iterations";
        EXPECT_EQ(change[1], points[point]["name"] == "I" ? 3 : 6);
    }
    const auto function = points_on(made, counters, "Twice := 2", "result");
    ASSERT_EQ(function.size(), 1U);
    EXPECT_TRUE(points[function.front()]["instance"].is_null());
    const auto state = points_on(made, counters, "State := Fast", "result");
    ASSERT_EQ(state.size(), 1U);
    EXPECT_EQ(points[state.front()]["format"], Data({"Off", "Slow", "Fast"}));
}

TEST(ProgramPage, ContainsTheLinesWithoutInterpretingThem) {
    const Made made = page_of_loop(counter_loop, counters, "plc.st");
    const std::string lines = between(made.page, "<pre id=\"program-0\" class=\"source\">", "</pre>");
    EXPECT_EQ(lines.front(), '\n') << "parsers ignore this newline";
    EXPECT_EQ(count_of(lines, "\n"), count_of(counters, "\n") + 1);
    const Made empty_line = page_of_loop(counter_loop, "\n" + counters, "plc.st");
    EXPECT_NE(empty_line.page.find("<pre id=\"program-0\" class=\"source\">\n\nTYPE Mode"), std::string::npos);
    EXPECT_NE(lines.find("&lt;/script&gt;&lt;b&gt;"), std::string::npos);
    EXPECT_EQ(made.page.find("id=\"equations\""), std::string::npos);
    EXPECT_EQ(made.page.find("id=\"findings\""), std::string::npos);
    EXPECT_EQ(made.page.find("id=\"coverage\""), std::string::npos) << "the program has no steps";
    EXPECT_NE(made.page.find("<h2>Programs</h2>"), std::string::npos);
}

TEST(ProgramPage, ShowsInternalVariablesInTheExplanationOfAProperty) {
    const Made made = page_of_loop(counter_loop, counters, "plc.st");
    const auto counted =
        std::ranges::find_if(made.data["properties"], [](const Data& p) { return p["name"] == "counted"; });
    ASSERT_NE(counted, made.data["properties"].end());
    const Data& terms = (*counted)["terms"];
    const auto sum = std::ranges::find_if(terms, [](const Data& term) { return term["op"] == "signal"; });
    ASSERT_NE(sum, terms.end());
    const Data& signals = run_of(made, "counted")["run"]["signals"];
    EXPECT_TRUE(std::ranges::any_of(signals, [&](const Data& signal) { return signal["name"] == (*sum)["text"]; }));
}

const std::string blinkers = R"(FUNCTION_BLOCK Blinker
VAR_INPUT Go : BOOL; END_VAR
VAR_OUTPUT Light : BOOL; END_VAR
INITIAL_STEP Dark: END_STEP
STEP Lit: Light(N); END_STEP
TRANSITION FROM Dark TO Lit := Go; END_TRANSITION
TRANSITION FROM Lit TO Dark := Lit.T >= T#30ms OR NOT Go; END_TRANSITION
END_FUNCTION_BLOCK
PROGRAM Main
VAR_INPUT A, B : BOOL; END_VAR
VAR_OUTPUT L : BOOL; END_VAR
VAR Left, Right : Blinker; END_VAR
Left(Go := A);
Right(Go := B);
L := Left.Light AND Right.Light;
END_PROGRAM
)";
const std::string blinker_loop = R"(    controller plc every 10ms;
    environment A = free(OUT = A);
    environment B = free(OUT = B);
    property dark: never L;
    property again: reachable Left.Dark.X && Right.Lit.X && Left.XDark;
)";

TEST(ProgramPage, DrawsTheChartOfEachInstance) {
    const Made made = page_of_loop(blinker_loop, blinkers, "plc.st");
    const std::string figure = between(made.page, "<figure id=\"chart-0\">", "</figure>");
    const Data& drawn = made.data["charts"][0];
    ASSERT_EQ(drawn["steps"].size(), 4U);
    ASSERT_EQ(drawn["transitions"].size(), 4U);
    for (const char* const kind : {"steps", "transitions", "conditions", "continuous"})
        for (const Data& id : drawn["ids"][kind])
            EXPECT_EQ(count_of(figure, "id=\"" + id.get<std::string>() + "\""), 1U) << id;
    EXPECT_EQ(count_of(figure, ">N Light<"), 2U);
    EXPECT_NE(figure.find("Lit.T &gt;= T#30ms"), std::string::npos);
}

TEST(ProgramPage, TransitionsOfTheScansExplainTheSituations) {
    const Made made = page_of_loop(blinker_loop, blinkers, "plc.st");
    std::size_t cleared = 0;
    for (const char* const name : {"dark", "again"}) {
        const Data& run = run_of(made, name)["run"];
        const Data& drawn = made.data["charts"][0];
        ASSERT_EQ(run["transitions"].size(), 4U);
        std::set<std::size_t> active, before;
        for (const Data& moment : run["moments"]) {
            before = active;
            if (moment.contains("situation")) active = moment["situation"].get<std::set<std::size_t>>();
            std::set<std::size_t> expected = before;
            for (const Data& act : moment["acts"])
                for (const Data& id : act["fired"]) {
                    const Data& from = drawn["transitions"][id.get<std::size_t>()]["from"];
                    EXPECT_TRUE(before.contains(from[0])) << "a step that is active before";
                    EXPECT_FALSE(active.contains(from[0]));
                    expected.erase(from[0].get<std::size_t>());
                    ++cleared;
                }
            if (before == active) continue;
            EXPECT_TRUE(before.empty() || std::ranges::includes(active, expected));
            EXPECT_TRUE(before.empty() || expected != before) << "a change without a cleared transition";
        }
    }
    EXPECT_GT(cleared, 2U);
    EXPECT_NE(made.page.find("id=\"coverage\""), std::string::npos);
}

TEST(ProgramPage, ShowsTheScanWithARunTimeFault) {
    const std::string program = R"(PROGRAM Main
VAR_INPUT A : BOOL; END_VAR
VAR_OUTPUT L : BOOL; END_VAR
VAR N : INT := 1; END_VAR
IF A THEN N := N - 1; END_IF
L := 4 / N > 2;
L := NOT L;
END_PROGRAM
)";
    const Made made = page_of_loop(
        "    controller plc every 10ms;\n    environment A = free(OUT = A);\n"
        "    property lit: always L || !L;\n",
        program, "plc.st");
    ASSERT_FALSE(made.data["runs"].empty());
    const Data& run = run_of(made, "breakdown-1");
    const auto scans = scans_of(run);
    ASSERT_FALSE(scans.empty());
    const auto last = points_on(made, program, "L := 4 / N", "result");
    const auto read = points_on(made, program, "L := 4 / N", "read");
    ASSERT_EQ(read.size(), 1U);
    EXPECT_EQ(scans.back().second.at(read.front())[1], 0) << "the divisor";
    EXPECT_TRUE(last.empty() || !scans.back().second.contains(last.front())) << "the faulty statement has no value";
}

/// Generates the page of a program that is checked with a property file, as `report` does.
Made page_of_program(const std::string& program, const std::string& properties) {
    Made made;
    Sources& sources = made.reading.sources;
    Diagnostics& diagnostics = made.reading.diagnostics;
    const Id<Source> file = sources.add({"plc.st", program}), yaml = sources.add({"plc.yaml", properties});
    auto checked = check_program(file, yaml, sources, {.witnesses = true}, diagnostics);
    EXPECT_TRUE(checked) << made.reading.diagnostics_text();
    if (!checked) return made;
    EXPECT_EQ(checked->report.failures, std::vector<std::string>());
    made.reading.model = std::move(checked->model);
    auto content = page_content(*made.reading.model, sources, {}, {0}, {}, {}, diagnostics);
    EXPECT_TRUE(content);
    if (!content) return made;
    content->report = std::move(checked->report);
    made.page = page_of(*content);
    made.data = Data::parse(between(made.page, "id=\"data\">", "</script>"), nullptr, false);
    return made;
}

const std::string blinker_properties =
    "properties:\n  - id: dark\n    kind: invariant\n    expression: \"NOT L\"\n"
    "  - id: lit\n    kind: reachable\n    expression: \"Left.Lit.X AND Right.Dark.X AND Left.Lit.T >= T#20ms\"\n";

TEST(ProgramPage, ShowsTheScansOfAProgramWithoutAPlant) {
    for (const bool task : {true, false}) {
        const Made made = page_of_program(
            blinkers + (task ? "CONFIGURATION C RESOURCE R ON PLC TASK T(INTERVAL := T#10ms, PRIORITY := 0);\n"
                               "PROGRAM P WITH T : Main; END_RESOURCE END_CONFIGURATION\n"
                             : ""),
            blinker_properties);
        for (const char* const name : {"dark", "lit"}) {
            const Data& run = run_of(made, name);
            const auto scans = scans_of(run);
            ASSERT_EQ(scans.size() + 1, run["run"]["moments"].size()) << "each event after power-on is a scan";
            const auto lamp = points_on(made, blinkers, "L := Left", "result");
            ASSERT_EQ(lamp.size(), 1U);
            for (const auto& [event, values] : scans) {
                EXPECT_EQ(values.at(lamp.front())[1], signal_after(run, "L", event));
                const Data& act = run["run"]["moments"][event]["acts"][0];
                EXPECT_EQ(task ? Data(10) : act["elapsed"], act["elapsed"]);
            }
        }
        EXPECT_EQ(signal_after(run_of(made, "dark"), "L", run_of(made, "dark")["run"]["moments"].size() - 1), 1);
        EXPECT_NE(made.page.find("There is no plant"), std::string::npos);
    }
}

TEST(ProgramPage, TransitionsOfAProgramWithoutAPlantExplainTheSituations) {
    const Made made = page_of_program(blinkers, blinker_properties);
    const Data& run = run_of(made, "dark")["run"];
    EXPECT_EQ(run["moments"][0]["situation"].size(), 2U) << "the initial steps of both instances";
    std::set<std::size_t> active;
    std::size_t cleared = 0;
    for (const Data& moment : run["moments"]) {
        const std::set<std::size_t> before = active;
        if (moment.contains("situation")) active = moment["situation"].get<std::set<std::size_t>>();
        for (const Data& id : moment["acts"][0]["fired"]) {
            const Data& transition = made.data["charts"][0]["transitions"][id.get<std::size_t>()];
            EXPECT_TRUE(before.contains(transition["from"][0].get<std::size_t>()));
            EXPECT_FALSE(active.contains(transition["from"][0].get<std::size_t>()));
            ++cleared;
        }
    }
    EXPECT_GE(cleared, 2U);
}

TEST(ProgramPage, OmitsTheValuesBeyondTheLimitOfThePage) {
    const Made made = page_of_loop(counter_loop, counters, "plc.st");
    const Model& model = *made.reading.model;
    Diagnostics diagnostics;
    const Report report = *check(model, {0}, {}, {}, diagnostics);
    const ChartRun& run = *report.answers.front().trace;
    const ProgramListing listing = listing_of(*model.charts[{0}].program, made.reading.sources);
    std::size_t few = 5, many = 100'000;
    ProgramScans omitted(model.charts[{0}], listing);
    EXPECT_TRUE(omitted.scans(run, {0}, few).is_null());
    EXPECT_EQ(few, 5U);
    EXPECT_TRUE(omitted.json()["points"].empty()) << "the points of an omitted run are removed";
    EXPECT_FALSE(omitted.scans(run, {0}, many).is_null());
    ProgramScans complete(model.charts[{0}], listing);
    std::size_t enough = 100'000;
    complete.scans(run, {0}, enough);
    EXPECT_EQ(omitted.json(), complete.json());
    EXPECT_EQ(many, enough);
    many = 100'000;
    EXPECT_FALSE(ProgramScans(model.charts[{0}], listing).scans(run, {0}, many).empty());
    EXPECT_LT(many, 100'000U);
}

TEST(ProgramPage, DrawsTheInitialStepOfAChartOfCodesys) {
    const std::string data = "<addData><data name=\"http://www.3s-software.com/plcopenxml/";
    const std::string xml =
        "<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\"><types><dataTypes/><pous><pou name=\"p\" "
        "pouType=\"program\"><interface><inputVars><variable name=\"a\"><type><BOOL/></type></variable></inputVars>"
        "</interface><body><SFC>\n<step localId=\"1\" name=\"S0\" initialStep=\"true\"><connectionPointIn>"
        "<connection refLocalId=\"4\"/></connectionPointIn></step>\n<step localId=\"2\" name=\"S1\">"
        "<connectionPointIn><connection refLocalId=\"3\"/></connectionPointIn></step>\n"
        "<transition localId=\"3\"><connectionPointIn><connection refLocalId=\"1\"/></connectionPointIn>"
        "<condition><inline><ST><xhtml>a</xhtml></ST></inline></condition></transition>\n"
        "<transition localId=\"4\"><connectionPointIn><connection refLocalId=\"2\"/></connectionPointIn>"
        "<condition negated=\"true\"><inline><ST><xhtml>a</xhtml></ST></inline></condition></transition>\n"
        "</SFC></body>" +
        data +
        "sfcsettings\"><SFCSettings><UseDefaults>false</UseDefaults><Flags><Reset Use=\"false\"/><Tip Use=\"false\"/>"
        "</Flags></SFCSettings></data></addData></pou></pous></types></project>";
    ReadOptions options;
    options.load = [&](const std::string&, std::string&) { return std::optional(xml); };
    const ParseResult reading = read_string("program plc = \"p.xml\";\n", "l.grafcet", options);
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    const Chart& interface = reading.model->charts[{0}];
    ASSERT_EQ(interface.steps.size(), 2U);
    EXPECT_FALSE(interface.steps[{0}].initial) << "it becomes active in the first scan";
    EXPECT_TRUE(drawn_chart(interface).steps[{0}].initial);
    EXPECT_FALSE(drawn_chart(interface).steps[{1}].initial);
}

TEST(ProgramPage, PrintsTheStatementsOfPlcopenXml) {
    std::ifstream file(SAMPLE_FOLDER "/tank_program/filling.xml");
    std::ostringstream xml;
    xml << file.rdbuf();
    Diagnostics diagnostics;
    Sources sources;
    ReadOptions options;
    options.load = [&](const std::string&, std::string&) { return std::optional(xml.str()); };
    const ParseResult reading = read_string("program plc = \"filling.xml\";\n", "l.grafcet", options);
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    const Chart& program = reading.model->charts[{0}];
    const ProgramListing listing = listing_of(*program.program, reading.sources);
    EXPECT_TRUE(listing.begins.empty());
    std::string text;
    for (const std::string& line : listing.lines) text += line + "\n";
    EXPECT_NE(text.find("PROGRAM"), std::string::npos) << text;
    EXPECT_NE(text.find(" := "), std::string::npos) << text;
    for (const ProgramListing::Item& item : listing.items) ASSERT_LT(item.line, listing.lines.size());
}

}  // namespace
}  // namespace grafverif
