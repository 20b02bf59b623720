// SPDX-License-Identifier: MIT
// `import`: translates a chart of another format to grafverif's text language.
#include "app/commands.hpp"
#include "app/system/write_files.hpp"
#include "derive/derive.hpp"
#include "read/formats.hpp"
#include "read/text.hpp"
#include "support/messages.hpp"
#include "syntax/language/format.hpp"

namespace grafverif::app {

ExitCode import_chart(CommandContext& job, const Streams& streams) {
    const auto source = read_source(job.options.operands[0], job);
    if (!source) return ExitCode::Input;
    const std::string_view text = job.sources[*source].text;
    if (format_of(text) == FileFormat::Grafcet) job.diagnostics.add(messages::already_internal({*source, 0, 0}));
    if (format_of(text) == FileFormat::Unknown) job.diagnostics.add(messages::unknown_format({*source, 0, 0}, ""));
    if (job.diagnostics.has_errors()) return ExitCode::Input;
    tree::File file = read_any(*source, job.sources, {job.options.lossy}, job.diagnostics);
    // All commands must accept the result: errors that they would report in the text are reported now, with their
    // position in the source file.
    const auto model = model_of({&file, 1}, false, job.sources, {}, job.diagnostics);
    if (model)
        for (const Chart& chart : model->charts) derive(chart, job.diagnostics);
    if (job.diagnostics.has_errors()) return ExitCode::Input;
    deliver(formatted(laid_out(std::move(file))), job, streams);
    return ExitCode::Done;
}

CliCommand import_usage() {
    return {"import",
            "FILE",
            1,
            1,
            "convert a chart from another format",
            "Writes the charts of FILE as .grafcet text, with comments. FILE is AGRAFE GRAFCET (XMI), PLCopen TC6 XML "
            "1.01, 2.0\n"
            "or 2.01 including the CODESYS dialect, or a textual Sequential Function Chart (IEC 61131-3); the format "
            "is detected\n"
            "from the contents. All other commands accept these files directly. An element that cannot be imported is "
            "an error\n"
            "with its position in FILE; with --lossy it is omitted, with a warning and a comment at the start of the "
            "text.\n"
            "docs/how-to/import.md lists the supported elements of each format.",
            {"grafverif import plant.xml -o plant.grafcet", "grafverif import --lossy --diagnostics json press.xml"},
            {OptionGroup::Within, OptionGroup::Output}};
}

}  // namespace grafverif::app
