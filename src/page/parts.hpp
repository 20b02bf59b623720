// SPDX-License-Identifier: MIT
// Adds the sections of a page to its HTML text.
#pragma once

#include "page/html.hpp"
#include "page/page.hpp"

namespace grafverif {

/// The summary of a page. `kind` is the CSS class: `ok`, `bad` or `unknown`.
struct SummaryItem {
    const char* kind = "";
    std::string words = {};
};

/// Returns the summary of a fault analysis. The summary is positive only if all verdicts are known.
SummaryItem summary_of(const FaultAnalysis& analysis);
/// Returns the summary of verdicts for values of constants. The summary is positive only if there is a property and
/// each verdict is as expected at each point.
SummaryItem summary_of(const Tuning& tuning);
/// Returns the summary of the verdicts on a recording. The summary is positive only if the recording conforms to each
/// chart and violates no property.
SummaryItem summary_of(const RecordingReport& report);

/// The CSS class of a property and the symbol with the same meaning.
struct PropertyLook {
    const char* kind = "";
    const char* mark = "";
};

/// Begins the element `details` of a property, with its summary.
void begin_property(const PropertyLook& look, const std::string& name, std::string_view text, std::string_view outcome,
                    bool folded, Html& html);
/// Adds the formula of a property.
void add_formula(const PageContent& content, Id<ClosedLoop> loop, const std::string& property, Html& html);

/// Adds file, version, date, the summary verdict, assumptions and warnings.
void add_head(const PageContent& content, Html& html);
/// Adds the verdict on every property. Properties that hold as expected are folded.
void add_verdicts(const PageContent& content, Html& html);
/// Adds the minimal combinations of faults for each property, and the effects of each fault.
void add_faults(const PageContent& content, Html& html);
/// Adds for each property the map of the grid or a table of boxes, and the margins of the current values.
void add_tuning(const PageContent& content, Html& html);
/// Adds for each chart the verdict on the recording with the first deviation, and the properties of the loops.
void add_recording(const PageContent& content, Html& html);
/// Adds the element of the player for runs. If JavaScript is disabled, the page shows the runs as text instead.
void add_runs(const PageContent& content, Html& html);
/// True if at least one controller is a chart, not a PLC program.
bool has_charts(const PageContent& content);
/// True if at least one controller has steps.
bool has_steps(const PageContent& content);
/// Returns the title of the section about the controllers: `Charts`, `Programs`, or both.
const char* charts_title(const PageContent& content);
void add_findings(const PageContent& content, Html& html);
void add_charts(const PageContent& content, Html& html);
/// Returns text that lists the instances of the environment with their components, such as `Start (push_button, GAP =
/// 1s)`. The constants of the instances are included only if `timed` is true. The text is empty if there are no such
/// instances.
std::string environment_text(const Model& model, const ClosedLoop& loop, bool timed);
void add_plant(const PageContent& content, Html& html);
void add_equations(const PageContent& content, Html& html);
/// Adds the trace coverage: the steps that were active and the transitions that were cleared in the runs of the page.
void add_coverage(const PageContent& content, Html& html);

}  // namespace grafverif
