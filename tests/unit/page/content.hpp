// SPDX-License-Identifier: MIT
// Generates the page of a text through the public API, as `report` does, and extracts parts of it.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

#include "grafverif/grafverif.hpp"
#include "page/page.hpp"

namespace grafverif {

/// The page of a text, with the parse result and with the JSON data in the page.
struct Made {
    ParseResult reading = {};
    std::string page = {};
    nlohmann::json data = {};
};

/// Returns the part of `text` between the first `begin` and the next `end`.
inline std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t from = text.find(begin);
    if (from == std::string::npos) return {};
    const std::size_t start = from + begin.size(), stop = text.find(end, start);
    return stop == std::string::npos ? "" : text.substr(start, stop - start);
}

inline std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

inline Made page_of_text(const std::string& text, const std::string& name = "test.grafcet", std::string date = "") {
    Made made{read_string(text, name)};
    EXPECT_TRUE(made.reading.model) << made.reading.diagnostics_text();
    if (!made.reading.model) return made;
    const Model& model = *made.reading.model;
    PageContent content{.model = model, .sources = made.reading.sources, .file = name, .version = "1"};
    content.date = std::move(date);
    Diagnostics& diagnostics = made.reading.diagnostics;
    std::vector<Id<Chart>> charts;
    if (model.loops.empty()) charts = {{0}};
    else content.loop = {0};
    for (std::uint32_t k = 0; content.loop.valid() && k < model.loops[content.loop].controllers.size(); ++k)
        charts.push_back(model.loops[content.loop].controllers[{k}].chart);
    content.report = content.loop.valid() ? *check(model, content.loop, {}, {}, diagnostics)
                                          : *check_untimed(model, charts[0], {}, {}, diagnostics);
    for (const Id<Chart> chart : charts)
        content.charts.push_back({.chart = chart,
                                  .drawing = svg_of(drawing_of(model, chart)),
                                  .equations = *equations_of(model, chart, diagnostics),
                                  .analysis = *analysis_of(model, chart, {}, {}, diagnostics)});
    std::set<Id<Component>> used;
    if (content.loop.valid())
        for (const ClosedLoop::Instance& instance : model.loops[content.loop].instances)
            if (used.insert(instance.component).second)
                content.components.push_back({instance.component, "<svg></svg>"});
    made.page = page_of(content);
    made.data = nlohmann::json::parse(between(made.page, "<script type=\"application/json\" id=\"data\">", "</script>"),
                                      nullptr, false);
    return made;
}

/// A button starts a motor. A violated property states that the motor never runs after a second press.
inline const std::string press = R"(
grafcet press {
    input START, DONE;
    output MOTOR;

    initial step 0;
    step 1 { MOTOR; }
    step 2;

    transition T0: 0 -> 1 when rise(START);
    transition T1: 1 -> 2 when 2s/X1 && (DONE || START);
    transition T2: 2 -> 0 when !START;
}

closed_loop shop {
    controller press with stability_search;
    environment Start = free(OUT = START);
    environment Done = free(OUT = DONE);

    property idle "the motor never runs": never MOTOR;
    property rests: reachable X2;
    property sound: never X0 && X1;
}
)";

}  // namespace grafverif
