// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <thread>

#include "app/serve/file_checker.hpp"
#include "app/serve/play.hpp"
#include "pipeline/file_watcher.hpp"
#include "run_program.hpp"

namespace grafverif::app {
namespace {

using Json = nlohmann::json;
using namespace std::chrono_literals;

const std::string lamp_text =
    "grafcet lamp { input ON, OFF; output LAMP; constraint !(ON && OFF); initial step 0; step 1 { LAMP; }\n"
    "transition on: 0 -> 1 when ON; transition off: 1 -> 0 when OFF && !ON || 3s/X1; }\n";
const std::string lamp_in_a_loop =
    lamp_text +
    "closed_loop house { controller lamp with stability_search; environment On = push_button(OUT = ON);\n"
    "environment Off = free(OUT = OFF); property LIT \"it can be lit\": reachable LAMP; property NEVER: never LAMP; "
    "}\n";

TEST(FileWatcher, DetectsChangesByAnEditor) {
    const Folder folder;
    const std::string file = folder.write("a.grafcet", "one"), other = folder.file("b.grafcet");
    FileWatcher watch;
    const auto look_again = [&] {
        watch.clear();
        watch.note(file);
        watch.note(other);
        EXPECT_FALSE(watch.changed());
    };
    look_again();
    folder.write("a.grafcet", "two");  // this overwrites the file in place, with the same length
    EXPECT_TRUE(watch.changed());
    look_again();
    folder.write("a.new", "two");
    fs::rename(folder.file("a.new"), file);  // this replaces the file by another file of the same name
    EXPECT_TRUE(watch.changed());
    look_again();
    fs::remove(file);
    EXPECT_TRUE(watch.changed());
    look_again();
    folder.write("a.grafcet", "two");
    EXPECT_TRUE(watch.changed());
    look_again();
    folder.write("b.grafcet", "it was not there before");
    EXPECT_TRUE(watch.changed());
}

TEST(FileWatcher, DetectsATextOfTheSameLengthWithATimeSetBack) {
    const Folder folder;
    const std::string file = folder.write("a.grafcet", "one");
    FileWatcher watch;
    watch.note(file);
    const fs::file_time_type written = fs::last_write_time(file);
    folder.write("a.grafcet", "two");
    fs::last_write_time(file, written);
    EXPECT_TRUE(watch.changed());
}

TEST(FileWatcher, NoticesAChangeBetweenTwoReadings) {
    const Folder folder;
    const std::string file = folder.write("a.grafcet", "one");
    FileWatcher watch;
    watch.note(file);
    folder.write("a.grafcet", "longer");
    watch.note(file);
    EXPECT_TRUE(watch.changed());
}

/// Runs the file checker of `serve` on `file`. The object stores its states in the order of arrival.
class Bystander {
public:
    explicit Bystander(const std::string& file, std::optional<std::uint64_t> response_timeout_ms = {},
                       std::optional<std::string> properties = {}) {
        options_.operands = {file};
        options_.property_file = std::move(properties);
        options_.response_timeout_ms = response_timeout_ms;
        bench_.emplace(options_, [] {});
    }

