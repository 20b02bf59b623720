// SPDX-License-Identifier: MIT
// Data of the page's script: one JSON document, in the element `data`.
//
//   version     1
//   charts      per controller, in order: `figure` (the id of the element around the drawing), `ids` (of the drawing's
//               elements, see ElementIds: `steps`, `transitions`, `conditions`, `continuous`, `stored`, `forcing`), and
//               the chart as in page/terms.hpp: `name`, `steps`, `transitions` (`name`, `from`, `condition`), `timed`,
//               `terms`, `ownerOfAction`, `ownerOfForcing`. Lists are in the order of the chart's tables
//   properties  those of the loop whose terms are known: `name`, `pattern`, `at_stable`, `operands`, `terms`
//   plant       per instance, by name, the id of the figure with the drawing of its component
//   runs        the runs to play:
//     name        in addresses: `#NAME/INDEX`, INDEX being a row, or `ROW+MOVES` between rows
//     kind        `counterexample`, `witness`, `evidence`, `breakdown`, `test`
//     title       display text
//     property    its index in `properties`, or null
//     charts      per controller of the run, its index in `charts`
//     conditions  per controller of the run and time condition of its chart, the index of its timer among the
//                 controller's, or null
//     initial     per instance, by name, the index of its initial location, if known
//     end         the text shown at the end of the run; may be empty
//     violation   of a sentence that an observer checks: `moment`, from which on it fails, and `steps`, each with
//                 `words` and its `moment`, or null; null: another property, or unknown
//     inside      of a run about a property, the moments that are not states of the model: if one step of the model is
//                 shown as several moments, its state is the one after the last
//     run         the run (docs/reference/trace-format.md); `rows` its display text: `moment`, `words`, `cleared`,
//                 `shown` (false: included in the next row); `loop_from` as there. Moves of observers are omitted
#pragma once

#include <string>
#include <vector>

#include "page/page.hpp"

namespace grafverif {

/// A run that the page can play.
struct Playable {
    std::string name = {}, kind = {}, title = {}, end = {};
    std::string property = {};  ///< property of the loop; may be empty
    const ChartRun* run = nullptr;
    std::vector<std::size_t> charts = {};  ///< index of the chart of each controller of the run
};
/// Limit of the total length of the runs on a page, because browsers cannot handle large pages well.
inline constexpr std::size_t longest_playable = 100'000;  // number of events of all runs together
/// True if the page may contain the run. Other runs are listed with their length.
inline bool can_be_played(const ChartRun& run) {
    return !run.moments.empty() && !run.rows.empty() && run.moments.size() <= longest_playable;
}

/// Returns the runs of the content that can be played, up to the limit. They are ordered: model errors, violated
/// properties, witnesses, runs of findings.
std::vector<Playable> playable_runs(const PageContent& content);

/// Returns the selected properties of the loop without a verdict, which the model cannot express.
std::vector<const Property*> left_out(const PageContent& content);

/// Returns the id of the figure of a component.
inline std::string component_figure(Id<Component> component) { return "component-" + std::to_string(component.index); }

/// Returns the name of a finding's run in addresses: `step-never-active:X4`.
std::string evidence_name(const PageContent& content, const Analysis& analysis, const Finding& finding);

/// Returns the document as text of a script element, in which `<` is escaped.
std::string page_data(const PageContent& content);

}  // namespace grafverif
