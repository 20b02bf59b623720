// SPDX-License-Identifier: MIT
// Randomized tests: the interpreter of PLC programs agrees with the equations of one scan in all variables, divisions
// by zero and overflows, scan by scan. Programs of ladder diagrams and Sequential Function Charts agree with a direct
// evaluation of the diagram.
#include "read/program/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>

#include "derive/program/scan.hpp"
#include "run/program/interpreter.hpp"
#include "support/random_codesys.hpp"
#include "support/random_diagram.hpp"
#include "support/random_program.hpp"
#include "support/random_sfc.hpp"
#include "support/row_counts.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

struct Met {
    int scans = 0, faults = 0, overflows = 0, timers = 0, changes = 0, intervals = 0, executions = 0;
};

std::string error_texts(const Diagnostics& diagnostics, const Sources& sources) {
    std::ostringstream text;
    render_text(diagnostics.all(), sources, Colour::Plain, text);
    return text.str();
}

/// The executed statements and the decided conditions of a scan, with their values.
using Executed = std::multiset<std::tuple<bool, std::uint32_t, std::int64_t>>;

Executed executed(const Scan& scan, const std::vector<std::optional<std::int64_t>>& terms) {
    Executed found;
    for (const Scan::Execution& each : scan.executions)
        if (terms[each.reached.index] == 1)
            found.emplace(each.node.valid(), each.node.valid() ? each.node.index : each.statement.index,
                          each.value.valid() ? terms[each.value.index].value() : 1);
    return found;
}

/// Returns the executed statements and decided conditions according to the log of the interpreter. The test compares
/// only data that the log and the equations both contain: a log contains neither the branches nor
/// the iterations of a statement, and records a condition that is a variable as a read variable.
Executed executed(const Program& program, const ScanLog& log, const Scan& scan, Executed& of_terms) {
    using Kind = Program::Statement::Kind;
    std::set<std::uint32_t> conditions;
    for (const Scan::Execution& each : scan.executions)
        if (each.node.valid() && program.nodes[each.node].op != Program::Op::Read) conditions.insert(each.node.index);
    const auto is_compared = [&](bool condition, std::uint32_t index) {
        if (condition) return conditions.contains(index);
        const Kind kind = program.statements[Id<Program::Statement>{index}].kind;
        return kind == Kind::Assign || kind == Kind::Invoke || kind == Kind::Exit || kind == Kind::Return;
    };
    Executed found;
    for (const auto& each : log.statements)
        if (is_compared(false, each.id.index)) found.emplace(false, each.id.index, each.value);
    for (const auto& each : log.nodes)
        if (is_compared(true, each.id.index)) found.emplace(true, each.id.index, each.value);
    std::erase_if(of_terms, [&](const auto& each) { return !is_compared(std::get<0>(each), std::get<1>(each)); });
    return found;
}

/// Returns the first disagreement of a run, or an empty string.
std::string disagreement(const Program& program, const Scan& scan, Random& random, Met& met) {
    ProgramRun run(program);
    const std::size_t cells = scan.layout.cells.size();
    for (int count = 0; count < 25; ++count) {
        const std::vector<std::int64_t> before(run.cells().begin(), run.cells().end());
        std::vector<std::int64_t> inputs, values(scan.equations.variables.size());
        for (std::size_t i = 0; i < cells; ++i) {
            std::int64_t value = before[i];
            if (scan.layout.cells[i].input) {
                const Program::Type& type = program.types[scan.layout.cells[i].type];
                if (chance(random, 40))
                    value = random_number(random, chance(random, 80) ? std::max<std::int64_t>(type.low, -4) : type.low,
                                          chance(random, 80) ? std::min<std::int64_t>(type.high, 4) : type.high);
                inputs.push_back(value);
            }
            if (scan.variables[i].valid()) values[scan.variables[i].index] = value;
        }
        std::int64_t elapsed = program.interval_ms.value_or(random_number(random, 0, 15));
        if (scan.elapsed.valid()) values[scan.elapsed.index] = std::min(elapsed, scan.layout.longest);
        ScanLog log;
        run.scan(inputs, elapsed, &log);
        const auto terms = evaluate_all(scan.equations.exprs,
                                        [&](const Expr& leaf) { return values[static_cast<std::size_t>(leaf.value)]; });
        const auto occurs = [&](const std::vector<Scan::Event>& events) {
            return std::ranges::any_of(events,
                                       [&](const Scan::Event& event) { return terms[event.condition.index] == 1; });
        };
        const std::string where = " in scan " + std::to_string(count + 1);
        ++met.scans;
        if (run.fault().has_value() != occurs(scan.faults)) return "a division by zero" + where;
        if (run.fault()) return ++met.faults, std::string();
        if (run.overflowed() != occurs(scan.overflows)) return "an overflow" + where;
        Executed of_terms = executed(scan, terms);
        const Executed of_log = executed(program, log, scan, of_terms);
        if (!scan.executions.empty() && of_terms != of_log) return "the executed statements" + where;
        met.executions += static_cast<int>(of_terms.size());
        met.overflows += run.overflowed() ? 1 : 0;
        met.timers += scan.layout.timers.empty() ? 0 : 1;
        met.intervals += program.interval_ms ? 1 : 0;
        for (std::size_t i = 0; i < cells; ++i) {
            if (scan.layout.cells[i].temporary) continue;  // the cell does not outlive the call
            if (terms[scan.after[i].index] != run.cells()[i])
                return scan.layout.cells[i].name + where + ": the equations give " +
                       (terms[scan.after[i].index] ? std::to_string(*terms[scan.after[i].index]) : "nothing") +
                       ", the interpreter " + std::to_string(run.cells()[i]);
            met.changes += run.cells()[i] != before[i] ? 1 : 0;
        }
    }
    return {};
}

