// SPDX-License-Identifier: MIT
// FaultAnalysis: the combinations of faults of a closed loop that violate its properties, and the steps and outputs
// that each fault affects.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/report.hpp"

namespace grafverif {

/// A combination of faults: indices in FaultAnalysis::faults, in increasing order.
using FaultSet = std::vector<std::size_t>;

struct FaultAnalysis {
    /// A property that a fault violates and that holds without faults.
    struct Observer {
        std::string property = {};  ///< its declaration, such as `property detects_A: never S1 && !S2 at stable;`
        /// Holds if, in every run in which the fault occurs, the property is violated after the fault has occurred.
        Outcome in_every_run = Outcome::Unknown;
        std::optional<std::int64_t> within_ms = {};  ///< the longest time from the fault to the violation
        std::string declared = {};  ///< its name if the loop declares it; empty for a proposed property
        bool operator==(const Observer&) const = default;
    };
    /// Names of the visible elements (steps and Boolean outputs of controllers) that a fault affects.
    struct Visible {
        /// Elements that are true in some reachable state if the fault may occur, but in no reachable state without
        /// faults.
        std::vector<std::string> newly_true = {};
        /// Elements that are true in some reachable state without faults, but in no reachable state if the fault is
        /// present from power-on.
        std::vector<std::string> never_true = {};
        /// Outcome of the query: if the fault is present from power-on, some element of `newly_true` becomes true in
        /// every run.
        Outcome always_shown = Outcome::Unknown;
        /// Holds if, in every run in which the fault occurs, an element of `newly_true` becomes true after the fault.
        Outcome detected = Outcome::Unknown;
        std::optional<std::int64_t> within_ms = {};  ///< maximum time from the fault to the event in `detected`
        /// A property that reveals the fault, if steps and outputs do not reveal the fault in every run.
        std::optional<Observer> observer = {};
        /// The limit that the search for `observer` has reached, such as `the search for an observer tried 6 of 14
        /// conditions`; empty if the search has reached no limit.
        std::string observer_limit = {};
        bool decided = false;  ///< false: the search was stopped, and the lists are incomplete
        bool operator==(const Visible&) const = default;
    };
    struct Fault {
        std::string name = {}, instance = {}, component = {};
        Span origin = {};
        Visible visible = {};
    };
    /// A combination of faults for which the property is violated, with the run that violates it.
    struct Cut {
        FaultSet faults = {};
        /// The faults that are present from power-on; all other faults of `faults` occur later in the run.
        FaultSet from_power_on = {};
        PropertyResult result = {};
        /// Proper subsets of `faults` for which the verdict is unknown. If this list is not empty, the combination may
        /// not be minimal.
        std::vector<FaultSet> unknown_subsets = {};
    };
    /// A combination of faults for which the verdict of the property is unknown.
    struct Open {
        FaultSet faults = {};
        std::string reason = {};
    };
    /// A `reachable` property is violated for the combination `violating`, but holds for its superset `holding`.
    struct NonMonotone {
        FaultSet violating = {}, holding = {};
    };
    struct Row {
        std::string property = {}, text = {};
        Pattern pattern = Pattern::Always;
        /// False if the model does not declare the property, or if the property was not requested.
        bool declared = true;
        Span origin = {};
        Outcome without_faults = Outcome::Unknown;
        bool expected_violated =
            false;  ///< true: the model declares that the loop without faults violates the property
        std::vector<Cut> minimal = {};
        std::vector<Open> open = {};
        std::vector<NonMonotone> non_monotone = {};
    };
    /// A model error that occurs if the faults of the combination `faults` may occur.
    struct Error {
        FaultSet faults = {};
        ModelErrorTrace trace = {};
    };

    std::string model = {};  ///< name of the closed loop
    CheckSettings settings = {};
    std::size_t order = 1;  ///< maximum number of faults in a combination
    std::vector<Fault> faults = {};
    std::vector<Row> rows = {};
    std::vector<Error> errors = {};
    std::size_t combinations = 0;  ///< number of combinations of at most `order` faults
    std::size_t checks = 0;        ///< number of checks of models of the loop, including the check without faults
    std::vector<std::string> failures = {};  ///< internal errors of the analysis
};

}  // namespace grafverif
