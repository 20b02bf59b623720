// SPDX-License-Identifier: MIT
#include "report/charts/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ostream>

#include "grafverif/ir/chart_run.hpp"
#include "report/table.hpp"
#include "report/terminal.hpp"
#include "support/json_text.hpp"
#include "support/printable.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

namespace {

/// Returns the value of a non-Boolean variable in the notation of programs: `3`, `T#1500ms`, `Heating`.
std::string value_text(const Comparison::Variable& variable, std::int64_t value) {
    if (variable.duration) return "T#" + duration_text(value);
    const bool named = value >= 0 && static_cast<std::size_t>(value) < variable.values.size();
    return named ? variable.values[static_cast<std::size_t>(value)] : std::to_string(value);
}

/// Returns the variables with nonzero values and all enumerations, such as `START, N = 3, Mode = Off`. If every
/// variable has the value 0 and is not an enumeration, returns `none`.
std::string standing(const std::vector<Comparison::Variable>& variables, const std::vector<std::int64_t>& values) {
    std::string text;
    for (std::size_t k = 0; k < variables.size(); ++k) {
        if (values[k] == 0 && variables[k].values.empty()) continue;
        text += (text.empty() ? "" : ", ") + variables[k].name;
        if (!variables[k].type.boolean) text += " = " + value_text(variables[k], values[k]);
    }
    return text.empty() ? "none" : text;
}

/// Returns the names of the outputs whose values in `a` and `b` differ.
std::string differing(const Comparison& comparison, const Comparison::ScanOutputs& a,
                      const Comparison::ScanOutputs& b) {
    std::string text;
    for (std::size_t k = 0; k < comparison.outputs.size(); ++k)
        if (a.outputs[k] != b.outputs[k]) text += (text.empty() ? "`" : ", `") + comparison.outputs[k].name + "`";
    return text;
}

std::string result_text(const Comparison& comparison, const Comparison::ScanOutputs& answer) {
    if (!answer.stop.empty()) return "stops: " + answer.stop;
    return standing(comparison.outputs, answer.outputs) + (answer.situation.empty() ? "" : "  in " + answer.situation);
}

/// Prints one row of the table of scans. Columns are separated by two blanks. An entry that is wider than its column is
/// wrapped.
void print_row(const std::array<std::string, 4>& cells, const std::array<std::size_t, 4>& widths, std::ostream& out) {
    std::array<std::vector<std::string>, 4> lines;
    std::size_t most = 1;
    for (std::size_t k = 0; k < cells.size(); ++k) {
        lines[k] = wrapped(printable(cells[k]), widths[k]);
        most = std::max(most, lines[k].size());
    }
    for (std::size_t line = 0; line < most; ++line) {
        std::string text = "  ";
        for (std::size_t k = 0; k < cells.size(); ++k)
            text += padded(line < lines[k].size() ? lines[k][line] : "", widths[k] + 2);
        out << text.substr(0, text.find_last_not_of(' ') + 1) << '\n';
    }
}

std::string_view sides_text(const Comparison& comparison) {
    if (comparison.programs[0] != comparison.programs[1]) return "the chart and the program";
    return comparison.programs[0] ? "the programs" : "the charts";
}

void print_scans(const Comparison& comparison, std::ostream& out) {
    std::vector<std::array<std::string, 4>> rows{{"time", "inputs", "a writes", "b writes"}};
    std::int64_t time = 0;
    for (std::size_t scan = 0; scan < comparison.scans.size(); ++scan) {
        if (scan > 0) time += comparison.scans[scan].wait_ms;
        rows.push_back({seconds_text(time), standing(comparison.inputs, comparison.scans[scan].inputs),
                        result_text(comparison, comparison.answers[0][scan]),
                        result_text(comparison, comparison.answers[1][scan])});
    }
    constexpr std::array<std::size_t, 4> most = {8, 24, 29, 29};
    std::array<std::size_t, 4> widths = {};
    for (const auto& row : rows)
        for (std::size_t k = 0; k < row.size(); ++k)
            widths[k] = std::min(most[k], std::max(widths[k], columns_of(row[k])));
    for (const auto& row : rows) print_row(row, widths, out);
    const Comparison::ScanOutputs &a = comparison.answers[0].back(), &b = comparison.answers[1].back();
    if (!a.stop.empty() && !b.stop.empty()) out << "  in the last scan, a and b both stop\n";
    else if (!a.stop.empty() || !b.stop.empty())
        out << fmt::format("  in the last scan, only `{}` stops\n", a.stop.empty() ? "b" : "a");
    else
        out << fmt::format("  in the last scan, {} differ in {}\n", sides_text(comparison),
                           printable(differing(comparison, a, b)));
}

std::string outcome_text(const Comparison& comparison, Colour colour) {
    const Outcome shown = comparison.outcome == Comparison::Outcome::Equal       ? Outcome::Holds
                          : comparison.outcome == Comparison::Outcome::Different ? Outcome::Violated
                                                                                 : Outcome::Unknown;
    return coloured(word(comparison.outcome), shown, colour);
}

bool has_program(const Comparison& comparison) { return comparison.programs[0] || comparison.programs[1]; }

/// Returns text that names the semantics under which the difference was replayed.
std::string_view replay_text(const Comparison& comparison) {
    if (!has_program(comparison)) return "under the rules of IEC 60848";
    return comparison.programs[0] && comparison.programs[1]
               ? "by the program interpreter"
               : "under the rules of IEC 60848 and by the program interpreter";
}

/// Returns text that defines the term "scan" for this comparison.
std::string scan_text(const Comparison& comparison) {
    if (!has_program(comparison)) return fmt::format("one PLC cycle, mode {}", word(comparison.mode));
    const bool with_chart = !comparison.programs[0] || !comparison.programs[1];
    std::string text =
        with_chart ? fmt::format("one PLC cycle of the chart, mode {}, and ", word(comparison.mode)) : "";
    text += with_chart ? "one execution of the program" : "one execution of each program";
    return text + (comparison.settles ? ", repeated with constant inputs and without delay until nothing changes" : "");
}

std::string names_text(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "`" : ", `") + name + "`";
    return text;
}

