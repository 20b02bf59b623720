// SPDX-License-Identifier: MIT
// Tests that names are consistent in all output and input: names of steps, internal variables, variables and locations
// of instances, and properties.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "run_program.hpp"

namespace grafverif::app {
namespace {

using Tree = nlohmann::json;

/// Two controllers with equal names of steps and internal variables. The model also has partial charts, a macro-step,
/// an enclosing step, and a variable of an instance.
const std::string named_model = R"(
component gate(input UP, DOWN; output OPEN) {
    variable H: int 0..3 = 0;
    initial location closed;
    location open;
    urgent closed -> open when UP do OPEN := true, H := 3;
    urgent open -> closed when DOWN do OPEN := false, H := 0;
}
grafcet upper {
    input a, OPEN;
    output UP, DOWN;
    internal N: int 0..3 = 0;
    initial step 0;
    step 1 { UP; N := 1 on activation; }
    macro step M1 expands E1;
    enclosing step 4 encloses G1;
    transition t0: 0 -> 1 when a && 1s/X0;
    transition t1: 1 -> M1 when OPEN;
    transition t2: M1 -> 4 when !a;
    transition t3: 4 -> 0 when G1.X21;
    expansion E1 {
        entry step E { DOWN; }
        exit step S;
        transition e0: E -> S when true;
    }
    partial G1 {
        linked step 20;
        step 21;
        transition g0: 20 -> 21 when true;
    }
    partial G2 {
        initial step 0;
        step 30;
        transition h0: 0 -> 30 when a;
        transition h1: 30 -> 0 when !a;
    }
}
grafcet lower {
    input a;
    output L;
    internal N: bool = false;
    initial step 0;
    step 1 { L; N := true on activation; }
    transition t0: 0 -> 1 when a;
    transition t1: 1 -> 0 when !a;
}
)";
std::string loop(const std::string& properties) {
    return named_model +
           "closed_loop both {\n"
           "    controller upper;\n"
           "    controller lower;\n"
           "    plant Gate = gate(UP = UP, DOWN = DOWN, OPEN = OPEN);\n"
           "    environment A = push_button(OUT = a);\n" +
           properties + "}\n";
}

/// Returns the name of the step variable (IEC 60848, 4.3): `press.G1.X3` for the step `press.G1.3`.
std::string variable(std::string step) { return step.insert(step.rfind('.') + 1, 1, 'X'); }

/// The names of variables and steps in the JSON of a run or an automaton. Properties accept the names of variables.
struct Names {
    std::set<std::string> values = {}, steps = {};
};

Names names_of_trace(const std::vector<std::string>& options) {
    const Folder folder;
    std::vector<std::string> words = {"check", folder.write("both.grafcet", loop("property p: never upper.X4;\n")),
                                      "--format", "json"};
    words.insert(words.end(), options.begin(), options.end());
    const Result result = grafverif(words);
    EXPECT_EQ(result.code, ExitCode::Verdict) << result.err;
    Names names;
    const Tree report = Tree::parse(result.out);
    for (const Tree& property : report.at("properties")) {
        if (property.at("trace").is_null()) continue;
        const Tree &trace = property.at("trace"), &run = trace.at("run");
        for (const Tree& signal : run.at("signals"))
            if (signal.at("role") != "image") names.values.insert(signal.at("name"));
        for (const Tree& step : run.at("steps")) {
            names.steps.insert(step.at("full_name"));
            names.steps.insert(step.at("short_name"));
        }
        for (const Tree& instance : run.at("instances"))
            for (const Tree& location : instance.at("locations"))
                if (instance.at("kind") == "plant" || instance.at("kind") == "environment")
                    names.values.insert(instance.at("name").get<std::string>() + "." + location.get<std::string>());
        for (const Tree& row : trace.at("steps")) {
            for (const Tree& step : row.at("situation")) names.steps.insert(step);
            for (const char* kind : {"inputs", "outputs"})
                for (const auto& [name, value] : row.at(kind).items()) names.values.insert(name);
        }
    }
    return names;
}

Names names_of_automaton() {
    const Folder folder;
    const std::string file = folder.write("both.grafcet", loop(""));
    Names names;
    for (const char* chart : {"upper", "lower"}) {
        const Result result = grafverif({"automaton", file, "--chart", chart, "--format", "json"});
        EXPECT_EQ(result.code, ExitCode::Done) << result.err;
        const std::string owner = std::string(chart) + ".";
        const Tree automaton = Tree::parse(result.out);
        for (const Tree& location : automaton.at("location_table")) {
            for (const Tree& step : location.at("situation")) names.steps.insert(owner + step.get<std::string>());
            for (const auto& [name, value] : location.at("values").items()) names.values.insert(owner + name);
            for (const auto& [name, value] : location.at("outputs").items()) names.values.insert(name);
        }
    }
    return names;
}

/// Returns the names of the steps in the situations of a generated test.
Names names_of_test() {
    const Folder folder;
    const Result result =
        grafverif({"testgen", folder.write("both.grafcet", loop("")), "--chart", "upper", "--format", "json"});
    EXPECT_EQ(result.code, ExitCode::Done) << result.err;
    Names names;
    const Tree parsed = Tree::parse(result.out);
    for (const Tree& sequence : parsed.at("sequences"))
        for (const Tree& step : sequence) {
            std::string situation = step.at("situation");
            for (situation = situation.substr(1, situation.size() - 2); !situation.empty();) {
                const std::size_t comma = std::min(situation.find(','), situation.size());
                names.steps.insert("upper." + situation.substr(0, comma));
                situation.erase(0, comma + 1);
            }
        }
    return names;
}

void can_be_named(const Names& names) {
    ASSERT_GT(names.steps.size(), 5U);
    std::set<std::string> terms = names.values;
    for (const std::string& step : names.steps) terms.insert(variable(step));
    std::string properties, script;
    int number = 0;
    for (const std::string& term : terms) {
        const bool integer = term == "Gate.H" || term == "upper.N";
        properties += "property q" + std::to_string(++number) + ": never " + term + (integer ? " > 1;\n" : ";\n");
        script += "expect " + term + (integer ? " < 2\n" : "\n");
    }
    std::string forced;
    for (const std::string& step : names.steps) forced += "force " + step + " on\nundo\n";
    const Folder folder;
    const std::string file = folder.write("named.grafcet", loop(properties));
    EXPECT_EQ(grafverif({"check", file, "--list"}).err, "");
    const Result simulated = grafverif({"simulate", file, "--script", folder.write("s.txt", script)});
    EXPECT_EQ(simulated.code, ExitCode::Verdict) << simulated.err;  // not all properties hold, but all names are known
    for (const char* refusal :
         {"! unknown step", "is ambiguous between"})  // other rejections by the interpreter are irrelevant here
        EXPECT_EQ(grafverif({"simulate", file}, forced).out.find(refusal), std::string::npos);
}

TEST(Names, TraceNamesAreValidInPropertiesAndScripts) { can_be_named(names_of_trace({})); }

TEST(Names, UntimedTraceHasTheNamesOfTheTimedTrace) {
    Names timed = names_of_trace({});
    const Names untimed = names_of_trace({"--untimed", "--plant", "automata"});
    timed.values.erase("A.idle");  // A has only this location, which untimed traces omit
    EXPECT_EQ(timed.values, untimed.values);
    EXPECT_EQ(timed.steps, untimed.steps);
    EXPECT_TRUE(timed.values.contains("Gate.H") && timed.values.contains("upper.N") &&
                timed.values.contains("lower.N") && timed.steps.contains("upper.E1.S"));
}

TEST(Names, NamesInLocationAutomataAreValid) { can_be_named(names_of_automaton()); }

TEST(Names, NamesInTestSequencesAreValid) { can_be_named(names_of_test()); }

TEST(Names, TimerIsShownAsInConditions) {
    const Folder folder;
    const std::string file = folder.write("both.grafcet", loop("property p: never upper.X1;\n"));
    for (const std::vector<std::string>& options : {std::vector<std::string>{}, {"--untimed", "--plant", "automata"}}) {
        std::vector<std::string> words = {"check", file};
        words.insert(words.end(), options.begin(), options.end());
        const std::string out = grafverif(words).out;
        EXPECT_NE(out.find("upper: 1s/X0 is true\n"), std::string::npos) << out;
        EXPECT_EQ(out.find("T_X0"), std::string::npos) << "a name of the network:\n" << out;
    }
    const std::string automaton = grafverif({"automaton", file, "--chart", "upper"}).out;
    EXPECT_NE(automaton.find("when a and OPEN and 1s/X0"), std::string::npos) << automaton;
}

TEST(Names, PropertyIsSelectedByItsNameInAnyOutput) {
    const Folder folder;
    const std::string file = folder.write(
        "both.grafcet",
        loop("property p: never upper.X4;\nproperty steps: reachable all steps;\nproperty q: no deadlock;\n"));
    const Result all = grafverif({"check", file, "--format", "json"});
    std::vector<std::string> again = {"check", file, "--format", "json"};
    const Tree report = Tree::parse(all.out);
    for (const Tree& property : report.at("properties"))
        again.insert(again.end(), {"--property", property.at("name").get<std::string>()});
    EXPECT_GT(again.size(), 20U);
    EXPECT_EQ(Tree::parse(grafverif(again).out).at("properties").size(), (again.size() - 4) / 2);
    EXPECT_EQ(grafverif({"check", file, "--property", "steps", "-q"}).code, ExitCode::Done);
}

TEST(Names, SimulationListsTheCandidatesOfAnAmbiguousName) {
    const Folder folder;
    const std::string file = folder.write("both.grafcet", loop(""));
    const Result result = grafverif({"simulate", file},
                                    "expect X0\nexpect G2.X0\nexpect N = 0\nexpect Gate_H = 0\nexpect upper.X0\n"
                                    "force 0 on\nexpect Gat.H = 0\ndo Gate opne\nH = 2\nGate.H = 9\n");
    for (const char* message : {"! `X0` is ambiguous between `upper.X0` and `upper.G2.X0`; write the qualified name",
                                "! `N` is ambiguous between `upper.N` and `lower.N`; write the qualified name",
                                "! `0` is ambiguous between `upper.0` and `upper.G2.0`; write the qualified name",
                                "! unknown variable or step `Gat.H`; did you mean `Gate.H`?",
                                "! unknown `Gate` location `opne`; did you mean `open`?", "! unknown input `H`",
                                "! `Gate.H` ranges from 0 to 3 and cannot be 9"})
        EXPECT_NE(result.out.find(message), std::string::npos) << message << '\n' << result.out;
    EXPECT_EQ(result.out.find("`G2.X0`"), std::string::npos) << "the name `G2.X0` is unambiguous";
    EXPECT_EQ(result.out.find("Gate_H"), std::string::npos) << "the name of the variable in the network is accepted";
}

/// Controllers of several closed loops may have equal names, but `--chart` must not choose one of them silently.
TEST(Names, ChartsWithOneNameAreNotChosen) {
    const Folder folder;
    const auto file = [&](const std::string& first, const std::string& second) {
        return folder.write("two.grafcet",
                            "grafcet g(input IN; T = 1s) { initial step 0; step 1; transition 0 -> 1 when IN; "
                            "transition 1 -> 0 when T/X1; }\n"
                            "closed_loop a { controller c = g(IN = A, T = " +
                                first +
                                "); environment e = free(OUT = A); }\n"
                                "closed_loop b { controller c = g(IN = A, T = " +
                                second + "); environment e = free(OUT = A); }\n");
    };
    const Result different = grafverif({"equations", file("1s", "3s"), "--chart", "c"});
    EXPECT_EQ(different.code, ExitCode::Input);
    EXPECT_NE(different.err.find("3:28: error: a second chart is named `c`"), std::string::npos) << different.err;
    EXPECT_EQ(grafverif({"equations", file("1s", "1000ms"), "--chart", "c"}).code, ExitCode::Done);
    EXPECT_EQ(grafverif({"equations", file("1s", "3s")}).code, ExitCode::Done);
}

}  // namespace
}  // namespace grafverif::app
