// SPDX-License-Identifier: MIT
// `testgen`: generates a test sequence for a PLC program. The interpreter must pass each sequence before it is written.
#include <fmt/format.h>

#include <ostream>
#include <sstream>

#include "app/commands.hpp"
#include "conform/test_sequence.hpp"
#include "pipeline/models.hpp"
#include "run/replay_test.hpp"
#include "syntax/print/automaton.hpp"
#include "syntax/print/test_csv.hpp"

namespace grafverif::app {

namespace {

std::string written(const TestSequence& test, const CommandContext& job) {
    if (job.options.format == Format::Text || job.options.format == Format::Xml)
        return structured_text_test(test, structured_text_form(job.options));
    std::ostringstream out;
    if (job.options.format == Format::Json) print_test_json(out, test);
    else print_test_csv(out, test);
    return std::move(out).str();
}

}  // namespace

ExitCode testgen(CommandContext& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    const auto chart = model ? chosen_chart(*model, job) : std::nullopt;
    const ResourceLimits bounds(job.options, streams);
    const auto test =
        chart ? test_of(*model, *chart, conform_options(job.options, bounds.limits()), job.diagnostics) : std::nullopt;
    if (!test) return bounds.interrupted() ? ExitCode::Unknown : ExitCode::Input;
    if (const auto wrong = disagreement(model->charts[*chart], *test)) {
        streams.err << "grafverif: internal error: the test fails under the rules of IEC 60848: " << *wrong << '\n';
        return ExitCode::Failure;
    }
    deliver(written(*test, job), job, streams);
    if (!job.options.quiet) streams.err << summary(*test) << '\n';
    return ExitCode::Done;
}

CliCommand testgen_usage() {
    return {
        "testgen",
        "FILE",
        1,
        1,
        "generate a test sequence for a PLC program",
        "Writes the inputs to apply and the outputs to expect, step by step from power-on. The number of steps, and\n"
        "whether it is minimal, is printed on standard error. Each step lasts `cycles` scans of the controller.\n"
        "Constraints of the chart restrict the inputs. The test is executed under the rules of IEC 60848 before it is\n"
        "written.\n"
        "Formats: CSV, JSON, Structured Text (IEC 61131-3) or PLCopen XML.",
        {"grafverif testgen samples/tanks/tanks.grafcet -o tanks.csv",
         "grafverif testgen samples/tanks/tanks.grafcet --cover evolutions",
         "grafverif testgen samples/tanks/tanks.grafcet --mode every-cycle --hold one --format json"},
        {OptionGroup::Output, OptionGroup::Chart, OptionGroup::Mode, OptionGroup::FormatTest, OptionGroup::Cover,
         OptionGroup::Minimise, OptionGroup::Limits}};
}

}  // namespace grafverif::app
