// SPDX-License-Identifier: MIT
// Tests task cycles on the command line: assumptions that are printed with the verdicts, `--cycle`, untimed models.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "unit/app/run_program.hpp"

namespace grafverif::app {
namespace {

/// Returns a loop with a light barrier whose pulses last 8 ms. `cycle` is inserted after `controller diverter`.
std::string sorter(const std::string& cycle) {
    return "grafcet diverter { input SEEN; output PUSH; initial step 0; step 1 { PUSH; }\n"
           "    transition t0: 0 -> 1 when SEEN; transition t1: 1 -> 0 when 50ms/X1 && !SEEN; }\n"
           "component light_barrier(output SEEN) { clock t; initial location free;\n"
           "    location covered invariant t <= 8ms;\n"
           "    timed free -> covered when t >= 100ms do SEEN := true, t := 0;\n"
           "    timed covered -> free when t == 8ms do SEEN := false, t := 0; }\n"
           "closed_loop sorter { controller diverter" +
           cycle +
           "; environment Barrier = light_barrier(SEEN = SEEN);\n"
           "    property rejected: SEEN leads to PUSH within 20ms;\n"
           "    property alive: no timelock;\n"
           "    property seen: reachable X1; }\n";
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string verdict(const Result& result, const std::string& property) {
    const nlohmann::json report = nlohmann::json::parse(result.out);
    for (const nlohmann::json& found : report["properties"])
        if (found["name"] == property) return found["verdict"];
    return {};
}

// A pulse as long as the task cycle can begin immediately after a scan and end immediately before the next one.
TEST(TaskCycle, DecidesWhetherThePlcSeesAPulse) {
    const Folder folder;
    struct Case {
        std::string cycle = {}, expected = {};
    };
    for (const Case& one : std::vector<Case>{{"", "holds"},
                                             {" every 10ms", "violated"},
                                             {" every 6ms..10ms", "violated"},
                                             {" every 8ms", "violated"},
                                             {" every 2ms..6ms", "holds"},
                                             {" every 10ms with every_cycle", "violated"},
                                             {" every 4ms with every_cycle", "holds"}}) {
        SCOPED_TRACE(one.cycle);
        const std::string file = folder.write("sorter.grafcet", sorter(one.cycle));
        for (const std::string grain : {"phased", "atomic"}) {
            const Result result = grafverif({"check", file, "--grain", grain, "--format", "json"});
            EXPECT_EQ(verdict(result, "rejected"), one.expected) << result.out << result.err;
            EXPECT_EQ(verdict(result, "alive"), "holds");
        }
    }
}

TEST(TaskCycle, IsPrintedWithTheVerdicts) {
    const Folder folder;
    const std::string file = folder.write("sorter.grafcet", sorter(" every 6ms..10ms"));
    EXPECT_TRUE(has(grafverif({"check", file}).out, "time unit 0.002 s, task cycle 6ms..10ms"));
    EXPECT_TRUE(has(grafverif({"check", file, "--cycle", "zero"}).out, "time unit 0.002 s, cycle time taken as zero"));
    const Result json = grafverif({"check", file, "--format", "json"});
    EXPECT_EQ(nlohmann::json::parse(json.out)["properties"][0]["cycle"], "task cycle 6ms..10ms");
    EXPECT_TRUE(has(grafverif({"check", file, "--untimed"}).out,
                    "task cycle 6ms..10ms not modelled: a scan may begin at any time"));
    EXPECT_TRUE(has(grafverif({"check", file, "--untimed", "--time", "discrete"}).out, "task cycle 6ms..10ms"));
}

TEST(TaskCycle, BothCycleTimesAreComparedOnRequest) {
    const Folder folder;
    const std::string file = folder.write("sorter.grafcet", sorter(" every 10ms"));
    const Result both = grafverif({"check", file, "--cycle", "both", "--format", "json"});
    EXPECT_EQ(both.code, ExitCode::Verdict);
    const nlohmann::json printed = nlohmann::json::parse(both.out);
    for (const nlohmann::json& property : printed["properties"]) {
        const bool noted = has(property["notes"].dump(), "with cycle time zero: holds");
        EXPECT_EQ(noted, property["name"] == "rejected") << property.dump();
    }
}

TEST(TaskCycle, AnUntimedTraceReplaysAndNeverBeginsAScanInAScan) {
    const Folder folder;
    const std::string file = folder.write(
        "pulse.grafcet",
        "grafcet pulse { input A; output O; initial step 0; step 1; step 2 { O; } transition t0: 0 -> 1 when A;\n"
        "    transition t1: 1 -> 2 when true; transition t2: 2 -> 0 when 5s/X2 && !A; }\n"
        "closed_loop pulse_loop { controller pulse every 10ms; environment a = free(OUT = A); property off: never O; "
        "}\n");
    for (const std::string grain : {"phased", "atomic"})
        for (const std::string cycle : {"task", "zero"})
            for (const std::string mode : {"stability-search", "every-cycle"}) {
                const Result result = grafverif({"check", file, "--untimed", "--plant", "automata", "--grain", grain,
                                                 "--cycle", cycle, "--mode", mode});
                EXPECT_EQ(result.code, ExitCode::Verdict) << result.out << result.err;
            }
}

TEST(TaskCycle, ProgramsWithTimersRejectCycleTimeZero) {
    const Folder folder;
    folder.write("p.st",
                 "PROGRAM P VAR_INPUT Key : BOOL; END_VAR VAR_OUTPUT Lamp : BOOL; END_VAR VAR T1 : TON; "
                 "END_VAR T1(IN := Key, PT := T#20ms); Lamp := T1.Q; END_PROGRAM\n");
    const std::string file =
        folder.write("p.grafcet",
                     "program p = \"p.st\";\nclosed_loop l {\n    controller p every 10ms;\n"
                     "    environment Key = push_button(OUT = Key);\n    property lit: reachable Lamp;\n}\n");
    for (const char* cycle : {"zero", "both"}) {
        const Result result = grafverif({"check", file, "--cycle", cycle});
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_EQ(result.out, "");
        EXPECT_TRUE(has(result.err,
                        "p.grafcet:3:16: error: the program `p` has timers, so its scans require a fixed "
                        "interval, and its cycle time cannot be zero; omit `--cycle` "
                        "[program-without-cycle]"))
            << result.err;
    }
    EXPECT_EQ(grafverif({"check", file}).code, ExitCode::Done);
}

TEST(TaskCycle, SuperviseRejectsIt) {
    const Folder folder;
    const Result result = grafverif({"supervise", folder.write("sorter.grafcet", sorter(" every 10ms"))});
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_TRUE(has(result.err, "a task cycle in `supervise` is not supported; remove it [unsupported]")) << result.err;
}

TEST(TaskCycle, UntimedModelsHavePlantAutomataOrAreRejected) {
    const Folder folder;
    const std::string file = folder.write("sorter.grafcet", sorter(" every 10ms"));
    EXPECT_TRUE(has(grafverif({"nusmv", file, "-o", "-"}).out, "plant automata, schedule interleaved"));
    for (const std::vector<std::string>& options :
         {std::vector<std::string>{"--plant", "none"}, {"--plant", "constraints"}, {"--schedule", "sequenced"}}) {
        std::vector<std::string> arguments{"check", file, "--untimed"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Result result = grafverif(arguments);
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_TRUE(has(result.err, "sorter.grafcet:7:")) << result.err;
        EXPECT_TRUE(has(result.err, "[cycle-without-time]")) << result.err;
        arguments.insert(arguments.end(), {"--cycle", "zero"});
        EXPECT_NE(grafverif(arguments).code, ExitCode::Input);
    }
}

}  // namespace
}  // namespace grafverif::app
