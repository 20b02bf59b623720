// SPDX-License-Identifier: MIT
// `st`: writes a chart, or a test of it, as a PLC program.
#include "app/commands.hpp"
#include "pipeline/models.hpp"

namespace grafverif::app {

ExitCode st(CommandContext& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    const auto chart = model ? chosen_chart(*model, job) : std::nullopt;
    const auto found = chart ? equations_of(*model, *chart, job) : std::nullopt;
    if (!found) return ExitCode::Input;
    std::string text;
    if (!job.options.sequence) {
        const bool xml = structured_text_form(job.options) == structured_text::Form::PlcopenXml;
        text = structured_text_of(*found, execution_mode(*model, *chart, job), job.diagnostics, xml,
                                  static_cast<std::uint32_t>(job.options.max_evolutions))
                   .value_or("");
    } else if (const auto sequence = test_sequence(*model, *chart, job)) {
        text = structured_text_test(*sequence, structured_text_form(job.options));
    }
    if (!job.diagnostics.has_errors()) deliver(text, job, streams);
    return ExitCode::Done;
}

CliCommand st_usage() {
    return {
        "st",
        "FILE",
        1,
        1,
        "generate Structured Text for a chart, or a test program",
        "Writes a chart of FILE as a function block in Structured Text (IEC 61131-3), derived from the verified\n"
        "equations. One call of the block is one PLC cycle. With --sequence, `st` writes a program that executes the\n"
        "test on this function block, one scan per call, and compares its outputs in each scan. Formats: PLCopen XML\n"
        "(TC6 2.01), text.",
        {"grafverif st samples/tanks/tanks.grafcet -o tanks.xml",
         "grafverif st samples/tanks/tanks.grafcet --mode every-cycle --format text",
         "grafverif st samples/tanks/tanks.grafcet --sequence samples/tanks/table2.csv -o test.xml"},
        {OptionGroup::Output, OptionGroup::Chart, OptionGroup::Mode, OptionGroup::FormatXml, OptionGroup::Sequence,
         OptionGroup::MaxEvolutions}};
}

}  // namespace grafverif::app