    /// Returns the first state from now on that satisfies the condition.
    Json wait_for(const std::function<bool(const Json&)>& wanted) {
        for (int tries = 0; tries < 2000; ++tries) {
            if (const auto newer = bench_->newer(known_)) {
                state_ = Json::parse(*newer);
                known_ = state_["version"].get<std::uint64_t>();
            }
            if (!state_.is_null() && wanted(state_)) return state_;
            std::this_thread::sleep_for(10ms);
        }
        ADD_FAILURE() << "the expected state was not published; last state: " << state_.dump(1);
        return state_;
    }
    Json wait_for_verdicts() {
        return wait_for(
            [](const Json& state) { return !state["models"].empty() && state["models"].back()["state"] == "done"; });
    }
    Json drawings() const { return Json::parse(app::drawings(*bench_->checked_file())); }
    Json play(const Json& request) const {
        return Json::parse(app::play(*bench_->checked_file(), options_, request.dump()));
    }

private:
    Options options_ = {};
    std::optional<FileChecker> bench_ = {};
    Json state_ = {};
    std::uint64_t known_ = 0;
};

const std::string spindle_program =
    "PROGRAM spindle VAR_INPUT Go : BOOL; END_VAR VAR_OUTPUT Run : BOOL; END_VAR\n"
    "INITIAL_STEP Idle: END_STEP\nSTEP Turning: Run(N); END_STEP\n"
    "TRANSITION FROM Idle TO Turning := Go; END_TRANSITION\n"
    "TRANSITION FROM Turning TO Idle := NOT Go; END_TRANSITION\nEND_PROGRAM\n";

TEST(ServeFileChecker, ProgramWithPropertiesIsCheckedAfterAChangeOfEitherFile) {
    const Folder folder;
    const std::string file = folder.write("p.st", spindle_program);
    const std::string still = "properties:\n  - {id: P1, kind: invariant, expression: \"NOT Run\"}\n";
    const std::string yaml = folder.write("p.yaml", still);
    Bystander watcher(file, {}, yaml);
    Json state = watcher.wait_for_verdicts();
    EXPECT_EQ(state["charts"][0], (Json{{"name", "spindle"}, {"runs", false}, {"steps", 2}}));
    EXPECT_EQ(state["models"][0]["kind"], "program");
    EXPECT_EQ(state["models"][0]["properties"][0]["verdict"], "violated");
    EXPECT_EQ(state["models"][0]["properties"][0]["has_trace"], true);
    EXPECT_NE(watcher.drawings()["drawings"][0].get<std::string>().find("Turning"), std::string::npos);
    folder.write("p.yaml", "properties:\n  - {id: P2, kind: reachable, expression: \"Run\"}\n");
    state = watcher.wait_for([](const Json& now) {
        return !now["models"].empty() && !now["models"][0]["properties"].empty() &&
               now["models"][0]["properties"][0]["name"] == "P2";
    });
    EXPECT_EQ(state["models"][0]["properties"][0]["verdict"], "holds");
    folder.write("p.yaml", "properties:\n  - {id: P2, kind: reachable, expression: \"Runs\"}\n");
    state = watcher.wait_for([](const Json& now) { return now["errors"] == 1; });
    EXPECT_NE(state["diagnostics"].get<std::string>().find("p.yaml:2"), std::string::npos) << state["diagnostics"];
    fs::remove(yaml);
    state = watcher.wait_for(
        [](const Json& now) { return now["diagnostics"].get<std::string>().find("cannot-read") != std::string::npos; });
    EXPECT_EQ(state["readable"], false);
}

TEST(ServeFileChecker, ProgramOfALoopIsDrawnAndSimulated) {
    const Folder folder;
    folder.write("p.st", spindle_program);
    Bystander watcher(folder.write("l.grafcet",
                                   "program spindle = \"p.st\";\nclosed_loop machine {\n"
                                   "controller spindle every 100ms;\nenvironment G = free(OUT = Go);\n"
                                   "property runs: reachable Run;\n}\n"));
    watcher.wait_for_verdicts();
    const Json drawn = watcher.drawings();
    EXPECT_NE(drawn["drawings"][0].get<std::string>().find("Turning"), std::string::npos);
    EXPECT_EQ(drawn["marks"][0]["transitions"].size(), 2U);
    const Json played = watcher.play({{"loop", "machine"}, {"moves", {"Go = true", "wait 200ms"}}});
    ASSERT_FALSE(played.contains("error")) << played;
    EXPECT_EQ(played["problem"], "") << played["problem"];
    const std::string lit = played["rows"].back()["lit"][0];
    EXPECT_NE(drawn["drawings"][0].get<std::string>().find("id=\"" + lit + "\""), std::string::npos) << lit;
    EXPECT_NE(lit.find("Turning"), std::string::npos);
}

TEST(ServeFileChecker, TimeoutEndsTheCheckAndNotTheFileChecker) {
    const Folder folder;
    const std::string file = folder.write("lamp.grafcet", lamp_in_a_loop);
    Bystander bystander(file, 0);
    const auto undecided = [](const Json& state) {
        for (const Json& property : state["models"][0]["properties"]) {
            EXPECT_EQ(property["verdict"], "unknown") << property;
            EXPECT_NE(property["reason"].get<std::string>().find("stopped at the time limit of 0 s"), std::string::npos)
                << property;
        }
        return state["models"][0]["properties"].size();
    };
    const Json first = bystander.wait_for_verdicts();
    EXPECT_GE(undecided(first), 2U);
    folder.write("lamp.grafcet", lamp_in_a_loop + "// again\n");
    bystander.wait_for([&](const Json& state) { return state["reading"] != first["reading"]; });
    EXPECT_GE(undecided(bystander.wait_for_verdicts()), 2U);
}

TEST(ServeFileChecker, ReportsVerdictsAndErrorsAndFollowsTheFile) {
    const Folder folder;
    const std::string file = folder.write("lamp.grafcet", lamp_in_a_loop);
    Bystander bystander(file);
    const Json first = bystander.wait_for_verdicts();
    EXPECT_EQ(first["diagnostics"], "");
    const Json& properties = first["models"][0]["properties"];
    ASSERT_GE(properties.size(), 2U);
    EXPECT_EQ(properties[0]["name"], "LIT");
    EXPECT_EQ(properties[0]["text"], "it can be lit");
    EXPECT_EQ(properties[0]["claim"], "reachable LAMP");
    EXPECT_EQ(properties[0]["as_expected"], true);
    EXPECT_EQ(properties[1]["verdict"], "violated");
    EXPECT_EQ(properties[1]["as_expected"], false);

    folder.write("lamp.grafcet", lamp_text + "nonsense");
    const Json broken = bystander.wait_for([](const Json& state) { return state["readable"] == false; });
    EXPECT_NE(broken["diagnostics"].get<std::string>().find("^"), std::string::npos) << "a caret";
    EXPECT_EQ(bystander.play({{"chart", "lamp"}})["error"],
              "the file has errors and cannot be simulated; correct them");

    fs::remove(file);
    bystander.wait_for([](const Json& state) {
        return state["diagnostics"].get<std::string>().find("cannot-read") != std::string::npos;
    });
    folder.write("lamp.grafcet", lamp_text);
    const Json back = bystander.wait_for_verdicts();
    EXPECT_EQ(back["models"][0]["kind"], "chart");
    EXPECT_EQ(back["diagnostics"], "");
}

TEST(ServeFileChecker, ReportsRejectedModelsAndUndecidedProperties) {
    const Folder folder;
    const std::string refused =
        "grafcet bad { input A, B; output L; initial step 0; step 1 { L; } transition on: 0 -> 1 when rise(rise(A) && "
        "B); transition off: 1 -> 0 when !A; }\n"
        "closed_loop yard { controller bad with stability_search; environment A1 = free(OUT = A);\n"
        "environment B1 = free(OUT = B); property NONE: never L; }\n";
    const std::string watched =
        lamp_text +
        "closed_loop house { controller lamp with stability_search; environment On = push_button(OUT = ON);\n"
        "environment Off = free(OUT = OFF); observer Eye { initial location 100; location 101; 100 -> 101 when LAMP; "
        "}\n"
        "property SEEN \"it is seen\": never Eye.101; property DARK: X0 && !X0 leads to LAMP; }\n";
    Bystander bystander(folder.write("lamp.grafcet", refused + watched));
    const Json state = bystander.wait_for_verdicts();
    EXPECT_GT(state["errors"], 0);
    ASSERT_EQ(state["models"].size(), 2U);
    EXPECT_EQ(state["models"][0]["name"], "yard");
    EXPECT_EQ(state["models"][0]["state"], "refused");
    const auto property = [&](const std::string& name) {
        for (const Json& each : state["models"][1]["properties"])
            if (each["name"] == name) return each;
        ADD_FAILURE() << name << " is not published";
        return Json();
    };
    EXPECT_EQ(property("SEEN")["verdict"], "unknown");
    EXPECT_EQ(property("SEEN")["text"], "it is seen");
    EXPECT_EQ(property("SEEN")["as_expected"], false);
    EXPECT_EQ(property("SEEN")["vacuous"], false);
    EXPECT_EQ(property("DARK")["verdict"], "holds");
    EXPECT_EQ(property("DARK")["vacuous"], true);
}

TEST(ServeFileChecker, RemovesTextDirectionControls) {
    const Folder folder;
    std::string text = lamp_in_a_loop;
    text.insert(text.find("it can be lit"), "\u202Edlo");
    Bystander bystander(folder.write("lamp.grafcet", text));
    EXPECT_EQ(bystander.wait_for_verdicts()["models"][0]["properties"][0]["text"], "?dloit can be lit");
}

TEST(ServeFileChecker, FollowsIncludedFilesEvenBeforeTheyExist) {
    const Folder folder;
    Bystander bystander(folder.write("main.grafcet", "include \"parts/lamp.grafcet\";\n"));
    bystander.wait_for([](const Json& state) { return state["readable"] == false; });
    fs::create_directory(folder.file("parts"));
    folder.write("parts/lamp.grafcet", lamp_text);
    EXPECT_EQ(bystander.wait_for_verdicts()["charts"][0]["name"], "lamp");
    folder.write("parts/lamp.grafcet", lamp_text + "grafcet");
    bystander.wait_for([](const Json& state) { return state["readable"] == false; });
}

TEST(ServeFileChecker, CancelsTheChecksOfAnEarlierSave) {
    const Folder folder;
    // A chart with six buttons, whose clocks have incommensurable times: the chart has too many
    // states for a search that the test could wait for.
    std::string hard =
        "grafcet panel { input A, B, C, D, E, F; output O; initial step 0; step 1 { O; }\n"
        "transition t: 0 -> 1 when A && B && C && D && E && F; transition u: 1 -> 0 when !A; }\n"
        "closed_loop room { controller panel with stability_search;\n";
    int gap = 900;
    for (const char button : {'A', 'B', 'C', 'D', 'E', 'F'})
        hard += fmt::format("environment E{0} = push_button(OUT = {0}, GAP = {1}ms);\n", button, gap += 7);
    const std::string file = folder.write("room.grafcet", hard + "}\n");
    Bystander bystander(file);
    bystander.wait_for(
        [](const Json& state) { return !state["models"].empty() && state["models"][0]["state"] == "running"; });
    folder.write("room.grafcet", lamp_text);
    EXPECT_EQ(bystander.wait_for_verdicts()["charts"][0]["name"], "lamp");
}

TEST(Play, MakesTheMovesFromThePowerOnEachTime) {
    const Folder folder;
    Bystander bystander(folder.write("lamp.grafcet", lamp_in_a_loop));
    bystander.wait_for([](const Json& state) { return state["readable"] == true; });
    const Json begun = bystander.play({{"chart", "lamp"}});
    EXPECT_EQ(begun["moves"].size(), 0U);
    EXPECT_EQ(begun["rows"].back()["lit"], Json({"c0-step-0"}));
    EXPECT_EQ(begun["choices"][0]["command"], "ON = true");
    const Json lit = bystander.play({{"chart", "lamp"}, {"moves", {"ON = true", "wait 1s"}}});
    EXPECT_EQ(lit["time"], 1000);
    EXPECT_EQ(lit["problem"], "");
    EXPECT_EQ(lit["rows"].back()["lit"], Json({"c0-step-1"}));
    EXPECT_EQ(lit["wait"]["change"], 3000) << "a multiple of the unit of 3 s, at least one unit";
    EXPECT_EQ(bystander.play({{"chart", "lamp"}}), begun);
    const Json both = bystander.play({{"chart", "lamp"}, {"moves", {"ON = true", "OFF = true"}}});
    EXPECT_EQ(both["broken_constraints"], Json({"!(ON && OFF)"}));

    const Json loop = bystander.play({{"loop", "house"}, {"moves", {"wait 1s", "ON = true"}}});
    EXPECT_EQ(loop["problem"], "");
    EXPECT_EQ(loop["rows"].back()["lit"], Json({"c0-step-1"}));
    for (const Json& choice : loop["choices"]) {
        const std::string command = choice["command"];
        const Json next = bystander.play({{"loop", "house"}, {"moves", {"wait 1s", "ON = true", command}}});
        EXPECT_EQ(next["problem"], "") << command;
    }
}

TEST(Play, DrawsMovesThatAScriptAccepts) {
    const Folder folder;
    const std::string file = folder.write("lamp.grafcet", lamp_in_a_loop);
    Bystander bystander(file);
    bystander.wait_for([](const Json& state) { return state["readable"] == true; });
    for (const char* of : {"loop", "chart"}) {
        const Json drawn =
            bystander.play({{of, std::string(of) == "loop" ? "house" : "lamp"}, {"random", 40}, {"seed", 7}});
        ASSERT_EQ(drawn["moves"].size(), 40U) << drawn["problem"];
        std::string script;
        for (const std::string move : drawn["moves"]) script += move + "\n";
        const Result result =
            grafverif({"simulate", file, std::string("--") + of, of == std::string("loop") ? "house" : "lamp",
                       "--script", folder.write("script.txt", script)});
        EXPECT_EQ(result.code, ExitCode::Done) << result.err;
        EXPECT_EQ(
            bystander.play({{of, std::string(of) == "loop" ? "house" : "lamp"}, {"moves", drawn["moves"]}})["rows"],
            drawn["rows"]);
    }
}

/// Returns the active steps in the last row of a response.
std::string situation(const Json& answer) { return answer["rows"].back()["situation"].get<std::string>(); }

TEST(Trial, AStepIsForcedByHandAndAllThatFollowsIsCalledATrial) {
    const Folder folder;
    Bystander bystander(folder.write("lamp.grafcet", lamp_in_a_loop));
    bystander.wait_for([](const Json& state) { return state["readable"] == true; });
    for (const auto& [of, name] : {std::pair("loop", "house"), std::pair("chart", "lamp")}) {
        SCOPED_TRACE(of);
        const auto moves = [&, of = of, name = name](std::vector<std::string> list) {
            return bystander.play({{of, name}, {"moves", std::move(list)}});
        };
        const Json begun = moves({});
        EXPECT_EQ(begun["trial"], false);
        EXPECT_EQ(begun["steps"], Json({{{"name", "0"}, {"active", true}}, {{"name", "1"}, {"active", false}}}));
        const Json forced = moves({"force 1 on"});
        EXPECT_EQ(forced["problem"], "");
        EXPECT_EQ(forced["trial"], true);
        EXPECT_EQ(situation(forced), "0, 1");
        EXPECT_EQ(forced["rows"].back()["outputs"], "LAMP");
        EXPECT_EQ(forced["rows"][0]["trial"], false);
        EXPECT_EQ(forced["rows"][1]["trial"], true);
        EXPECT_EQ(forced["rows"][1]["what"],
                  "WHAT-IF: step 1 was forced active; the trace is no longer a run of the model");
        EXPECT_EQ(situation(moves({"force 1 on", "force 0 off", "wait 2s"})), "1");
        EXPECT_EQ(situation(moves({"force 1 on", "force 0 off", "wait 3s"})), "0")
            << "the time starts when the step is forced";
        EXPECT_EQ(moves({"force 1 on", "force 1 on"})["problem"], "step `1` is already active");
        EXPECT_EQ(moves({"force 1 off"})["problem"], "step `1` is not active");
        EXPECT_EQ(moves({"force 7 on"})["problem"], "unknown step `7`");
    }
}

TEST(Trial, RulesOfHierarchyTakePrecedence) {
    struct Case {
        const char* element;
        std::vector<std::string> moves;
        const char* situation;
        const char* problem;
    };
    for (const Case& c : std::vector<Case>{
             {"macro_steps", {"force M1 on"}, "0, M1, E1.E", ""},
             {"macro_steps", {"force E3.E on"}, "0, M1, M3, E3.E", ""},
             {"macro_steps", {"force M1 on", "force M1 off"}, "0", ""},
             {"enclosing_steps", {"force 1 on"}, "0, 1, 11", ""},
             {"enclosing_steps", {"force 20 on"}, "", "step `G2.20` is enclosed by step `G1.12`, which is not active"},
             {"forcing_orders", {"force 11 on"}, "0, 10, 11, 21", ""},
             {"forcing_orders",
              {"force 11 on", "force 20 on"},
              "0, 10, 11, 21",
              "step `production.20` is held by the forcing order of step `control.11`; deactivate that step first"},
             {"forcing_orders", {"force 12 on"}, "0, 10, 12", ""},
         }) {
        SCOPED_TRACE(std::string(c.element) + " " + c.moves.back());
        const fs::path file = root / "tests/unit/app/elements" / (std::string(c.element) + ".grafcet");
        Bystander bystander(file.string());
        bystander.wait_for([](const Json& state) { return state["readable"] == true; });
        const Json answer = bystander.play({{"chart", c.element}, {"moves", c.moves}});
        std::string forced;  // situation in the last row that begins with WHAT-IF; empty if there is none
        for (const Json& row : answer["rows"])
            if (row["what"].get<std::string>().starts_with("WHAT-IF")) forced = row["situation"];
        EXPECT_EQ(forced, c.situation);
        EXPECT_EQ(answer["problem"], c.problem);
    }
}

/// The interpreter runs a chart without its loop; the network runs the chart in its loop.
TEST(Trial, ChartAloneAndItsLoopContinueEqually) {
    std::mt19937_64 random(12);
    std::size_t made = 0, refused = 0;
    for (const auto& entry : fs::directory_iterator(root / "tests/unit/app/elements")) {
        const std::string name = entry.path().stem().string();
        Bystander bystander(entry.path().string());
        const Json state = bystander.wait_for([](const Json& each) { return each["readable"] == true; });
        if (state["models"].empty() || state["models"][0]["state"] == "refused") continue;
        const std::string loop = state["models"][0]["name"], chart = state["charts"][0]["name"];
        if (state["charts"].size() > 1) continue;
        const Json begun = bystander.play({{"chart", chart}});
        const Json& steps = begun["steps"];
        for (int script = 0; script < 12; ++script) {
            std::vector<std::string> moves;
            for (int k = 0; k < 4; ++k) {
                const Json& step = steps[random() % steps.size()];
                moves.push_back("force " + step["name"].get<std::string>() + (random() % 2 == 0 ? " on" : " off"));
                const Json alone = bystander.play({{"chart", chart}, {"moves", moves}});
                const Json plant = bystander.play({{"loop", loop}, {"moves", moves}});
                ASSERT_EQ(alone["problem"].get<std::string>().empty(), plant["problem"].get<std::string>().empty())
                    << name << alone["moves"] << alone["problem"] << plant["problem"];
                if (alone["problem"] != "") {
                    EXPECT_EQ(alone["problem"], plant["problem"]) << name << moves.back();
                    moves.pop_back();
                    ++refused;
                    continue;
                }
                ++made;
                if (random() % 3 == 0) moves.push_back("wait 1s");
                const Json one = bystander.play({{"chart", chart}, {"moves", moves}});
                const Json other = bystander.play({{"loop", loop}, {"moves", moves}});
                EXPECT_EQ(one["problem"], "");
                EXPECT_EQ(other["problem"], "");
                EXPECT_EQ(situation(one), situation(other)) << name << one["moves"];
                EXPECT_EQ(one["rows"].back()["outputs"], other["rows"].back()["outputs"]) << name << one["moves"];
            }
        }
    }
    EXPECT_GT(made, 200U);
    EXPECT_GT(refused, 50U);
}

TEST(Play, AnswersAnyRequest) {
    const Folder folder;
    Bystander bystander(folder.write("lamp.grafcet", lamp_in_a_loop));
    bystander.wait_for([](const Json& state) { return state["readable"] == true; });
    const auto error_text = [&](const Json& request) { return bystander.play(request).value("error", ""); };
    for (const Json& request : std::vector<Json>{Json(), Json(3), Json::array(), {{"moves", 3}}, {{"moves", {1, 2}}}})
        EXPECT_NE(error_text(request), "") << request;
    EXPECT_EQ(error_text({{"chart", "nobody"}}), "there is no chart `nobody` that can be simulated");
    EXPECT_EQ(error_text({{"loop", "lamp"}}), "there is no closed loop `lamp` that can be simulated");
    EXPECT_NE(error_text({{"chart", "lamp"}, {"moves", std::vector<std::string>(most_moves + 1, "wait 1s")}}), "");
    EXPECT_NE(error_text({{"chart", "lamp"}, {"random", most_random_moves + 1}}), "");
    const Json stopped = bystander.play({{"chart", "lamp"}, {"moves", {"ON = true", "ON = 7", "OFF = true"}}});
    EXPECT_EQ(stopped["moves"], Json({"ON = true", "ON = 7"}));
    EXPECT_EQ(stopped["problem"], "`ON` is Boolean and cannot be 7; use true or false");
    EXPECT_EQ(bystander.play({{"chart", "lamp"}, {"moves", {"back"}}})["problem"], "`back` is not a valid move");
    EXPECT_NE(Json::parse(play(CheckedFile(), Options(), std::string(100'000, '['))).value("error", ""), "");
}

}  // namespace
}  // namespace grafverif::app
