// SPDX-License-Identifier: MIT
#include "app/traces.hpp"

#include <sstream>

#include "report/svg.hpp"
#include "report/vcd.hpp"

namespace grafverif::app {

std::vector<OutputFile> trace_files(const ChartRun& run, std::string_view title, const Options& options) {
    std::vector<OutputFile> files;
    if (options.trace_vcd) {
        std::ostringstream text;
        print_vcd(run, text);
        files.push_back({*options.trace_vcd, std::move(text).str()});
    }
    if (options.trace_svg) {
        std::ostringstream text;
        print_svg(run, title, options.events, text);
        files.push_back({*options.trace_svg, std::move(text).str()});
    }
    return files;
}

}  // namespace grafverif::app
