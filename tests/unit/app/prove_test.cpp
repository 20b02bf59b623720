// SPDX-License-Identifier: MIT
// Tests `st --prove`: programs are written only if they are proved equivalent to their charts, and changes of a program
// are found.
#include "pipeline/program/prove.hpp"

#include <gtest/gtest.h>

#include <random>

#include "compare_programs.hpp"
#include "support/run_structured_text.hpp"

namespace grafverif::app {
namespace {

/// A chart with three evolutions per search, a stored integer and an edge.
const std::string stairs =
    "grafcet stairs {\n    input go, back;\n    output L, M;\n    internal N: int 0..3;\n\n    initial step 0;\n"
    "    step 1 { N := N + 1 on activation; }\n    step 2;\n"
    "    step 3 { L; M if N > 1; N := 0 on event rise(back); }\n\n"
    "    transition t0: 0 -> 1 when rise(go);\n    transition t1: 1 -> 2 when true;\n"
    "    transition t2: 2 -> 3 when true;\n    transition t3: 3 -> 0 when back && !go;\n}\n";

const std::string slow = with(lamp, "when off", "when off || 2s/X1");

TEST(Prove, ProvedProgramIsWritten) {
    const Folder folder;
    const std::string chart = folder.write("stairs.grafcet", stairs);
    for (const std::string format : {"text", "xml"}) {
        const std::string file = folder.file("stairs." + format);
        const Result result = grafverif({"st", chart, "--prove", "--format", format, "-o", file});
        EXPECT_EQ(result.code, ExitCode::Done) << result.out << result.err;
        EXPECT_TRUE(result.out.starts_with("`stairs` (a) and `stairs` (b): equal\n")) << result.out;
        EXPECT_NE(result.out.find("  b stops at the end of a scan if its output `FAULT` is not zero;"),
                  std::string::npos)
            << result.out;
        EXPECT_TRUE(result.out.ends_with("  the program executes at most 8 evolutions per scan\n")) << result.out;
        EXPECT_EQ(folder.read("stairs." + format),
                  grafverif({"st", chart, "--format", format, "--max-evolutions", "8"}).out);
    }
    const Result streamed = grafverif({"st", chart, "--prove", "--mode", "every-cycle", "--format", "text"});
    EXPECT_EQ(streamed.code, ExitCode::Done) << streamed.err;
    EXPECT_EQ(streamed.out, grafverif({"st", chart, "--mode", "every-cycle", "--format", "text"}).out);
    EXPECT_TRUE(streamed.err.starts_with("`stairs` (a) and `stairs` (b): equal\n")) << streamed.err;
}

TEST(Prove, ProgramThatStopsTooEarlyIsNotWritten) {
    const Folder folder;
    const std::string chart = folder.write("stairs.grafcet", stairs), file = folder.write("stairs.st", "old");
    const Result result = grafverif({"st", chart, "--prove", "--format", "text", "--max-evolutions", "3", "-o", file,
                                     "--depfile", folder.file("stairs.d")});
    EXPECT_EQ(result.code, ExitCode::Verdict) << result.out << result.err;
    EXPECT_NE(result.out.find("in the last scan, only `b` stops\n"), std::string::npos) << result.out;
    EXPECT_TRUE(result.out.ends_with("  the program is not proved equivalent to the chart, so it is not written\n"))
        << result.out;
    EXPECT_EQ(folder.read("stairs.st"), "old");
    EXPECT_EQ(folder.entries(), 2U) << "a depfile was written";
}

TEST(Prove, InconclusiveProofWritesNothing) {
    const Folder folder;
    const std::string chart = folder.write("slow.grafcet", slow);
    const Result result =
        grafverif({"st", chart, "--prove", "--format", "text", "--timeout", "100ms", "-o", folder.file("slow.st")});
    EXPECT_EQ(result.code, ExitCode::Unknown) << result.out << result.err;
    EXPECT_NE(result.out.find("inconclusive: "), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("a coarser `--resolution` makes the search smaller"), std::string::npos) << result.out;
    EXPECT_EQ(folder.entries(), 1U);
    const Result coarse =
        grafverif({"st", chart, "--prove", "--format", "text", "--resolution", "1s", "-o", folder.file("slow.st")});
    EXPECT_EQ(coarse.code, ExitCode::Done) << coarse.out << coarse.err;
    EXPECT_NE(coarse.out.find("scans occur at arbitrary multiples of 1s\n"), std::string::npos) << coarse.out;
    EXPECT_EQ(folder.entries(), 2U);
}

TEST(Prove, RenamedInputsAndOutputsAreCompared) {
    const Folder folder;
    const std::string chart = folder.write(
        "names.grafcet",
        "grafcet names { input ON, on, a__b; output Ausgabe_1, FAULT; initial step 0 { FAULT if on; Ausgabe_1 if ON || "
        "a__b; } }\n");
    for (const std::string dialect : {"codesys", "iec"}) {
        const Result result = grafverif(
            {"st", chart, "--prove", "--format", "text", "--dialect", dialect, "-o", folder.file("names.st")});
        EXPECT_EQ(result.code, ExitCode::Done) << result.out << result.err;
    }
    EXPECT_NE(folder.read("names.st").find("FAULT_2 : INT"), std::string::npos);
}

TEST(Prove, ChartThatCannotBeComparedIsAnError) {
    const Folder folder;
    const std::string chart = folder.write("none.grafcet", "grafcet none { input a; initial step 0; }\n");
    const Result result = grafverif({"st", chart, "--prove", "-o", folder.file("none.xml")});
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_NE(result.err.find("has no outputs and cannot be compared"), std::string::npos) << result.err;
    EXPECT_EQ(folder.entries(), 1U);
}

TEST(Prove, OptionsThatHaveNoEffectAreRejected) {
    EXPECT_NE(grafverif({"st", "a", "--resolution", "1s"}).err.find("`--resolution` requires `--prove`; add it"),
              std::string::npos);
    for (const std::string dialect : {"twincat", "siemens"}) {
        EXPECT_NE(grafverif({"st", "a", "--dialect", dialect, "--format", "xml"})
                      .err.find("`--format` applies only to the dialects `iec` and `codesys`; remove it"),
                  std::string::npos);
        EXPECT_NE(grafverif({"st", "a", "--dialect", dialect, "--prove"})
                      .err.find("`--prove` can read only the dialects `iec` and `codesys`"),
                  std::string::npos);
    }
    EXPECT_NE(grafverif({"st", "a", "--prove", "--sequence", "b"})
                  .err.find("`--prove` and `--sequence` are mutually exclusive; remove one"),
              std::string::npos);
}

// -- changes of the text ----------------------------------------------------------------------------------------------

/// The chart that a text is compared with.
struct Written {
    ParseResult reading = {};
    Id<Chart> chart = {};
    Equations equations = {};
    ProofOptions options = {};
    std::string text = {};
};

Written written(const std::string& text, ExecutionMode mode) {
    Written made{read_string(text, "chart", {}), {}, {}, {}, {}};
    EXPECT_TRUE(made.reading.model) << made.reading.diagnostics_text();
    made.chart = *made.reading.model->charts.ids().begin();
    made.equations = *equations_of(*made.reading.model, made.chart, made.reading.diagnostics);
    made.options = {.mode = mode, .form = structured_text::Form::Text, .max_evolutions = 5, .resolution_ms = 1000};
    made.text = proved_structured_text(*made.reading.model, made.chart, made.options, made.reading.sources,
                                       made.reading.diagnostics)
                    ->text;
    return made;
}

std::optional<Comparison> compared_with(Written& original, const std::string& text) {
    return compare_with_text(*original.reading.model, original.chart, original.equations, text, original.options,
                             original.reading.sources, original.reading.diagnostics);
}

/// True if the simulated PLC writes the same outputs with both texts in random scans, up to a stop of the first one.
bool behave_equally(const Written& original, const std::string& text) {
    std::mt19937_64 random(7);
    for (int run = 0; run < 40; ++run) {
        SmallPlc one({original.text}, original.equations.name), other({text}, original.equations.name);
        for (int scan = 0; scan < 12; ++scan) {
            for (const Equations::Variable& variable : original.equations.variables)
                if (variable.role == Equations::Role::Input) {
                    const auto value = static_cast<std::int64_t>(random() % 2);
                    one.set(variable.name, value);
                    other.set(variable.name, value);
                }
            one.call(1000 * scan);
            other.call(1000 * scan);
            if ((one.value("FAULT") != 0) != (other.value("FAULT") != 0)) return false;
            if (one.value("FAULT") != 0) break;
            for (const Equations::Variable& variable : original.equations.variables)
                if (variable.role == Equations::Role::Output && one.value(variable.name) != other.value(variable.name))
                    return false;
        }
    }
    return true;
}

/// Returns all texts in which one occurrence of `before` in the body is replaced.
std::vector<std::string> changed(const std::string& text, const std::string& before, const std::string& after) {
    std::vector<std::string> all;
    for (std::size_t at = text.find(before, text.find("<> 0 THEN RETURN")); at != std::string::npos;
         at = text.find(before, at + 1))
        all.push_back(std::string(text).replace(at, before.size(), after));
    return all;
}

using Change = std::pair<std::string, std::string>;

/// Compares each changed text with the chart. A text for which the simulated PLC shows a difference must not be proved.
void expect_found(ExecutionMode mode, const std::vector<Change>& changes, int& different, int& equal) {
    Written chart = written(stairs, mode);
    for (const auto& [before, after] : changes)
        for (const std::string& text : changed(chart.text, before, after)) {
            bool same = true;
            try {
                same = behave_equally(chart, text);
            } catch (const std::runtime_error&) {
                same = false;  // the simulated PLC does not accept the text
            }
            const auto found = compared_with(chart, text);
            const bool proved = found && found->outcome == Comparison::Outcome::Equal;
            EXPECT_FALSE(proved && !same) << before << " -> " << after << '\n' << text;
            (proved ? equal : different) += 1;
        }
}

TEST(Prove, ChangesOfTheTextAreFound) {
    int different = 0, equal = 0;
    expect_found(ExecutionMode::EveryCycle,
                 {{" AND ", " OR "}, {" OR ", " AND "}, {"NOT ", ""}, {":= TRUE", ":= FALSE"}, {" > ", " >= "}},
                 different, equal);
    expect_found(ExecutionMode::StabilitySearch, {{" > ", " >= "}, {"+ 1", "+ 2"}}, different, equal);
    EXPECT_GT(different, 2 * equal);
    EXPECT_GT(different, 20);
}

TEST(Prove, ChangedDurationIsFound) {
    Written chart = written(slow, ExecutionMode::EveryCycle);
    std::string text = chart.text;
    for (std::size_t at = text.find("T#2s"); at != std::string::npos; at = text.find("T#2s", at)) text[at + 2] = '3';
    const auto found = compared_with(chart, text);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->outcome, Comparison::Outcome::Different) << text;
}

TEST(Prove, DurationBetweenMultiplesOfTheResolutionIsNotProved) {
    Written chart = written(slow, ExecutionMode::EveryCycle);
    std::string text = chart.text;
    for (std::size_t at = text.find("T#2s"); at != std::string::npos; at = text.find("T#2s", at))
        text.replace(at, 4, "T#1500ms");
    const auto found = compared_with(chart, text);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->outcome, Comparison::Outcome::Unknown) << text;
    EXPECT_EQ(found->reason, "the duration 1500ms of the program is not a multiple of the resolution 1s");
}

}  // namespace
}  // namespace grafverif::app
