// SPDX-License-Identifier: MIT
// Report: results of an engine for one model. A Report contains the verdicts of all properties, the assumptions of the
// verdicts, and their runs in terms of the charts.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/chart_run.hpp"
#include "grafverif/ir/named_constant.hpp"
#include "grafverif/ir/state_profile.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// Settings and assumptions that apply to all verdicts of a report.
struct CheckSettings {
    std::string engine = {};  ///< engine name, such as `timed`
    std::string mode = {};    ///< `stability-search` or `every-cycle`; both if the controllers have different modes
    std::string grain = {};   ///< grain: `phased` or `atomic`
    std::int64_t time_unit_ms = 1000;
    /// Task cycles of the controllers, such as `task cycle 10ms`; empty if all cycle times are zero.
    std::string cycle = {};
    /// Plant approach and schedule of an untimed model, such as `no plant` or `plant automata, interleaved`; empty for
    /// a timed check.
    std::string untimed = {};
    std::vector<NamedConstant> constants = {};  ///< constants of the loop with their current values

    bool operator==(const CheckSettings&) const = default;
};

struct PropertyResult {
    Verdict verdict = {};
    std::string text = {};               ///< text of the property in the model
    std::optional<ChartRun> trace = {};  ///< counterexample or witness

    /// What an untimed verdict implies for the timed closed loop; empty for a timed check.
    std::string preservation = {};
    std::string place = {};  ///< `file:line` of the property, if the sources are available

    bool operator==(const PropertyResult&) const = default;
};

/// A model error and the run that leads to it.
struct ModelErrorTrace {
    std::string code = {};  ///< code of the error: `out-of-range`, `action-race` or `no-value`
    std::string message = {};
    ChartRun trace = {};

    bool operator==(const ModelErrorTrace&) const = default;
};

struct Report {
    std::string model = {};  ///< name of the closed loop
    CheckSettings settings = {};
    std::vector<PropertyResult> answers = {};
    std::vector<ModelErrorTrace> error_traces = {};
    std::vector<std::string> failures = {};    ///< internal errors: unreported runs that the replay does not confirm
    std::optional<StateProfile> profile = {};  ///< state profile, if the search was long or a profile was requested

    bool operator==(const Report&) const = default;
};

}  // namespace grafverif
