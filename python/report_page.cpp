// SPDX-License-Identifier: MIT
#include "report_page.hpp"

#include <sstream>
#include <utility>

#include "page/page.hpp"

namespace grafverif::python {

std::optional<std::string> report_page(const ParseResult& reading, Id<ClosedLoop> loop, Id<Chart> chart,
                                       const Report& report, std::optional<ExecutionMode> mode, std::string date,
                                       const Limits& limits, Diagnostics& diagnostics) {
    auto made = page_content(*reading.model, reading.sources, loop, chart, mode, limits, diagnostics);
    if (!made) return {};
    PageContent& content = *made;
    if (!reading.sources.empty()) content.file = reading.sources.begin()->name;
    content.version = GRAFVERIF_VERSION;
    content.date = std::move(date);
    content.report = report;
    std::ostringstream warnings;
    render_text(reading.diagnostics.all(), reading.sources, Colour::Plain, warnings);
    content.warnings = std::move(warnings).str();
    return page_of(content);
}

}  // namespace grafverif::python