TEST(RandomizedProgram, InterpreterAgreesWithEquations) {
    Met met;
    const int programs = test_size(400);
    for (int seed = 0; seed < programs; ++seed) {
        Random random(static_cast<unsigned>(seed));
        const std::string text = random_program(random);
        Sources sources;
        Diagnostics diagnostics;
        const auto read = read_program(sources.add({"random.st", text}), sources, diagnostics);
        ASSERT_TRUE(read) << "seed " << seed << '\n' << error_texts(diagnostics, sources) << text;
        const auto scan = scan_of(read->program(), diagnostics, true);
        ASSERT_TRUE(scan) << "seed " << seed << '\n' << error_texts(diagnostics, sources) << text;
        ASSERT_EQ(verify(scan->equations), std::vector<std::string>()) << text;
        ASSERT_EQ(disagreement(read->program(), *scan, random, met), "") << "seed " << seed << '\n' << text;
    }
    for (const int count :
         {met.scans, met.faults, met.overflows, met.timers, met.changes, met.intervals, met.executions})
        EXPECT_GT(count, programs / 100);
}

TEST(RandomizedProgram, LadderDiagramsAgreeWithTheirRungs) {
    std::map<std::string, int> seen;
    Met met;
    for (int seed = 1; seed <= test_size(200); ++seed) {
        Random random(static_cast<unsigned>(seed));
        Rungs rungs = random_rungs(random);
        const std::string text = xml_of(rungs, random);
        Sources sources;
        Diagnostics diagnostics;
        const auto read = read_program(sources.add({"random.xml", text}), sources, diagnostics);
        ASSERT_TRUE(read) << "seed " << seed << '\n' << error_texts(diagnostics, sources) << text;
        const auto equations = scan_of(read->program(), diagnostics);
        ASSERT_TRUE(equations) << "seed " << seed << '\n' << error_texts(diagnostics, sources) << text;
        ASSERT_EQ(disagreement(read->program(), *equations, random, met), "") << "seed " << seed << '\n' << text;
        ProgramRun run(read->program());
        std::vector<std::int64_t> inputs(Rungs::inputs);
        for (int scan = 1; scan <= 20; ++scan) {
            for (std::int64_t& input : inputs) input = chance(random, 40) ? 1 - input : input;
            const std::vector<bool> before = rungs.values;
            run.scan(inputs, 10);
            rungs.scan(inputs);
            for (std::size_t i = Rungs::inputs; i < rungs.values.size(); ++i) {
                const auto cell = std::ranges::find(run.layout().cells, diagram_variable(i), &ProgramCell::name);
                ASSERT_NE(cell, run.layout().cells.end()) << diagram_variable(i);
                const bool value = run.cells()[static_cast<std::size_t>(cell - run.layout().cells.begin())] != 0;
                ASSERT_EQ(value, rungs.values[i])
                    << "seed " << seed << ", scan " << scan << ", " << diagram_variable(i) << '\n'
                    << text;
                if (rungs.values[i] != before[i]) ++seen["changes of outputs"];
            }
        }
        for (const Rungs::Rung& rung : rungs.rungs) ++seen[rung.latch ? "latches" : "rungs without latch"];
    }
    print_counts(seen);
    EXPECT_GT(seen["changes of outputs"], test_size(100));
    EXPECT_GT(seen["latches"], test_size(20));
}

std::int64_t value_of(const ProgramRun& run, const std::string& name) {
    const auto cell = std::ranges::find(run.layout().cells, name, &ProgramCell::name);
    EXPECT_NE(cell, run.layout().cells.end()) << name;
    if (cell == run.layout().cells.end()) return -1;
    return run.cells()[static_cast<std::size_t>(cell - run.layout().cells.begin())];
}

/// Returns the first variable whose value differs, or an empty string.
std::string difference(const ProgramRun& run, const RandomSfc& chart) {
    for (std::size_t i = 0; i < chart.steps.size(); ++i) {
        const std::string name = "S" + std::to_string(i) + ".X";
        if (value_of(run, name) != (chart.steps[i].active ? 1 : 0)) return name;
    }
    for (std::size_t i = 0; i < chart.actions.size(); ++i) {
        const RandomSfc::Action& action = chart.actions[i];
        const std::string index = std::to_string(i), q = "v" + index + (action.variable ? "" : ".Q");
        if ((action.variable || action.used) && value_of(run, q) != (action.q ? 1 : 0)) return q;
        if (action.variable) continue;
        if (value_of(run, "c" + index) != action.count) return "c" + index;
        if (value_of(run, "m" + index) != (action.copy ? 1 : 0)) return "m" + index;
    }
    return {};
}

