// SPDX-License-Identifier: MIT
// Tests `check --untimed`: verdicts of the symbolic engine, their assumptions, traces without time, and other engines.
#include "pipeline/untimed.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run_program.hpp"

namespace grafverif::app {
namespace {

using UntimedJson = nlohmann::json;

const std::string tank_sample = (root / "samples/tanks/tanks.grafcet").string();

std::string lamp(const std::string& properties) {
    return "grafcet lamp { input A, B; output L, M; initial step 0; step 1 { L; } step 2 { M; }\n"
           "transition t0: 0 -> 1 when A; transition t1: 1 -> 2 when B; transition t2: 2 -> 0 when !A; }\n"
           "closed_loop room { controller lamp; environment a = free(OUT = A); environment b = free(OUT = B); " +
           properties + " }\n";
}

TEST(CheckUntimed, PrintsTheAssumptionsOfEachVerdict) {
    const Folder folder;
    const std::string file = folder.write("lamp.grafcet", lamp("property apart: never L && M; property lit: never L;"
                                                               "property shown: reachable M;"
                                                               "property quick: inevitable X1;"));
    const Result result = grafverif({"check", file, "--untimed"});
    EXPECT_EQ(result.code, ExitCode::Verdict) << result.err;
    EXPECT_TRUE(
        result.out.starts_with("room, checked with: symbolic, untimed: no plant; stability-search; 36 states\n"
                               "    apart: valid for every plant, in grain atomic\n"
                               "    lit, quick: may hold with the real plant\n"
                               "    shown: no conclusion about any plant\n"))
        << result.out;
}

TEST(CheckUntimed, DecidesIndependentControllersThatNeverBecomeStable) {
    const Folder folder;
    const std::string file =
        folder.write("twins.grafcet",
                     "grafcet a { initial step 0; transition t0: 0 -> 0 when true; }\n"
                     "grafcet b { initial step 0; transition t0: 0 -> 0 when true; }\n"
                     "closed_loop twins { controller a; controller b; property p: always a.X0; }\n");
    for (const std::vector<std::string>& more :
         {std::vector<std::string>{}, {"--time", "discrete"}, {"--max-memory", "512M"}}) {
        std::vector<std::string> words{"check", file, "--untimed", "--plant", "automata", "--engine", "auto"};
        words.insert(words.end(), more.begin(), more.end());
        const Result result = grafverif(words);
        EXPECT_EQ(result.code, ExitCode::Done) << result.err;
        EXPECT_NE(result.out.find("p         holds"), std::string::npos) << result.out;
    }
    const Result why = grafverif({"check", file, "--why", "--timeout", "20s"});
    EXPECT_EQ(why.err.find("[out-of-memory]"), std::string::npos) << why.err;
    EXPECT_NE(why.out.find("proof dependencies"), std::string::npos) << why.out;
}

TEST(CheckUntimed, TimesThatPropertiesReadAreFreeWithoutAPlant) {
    const Folder folder;
    const std::string file = folder.write(
        "lamp.grafcet",
        "grafcet lamp { input A; output L; initial step 0; step 1 { L after 2s; }\n"
        "transition t0: 0 -> 1 when A; transition t1: 1 -> 0 when 5s/X1; }\n"
        "closed_loop room { controller lamp; environment a = free(OUT = A);\n"
        "property over: never 5s/X1; property apart: never 5s/X1 && X0; property late: always 5s/X1 => 2s/X1; }\n");
    for (const std::string engine : {"symbolic", "pdr"}) {
        const Result result = grafverif({"check", file, "--untimed", "--engine", engine});
        EXPECT_EQ(result.code, ExitCode::Verdict) << result.err;
        EXPECT_NE(result.out.find("over: violated"), std::string::npos) << result.out;
        EXPECT_NE(result.out.find("late: violated"), std::string::npos)
            << result.out;  // both delays are arbitrary and independent
        EXPECT_EQ(result.out.find("apart: violated"), std::string::npos) << result.out;
    }
    const Result timed = grafverif({"check", file});
    EXPECT_NE(timed.out.find("over: violated"), std::string::npos) << timed.out;
    EXPECT_EQ(timed.out.find("late: violated"), std::string::npos) << timed.out;
    EXPECT_EQ(grafverif({"nusmv", file, "-o", "-"}).code, ExitCode::Done);
}

TEST(CheckUntimed, TracesNameTheInputsThatTimersWatch) {
    const Folder folder;
    const std::string file = folder.write(
        "lamp.grafcet",
        "grafcet lamp { input A, B; output L; initial step 0; step 1 { L; }\n"
        "transition t0: 0 -> 1 when 2s/A; transition t1: 1 -> 0 when 5s/X1 || 1s/(A && B); }\n"
        "closed_loop room { controller lamp; environment a = free(OUT = A); environment b = free(OUT = B);\n"
        "property dark: never L; }\n");
    for (const std::vector<std::string>& how :
         std::vector<std::vector<std::string>>{{}, {"--untimed"}, {"--untimed", "--plant", "automata"}}) {
        std::vector<std::string> command{"check", file, "--format", "json"};
        command.insert(command.end(), how.begin(), how.end());
        const UntimedJson document = UntimedJson::parse(grafverif(command).out);
        UntimedJson names = UntimedJson::array();
        for (const auto& timer : document["properties"][0]["trace"]["run"]["timers"]) names.push_back(timer["watched"]);
        EXPECT_EQ(names, UntimedJson({"A", "X1", nullptr}));
    }
}

/// True if `out` contains the statement `carries` about other models for the verdict on `property`. The statement is at
/// the beginning if it applies to all properties, or belongs to the group that names the property.
bool says_of(const std::string& property, const std::string& carries, const std::string& out) {
    std::string head = out.substr(0, out.find("\n\n")) + '\n';
    for (std::size_t at = 0; (at = head.find("\n        ")) != std::string::npos;) head.replace(at, 9, " ");
    if (head.substr(0, head.find('\n')).ends_with(" states; " + carries)) return true;
    std::istringstream lines(head);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("    ") && line.find(' ' + property) < line.find(": ") && line.ends_with(": " + carries))
            return true;
    return false;
}

TEST(CheckUntimed, StatesWhichVerdictsArePreservedUnderEachScheduleAndUnderFairness) {
    struct Case {
        std::vector<std::string> options;
        std::string apart, lit, quick;  ///< the properties `never L && M`, `never L`, `inevitable X1`
    };
    const std::string nothing = "no conclusion beyond this model", so = "valid for the timed loop";
    const std::string states = "applies to integer time, and to dense time only if no clock constraint is strict";
    const Case cases[] = {
        {{"--plant", "automata"}, so, "may hold in the timed loop", "may hold in the timed loop"},
        {{"--plant", "automata", "--fairness"}, so, "may hold in the timed loop", nothing},
        {{"--plant", "automata", "--schedule", "synchronous"}, nothing, nothing, nothing},
        {{"--plant", "automata", "--schedule", "sequenced"}, nothing, nothing, nothing},
        {{"--time", "discrete"}, states, so, "applies only to integer time"},
    };
    const Folder folder;
    const std::string file = folder.write(
        "lamp.grafcet", lamp("property apart: never L && M; property lit: never L; property quick: inevitable X1;"));
    for (const Case& one : cases) {
        std::vector<std::string> words{"check", file, "--untimed"};
        words.insert(words.end(), one.options.begin(), one.options.end());
        const std::string out = grafverif(words).out;
        for (const auto& [property, carries] :
             {std::pair("apart", one.apart), std::pair("lit", one.lit), std::pair("quick", one.quick)})
            EXPECT_TRUE(says_of(property, carries, out)) << property << ": " << carries << '\n' << out;
        EXPECT_FALSE(says_of("lit", one.lit == so ? nothing : so, out)) << out;
    }
}

TEST(CheckUntimed, PrintsTracesInStepsWithElementsOfTheChart) {
    const Folder folder;
    const std::string file = folder.write("lamp.grafcet", lamp("property dark: never M;"));
    const Result result = grafverif({"check", file, "--untimed", "--format", "json"});
    const UntimedJson property = UntimedJson::parse(result.out)["properties"][0];
    EXPECT_EQ(property["engine"], "symbolic");
    EXPECT_TRUE(property["grain"].is_null());
    EXPECT_TRUE(property["transitions"].is_null());
    EXPECT_EQ(property["states"], 36);
    const UntimedJson& steps = property["trace"]["steps"];
    std::vector<std::string> fired;
    for (const UntimedJson& step : steps) {
        EXPECT_TRUE(step["time"].is_null());
        for (const UntimedJson& transition : step["fired"]) fired.push_back(transition);
    }
    EXPECT_EQ(fired, (std::vector<std::string>{"t0", "t1"}));
    EXPECT_EQ(steps.back()["situation"], UntimedJson::array({"2"}));
    EXPECT_TRUE(steps.back()["outputs"]["M"]);
}

TEST(CheckUntimed, ALassoMarksItsLoop) {
    const Folder folder;
    const std::string file = folder.write("lamp.grafcet", lamp("property quick: inevitable X1;"));
    const Result result = grafverif({"check", file, "--untimed", "--format", "json"});
    const UntimedJson property = UntimedJson::parse(result.out)["properties"][0];
    EXPECT_EQ(property["verdict"], "violated");
    EXPECT_TRUE(property["trace"]["loop_from"].is_number());
}

TEST(CheckUntimed, AChartWithoutALoopIsCheckedWithFreeInputs) {
    const Folder folder;
    const std::string file = folder.write(
        "dead.grafcet",
        "grafcet dead { input A; initial step 0; step 1; step 2;\n"
        "transition t0: 0 -> 1 when A; transition t1: 1 -> 0 when !A; transition t2: 1 -> 2 when A && !A; }\n");
    const Result result = grafverif({"check", file});
    EXPECT_EQ(result.code, ExitCode::Verdict);
    EXPECT_NE(
        result.err.find("`dead` is not part of a closed loop: the reachability of its steps is checked in the untimed "
                        "model, with free inputs"),
        std::string::npos)
        << result.err;
    EXPECT_TRUE(result.out.starts_with("dead, checked with: symbolic, untimed: no plant; stability-search\n"))
        << result.out;
    EXPECT_TRUE(says_of("reachable.X2", "4 states; valid for every plant, in grain atomic", result.out)) << result.out;
    EXPECT_NE(result.out.find("reachable.X2: violated\n"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("reachable (2 of 3 steps)   holds"), std::string::npos) << result.out;
    EXPECT_EQ(grafverif({"check", tank_sample, "--chart", "tanks", "--property", "reachable"}).code, ExitCode::Done);
}

TEST(CheckUntimed, PropertyThatAnUntimedModelCannotExpressIsUnknown) {
    const Result result = grafverif({"check", tank_sample, "--untimed", "--property", "no_timelock"});
    EXPECT_EQ(result.code, ExitCode::Unknown);
    EXPECT_NE(result.out.find("no_timelock: unknown\n"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("why: this model has no time"), std::string::npos) << result.out;
}

TEST(CheckUntimed, UntimedEngineImpliesTheUntimedModel) {
    const Result result = grafverif({"check", tank_sample, "--engine", "symbolic", "--property", "one_way_1"});
    EXPECT_EQ(result.code, ExitCode::Done);
    EXPECT_NE(result.out.find("symbolic, untimed"), std::string::npos) << result.out;
    const Result wrong = grafverif({"check", tank_sample, "--engine", "timed", "--untimed"});
    EXPECT_EQ(wrong.code, ExitCode::Input);
    EXPECT_NE(wrong.err.find("`--engine timed` checks only timed models; remove `--untimed`"), std::string::npos)
        << wrong.err;
}

TEST(CheckUntimed, MissingProgramIsNamedWithARemedy) {
    const Result result = grafverif({"check", tank_sample, "--engine", "nuXmv"});
    if (result.code == ExitCode::Done) GTEST_SKIP() << "nuXmv is on the PATH";
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_NE(result.err.find("`nuXmv` is not on the PATH"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("--engine symbolic"), std::string::npos) << result.err;
}

/// Installs a stand-in for NuSMV that prints `answer` for the first property only.
std::string install_nusmv(const Folder& folder, const std::string& answer) {
    fs::permissions(folder.write("NuSMV",
                                 "#!/bin/sh\n"
                                 "cat <<'END'\n"
                                 "grafverif: fsm\nThe transition relation is total\n"
                                 "grafverif: states\nreachable states: 36 (2^5.2) out of 64\n"
                                 "grafverif: 0\nEND\n" +
                                     answer + "\necho 'grafverif: end'\n"),
                    fs::perms::owner_all);
    return folder.file("");
}

std::string printing(const std::string& text) { return "cat <<'END'\n" + text + "END"; }

TEST(CheckUntimed, WrongResultOfTheProgramIsRejected) {
    const std::string trace =
        "-- as demonstrated by the following execution sequence\nTrace Description: AG alpha Counterexample\n"
        "Trace Type: Counterexample\n  -> State: 1.1 <-\n";
    const std::string initial =
        "    A = FALSE\n    B = FALSE\n    lamp.X_0 = TRUE\n    lamp.X_1 = FALSE\n    lamp.X_2 = FALSE\n";
    struct Case {
        const char* property;
        std::string answer, why;
    };
    for (const Case& one : {
             Case{"never L", printing("-- invariant !lamp.L  is false\n"),
                  "engine-disagrees: the program printed no trace for its verdict"},
             {"reachable L", printing("-- invariant !lamp.L  is false\n"),
              "engine-disagrees: the program printed no trace for its verdict"},
             {"never L", printing("-- invariant !lamp.L  is true\n-- invariant !lamp.L  is false\n"),
              "engine-disagrees: the program printed more than one verdict"},
             {"never L", printing("-- invariant a  is true\ngrafverif: 0\n-- invariant a  is true\n"),
              "engine-disagrees: the program printed more than one verdict"},
             {"never L", printing("-- invariant a  is false\n" + trace + "    lamp.X_0 = seventeen\n"),
              "engine-disagrees: the program printed no trace for its verdict"},
             {"never L", printing("-- invariant a  is false\n" + trace + "    lamp.X_0 = 17\n"),
              "engine-disagrees: state 1 of the trace gives `lamp.X_0` a value outside its range"},
             {"never L", printing("-- invariant a  is false\n" + trace + "    lamp.X_1 = TRUE\n"),
              "engine-disagrees: state 1 of the trace "},
             {"never X2",
              printing("-- invariant a  is false\n" + trace + initial + "  -> State: 1.2 <-\n    lamp.X_2 = TRUE\n"),
              "engine-disagrees: state 1 of the trace "},
             {"inevitable X1", printing("-- specification AF lamp.X_1  is false\n" + trace + initial),
              "engine-disagrees: "},
             {"never L", "echo 'grafverif: 7'; echo '-- invariant a  is true'", "the program printed no verdict"},
             {"never L", printing("my hovercraft is full of eels\n"), "the program printed no verdict"},
             {"never L", "exec yes 'my hovercraft is full of eels'", "the output of the program is too large"},
             {"never L", "echo '-- invariant a  is true'; exit 0", "the program printed no verdict"},
             {"never L", "echo '-- invariant a  is true'; echo 'grafverif: end'; kill -SEGV $$",
              "the program was terminated by signal 11"},
         }) {
        SCOPED_TRACE(one.answer);
        const Folder folder;
        const Path path(install_nusmv(folder, one.answer) + ":/usr/bin:/bin");
        const std::string file = folder.write("lamp.grafcet", lamp("property P: " + std::string(one.property) + ";"));
        const Result result = grafverif({"check", file, "--engine", "NuSMV"});
        EXPECT_EQ(result.code, ExitCode::Unknown) << result.out;
        EXPECT_EQ(result.err, "");
        EXPECT_NE(result.out.find("P: unknown"), std::string::npos) << result.out;
        EXPECT_NE(result.out.find("why: " + one.why), std::string::npos) << result.out;
    }
}

TEST(CheckUntimed, UnrequestedResultsAreNotReported) {
    const Folder folder;
    const Path path(
        install_nusmv(folder, printing("-- invariant a  is true\ngrafverif: 1\n-- invariant b  is false\n")) +
        ":/usr/bin:/bin");
    const std::string file = folder.write("lamp.grafcet", lamp("property P: never L && M;"));
    const Result result = grafverif({"check", file, "--engine", "NuSMV"});
    EXPECT_EQ(result.code, ExitCode::Done) << result.out << result.err;
    EXPECT_NE(result.out.find("room: 1 hold"), std::string::npos) << result.out;
}

TEST(CheckUntimed, FormulaWithAnUnknownNameAffectsNoOther) {
    const Folder folder;
    const std::string file =
        folder.write("lamp.grafcet", lamp("property F: ctl \"AG EF lamp.X_9\"; property P: never L && M;"));
    const Result result = grafverif({"check", file, "--untimed"});
    EXPECT_EQ(result.code, ExitCode::Unknown);
    EXPECT_NE(result.out.find("why: the model does not declare `lamp.X_9`"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("P         holds"), std::string::npos) << result.out;
    const Result model = grafverif({"nusmv", file});
    EXPECT_EQ(model.code, ExitCode::Done);
    EXPECT_NE(model.out.find("-- omitted: the model does not declare `lamp.X_9`"), std::string::npos) << model.out;
    EXPECT_EQ(model.out.find("AG EF lamp.X_9"), std::string::npos);
    EXPECT_NE(model.err.find("[not-expressible]"), std::string::npos) << model.err;
}

TEST(CheckUntimed, ATimeLimitEndsInUnknown) {
    const Result result = grafverif({"check", station, "--untimed", "--timeout", "0ms"});
    EXPECT_EQ(result.code, ExitCode::Unknown);
    EXPECT_NE(result.out.find("stopped at the time limit of 0 s"), std::string::npos) << result.out;
}

std::string counter(const std::string& step, const std::string& properties) {
    return "grafcet counter { input A; output L; internal N: int 0..10 = 0; initial step 0;\n"
           "step 1 { " +
           step +
           " } transition up: 0 -> 1 when A && N < 10; transition down: 1 -> 0 when !A; }\n"
           "component mover(output S; K = 1) { variable X: int 0..10;\n"
           "initial location off; location on; urgent off -> on when X < K * K / 100000000 do S := true; }\n"
           "closed_loop room { controller counter; plant m = mover(S = A);\n" +
           properties + " }\n";
}

/// NuSMV and UPPAAL compute with 32 bits, and would report that N * 500000000 never exceeds
/// 2100000000.
TEST(Models, PropertyThatNeedsMoreThan32BitsIsOmittedAndDecidedByEmbeddedEngines) {
    const Folder folder;
    const std::string file =
        folder.write("counter.grafcet", counter("N := N + 1 on activation;",
                                                "property small: never N * 500000000 > 2100000000;\n"
                                                "property one: reachable N > 0;"));
    for (const std::string verb : {"nusmv", "uppaal"}) {
        SCOPED_TRACE(verb);
        const Result made = grafverif({verb, file});
        EXPECT_EQ(made.code, ExitCode::Done) << made.err;
        EXPECT_NE(made.err.find("counter.grafcet:6:10: warning: property `small` is omitted from the "),
                  std::string::npos)
            << made.err;
        EXPECT_NE(made.err.find("model; the property may need integers of more than 32 bits [not-expressible]"),
                  std::string::npos);
        EXPECT_EQ(made.out.find("500000000"), std::string::npos);
        EXPECT_NE(made.out.find("one"), std::string::npos);
    }
}

TEST(Models, TermOfMoreThan32BitsIsRejectedAtItsLocation) {
    const Folder folder;
    const std::string chart =
        folder.write("chart.grafcet", counter("N := N * 300000000 / 1000000000 on activation;", ""));
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"nusmv", chart}, {"uppaal", chart}, {"build", chart}}) {
        const Result refused = grafverif(command);
        EXPECT_EQ(refused.code, ExitCode::Input) << command.front();
        EXPECT_NE(refused.err.find("N` may exceed 32 bits"), std::string::npos) << refused.err;
        EXPECT_NE(refused.err.find("[beyond-32-bits]"), std::string::npos);
        EXPECT_EQ(refused.out, "");
    }
    // UPPAAL evaluates the constant term itself, with 32 bits. For NuSMV, grafverif evaluates the term when it
    // translates the instance.
    std::string text = counter("", "");
    text.replace(text.find("mover(S = A)"), 12, "mover(S = A, K = 50000)");
    const std::string plant = folder.write("plant.grafcet", text);
    const Result refused = grafverif({"uppaal", plant});
    EXPECT_EQ(refused.code, ExitCode::Input);
    EXPECT_NE(refused.err.find("plant.grafcet:4:36: error: the guard of an edge may exceed 32 bits"), std::string::npos)
        << refused.err;
    EXPECT_EQ(grafverif({"nusmv", plant, "--plant", "automata"}).code, ExitCode::Done);
    EXPECT_EQ(grafverif({"uppaal", folder.write("small.grafcet", counter("", ""))}).code, ExitCode::Done);
}

}  // namespace
}  // namespace grafverif::app
