// SPDX-License-Identifier: MIT
// `fmt`: prints a file in canonical form.
#include "app/commands.hpp"
#include "app/system/watchdog.hpp"
#include "app/system/write_files.hpp"
#include "support/printable.hpp"
#include "syntax/language/format.hpp"
#include "syntax/language/parse.hpp"
#include "syntax/language/readable.hpp"

namespace grafverif::app {

ExitCode fmt(CommandContext& job, const Streams& streams) {
    const std::string& path = job.options.operands[0];
    const auto source = read_source(path, job);
    if (!source) return ExitCode::Input;
    const std::string read = job.sources[*source].text;
    make_utf8(*source, job.sources, job.diagnostics);
    const tree::File file = parse_file(*source, job.sources, job.diagnostics);
    if (job.diagnostics.has_errors()) return ExitCode::Input;
    const std::string text = formatted(file);
    const bool canonical = text == read;
    if (job.options.check) {
        if (!canonical && !job.options.quiet)
            streams.err << printable(path) << ": not in canonical form; rewrite it with `grafverif fmt -i`\n";
        return canonical ? ExitCode::Done : ExitCode::Verdict;
    }
    if (!job.options.in_place) deliver(text, job, streams);
    else if (!canonical) {
        work_is_done();
        write_files({{path, text}});
    }
    return ExitCode::Done;
}

CliCommand fmt_usage() {
    return {
        "fmt",
        "FILE...",
        1,
        any_number,
        "print a file in canonical form",
        "Prints FILE in canonical form, with one declaration per line; comments are kept. A file in canonical form is\n"
        "printed unchanged.",
        {"grafverif fmt station.grafcet", "grafverif fmt -i station.grafcet", "grafverif fmt --check station.grafcet"},
        {OptionGroup::Output, OptionGroup::InPlace}};
}

}  // namespace grafverif::app
