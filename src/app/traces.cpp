// SPDX-License-Identifier: MIT
#include "app/traces.hpp"

#include <fmt/format.h>

#include <sstream>

#include "report/svg.hpp"
#include "report/vcd.hpp"

namespace grafverif::app {

std::vector<const Chart*> charts_of(const Model& model, const ClosedLoop& loop) {
    std::vector<const Chart*> charts;
    for (const ClosedLoop::Controller& controller : loop.controllers) charts.push_back(&model.charts[controller.chart]);
    return charts;
}

std::string replay_failure(std::string_view what, const Disagreement& disagreement) {
    return fmt::format("{} does not replay on the rules of IEC 60848: {}: {} (move {})", what, disagreement.where,
                       disagreement.what, disagreement.move);
}

std::vector<OutputFile> trace_files(const ChartRun& run, std::string_view title, const Options& options) {
    std::vector<OutputFile> files;
    if (options.trace_vcd) {
        std::ostringstream text;
        print_vcd(run, text);
        files.push_back({*options.trace_vcd, std::move(text).str()});
    }
    if (options.trace_svg) {
        std::ostringstream text;
        print_svg(run, title, text);
        files.push_back({*options.trace_svg, std::move(text).str()});
    }
    return files;
}

}  // namespace grafverif::app