/// Prints the assumptions under which the verdict of the comparison is valid.
void print_basis(const Comparison& comparison, std::ostream& out) {
    out << "  a scan is " << scan_text(comparison);
    if (comparison.interval_ms) out << fmt::format("; scans occur every {}", duration_text(*comparison.interval_ms));
    else if (comparison.resolution_ms > 0)
        out << fmt::format("; scans occur at arbitrary multiples of {}", duration_text(comparison.resolution_ms));
    out << '\n';
    if (!comparison.from[0].empty())
        out << fmt::format("  a starts in {{{}}} and b in {{{}}}\n", printable(comparison.from[0]),
                           printable(comparison.from[1]));
    if (comparison.constrained) out << "  the constraints of both charts are assumed\n";
    for (const std::size_t k : {0U, 1U})
        if (!comparison.stop_outputs[k].empty())
            out << fmt::format(
                "  {} stops at the end of a scan if its output `{}` is not zero; outputs of this scan and of "
                "later scans are not compared\n",
                k == 0 ? "a" : "b", printable(comparison.stop_outputs[k]));
    if (!comparison.restricted.empty())
        out << "  these inputs of the program are restricted to the ranges of the chart's inputs: "
            << printable(names_text(comparison.restricted)) << '\n';
    if (!comparison.ignored.empty())
        out << "  these outputs are not compared: " << printable(names_text(comparison.ignored)) << '\n';
}

/// Returns the statement that is proved if no sequence of scans distinguishes the two sides.
std::string equality_text(const Comparison& comparison) {
    return fmt::format("for all inputs{}, a and b write the same outputs in every scan, or both stop in the same scan",
                       comparison.resolution_ms > 0 && !comparison.interval_ms ? " and all times between scans" : "");
}

void print_sentence(const Comparison& comparison, std::ostream& out) {
    const std::size_t scans = comparison.scans.size();
    switch (comparison.outcome) {
    case Comparison::Outcome::Equal: out << "  " << equality_text(comparison) << '\n'; return;
    case Comparison::Outcome::Different:
        out << fmt::format("  distinguished by {} scan{}{}, replayed {}:\n", scans, scans == 1 ? "" : "s",
                           comparison.shortest ? ", the minimum" : "", replay_text(comparison));
        return;
    case Comparison::Outcome::Unknown:
        out << fmt::format("  inconclusive: {}\n", printable(comparison.reason));
        if (comparison.faulty)
            out << fmt::format("  proved: {}\n  found: a run-time fault in scan {}, replayed {}:\n",
                               equality_text(comparison), scans, replay_text(comparison));
        return;
    }
}

