// SPDX-License-Identifier: MIT
// Writes the data of the page's script: one JSON document, in the element `data`.
//
//   `version`: Version of the format: 1.
//   `charts`: Per controller, in order, an object with these members: `figure` is the id of the element around the
//     drawing. `ids` are the ids of the elements of the drawing (see ElementIds): `steps`, `transitions`, `conditions`,
//     `continuous`, `stored`, `forcing`. The other members represent the chart as in page/terms.hpp: `name`, `steps`,
//     `transitions` (`name`, `from`, `condition`), `timed`, `terms`, `ownerOfAction`, `ownerOfForcing`. Lists are in
//     the order of the tables of the chart. A PLC program has no conditions; the additional member `program` contains:
//     `listing`: The id of the element that contains the lines of the program.
//     `code`: The lines with values: `[line, unit]`; lines are counted from 0.
//     `units`: The names of the units of the program.
//     `instances`: `name` and `unit` of each function block instance; the name of the program itself is empty.
//     `steps`: For each step of the chart, its `line`, or null, and its `instance`.
//     `transitions`: For each transition of the chart, the line of its condition.
//     `points`: The values of the lines: `line`; `order` on the line; `instance`, or null in a function; `role`
//       (`read`, `condition`, `result`, `executed`); `name` of the variable, or empty; `format`: `boolean`, `time` (in
//       ms), a list of the names of the values, or null for a number.
//   `properties`: The properties of the loop (page/terms.hpp): `name`, `pattern`, `at_stable`, `operands`, `terms`.
//   `plant`: For each instance, by name, the id of the figure with the drawing of its component.
//   `runs`: The runs that the page can play, each with these members:
//     `name`: Name in addresses: `#NAME/INDEX`. INDEX is a row, or `ROW+MOVES` for a state between two rows.
//     `kind`: `counterexample`, `witness`, `evidence`, `breakdown`, `test` or `recording`.
//     `title`: Display text.
//     `property`: Index of the property of the run in `properties`, or null.
//     `charts`: For each controller of the run, the index of its chart in the list of charts.
//     `conditions`: For each controller of the run and each time condition of its chart, the index of the timer in the
//       list of timers of the controller, or null.
//     `scans`: For each controller of the run, the scans of its program, or null. A scan is `[moment, changes]`. Each
//       change is `[point, value]`, or `[point, value, count]` if the point was evaluated several times. The value is
//       null if the scan did not evaluate the point. A point without a change has the same value as in the previous
//       scan.
//     `initial`: For each instance, by name, the index of its initial location, if known.
//     `end`: The text shown at the end of the run; may be empty.
//     `violation`: How the run violates a sentence that an observer checks, or null. `moment` is the event after which
//       the sentence fails, and each of `steps` has `words` and its `moment`, or null.
//     `inside`: The moments after which there is no state of the model. If the run shows one step of the model as
//       several moments, only the state after the last of these moments is a state of the model.
//     `run`: The run (docs/reference/trace-format.md) without moves of observers. Each of `rows` has the display text
//       as `moment`, `words`, `cleared` and `shown` (false: included in the next row). `loop_from` is the index of the
//       first row that repeats forever, or null.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "page/page.hpp"

namespace grafverif {

/// A run that the page can play.
struct Playable {
    std::string name = {}, kind = {}, title = {}, end = {};
    std::string property = {};  ///< name of a property of the loop; may be empty
    const ChartRun* run = nullptr;
    std::vector<std::size_t> charts = {};  ///< index of the chart of each controller of the run

    /// Indices of the initial locations of instances, by name of the instance, if they differ from the model; empty if
    /// unknown.
    std::map<std::string, std::optional<std::size_t>> initial = {};
    /// Model of the run if it is not the model of the page. The model of the run and the model of the page have the
    /// same controllers and the same elements in their charts; conditions, properties and instances may differ.
    const Model* model = nullptr;
};
/// Maximum total length of the runs on a page. The length is limited, because browsers are slow with large pages.
inline constexpr std::size_t longest_playable = 100'000;  // total number of events of all runs

/// Maximum number of scans and of changes of values of statements on a page.
inline constexpr std::size_t most_points = 1'000'000;
/// True if the page may contain the run. For other runs, the page states only their length.
inline bool can_be_played(const ChartRun& run) {
    return !run.moments.empty() && !run.rows.empty() && run.moments.size() <= longest_playable;
}

/// Returns the runs of the content that can be played, up to longest_playable events, in this order: model errors,
/// violated properties, witnesses, runs of findings, test sequences.
std::vector<Playable> playable_runs(const PageContent& content);

/// Returns the runs of the fault analysis. `charts` contains the index of the chart of each controller.
std::vector<Playable> fault_runs(const PageContent& content, const std::vector<std::size_t>& charts);

/// Returns the runs at those points of the tuning grid whose models have the same controllers and elements as the
/// drawings. `charts` contains the index of the chart of each controller.
std::vector<Playable> tuning_runs(const PageContent& content, const std::vector<std::size_t>& charts);

/// Returns the runs of charts that correspond to admissible timings of a recording.
std::vector<Playable> recording_runs(const PageContent& content);

/// Returns the selected properties of the loop that have no verdict because the model cannot express them.
std::vector<const Property*> left_out(const PageContent& content);

/// Returns the id of the figure of a component.
inline std::string component_figure(Id<Component> component) { return "component-" + std::to_string(component.index); }

/// Returns the name of a finding's run in addresses: `step-never-active:X4`.
std::string evidence_name(const PageContent& content, const Analysis& analysis, const Finding& finding);

/// Returns the JSON document as the text of a script element, in which each `<` is escaped.
std::string page_data(const PageContent& content);

}  // namespace grafverif
