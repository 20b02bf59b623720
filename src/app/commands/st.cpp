// SPDX-License-Identifier: MIT
// `st` and `c`: write a chart as a PLC program or in C. `st` also writes a test of the chart.
#include <filesystem>
#include <ostream>
#include <sstream>

#include "app/commands.hpp"
#include "app/outputs.hpp"
#include "app/stop_text.hpp"
#include "app/system/watchdog.hpp"
#include "pipeline/files.hpp"
#include "pipeline/models.hpp"
#include "pipeline/program/prove.hpp"
#include "report/charts/comparison.hpp"

namespace grafverif::app {

namespace {

std::uint32_t max_evolutions(const Options& options) {
    return static_cast<std::uint32_t>(options.st.max_evolutions.value_or(1000));
}

/// Writes the program if it is proved equivalent to the chart. Always prints the result of the
/// comparison: to standard output, or to standard error if the program is written to standard
/// output.
ExitCode write_if_proved(const Model& model, Id<Chart> chart, CommandContext& job, const Streams& streams) {
    const ResourceLimits bounds(job.options, streams);
    ProofOptions how{.mode = execution_mode(model, chart, job),
                     .form = structured_text_form(job.options),
                     .dialect = job.options.st.dialect,
                     .limits = bounds.limits()};
    if (const auto most = job.options.st.max_evolutions) how.max_evolutions = static_cast<std::uint32_t>(*most);
    if (const auto time = job.options.resolution_ms) how.resolution_ms = static_cast<std::int64_t>(*time);
    auto found = proved_structured_text(model, chart, how, job.sources, job.diagnostics);
    if (!found) return ExitCode::Input;
    Comparison& comparison = found->comparison;
    comparison.reason = with_who_stopped(std::move(comparison.reason), bounds.interrupted(), job.options);
    const ExitCode code = app::exit_code(comparison);
    const bool to_output = !job.options.output || names_output(*job.options.output);
    std::ostream& out = to_output ? streams.err : streams.out;
    std::ostringstream text;
    print_result(comparison, colour_on(to_output ? streams.err_screen : streams.out_screen, job.options), text);
    if (how.mode == ExecutionMode::StabilitySearch && code == ExitCode::Done)
        text << "  the program executes at most " << found->max_evolutions << " evolutions per scan\n";
    if (code != ExitCode::Done) text << "  the program is not proved equivalent to the chart, so it is not written\n";
    work_is_done();
    out << std::move(text).str();
    print_failures(comparison.failures, streams);
    if (code == ExitCode::Done) deliver(found->text, job, streams);
    else job.options.depfile.reset();
    return code;
}

}  // namespace

ExitCode st(CommandContext& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    const auto chart = model ? chosen_chart(*model, job) : std::nullopt;
    if (chart && job.options.st.prove) return write_if_proved(*model, *chart, job, streams);
    const auto found = chart ? equations_of(*model, *chart, job) : std::nullopt;
    if (!found) return ExitCode::Input;
    std::string text;
    if (!job.options.sequence) {
        text = structured_text_of(*found,
                                  {execution_mode(*model, *chart, job), max_evolutions(job.options),
                                   structured_text_form(job.options), job.options.st.dialect},
                                  job.diagnostics)
                   .value_or("");
    } else if (const auto sequence = test_sequence(*model, *chart, job)) {
        text = structured_text_test(*sequence, structured_text_form(job.options));
    }
    if (!job.diagnostics.has_errors()) deliver(text, job, streams);
    return ExitCode::Done;
}

namespace {

/// True if no header can be written next to the output, because the output is a stream or a special file such as
/// `/dev/null`.
bool receives_both_files(const std::string& output) {
    if (names_output(output) || own_descriptor(output)) return true;
    std::error_code failure;
    const std::filesystem::file_status status = std::filesystem::status(output, failure);
    return std::filesystem::is_other(status);
}

}  // namespace

ExitCode c(CommandContext& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    const auto chart = model ? chosen_chart(*model, job) : std::nullopt;
    const auto found = chart ? equations_of(*model, *chart, job) : std::nullopt;
    if (!found) return ExitCode::Input;
    const std::string output = job.options.output.value_or("-");
    const bool one_file = receives_both_files(output);
    const std::filesystem::path header = std::filesystem::path(output).replace_extension(".h");
    const auto code = c_code_of(*found, execution_mode(*model, *chart, job), max_evolutions(job.options),
                                one_file ? "" : header.filename().string(), job.diagnostics);
    if (!code) return ExitCode::Input;
    std::vector<OutputFile> files = {{output, one_file ? code->header + '\n' + code->source : code->source}};
    if (!one_file) files.push_back({header, code->header});
    return write_outputs(files, job, streams) ? ExitCode::Done : ExitCode::Input;
}

CliCommand c_usage() {
    return {
        "c",
        "FILE",
        1,
        1,
        "generate C99 for a chart",
        "Writes a chart of FILE as a controller in C99, with the statements of the function block that `st` writes.\n"
        "With -o NAME.c, the header is NAME.h. Without -o, code and header are written to standard output as one\n"
        "file. NAME_init sets the state at power-on. NAME_scan executes one PLC cycle; its arguments are the state,\n"
        "the inputs and the time since the previous cycle. The code uses only <stdbool.h> and <stdint.h>, and\n"
        "allocates no memory.",
        {"grafverif c samples/tanks/tanks.grafcet -o tanks.c",
         "grafverif c samples/tanks/tanks.grafcet --mode every-cycle"},
        {OptionGroup::Output, OptionGroup::Chart, OptionGroup::Mode, OptionGroup::MaxEvolutions}};
}

CliCommand st_usage() {
    return {
        "st",
        "FILE",
        1,
        1,
        "generate Structured Text for a chart, or a test program",
        "Writes a chart of FILE as a function block in Structured Text (IEC 61131-3), generated from the equations\n"
        "of the chart. One call of the block is one PLC cycle. With --sequence, `st` writes a program that executes\n"
        "the test on this function block, one scan per call, and compares its outputs in each scan. Formats: PLCopen\n"
        "XML (TC6 2.01), text.\n"
        "\n"
        "The dialects `twincat` (a .TcPOU file) and `siemens` (a source in SCL for TIA Portal) have their own "
        "formats.\n"
        "The dialect `codesys` has the formats of `iec`; only its reserved words differ.\n"
        "\n"
        "With --prove, `st` reads the generated text as a PLC program and compares it with the chart, as `compare`\n"
        "does. The text is written only if program and chart are proved equivalent. Exit code 1: different; 3:\n"
        "inconclusive (--timeout, --max-memory, Ctrl-C). With exit codes 1 and 3, no program is written. If\n"
        "--prove is given without --max-evolutions, the limit of evolutions per scan is the smallest of 8, 16, ...,\n"
        "128 with which the program completes every scan that the chart completes.",
        {"grafverif st samples/tanks/tanks.grafcet -o tanks.xml",
         "grafverif st samples/tanks/tanks.grafcet --mode every-cycle --format text",
         "grafverif st samples/tanks/tanks.grafcet --prove -o tanks.xml",
         "grafverif st samples/tanks/tanks.grafcet --dialect siemens -o tanks.scl",
         "grafverif st samples/tanks/tanks.grafcet --sequence samples/tanks/table2.csv -o test.xml"},
        {OptionGroup::Output, OptionGroup::Chart, OptionGroup::Mode, OptionGroup::FormatXml, OptionGroup::Sequence,
         OptionGroup::MaxEvolutions, OptionGroup::StructuredText}};
}

}  // namespace grafverif::app
