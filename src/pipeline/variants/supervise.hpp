// SPDX-License-Identifier: MIT
// Supervisory control: conditions on the charts of a closed loop that enforce its properties. The conditions are
// computed by solving a game on the untimed model with grain atomic, and are inserted into the text of the charts.
// Before the result is reported, the modified text is parsed, and two engines prove the properties again.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/supervise/supervise.hpp"
#include "grafverif/grafverif.hpp"

namespace grafverif {

struct SuperviseRequest {
    /// Names of the properties to enforce. If empty, all properties of single states are enforced, except properties
    /// that are expected to be violated.
    std::vector<std::string> properties = {};
    std::string marked = {};  ///< term of the loop that marked states satisfy; the initial situation if empty
    bool transitions = true, outputs = true;  ///< elements to which conditions may be added
    std::optional<ExecutionMode> mode = {};
    ReadOptions read = {};  ///< options with which the model was read
    Limits limits = {};
};

/// A condition and the element that it restricts.
struct ChartCondition {
    std::string chart = {};
    std::string subject = {};  ///< name of the element: `t3`, `CLOSE`
    std::string step = {};     ///< for an output: the step variable of the action, `X10`; otherwise empty
    std::string term = {};     ///< term that is added to the existing condition, as in the text
    bool sum = false;          ///< true if the term needs parentheses after `&&`
    Span origin = {};          ///< position of the transition or action
};

struct Supervised {
    std::string loop = {};
    /// A property of the loop about which the result states nothing.
    struct Ignored {
        std::string property = {}, reason = {};
    };
    std::vector<std::string> kept = {};  ///< names of the enforced properties
    std::vector<Ignored> ignored = {};
    std::string marked = {};  ///< the term as given; the initial situation if empty
    Supervisor::Outcome outcome = Supervisor::Outcome::Unknown;
    std::string reason = {};  ///< reason for an unknown outcome
    Supervisor::Permissiveness claim = Supervisor::Permissiveness::Least;
    std::vector<std::string> hidden = {}, traded = {};  ///< names of elements; see Supervisor
    std::vector<ChartCondition> conditions = {};
    /// Transitions that are never cleared and outputs that are never set because the conditions are never true. If
    /// there are such transitions or outputs, the conditions are valid but not useful.
    std::vector<std::string> disabled_transitions = {}, disabled_outputs = {};
    /// Variables of steps that are active in some reachable state without the conditions, but in no reachable state
    /// with the conditions.
    std::vector<std::string> never_active_steps = {};
    /// The verdict in the timed loop with grain atomic, without conditions, on a property that the untimed model
    /// violates without conditions. If the property holds in the timed loop, it depends on durations, which the untimed
    /// model omits.
    struct Timed {
        std::string property = {};
        Outcome outcome = Outcome::Unknown;
    };
    std::vector<Timed> timed = {};
    Outcome timelock = Outcome::Unknown;  ///< result of `no timelock` with the conditions
    /// The file to which the conditions are added; invalid if there are several such files or none.
    std::optional<Id<Source>> file = {};
    std::string text = {};             ///< text of that file with the conditions
    std::optional<ChartRun> run = {};  ///< if no conditions are sufficient: a run that cannot be prevented
    bool blocked = false;  ///< true if the last state of the run is not bad, but no marked state is reachable from it
    /// Internal failures; if the list is not empty, all other results are invalid.
    std::vector<std::string> failures = {};
};

/// Synthesizes the conditions. `main` is the source from which `model` was read; `sources` also contains its includes.
/// The result is empty after an error: a property does not exist or does not concern single states, or the term is
/// invalid.
std::optional<Supervised> supervised(const Model& model, Id<ClosedLoop> loop, Id<Source> main, Sources& sources,
                                     const SuperviseRequest& request, Diagnostics& diagnostics);

}  // namespace grafverif
