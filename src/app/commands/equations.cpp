// SPDX-License-Identifier: MIT
// `equations`: prints the semantics of a chart as equations (11) to (13) of CEP13, in the notation of its Fig. 19.
#include "syntax/print/equations.hpp"

#include <sstream>

#include "app/commands.hpp"
#include "support/overloaded.hpp"

namespace grafverif::app {

namespace {

std::string printed(const Equations& equations, Format format) {
    std::ostringstream out;
    switch (format) {
    case Format::Text: print_equations(out, equations); break;
    case Format::Latex: print_equations_latex(out, equations); break;
    case Format::Json: print_equations_json(out, equations); break;
    case Format::JsonLines:
    case Format::Xml:
    case Format::Sarif:
    case Format::Dot:
    case Format::Svg:
    case Format::Csv: break;  // `equations` does not support these formats
    }
    return out.str();
}

}  // namespace

ExitCode equations(CommandContext& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    const auto chart = model ? chosen_chart(*model, job) : std::nullopt;
    const auto found = chart ? equations_of(*model, *chart, job) : std::nullopt;
    if (!found) return ExitCode::Input;
    deliver(printed(*found, job.options.format), job, streams);
    return ExitCode::Done;
}

CliCommand equations_usage() {
    return {
        "equations",
        "FILE",
        1,
        1,
        "print the equations of a chart",
        "Prints the semantics of a chart as equations: (a) firing conditions, (b) step activities, (c) outputs and\n"
        "timers. Equations of stored actions are printed between (b) and (c).",
        {"grafverif equations samples/testing_station/testing_station.grafcet",
         "grafverif equations samples/oven_door/oven_door.grafcet --format latex -o oven_door.tex"},
        {OptionGroup::Output, OptionGroup::Chart, OptionGroup::FormatLatex}};
}

}  // namespace grafverif::app
