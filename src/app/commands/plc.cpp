// SPDX-License-Identifier: MIT
// `plc`: executes a chart as a PLC does, on standard input and output. The command can be the controller under test for
// `test --against`. One line of inputs is one scan: the inputs are read, the situation becomes stable if the mode
// requires it, and the outputs are written.
#include <fmt/format.h>

#include <chrono>
#include <istream>
#include <ostream>

#include "app/commands.hpp"
#include "run/scanner.hpp"
#include "simulate/commands.hpp"
#include "syntax/print/scan_line.hpp"

namespace grafverif::app {

namespace {

std::vector<ScanColumn> scan_columns(const Chart& chart, const Scanner& plc) {
    std::vector<ScanColumn> columns;
    for (const Id<Chart::Variable> id : plc.inputs())
        columns.push_back({chart.variables[id].name, chart.variables[id].type});
    return columns;
}

/// Reads the next line; returns false at the end of the input. At most `longest` + 1 characters are stored, so that the
/// caller can detect a line that is too long.
bool next_line(std::istream& in, std::size_t longest, std::string& line) {
    line.clear();
    std::streambuf& bytes = *in.rdbuf();
    int byte = bytes.sbumpc();
    if (byte == std::char_traits<char>::eof()) return false;
    for (; byte != std::char_traits<char>::eof() && byte != '\n'; byte = bytes.sbumpc())
        if (line.size() <= longest) line += static_cast<char>(byte);
    return true;
}

/// Executes each valid line. The response to an invalid line is an error message.
class PlcSession {
public:
    PlcSession(const Chart& chart, ExecutionMode mode, Clock clock, const Streams& streams)
        : plc_(chart, mode), columns_(scan_columns(chart, plc_)), clock_(clock), streams_(streams) {}

    ExitCode run() {
        const std::size_t longest = longest_scan_line(columns_.size());
        for (std::string line; code_ != ExitCode::Verdict && next_line(streams_.in, longest, line);) {
            ++number_;
            if (line.size() > longest) refuse(fmt::format("the line is longer than {} bytes; shorten it", longest));
            else execute(line);
            streams_.out << std::flush;
            if (!streams_.out) break;
        }
        return code_;
    }

private:
    using Steady = std::chrono::steady_clock;

    void execute(const std::string& line) {
        if (line.starts_with("wait")) return execute_wait(line);
        const ScanValues inputs = read_scan_line(line, columns_);
        if (!inputs.values) return refuse(inputs.problem);
        if (clock_ == Clock::Real) elapse_real_time();
        const std::string problem = plc_.scan(*inputs.values);
        if (problem.empty()) streams_.out << scan_line(plc_.outputs()) << '\n';
        else fail(problem, ExitCode::Verdict);
    }

    void execute_wait(const std::string& line) {
        const Command command = command_of(line);
        const WaitCommand* const wait = std::get_if<WaitCommand>(&command);
        if (clock_ == Clock::Real) refuse("`wait` requires `--clock simulated`; use this option, or remove `wait`");
        else if (wait == nullptr || !wait->milliseconds)
            refuse("`wait` requires a duration; write `3s`, `250ms` or `2min`, for example");
        else plc_.wait(*wait->milliseconds);
    }

    void elapse_real_time() {
        const Steady::time_point now = Steady::now();
        const auto passed = std::chrono::duration_cast<std::chrono::milliseconds>(now - last_);
        plc_.wait(passed.count());
        last_ += passed;
    }

    void refuse(const std::string& problem) { fail(problem, ExitCode::Input); }

    void fail(const std::string& problem, ExitCode code) {
        streams_.out << "error: " << problem << '\n';
        streams_.err << fmt::format("grafverif: line {}: error: {}\n", number_, problem);
        code_ = code;
    }

    Scanner plc_;
    std::vector<ScanColumn> columns_;
    Clock clock_;
    const Streams& streams_;
    Steady::time_point last_ = Steady::now();
    std::size_t number_ = 0;
    ExitCode code_ = ExitCode::Done;
};

}  // namespace

ExitCode plc(CommandContext& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    const auto chart = model ? chosen_chart(*model, job) : std::nullopt;
    if (!chart || !equations_of(*model, *chart, job)) return ExitCode::Input;
    return PlcSession(model->charts[*chart], execution_mode(*model, *chart, job), job.options.clock, streams).run();
}

CliCommand plc_usage() {
    return {
        "plc",
        "FILE",
        1,
        1,
        "execute a chart as a PLC would; read inputs from standard input, write outputs to standard output",
        "Executes a chart of FILE as a PLC would: each line of standard input has the inputs of one scan, in the order "
        "of their\n"
        "declaration; the response is one line with the outputs, in the same order. Booleans are 0 and 1.\n"
        "  1,0,0,1,1          a scan with these inputs (commas or blanks)\n"
        "  wait 5s            time passes before the next scan; no response\n"
        "The response to an invalid line is `error: ...`, without a scan. After total instability, a race or an "
        "out-of-range\n"
        "value, the response is `error: ...` and the program exits with code 1.",
        {"grafverif plc station.grafcet --chart testing_station --mode every-cycle < inputs.csv",
         "printf '0,0,0,1,1\\n1,1,0,1,1\\n' | grafverif plc samples/tanks/tanks.grafcet"},
        {OptionGroup::Chart, OptionGroup::Mode, OptionGroup::Clock}};
}

}  // namespace grafverif::app
