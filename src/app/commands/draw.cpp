// SPDX-License-Identifier: MIT
// `draw`: draws a chart according to IEC 60848.
#include <algorithm>

#include "app/commands.hpp"
#include "pipeline/chart_text.hpp"
#include "support/messages_program.hpp"

namespace grafverif::app {

namespace {

constexpr std::uint64_t most_columns = 1000;

}  // namespace

ExitCode draw(CommandContext& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    const auto chart = model ? chosen_chart(*model, job) : std::nullopt;
    if (!chart) return ExitCode::Input;
    if (const Chart& drawn = model->charts[*chart]; drawn.program && drawn.steps.empty())
        job.diagnostics.add(messages::only_for_charts(drawn.origin, drawn.name, "only charts with steps can be drawn",
                                                      "use `grafverif report` to show its statements"));
    const DrawOptions options{
        .notation = job.options.notation,
        .situation = named_steps(model->charts[*chart], job.options.situation, "--situation", job),
        .columns = static_cast<int>(std::min(job.options.columns, most_columns))};
    if (job.diagnostics.has_errors()) return ExitCode::Input;
    deliver(svg_of(drawing_of(*model, *chart, options, job.sources)), job, streams);
    return ExitCode::Done;
}

CliCommand draw_usage() {
    return {
        "draw",
        "FILE",
        1,
        1,
        "draw a chart",
        "Draws a chart in the notation of IEC 60848 as SVG. Partial charts are side by side; expansions and enclosed\n"
        "charts have separate frames. Steps, transitions, conditions and actions have ids that web pages can\n"
        "refer to.",
        {"grafverif draw samples/oven_door/oven_door.grafcet -o oven_door.svg",
         "grafverif draw samples/testing_station/faulty.grafcet --situation 4,W0,W5 --notation text -o station.svg"},
        {OptionGroup::Within, OptionGroup::Output, OptionGroup::Chart, OptionGroup::Drawing}};
}

}  // namespace grafverif::app
