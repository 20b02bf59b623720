// SPDX-License-Identifier: MIT
// Tests properties that hold vacuously: every form of docs/reference/properties.md, in every engine and every output
// format.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run_program.hpp"

namespace grafverif::app {
namespace {

using VacuityJson = nlohmann::json;

/// Returns a loop of a chart in which step 2 is never active, and `X0` is true at power-on.
std::string never_two(const std::string& properties) {
    return "grafcet lamp { input A; output M; initial step 0; step 1 { M; } step 2;\n"
           "transition t0: 0 -> 1 when A; transition t1: 1 -> 0 when !A; transition t2: 2 -> 0 when A; }\n"
           "closed_loop room { controller lamp; environment a = push_button(OUT = A);\n" +
           properties + "}\n";
}

struct Form {
    std::string text = {};
    std::string note = {};  ///< the reason why the property is vacuous; empty if it is not vacuous
};

const std::string premise = "the premise is never true", response = "the response is never needed",
                  in_closed = " within a scope that closes", in_scope = " within the scope",
                  opens = "the scope never opens", closes = "the scope never closes";

const std::vector<Form>& forms() {
    static const std::vector<Form> all = [] {
        std::vector<Form> made{
            {"X2 leads to M", premise},
            {"X2 leads to M within 2s", premise},
            {"X2 leads to M within 2s at stable", premise},
            {"X2 holds for 3s", premise},
            {"X2 holds at most 3s", premise},
            {"X2 at most 1s since M", premise},
            {"!X2 at least every 1s", response},
            {"M precedes X2", response},
            {"X2 at most 1 time", premise},
            {"never X2 before X0", "the scope is always empty"},
            {"never X2 between X1 and X2", closes},
            {"X1 leads to X0 within 5s between X1 and X2", premise + in_closed},
            {"X1 leads to M", ""},
            {"X1 leads to M within 2s", ""},
            {"A holds for 0.1s", ""},
            {"X1 at most 1s since A", ""},
            {"A precedes X1", ""},
            {"always !X2", ""},
        };
        // The next properties have scopes that are never opened or never closed, or premises that are never true within
        // a scope.
        for (const std::string never : {"never M", "always !M", "inevitable M"}) {
            made.push_back({never + " before X2", closes});
            for (const char* scope : {" after X2", " between X2 and X0", " after X2 until X0"})
                made.push_back({never + scope, opens});
        }
        const std::vector<std::pair<std::string, std::string>> with_premise{
            {"X2 leads to M", premise},     {"X2 leads to M within 2s", premise}, {"M precedes X2", response},
            {"X2 at most 1 time", premise}, {"!X2 at least every 1s", response},  {"X2 holds at most 1s", premise}};
        for (const auto& [text, note] : with_premise) {
            made.push_back({text + " before X1", note + in_closed});
            made.push_back({text + " between X1 and X0", note + in_closed});
            made.push_back({text + " after X1", note + in_scope});
            made.push_back({text + " after X1 until X0", note + in_scope});
            made.push_back({text + " before X2", closes});
            made.push_back({text + " after X2", opens});
            made.push_back({text + " between X2 and X1", opens});
            made.push_back({text + " after X2 until X1", opens});
        }
        for (const char* text :
             {"never X2 before X1", "never X2 after X1", "never X2 between X1 and X0", "never X2 after X1 until X0",
              "inevitable A before X1", "inevitable M after X1", "inevitable M between X1 and X0",
              "X1 leads to M between X1 and X0", "X1 leads to M within 1s after X1", "A precedes X1 before X1 && M",
              "M at most 1 time between X1 and X0", "X1 || !X1 at least every 9s between X0 and X1"})
            made.push_back({text, std::string(text).starts_with("X1 ||") ? response + in_closed : ""});
        return made;
    }();
    return all;
}

/// Checks the verdict on the property, which must hold.
void expect_verdict(const VacuityJson& property, const Form& form, const std::string& how) {
    SCOPED_TRACE(form.text + ", " + how);
    ASSERT_EQ(property["verdict"], "holds") << property["reason"];
    EXPECT_EQ(property["vacuous"], !form.note.empty()) << property["notes"];
    const auto& notes = property["notes"];
    const bool noted = std::find(notes.begin(), notes.end(), form.note) != notes.end();
    EXPECT_EQ(noted, !form.note.empty()) << notes;
}

TEST(Vacuity, EveryFormIsMarkedByTheTimedEngine) {
    const Folder folder;
    std::string properties;
    for (std::size_t k = 0; k < forms().size(); ++k)
        properties += fmt::format("property p{}: {};\n", k, forms()[k].text);
    const Result result = grafverif({"check", folder.write("lamp.grafcet", never_two(properties)), "--format", "json"});
    ASSERT_EQ(result.code, ExitCode::Done) << result.err;
    const VacuityJson all = VacuityJson::parse(result.out)["properties"];
    ASSERT_EQ(all.size(), forms().size() + 1);  // one additional verdict for `no_timelock`
    for (std::size_t k = 0; k < forms().size(); ++k) expect_verdict(all[k], forms()[k], "timed");
}

TEST(Vacuity, EveryFormIsMarkedInDiscreteTime) {
    const Folder folder;
    for (std::size_t k = 0; k < forms().size(); ++k) {
        const Form& form = forms()[k];
        const std::string file = folder.write("lamp.grafcet", never_two("property p: " + form.text + ";\n"));
        std::vector<std::string> command{"check",    file,       "--untimed", "--plant",    "automata", "--time",
                                         "discrete", "--format", "json",      "--property", "p",        "--engine"};
        for (const std::string engine : {"symbolic", "auto", "pdr"}) {
            if (engine != "symbolic" && k % 5 != 0) continue;
            auto one = command;
            one.push_back(engine);
            const Result result = grafverif(one);
            const VacuityJson all = VacuityJson::parse(result.out)["properties"];
            ASSERT_EQ(all.size(), 1U) << "probes are not properties";
            if (engine == "pdr" && all[0]["verdict"] == "unknown") continue;  // PDR decides only state properties
            expect_verdict(all[0], form, engine);
        }
    }
}

TEST(Vacuity, ModelsThatAreWrittenHaveNoProbes) {
    const Folder folder;
    const std::string file = folder.write("lamp.grafcet", never_two("property p: never M between X2 and X0;\n"));
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"uppaal", file, "-o", "-"}, std::vector<std::string>{"pins", file, "-o", "-"},
          std::vector<std::string>{"nusmv", file, "--plant", "automata", "-o", "-"}}) {
        const Result result = grafverif(command);
        ASSERT_EQ(result.code, ExitCode::Done) << result.err;
        EXPECT_EQ(result.out.find("p_scope"), std::string::npos) << command.front();
        EXPECT_EQ(result.out.find("(scope)"), std::string::npos) << command.front();
    }
    const Result unknown = grafverif({"check", file, "--property", "p.(scope)"});
    EXPECT_EQ(unknown.code, ExitCode::Input) << unknown.out;
}

