// SPDX-License-Identifier: MIT
// What the script of a page knows: one JSON document, in the element `data`.
//
//   version     1
//   charts      per controller, in order: `figure` (the id of the element around the drawing), `ids` (of the drawing's
//               elements, see ElementIds: `steps`, `transitions`, `conditions`, `continuous`, `stored`, `forcing`), and what
//               page/terms.hpp tells of the chart: `name`, `steps`, `transitions` (`name`, `from`, `condition`), `timed`,
//               `terms`, `ownerOfAction`, `ownerOfForcing`. Lists are in the order of the chart's tables
//   properties  those of the loop whose terms are known: `name`, `pattern`, `at_stable`, `operands`, `terms`
//   plant       per instance, by name, the id of the figure with the drawing of its component
//   runs        those to play:
//     name        in addresses: `#NAME/INDEX`, INDEX being a row, or `ROW+MOVES` between rows
//     kind        `counterexample`, `witness`, `evidence`, `breakdown`, `test`
//     title       for people
//     property    its place in `properties`, or null
//     charts      per controller of the run, its place in `charts`
//     conditions  per controller of the run and time condition of its chart, the place of its timer among the controller's,
//                 or null
//     initial     per instance, by name, the place of the location where it begins, where that is known
//     end         what is to be said where the run ends; may be empty
//     violation   of a sentence that an observer checks: `moment`, from which on it fails, and `steps`, each with `words` and
//                 its `moment`, or null; null: of another property, or not known
//     inside      of a run about a property, the moments that are no state of the model: a step of it that the run tells as
//                 several moments has its state behind the last
//     run         the run (docs/trace.md), `rows` the same for people: `moment`, `words`, `cleared`, `shown` (false: the next
//                 row tells it anyhow); `loop_from` as there. Moves of observers are omitted
#pragma once

#include <string>
#include <vector>

#include "page/page.hpp"

namespace grafverif {

/// A run on the page.
struct Playable {
    std::string name = {}, kind = {}, title = {}, end = {};
    std::string property = {};  ///< of the loop; may be empty
    const ChartRun* run = nullptr;
    std::vector<std::size_t> charts = {};  ///< per controller of the run
};
/// Longer runs, and more of them, make a page that no browser opens gladly.
inline constexpr std::size_t longest_playable = 100'000;  // moments, of all runs together
/// Whether the run may stand on the page; the others are named there with their length.
inline bool can_be_played(const ChartRun& run) {
    return !run.moments.empty() && !run.rows.empty() && run.moments.size() <= longest_playable;
}

/// The runs of the content that can be played, as many as fit: where the model breaks off, violated properties first, witnesses, evidence of findings.
std::vector<Playable> playable_runs(const PageContent& content);

/// The properties of the loop that were to be decided and have no verdict: the model cannot be asked them.
std::vector<const Property*> left_out(const PageContent& content);

/// The id of the figure of a component.
inline std::string component_figure(Id<Component> component) { return "component-" + std::to_string(component.index); }

/// The name of a finding's evidence in addresses: `step-never-active:X4`.
std::string evidence_name(const PageContent& content, const Analysis& analysis, const Finding& finding);

/// The document as the text of a script element: `<` is escaped.
std::string page_data(const PageContent& content);

}  // namespace grafverif
