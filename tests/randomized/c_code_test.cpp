// SPDX-License-Identifier: MIT
// Randomized test: the C compiler of the system compiles the controllers of random charts without warnings, except for
// conditions of a chart that compare a variable with itself. The compiled controllers agree with the interpreter scan
// by scan, in both execution modes, in the outputs, the situation, and the scan in which the controller stops. A
// further test compiles a chart with names that are similar to those of the code, in C and in C++.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "derive/derive.hpp"
#include "emit/c/c.hpp"
#include "emit/controller/names.hpp"
#include "randomized/controller_cases.hpp"
#include "run/interpreter.hpp"
#include "support/messages.hpp"
#include "support/play.hpp"
#include "support/random_chart.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

namespace fs = std::filesystem;

constexpr int scans = 14;

/// The controller of a chart, with the values that its compiled code must print.
struct Controller {
    Chart chart = {};
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::uint64_t seed = 0;
    std::string code = {};             ///< header, source, and a function that runs the controller
    std::string input = {};            ///< numbers that the function reads
    std::vector<std::string> printed;  ///< one line per scan, up to the stop
    std::vector<int> faults = {};
};

/// Returns a function that reads the scans of a controller and prints its outputs and steps.
std::string driver(const Equations& equations, const controller::Names& names) {
    std::ostringstream out;
    const std::string& block = names.block;
    out << "static void run_" << block << "(void)\n{\n    " << block << "_state state;\n    " << block
        << "_inputs inputs;\n    int scan;\n    " << block << "_init(&state);\n    for (scan = 0; scan < " << scans
        << "; ++scan) {\n        uint32_t elapsed = (uint32_t)number();\n";
    std::string outputs, steps;
    for (const Id<Equations::Variable> id : equations.variables.ids()) {
        const Equations::Variable& variable = equations.variables[id];
        const std::string& name = names.variables[id.index];
        if (variable.role == Equations::Role::Input)
            out << "        inputs." << name << " = " << (variable.type.boolean ? "number() != 0" : "(int32_t)number()")
                << ";\n";
        const std::string print = "        (void)printf(\" %ld\", (long)state." + name + ");\n";
        if (variable.role == Equations::Role::Output) outputs += print;
        if (variable.role == Equations::Role::Step) steps += print;
    }
    out << "        " << block << "_scan(&state, &inputs, elapsed);\n        (void)printf(\"%d\", (int)state."
        << names.fault << ");\n"
        << outputs << "        (void)printf(\" steps\");\n"
        << steps << "        (void)printf(\"\\n\");\n    }\n}\n";
    return std::move(out).str();
}

/// Returns the line that the driver prints after a scan.
std::string line_of(const Chart& chart, const Equations& equations, const Cycle& run) {
    std::string outputs, steps;
    for (const Id<Equations::Variable> variable : equations.variables.ids()) {
        if (equations.variables[variable].role == Equations::Role::Output)
            for (const Id<Chart::Variable> id : chart.variables.ids())
                if (chart.variables[id].name == equations.variables[variable].name)
                    outputs += ' ' + std::to_string(run.state.outputs[id.index]);
        for (std::size_t k = 0; k < equations.steps.size(); ++k)
            if (equations.steps[k].variable == variable) steps += run.state.situation[k] ? " 1" : " 0";
    }
    return std::to_string(fault_of(run)) + outputs + " steps" + steps;
}

/// Adds the inputs of all scans and the expected lines.
void simulate(Controller& made, const Equations& equations, Met& met) {
    const Chart& chart = made.chart;
    Random random(made.seed);
    State state = power_on(chart);
    std::vector<std::int64_t> inputs = state.values;
    std::int64_t delay = 0;
    bool stopped = false;
    for (int k = 0; k < scans; ++k) {
        made.input += std::to_string(delay);
        for (const Equations::Variable& variable : equations.variables)
            for (const Id<Chart::Variable> id : chart.variables.ids())
                if (variable.role == Equations::Role::Input && chart.variables[id].name == variable.name)
                    made.input += ' ' + std::to_string(inputs[id.index]);
        made.input += '\n';
        if (stopped) continue;
        const Cycle run = cycle(chart, state, inputs, made.mode);
        meet(chart, state, run, met);
        made.printed.push_back(line_of(chart, equations, run));
        made.faults.push_back(fault_of(run));
        stopped = made.faults.back() != 0;
        for (const Id<Chart::Variable> id : chart.variables.ids()) {
            const Chart::Variable& variable = chart.variables[id];
            if (variable.kind == Chart::VariableKind::Input && chance(random, 40))
                inputs[id.index] = random_number(random, variable.type.low, variable.type.high);
        }
        delay = chance(random, 40) ? 500 * random_number(random, 1, 6) : 0;
        state = pass_time(run.state, delay);
    }
}

std::optional<Controller> controller_of(Chart chart, std::size_t number, ExecutionMode mode, std::uint64_t seed,
                                        Met& met) {
    chart.name = "c" + std::to_string(number);
    Diagnostics diagnostics;
    const auto equations = derive(chart, diagnostics);
    if (!equations || !controller::expressible(*equations, messages::not_in_c, diagnostics))
        return ++met.refused, std::nullopt;
    Controller made{std::move(chart), mode, seed, {}, {}, {}, {}};
    const controller::Code code = controller::code_of(*equations, {mode, 1000}, Target::C);
    made.code =
        c::header_of(code) + c::source_of(code, "") + driver(*equations, controller::names_of(*equations, Target::C));
    simulate(made, *equations, met);
    return made;
}