TEST(Vacuity, IsInEveryOutput) {
    const Folder folder;
    const std::string file = folder.write(
        "lamp.grafcet",
        never_two("property late \"M follows\": X2 leads to M within 2s; property lit: X1 leads to M within 2s;"));
    const std::string junit = folder.file("junit.xml"), sarif = folder.file("log.sarif");
    const Result result = grafverif({"check", file, "--junit", junit, "--sarif", sarif});
    EXPECT_EQ(result.code, ExitCode::Done) << result.err;
    EXPECT_NE(result.out.find("note (late): the premise is never true"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("holds, vacuously"), std::string::npos) << result.out;
    EXPECT_NE(folder.read("junit.xml")
                  .find("<system-out>M follows\n"
                        "holds, vacuously: the premise is never true"),
              std::string::npos)
        << folder.read("junit.xml");
    const VacuityJson log = VacuityJson::parse(folder.read("log.sarif"))["runs"][0];
    // The log contains these results in addition to the warning about step 2.
    VacuityJson vacuous = VacuityJson::array();
    for (const VacuityJson& each : log["results"])
        if (each["ruleId"] == "property-vacuous") vacuous.push_back(each);
    ASSERT_EQ(vacuous.size(), 1U);
    EXPECT_EQ(vacuous[0]["kind"], "review");
    EXPECT_EQ(vacuous[0]["level"], "none");
    EXPECT_EQ(vacuous[0]["message"]["text"], "room: late \"M follows\": holds, vacuously; the premise is never true");

    const Result lines = grafverif({"check", file, "--json-lines"});
    EXPECT_NE(lines.out.find("\"vacuous\":true"), std::string::npos) << lines.out;
    ASSERT_EQ(grafverif({"report", file, "-o", folder.file("page.html")}).code, ExitCode::Done);
    EXPECT_NE(folder.read("page.html").find("holds, vacuously"), std::string::npos);
}

TEST(Vacuity, MutateReportsVacuousProperties) {
    const Folder folder;
    const std::string file = folder.write(
        "lamp.grafcet", never_two("property late: X2 leads to M within 2s; property lit: X1 holds for 0.1s;"));
    const Result text = grafverif({"mutate", file, "--jobs", "1"});
    EXPECT_NE(text.out.find("late detects 0; holds vacuously"), std::string::npos) << text.out << text.err;
    EXPECT_EQ(text.out.find("lit notices 0; holds vacuously"), std::string::npos) << text.out;
    const VacuityJson json = VacuityJson::parse(grafverif({"mutate", file, "--jobs", "1", "--format", "json"}).out);
    EXPECT_EQ(json["properties"][0]["vacuous"], true);
    EXPECT_EQ(json["properties"][1]["vacuous"], false);
    bool becomes = false;  // true for a mutant that never leaves step 0
    for (const VacuityJson& mutant : json["mutants"]) becomes = becomes || mutant["vacuous"] == VacuityJson({"lit"});
    EXPECT_TRUE(becomes) << json["mutants"].dump(1);
}

/// This stand-in for verifyta finds the premise unreachable: its `E<>` is not satisfied.
TEST(Vacuity, ExternalProgramsCheckIt) {
    const Folder folder;
    fs::permissions(folder.write("verifyta",
                                 "#!/bin/sh\n"
                                 "case \"$(cat \"$2\")\" in 'E<>'*) echo ' -- Formula is NOT satisfied.';;\n"
                                 "*) echo ' -- Formula is satisfied.';; esac\n"),
                    fs::perms::owner_all);
    const Variable path("PATH", fs::path(folder.file("")).string() + ":/usr/bin:/bin");
    const std::string file =
        folder.write("lamp.grafcet", never_two("property now: X2 leads to M; property late: X2 leads to M within 2s;"));
    const Result result = grafverif({"check", file, "--engine", "verifyta", "--format", "json"});
    const VacuityJson all = VacuityJson::parse(result.out)["properties"];
    ASSERT_EQ(all.size(), 3U);  // the third property is `no_timelock`, which is unknown
    for (const std::size_t k : {0U, 1U}) expect_verdict(all[k], {all[k]["name"], premise}, "verifyta");
}

}  // namespace
}  // namespace grafverif::app
