// SPDX-License-Identifier: MIT
// Supervisory control: adds conditions to the charts of a closed loop that enforce its properties. The solution of a
// game on the untimed model with grain atomic (a PLC cycle is one move) determines the conditions, which are inserted
// into the text of the charts. Before the result is reported, the modified text is parsed, and two engines prove the
// properties.
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
    std::string marked = {};                  ///< term that is true in marked states; the initial situation if empty
    bool transitions = true, outputs = true;  ///< elements to which conditions may be added
    std::optional<ExecutionMode> mode = {};
    ReadOptions read = {};  ///< options with which the model was read
    Limits limits = {};
};

/// A condition, and the transition or output that it restricts.
struct ChartCondition {
    std::string chart = {};
    std::string subject = {};  ///< name of the element: `t3`, `CLOSE`
    std::string step = {};     ///< for an output: the step variable of the action, `X10`; otherwise empty
    std::string term = {};     ///< term that is added to the existing condition, in source syntax
    bool sum = false;          ///< true if the term needs parentheses as an operand of `&&`
    Span origin = {};          ///< position of the transition or action
};

struct Supervised {
    std::string loop = {};
    /// A property of the loop that is not enforced, and the reason.
    struct Ignored {
        std::string property = {}, reason = {};
    };
    std::vector<std::string> kept = {};  ///< names of the enforced properties
    std::vector<Ignored> ignored = {};
    std::string marked = {};  ///< the term as given; the initial situation if empty
    Supervisor::Outcome outcome = Supervisor::Outcome::Unknown;
    std::string reason = {};  ///< reason for an unknown outcome
    Supervisor::Permissiveness claim = Supervisor::Permissiveness::Least;
    std::vector<std::string> hidden = {}, traded = {};  ///< names of transitions and outputs; see Supervisor
    std::vector<ChartCondition> conditions = {};
    /// Transitions that are never cleared, and outputs that are never set, because their conditions are never true. If
    /// one of these lists is not empty, the conditions are valid but not useful.
    std::vector<std::string> disabled_transitions = {}, disabled_outputs = {};
    /// Variables of steps that are active in some reachable state without the conditions, but in no reachable state
    /// with the conditions.
    std::vector<std::string> never_active_steps = {};
    /// The verdict on a property for the timed loop with grain atomic and without conditions. The untimed model without
    /// conditions violates this property. If the property holds in the timed loop, it depends on durations, which the
    /// untimed model omits.
    struct Timed {
        std::string property = {};
        Outcome outcome = Outcome::Unknown;
    };
    std::vector<Timed> timed = {};
    Outcome timelock = Outcome::Unknown;  ///< result of `no timelock` with the conditions

    /// The only file to which conditions are added. Empty if no file or several files need conditions.
    std::optional<Id<Source>> file = {};
    std::string text = {};             ///< text of `file` with the conditions
    std::optional<ChartRun> run = {};  ///< if conditions cannot enforce the properties: a violating run
    bool blocked = false;              ///< true if the run ends in a state without a path to a marked state

    /// Internal failures; if the list is not empty, all other results are invalid.
    std::vector<std::string> failures = {};
};

/// Synthesizes the conditions. `main` is the source from which `model` was read; `sources` also contains its includes.
/// The result is empty after an error: a property does not exist or does not concern single states, or the term
/// `marked` is invalid.
std::optional<Supervised> supervised(const Model& model, Id<ClosedLoop> loop, Id<Source> main, Sources& sources,
                                     const SuperviseRequest& request, Diagnostics& diagnostics);

}  // namespace grafverif