nlohmann::ordered_json values_json(const std::vector<Comparison::Variable>& variables,
                                   const std::vector<std::int64_t>& values) {
    auto object = nlohmann::ordered_json::object();
    for (std::size_t k = 0; k < variables.size(); ++k)
        object[variables[k].name] = variables[k].type.boolean ? nlohmann::ordered_json(values[k] != 0)
                                    : variables[k].values.empty()
                                        ? nlohmann::ordered_json(values[k])
                                        : nlohmann::ordered_json(value_text(variables[k], values[k]));
    return object;
}

nlohmann::ordered_json scans_json(const Comparison& comparison) {
    auto scans = nlohmann::ordered_json::array();
    std::int64_t time = 0;
    for (std::size_t scan = 0; scan < comparison.scans.size(); ++scan) {
        if (scan > 0) time += comparison.scans[scan].wait_ms;
        nlohmann::ordered_json row = {{"wait_ms", comparison.scans[scan].wait_ms},
                                      {"time_ms", time},
                                      {"inputs", values_json(comparison.inputs, comparison.scans[scan].inputs)},
                                      {"answers", nlohmann::ordered_json::array()}};
        for (const auto& answers : comparison.answers)
            row["answers"].push_back(
                {{"outputs", answers[scan].stop.empty() ? values_json(comparison.outputs, answers[scan].outputs)
                                                        : nlohmann::ordered_json(nullptr)},
                 {"situation", text_or_null(answers[scan].situation)},
                 {"stop", text_or_null(answers[scan].stop)}});
        scans.push_back(std::move(row));
    }
    return scans;
}

}  // namespace

void print_changes(const std::vector<ChartChange>& changes, std::ostream& out) {
    for (const ChartChange& change : changes) {
        out << fmt::format("  {} {}: ", printable(change.subject), word(change.kind));
        if (change.before.empty() || change.after.empty())
            out << printable(change.before.empty() ? change.after : change.before) << '\n';
        else out << fmt::format("{}\n    now {}\n", printable(change.before), printable(change.after));
    }
}

void print_result(const Comparison& comparison, Colour colour, std::ostream& out) {
    out << fmt::format("`{}` (a) and `{}` (b): {}\n", printable(comparison.charts[0]), printable(comparison.charts[1]),
                       outcome_text(comparison, colour));
    print_sentence(comparison, out);
    if (!comparison.scans.empty()) print_scans(comparison, out);
    print_basis(comparison, out);
}

void print_comparison(const Comparison& comparison, Colour colour, std::ostream& out) {
    print_result(comparison, colour, out);
    if (has_program(comparison)) return;
    out << (comparison.changes.empty() ? "the texts differ at most in order and layout\n"
                                       : "differences between the texts, from a to b:\n");
    print_changes(comparison.changes, out);
}

std::string comparison_json(const Comparison& comparison) {
    nlohmann::ordered_json object = {{"charts", comparison.charts},
                                     {"programs", comparison.programs},
                                     {"mode", word(comparison.mode)},
                                     {"settled", comparison.settles},
                                     {"from", nullptr},
                                     {"resolution_ms", nullptr},
                                     {"interval_ms", nullptr},
                                     {"constrained", comparison.constrained},
                                     {"restricted", comparison.restricted},
                                     {"ignored", comparison.ignored},
                                     {"stop_outputs", nlohmann::ordered_json::array()},
                                     {"outcome", word(comparison.outcome)},
                                     {"reason", text_or_null(comparison.reason)},
                                     {"faulty", comparison.faulty},
                                     {"shortest", comparison.shortest},
                                     {"seconds", comparison.seconds},
                                     {"scans", scans_json(comparison)},
                                     {"changes", nlohmann::ordered_json::array()}};
    if (!comparison.from[0].empty()) object["from"] = comparison.from;
    if (comparison.resolution_ms > 0) object["resolution_ms"] = comparison.resolution_ms;
    if (comparison.interval_ms) object["interval_ms"] = *comparison.interval_ms;
    for (const std::string& output : comparison.stop_outputs) object["stop_outputs"].push_back(text_or_null(output));
    for (const ChartChange& change : comparison.changes)
        object["changes"].push_back({{"kind", word(change.kind)},
                                     {"subject", change.subject},
                                     {"before", text_or_null(change.before)},
                                     {"after", text_or_null(change.after)}});
    return json_text(object);
}

}  // namespace grafverif
