// SPDX-License-Identifier: MIT
// page_of: everything that was found out about a file as one HTML document, which needs nothing beside it: text, drawings
// and tables to read and print, and the player of runs for who has a script engine. Same content, same bytes.
//
// The document allows its own style and script by their hashes and forbids everything else (Content-Security-Policy).
// What the script knows stands in the element `data`, see page/data.hpp. Its sections have the ids `verdicts`, `runs`,
// `findings`, `charts`, `plant`, `equations`, `coverage`; a property has `property-NAME`, the drawing of a chart stands
// in the figure `chart-N` with ids by element_ids(), that of a component in `component-N`.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/drawing.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/finding.hpp"
#include "grafverif/ir/report.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

/// A chart on the page, and all that is said of it alone.
struct ChartContent {
    Id<Chart> chart = {};
    std::string prefix = {};   ///< of the ids in its drawing
    std::string drawing = {};  ///< an `<svg>` of ours
    Equations equations = {};
    Analysis analysis = {};
};

/// A component of the plant on the page.
struct ComponentContent {
    Id<Component> component = {};
    std::string drawing = {};  ///< an `<svg>` of ours, its locations in order as `rect.node`; empty: there are too many
};

/// What a page shows. The references outlive it.
struct PageContent {
    const Model& model;
    const Sources& sources;
    std::string file = {}, version = {};
    std::string date = {};                          ///< as given; empty: none
    std::vector<std::string> asked = {};            ///< the properties asked for; empty: all
    Id<ClosedLoop> loop = {};                       ///< not valid: a chart alone
    std::vector<ChartContent> charts = {};          ///< of the controllers, in order
    std::vector<ComponentContent> components = {};  ///< that the plant is made of, each once
    Report report = {};
    std::vector<ChartRun> tests = {};  ///< sequences of a test of the only chart
    std::string warnings = {};         ///< diagnostics, rendered
};

std::string page_of(const PageContent& content);

}  // namespace grafverif