TEST(RandomizedProgram, SequentialFunctionChartsAgreeWithTheirRules) {
    std::map<std::string, int> seen;
    Met met;
    for (int seed = 1; seed <= test_size(300); ++seed) {
        Random random(static_cast<unsigned>(seed));
        RandomSfc chart = random_sfc(random);
        const bool drawn = chance(random, 40);
        const std::string text = drawn ? chart.xml(random) : chart.text();
        Sources sources;
        Diagnostics diagnostics;
        const auto read = read_program(sources.add({drawn ? "random.xml" : "random.st", text}), sources, diagnostics);
        ASSERT_TRUE(read) << "seed " << seed << '\n' << error_texts(diagnostics, sources) << text;
        const auto equations = scan_of(read->program(), diagnostics);
        ASSERT_TRUE(equations) << "seed " << seed << '\n' << error_texts(diagnostics, sources) << text;
        ASSERT_EQ(disagreement(read->program(), *equations, random, met), "") << "seed " << seed << '\n' << text;
        ++seen[drawn ? "drawn charts" : "textual charts"];
        ProgramRun run(read->program());
        std::vector<std::int64_t> inputs(RandomSfc::inputs);
        for (int scan = 1; scan <= 60; ++scan) {
            for (std::int64_t& input : inputs) input = chance(random, 40) ? 1 - input : input;
            const std::int64_t elapsed = random_number(random, 0, 15);
            run.scan(inputs, elapsed);
            chart.scan(inputs, elapsed);
            ASSERT_EQ(difference(run, chart), "") << "seed " << seed << ", scan " << scan << '\n' << text;
            seen["cleared transitions"] += chart.cleared;
            seen["simultaneous clearing"] += chart.cleared > 1 ? 1 : 0;
            seen["selections"] += chart.selected ? 1 : 0;
            for (const RandomSfc::Action& action : chart.actions) {
                if (action.q && !action.timed.empty()) ++seen["actions with " + action.timed];
                if (action.q) ++seen["actions"];
                if (!action.q && action.executed) ++seen["final scans"];
            }
        }
    }
    print_counts(seen);
    for (const char* what :
         {"cleared transitions", "simultaneous clearing", "selections", "actions", "final scans", "actions with L",
          "actions with D", "actions with SD", "actions with DS", "actions with SL"})
        EXPECT_GT(seen[what], test_size(100)) << what;
}

TEST(RandomizedProgram, ChartsOfCodesysAgreeWithItsDocumentation) {
    std::map<std::string, int> seen;
    Met met;
    for (int seed = 1; seed <= test_size(300); ++seed) {
        Random random(static_cast<unsigned>(seed));
        RandomCodesys charts = random_codesys(random);
        const std::string text = charts.xml();
        Sources sources;
        Diagnostics diagnostics;
        const auto read = read_program(sources.add({"random.xml", text}), sources, diagnostics);
        ASSERT_TRUE(read) << "seed " << seed << '\n' << error_texts(diagnostics, sources) << text;
        const auto equations = scan_of(read->program(), diagnostics);
        ASSERT_TRUE(equations) << "seed " << seed << '\n' << error_texts(diagnostics, sources) << text;
        ASSERT_EQ(disagreement(read->program(), *equations, random, met), "") << "seed " << seed << '\n' << text;
        ProgramRun run(read->program());
        std::vector<std::int64_t> inputs(4);
        for (int scan = 1; scan <= 60; ++scan) {
            for (std::int64_t& input : inputs) input = chance(random, 40) ? 1 - input : input;
            if (chance(random, 80)) inputs[3] = 0;
            const std::int64_t elapsed = random_number(random, 0, 15);
            run.scan(inputs, elapsed);
            charts.scan(inputs, elapsed);
            const std::string where = "seed " + std::to_string(seed) + ", scan " + std::to_string(scan) + '\n' + text;
            ASSERT_EQ(value_of(run, "log"), charts.log) << where;
            for (const char* name : {"v0", "v1", "v2"})
                ASSERT_EQ(value_of(run, name), charts.values[name] ? 1 : 0) << name << ", " << where;
            for (std::size_t c = 0; c < charts.charts.size(); ++c)
                for (std::size_t i = 0; i < charts.charts[c].steps.size(); ++i) {
                    const std::string step = "Chart" + std::to_string(c) + ".S" + std::to_string(i);
                    ASSERT_EQ(value_of(run, step + ".X"), charts.charts[c].steps[i].active ? 1 : 0)
                        << step << ", " << where;
                }
        }
        seen["cleared transitions"] += charts.cleared;
        seen["ends of actions"] += charts.ends;
        seen["exit actions"] += charts.exits;
        seen["resets"] += charts.resets;
    }
    print_counts(seen);
    for (const auto& [what, count] : seen) EXPECT_GT(count, test_size(100)) << what;
}

}  // namespace
}  // namespace grafverif