/// Compiles all controllers as one program and runs it. Returns the lines that it prints, or nothing after an error.
std::optional<std::vector<std::string>> compiled_and_run(const std::vector<Controller>& all, std::string& error) {
    std::string pattern = (fs::temp_directory_path() / "grafverif-c-XXXXXX").string();
    const fs::path folder = ::mkdtemp(pattern.data());
    std::ofstream source(folder / "all.c"), input(folder / "input");
    source << "#include <stdio.h>\n#include <stdlib.h>\n\nstatic long number(void)\n{\n    long read = 0;\n"
              "    if (scanf(\"%ld\", &read) != 1) {\n        exit(1);\n    }\n    return read;\n}\n\n";
    std::string calls;
    for (const Controller& one : all) {
        source << one.code << '\n';
        input << one.input;
        calls += "    run_" + one.chart.name + "();\n";
    }
    source << "int main(void)\n{\n" << calls << "    return 0;\n}\n";
    source.close();
    input.close();
    const std::string at = "cd " + folder.string() + " && ";
    const bool done = std::system((at + "cc -std=c99 -pedantic -Wall -Wextra -Wshadow -Wconversion -Werror "
                                        "-Wno-tautological-compare -O0 -o all all.c 2> errors")
                                      .c_str()) == 0 &&
                      std::system((at + "./all < input > output 2>> errors").c_str()) == 0;
    std::vector<std::string> lines;
    std::ifstream output(folder / (done ? "output" : "errors"));
    for (std::string line; std::getline(output, line);) lines.push_back(line);
    if (!done)
        for (std::size_t k = 0; k < std::min<std::size_t>(lines.size(), 20); ++k) error += lines[k] + '\n';
    fs::remove_all(folder);
    return done ? std::optional(std::move(lines)) : std::nullopt;
}

/// True if the code prints the line. If an evolution has several faults, any of them may be reported. After a fault,
/// only the outputs are compared.
bool agrees(const std::string& found, const std::string& expected, int fault) {
    if (fault == 0) return found == expected;
    const std::string outputs = expected.substr(1, expected.find(" steps") - 1);
    const bool same_fault = found[0] == expected[0] || (fault > 1 && found[0] > '1');
    return same_fault && found.substr(1, found.find(" steps") - 1) == outputs;
}

TEST(RandomizedCCode, CompiledControllersAgreeWithTheRulesOfTheStandard) {
    if (std::system("cc --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "there is no C compiler `cc`";
    Met met;
    std::vector<Controller> all;
    for (int seed = 1; seed <= test_size(80); ++seed) {
        Random random(static_cast<std::uint64_t>(seed) + 70000);
        const Chart chart = random_chart(random);
        for (const ExecutionMode mode : {ExecutionMode::StabilitySearch, ExecutionMode::EveryCycle})
            if (auto made = controller_of(chart, all.size(), mode, random(), met)) all.push_back(std::move(*made));
    }
    std::string error;
    const auto lines = compiled_and_run(all, error);
    ASSERT_TRUE(lines) << error;
    ASSERT_EQ(lines->size(), all.size() * scans);
    for (std::size_t k = 0; k < all.size(); ++k)
        for (std::size_t scan = 0; scan < all[k].printed.size(); ++scan)
            ASSERT_PRED3(agrees, (*lines)[k * scans + scan], all[k].printed[scan], all[k].faults[scan])
                << "scan " << scan + 1 << '\n'
                << all[k].input << chart_text(all[k].chart) << all[k].code;
    EXPECT_LT(met.refused, test_size(80));
    EXPECT_GT(met.transients, 20);
    EXPECT_GT(met.endless, 3);
    EXPECT_GT(met.races, 1);
    EXPECT_GT(met.out_of_range, 1);
    EXPECT_GT(met.outputs, 100);
    EXPECT_GT(met.timed, 20);
}

/// Declarations of a chart named `chart`. The declarations contain names that the code derives from
/// the name of the chart, and names of <stdint.h>.
constexpr std::string_view similar_names =
    "input chart_H, chart_inputs, uint16_t; output chart_timer, chart_MAX_EVOLUTIONS, int32_t; internal N: int 0..7;\n"
    "initial step 0 { int32_t; } step 1 { chart_timer if 1s/chart_H/2s; chart_MAX_EVOLUTIONS; }\n"
    "step 2 { N := N + 1 on activation; } transition a: 0 -> 1 when chart_H && 3s/X0;\n"
    "transition b: 1 -> 2 when uint16_t || chart_inputs; transition c: 2 -> 0 when N < 5;";

/// True if the compiler accepts `text` without warnings.
bool compiles(const std::string& compiler, const std::string& text) {
    FILE* input = ::popen((compiler + " -Wall -Wextra -Werror -fsyntax-only -").c_str(), "w");
    if (input == nullptr) return false;
    (void)std::fwrite(text.data(), 1, text.size(), input);
    return ::pclose(input) == 0;
}

TEST(CCodeNames, NamesOfTheChartDoNotConflictWithNamesOfTheCode) {
    const controller::Code code =
        controller::code_of(equations(similar_names), {ExecutionMode::StabilitySearch, 1000}, Target::C);
    const std::string text = c::header_of(code) + c::source_of(code, "");
    for (const char* name : {" chart_H;", " chart_inputs;", " chart_timer;", " chart_MAX_EVOLUTIONS;"})
        EXPECT_NE(text.find("    bool" + std::string(name)), std::string::npos) << name << text;
    for (const std::string compiler : {"cc -x c -std=c99 -pedantic -Wconversion", "c++ -x c++ -std=c++17"}) {
        if (std::system((compiler.substr(0, compiler.find(' ')) + " --version > /dev/null").c_str()) != 0) continue;
        EXPECT_TRUE(compiles(compiler, text)) << compiler << text;
    }
}

}  // namespace
}  // namespace grafverif
