// SPDX-License-Identifier: MIT
// `import`: translates a chart of another format to grafverif's text language.
#include "app/system/write_files.hpp"
#include "app/verbs.hpp"
#include "derive/derive.hpp"
#include "read/formats.hpp"
#include "read/text.hpp"
#include "support/messages.hpp"
#include "syntax/language/format.hpp"

namespace grafverif::app {

ExitCode import_chart(Job& job, const Streams& streams) {
    const auto source = read_source(job.options.operands[0], job);
    if (!source) return ExitCode::Input;
    const std::string_view text = job.sources[*source].text;
    if (format_of(text) == FileFormat::Grafcet) job.diagnostics.add(messages::ours_already({*source, 0, 0}));
    if (format_of(text) == FileFormat::Unknown) job.diagnostics.add(messages::unknown_format({*source, 0, 0}, ""));
    if (job.diagnostics.has_errors()) return ExitCode::Input;
    tree::File file = read_any(*source, job.sources, {job.options.lossy}, job.diagnostics);
    // All commands must accept the result: errors that they would report in the text are reported here, with their
    // location in the source file.
    const auto model = model_of({&file, 1}, false, job.sources, {}, job.diagnostics);
    if (model)
        for (const Chart& chart : model->charts) derive(chart, job.diagnostics);
    if (job.diagnostics.has_errors()) return ExitCode::Input;
    deliver(formatted(laid_out(std::move(file))), job, streams);
    return ExitCode::Done;
}

Verb import_usage() {
    return {"import",
            "FILE",
            1,
            1,
            "write a chart of another format in our language",
            "Writes the charts of FILE as .grafcet text, its comments kept. FILE is AGRAFE GRAFCET (XMI), PLCopen TC6 "
            "XML 1.01, 2.0\n"
            "or 2.01 with the dialect of CODESYS, or the textual form of Sequential Function Charts (IEC 61131-3); "
            "which of them is\n"
            "told from what is written. Every other verb takes such files directly. What cannot be taken over is an "
            "error with its\n"
            "place in FILE; with --lossy it is left out, with a warning, and named at the head of the text. "
            "docs/how-to/import.md tells\n"
            "what of each format works.",
            {"grafverif import plant.xml -o plant.grafcet", "grafverif import --lossy --diagnostics json press.xml"},
            {Accepts::Output}};
}

}  // namespace grafverif::app
