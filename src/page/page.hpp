// SPDX-License-Identifier: MIT
// page_of: writes all results about a file as one self-contained HTML document. The document contains text, drawings,
// tables, and a player of runs, which requires JavaScript. The output is deterministic: equal contents result in equal
// bytes.
//
// The Content-Security-Policy of the document permits only its own style and script, which it identifies by their
// hashes. The data of the script is in the element `data` (see page/data.hpp). The sections have the ids `verdicts`,
// `runs`, `findings`, `charts`, `plant`, `equations`, `coverage`. A page with a fault analysis has the section `faults`
// instead of `verdicts`, a page about values of constants has `tuning`, a page about a recording has `recording`; these
// pages have neither `findings`, `equations` nor `coverage`. A property has the id `property-NAME`. The drawing of a
// chart is in the figure `chart-N`, with the ids that element_ids() returns; the lines of a PLC program are in
// `program-N`, the drawing of a component is in `component-N`.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/grafverif.hpp"
#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/drawing.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/finding.hpp"
#include "grafverif/ir/report.hpp"
#include "grafverif/support/source.hpp"
#include "ir/certificate_summary.hpp"
#include "ir/fault_analysis.hpp"
#include "ir/recording.hpp"
#include "ir/tuning.hpp"
#include "page/listing.hpp"
#include "report/remedies/trials.hpp"

namespace grafverif {

/// A PLC program on the page.
struct ProgramContent {
    Chart drawn = {};  ///< the result of drawn_chart (ir/program/interface.hpp)
    ProgramListing listing = {};
};

/// A chart on the page, with its results. For a PLC program, there are no equations and no analysis.
struct ChartContent {
    Id<Chart> chart = {};
    std::string prefix = {};   ///< prefix of the ids in the drawing of the chart
    std::string drawing = {};  ///< a generated `<svg>` element; empty for a program without a chart
    Equations equations = {};
    Analysis analysis = {};
    std::optional<ProgramContent> program = {};
};

/// A component of the plant on the page.
struct ComponentContent {
    Id<Component> component = {};
    /// A generated `<svg>` element that contains the locations in order as elements `rect.node`; empty if there are too
    /// many locations.
    std::string drawing = {};
};

/// The content of a page. The referenced objects must outlive the content.
struct PageContent {
    const Model& model;
    const Sources& sources;
    std::string file = {}, version = {};
    std::string date = {};                          ///< date as text; if empty, no date is shown
    std::vector<std::string> requested = {};        ///< names of the selected properties; all if empty
    Id<ClosedLoop> loop = {};                       ///< invalid if the page is about a chart without a loop
    std::vector<ChartContent> charts = {};          ///< charts of the controllers, in order
    std::vector<ComponentContent> components = {};  ///< components of the plant, without duplicates
    Report report = {};
    std::vector<Trial> trials = {};                      ///< trials of remedies, if a limit ended the check
    std::optional<CertificateSummary> certificate = {};  ///< certificate of the verdicts of `report`, if requested

    /// If the page is about a single chart: runs of its test sequences.
    std::vector<ChartRun> tests = {};
    /// Fault analysis. If present, the page shows its results instead of the verdicts of `report`.
    std::optional<FaultAnalysis> faults = {};
    /// Verdicts for several values of constants. If present, the page shows them instead of the verdicts of `report`.
    std::optional<Tuning> tuning = {};
    std::map<std::size_t, Model> point_models = {};  ///< models at those points of `tuning` that have runs

    /// Verdicts on a recording. If present, the page shows them instead of the verdicts of `report`. `charts` contains
    /// the charts of the verdicts on the recording, in order.
    std::optional<RecordingReport> recording = {};
    std::string warnings = {};  ///< warnings about the file, as text
};

/// Returns the chart to be drawn. For a PLC program, the result is the chart with the transitions and actions of its
/// Sequential Function Chart.
inline const Chart& drawn_chart(const PageContent& content, const ChartContent& one) {
    return one.program ? one.program->drawn : content.model.charts[one.chart];
}

/// True if the page shows the verdicts of `report` and the analyses of the charts.
inline bool is_about_verdicts(const PageContent& content) {
    return !content.faults && !content.tuning && !content.recording;
}

/// Returns the drawn charts and components of a page about `loop`, without equations and analyses.
PageContent drawn_content(const Model& model, const Sources& sources, Id<ClosedLoop> loop);
/// Returns the drawn charts of a page about `charts`, without equations and analyses.
PageContent drawn_charts(const Model& model, const Sources& sources, const std::vector<Id<Chart>>& charts);

/// Returns the charts and components of a page about `loop`, or about `chart` if `loop` is invalid, or nothing after an
/// error.
std::optional<PageContent> page_content(const Model& model, const Sources& sources, Id<ClosedLoop> loop,
                                        Id<Chart> chart, std::optional<ExecutionMode> mode, const Limits& limits,
                                        Diagnostics& diagnostics);

std::string page_of(const PageContent& content);

}  // namespace grafverif
