// SPDX-License-Identifier: MIT
// Fuzz targets that read tables and lines: tests and exclusions in CSV, recordings, lines of the test protocol, and
// interactive commands.
#include <sstream>

#include "fuzz/common.hpp"
#include "fuzz/targets.hpp"
#include "read/exclusions.hpp"
#include "read/test_csv.hpp"
#include "read/text.hpp"
#include "syntax/print/scan_line.hpp"
#include "syntax/print/test_csv.hpp"
#include "unit/app/run_program.hpp"

namespace grafverif::fuzz {

namespace {

const Chart& press() {
    static const Model model = [] {
        const std::string text = press_text;
        Sources sources;
        Diagnostics diagnostics;
        return *read_text(sources.add({"press.grafcet", text.substr(0, text.find("closed_loop"))}), sources, {},
                          diagnostics);
    }();
    return *model.charts.begin();
}

/// Checks that messages about unknown lines contain no control characters.
std::string session_complaint(std::vector<std::string> words, std::string_view typed) {
    static const app::Folder folder;
    static const std::string file = folder.write("press.grafcet", press_text);
    words.insert(words.begin() + 1, file);
    const app::Result result = app::grafverif(words, std::string(typed));
    if (result.code == app::ExitCode::Failure) return "internal error:\n" + result.out + result.err;
    for (const std::string* text : {&result.out, &result.err})
        for (const char byte : *text)
            if (byte != '\n' && static_cast<unsigned char>(byte) < ' ') return "a control character in:\n" + *text;
    return {};
}

}  // namespace

std::string test_table_complaint(std::string_view bytes) {
    for (const ExecutionMode mode : {ExecutionMode::StabilitySearch, ExecutionMode::EveryCycle}) {
        Sources sources;
        Diagnostics diagnostics;
        const auto test =
            read_test_csv(sources.add({"fuzzed.csv", std::string(bytes)}), sources, press(), mode, diagnostics);
        const std::string rendered = shown(diagnostics, sources);
        if (test.has_value() == diagnostics.has_errors())
            return "the result and the diagnostics contradict each other:\n" + rendered;
        if (!test) continue;
        for (const std::string& broken : verify(*test)) return "not well formed: " + broken;
        std::ostringstream written;
        print_test_csv(written, *test);
        Diagnostics none;
        const auto again = read_test_csv(sources.add({"written.csv", written.str()}), sources, press(), mode, none);
        if (!again) return "the written table is rejected:\n" + shown(none, sources) + written.str();
        if (*again != *test) return "the written table has another meaning:\n" + written.str();
    }
    return {};
}

std::string exclusions_complaint(std::string_view bytes) {
    Sources sources;
    Diagnostics diagnostics;
    const Id<Source> source = sources.add({"fuzzed.csv", std::string(bytes)});
    const auto rows = read_exclusions(source, sources, press(), diagnostics);
    const std::string rendered = shown(diagnostics, sources);
    if (rows.has_value() == diagnostics.has_errors())
        return "the result and the diagnostics contradict each other:\n" + rendered;
    if (!rows) return {};
    for (const ExclusionRow& row : *rows) {
        if (row.first == row.second) return "an input that excludes itself";
        for (const auto input : {row.first, row.second})
            if (press().variables[input].kind != Chart::VariableKind::Input || !press().variables[input].type.boolean)
                return "an exclusion of a variable that is not a Boolean input";
    }
    return {};
}

std::string scan_complaint(std::string_view bytes) {
    const std::vector<ScanColumn> columns{{"start", {}}, {"level", integer_type(-2, 300)}, {"stop", {}}};
    const ScanValues read = read_scan_line(bytes, columns);
    if (read.values.has_value() != read.problem.empty())
        return "the result and the error contradict each other: " + read.problem;
    for (const std::string& text : {shown_line(bytes), read.problem})
        for (const char byte : text)
            if (byte < ' ' || byte > '~') return "a displayed line is not printable: " + text;
    if (!read.values) return {};
    if (bytes.size() > longest_scan_line(columns.size())) return "a line that is too long is accepted";
    const std::string written = scan_line(*read.values);
    if (read_scan_line(written, columns).values != read.values)
        return "the written line has another meaning: " + written;
    return {};
}

std::string plc_complaint(std::string_view bytes) { return session_complaint({"plc"}, bytes); }
std::string monitor_complaint(std::string_view bytes) {
    const std::string complaint = session_complaint({"monitor"}, bytes);
    return complaint.empty() ? session_complaint({"replay", "--log=-"}, bytes) : complaint;
}

std::string simulate_complaint(std::string_view bytes) { return session_complaint({"simulate"}, bytes); }

}  // namespace grafverif::fuzz
