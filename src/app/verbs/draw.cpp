// SPDX-License-Identifier: MIT
// `draw`: a chart as a drawing of IEC 60848.
#include <algorithm>
#include <string_view>
#include <vector>

#include "app/verbs.hpp"
#include "support/messages.hpp"
#include "support/messages_choice.hpp"
#include "syntax/resolve/nearest_of.hpp"

namespace grafverif::app {

namespace {

constexpr std::uint64_t most_columns = 1000;

/// `3` or `G1.3`, with or without the X of the step variable.
bool is_called(const Chart& chart, Id<Chart::Step> step, std::string_view name) {
    const std::string& partial = chart.partial_charts[chart.steps[step].chart].name;
    const std::string& own = chart.steps[step].name;
    return name == own || name == "X" + own || name == partial + '.' + own || name == partial + ".X" + own;
}

/// The steps of `--situation`; one that is not there, or could be several, is an error.
std::vector<Id<Chart::Step>> situation(const Chart& chart, Job& job) {
    std::vector<Id<Chart::Step>> steps;
    std::string_view rest = job.options.situation;
    while (!rest.empty()) {
        const std::string_view name = rest.substr(0, rest.find(','));
        rest.remove_prefix(std::min(name.size() + 1, rest.size()));
        std::vector<Id<Chart::Step>> meant;
        for (const Id<Chart::Step> step : chart.steps.ids())
            if (is_called(chart, step, name)) meant.push_back(step);
        if (meant.size() == 1) {
            steps.push_back(meant.front());
            continue;
        }
        std::vector<std::string> known;
        for (const Id<Chart::Step> step : chart.steps.ids())
            if (meant.empty() || std::ranges::find(meant, step) != meant.end())
                known.push_back(step_variable(chart, step));
        job.diagnostics.add(meant.empty() ? messages::no_such_choice("step", name, known, nearest_of(name, known))
                                          : messages::ambiguous_choice("step", "--situation", known));
    }
    return steps;
}

}  // namespace

ExitCode draw(Job& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    const auto chart = model ? chosen_chart(*model, job) : std::nullopt;
    if (!chart) return ExitCode::Input;
    const DrawOptions options{.notation = job.options.notation,
                              .situation = situation(model->charts[*chart], job),
                              .columns = static_cast<int>(std::min(job.options.columns, most_columns))};
    if (job.diagnostics.has_errors()) return ExitCode::Input;
    deliver(svg_of(drawing_of(*model, *chart, options)), job, streams);
    return ExitCode::Done;
}

Verb draw_usage() {
    return {
        "draw",
        "FILE",
        1,
        1,
        "draw a chart",
        "Draws a chart with the symbols of IEC 60848, as SVG: its partial charts side by side, expansions and "
        "enclosed charts\n"
        "in frames of their own. The steps, transitions, conditions and actions have ids that pages can use.",
        {"grafverif draw samples/oven_door/oven_door.grafcet -o oven_door.svg",
         "grafverif draw samples/testing_station/faulty.grafcet --situation 4,W0,W5 --notation text -o station.svg"},
        {Accepts::Output, Accepts::Chart, Accepts::Drawing}};
}

}  // namespace grafverif::app
