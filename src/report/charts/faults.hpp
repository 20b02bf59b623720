// SPDX-License-Identifier: MIT
// Writes results of a fault analysis as text, as JSON, and as a fault tree in the Open-PSA Model Exchange Format.
//
// The text contains, for each property, a table of the minimal combinations of faults that violate it, the effects of
// each fault (FMEA), and runs.
//
// JSON: missing values are null. `trace` has the format of report/json.hpp.
//
//   {"model", "engine", "mode", "grain", "time_unit", "order", "combinations", "checks", "faults":[FAULT],
//   "properties":[PROPERTY], "errors":[{"faults", "code", "message", "trace"}]}
//   FAULT     {"name", "instance", "component", "file", "line", "column", "violates", "newly_true", "never_true",
//             "always_shown":true|false|null, "detected":true|false|null, "within", "observer":OBSERVER, "decided"}
//   OBSERVER  {"property", "declared", "in_every_run":true|false|null, "within"}; `declared` is the name if the loop
//             declares the property; `within` is in seconds
//   PROPERTY  {"name", "text", "file", "line", "column", "declared", "without_faults", "minimal":[CUT],
//             "unknown":[{"faults", "reason"}], "non_monotone":[{"violating", "holding"}]}
//   CUT       {"faults", "from_power_on", "unknown_subsets":[["F"]], "trace"}; minimal if `unknown_subsets` is empty
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

#include "grafverif/support/source.hpp"
#include "ir/fault_analysis.hpp"

namespace grafverif {

/// Returns the names of the faults of a combination, such as `V_stuck + H_stuck`. For the empty combination, returns
/// `no fault`.
std::string names_of(const FaultAnalysis& analysis, const FaultSet& faults);
/// Returns text such as `minimality is unproved: V_stuck, H_stuck have an unknown verdict`; empty if the combination
/// is proved to be minimal.
std::string unproved(const FaultAnalysis& analysis, const FaultAnalysis::Cut& cut);
/// Returns the reason why a combination has no trace.
std::string absence_of_trace(const FaultAnalysis::Row& row, const FaultAnalysis::Cut& cut);
/// True if the report shows the results for a property. The report omits an undeclared `no timelock` if this property
/// holds without faults and for all checked combinations.
bool is_shown(const FaultAnalysis::Row& row);

/// The effects of a fault, one sentence each.
struct FaultEffects {
    std::vector<std::string> on_properties = {};
    std::vector<std::string> visible = {};  ///< effects of the fault on steps and outputs
};
FaultEffects effects_of(const FaultAnalysis& analysis, std::size_t fault);

/// Prints the analysis as text. If `all_runs` is true, prints a run for each minimal combination, otherwise only for
/// the first minimal combination of each property.
void print_faults(const FaultAnalysis& analysis, bool all_runs, std::ostream& out);
std::string faults_json(const FaultAnalysis& analysis, const Sources& sources);
/// Returns a fault tree with a gate per property: the disjunction of its minimal combinations. A name in the tree is
/// changed if the format does not allow it; labels contain the original names. Comments state what the tree omits.
std::string open_psa_of(const FaultAnalysis& analysis);

}  // namespace grafverif
