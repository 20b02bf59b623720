// SPDX-License-Identifier: MIT
// Detection of a fault: determines the time after which steps and outputs of the controllers show the fault. For a
// fault that they do not show, proposes a property that reveals the fault.
//
// The networks with a fault in this file contain an announced fault (pipeline/variants/fault_model.hpp): when the fault
// occurs, its instance is in the last location of its process for an instant. A fault is detected if this location
// leads to a condition that is true in no run without faults.
//
// A complete search determines the longest time to this condition. An observer starts a clock when the fault occurs and
// leaves its location when the condition is true; the longest time is the maximum value of this clock in all states. If
// all constraints are closed, this maximum is also the maximum in dense time, because the longest time of a path
// between two states is attained at integer times. If a constraint is strict, the timed engine does not decide that the
// fault is always detected, and no time is reported.
//
// A proposed property is `never a at stable` or `never a && b at stable`, in which a and b are inputs, outputs or steps
// of the controllers, or their complements. In the second form, each of a and b is true in some quiescent state without
// faults. The literals and pairs that are true in some quiescent state with the fault, but in none without faults, are
// found by complete searches. These searches decide the property without faults and with the fault, too.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/grafverif.hpp"
#include "ir/fault_analysis.hpp"

namespace grafverif {

/// The name of a step, input or output in properties, and its Boolean variable. Examples: `S1` and `X2`; if there are
/// several controllers, `press.X2`.
struct ControllerSignal {
    std::string name = {};
    Id<Network::Variable> variable = {};
};

/// Returns the steps and Boolean outputs of all controllers and, if `inputs` is true, their Boolean inputs.
std::vector<ControllerSignal> controller_signals(const Network& network, bool inputs);

/// Returns the term that is true if at least one of the steps and outputs `names` is true.
Id<Expr> any_of_signals(Network& network, const std::vector<std::string>& names);

class FaultDetection {
public:
    /// A function that decides the properties of a network.
    using Decide = std::function<std::vector<Verdict>(const Network&)>;

    /// Searches visit at most `max_states` states. `network` is the loop without faults. The constructor searches it
    /// for the pairs of literals that `observer` requires.
    FaultDetection(const Network& network, const Limits& limits, std::uint64_t max_states);

    /// Decides if at least one of the steps and outputs `names` becomes true in every run in which the fault occurs,
    /// and returns the longest time to this event. `faulty` contains the announced fault of the process `instance`.
    struct Detected {
        Outcome in_every_run = Outcome::Unknown;
        std::optional<std::int64_t> within_ms = {};
    };
    Detected detected(Network faulty, const std::string& instance, const std::vector<std::string>& names,
                      const Decide& decide) const;

    /// The result of the search for a property that reveals a fault: the property, if one was found, and the limit that
    /// the search has reached.
    struct Proposal {
        std::optional<FaultAnalysis::Observer> observer = {};
        std::string limit = {};
    };
    /// Returns a property of the considered form with the name `name` that reveals the fault. If several properties do,
    /// a property that is violated in every run with the fault is preferred. If the loop declares a property with the
    /// same condition, the result is this property. `decide` must be a check of the loop with the announced fault.
    Proposal observer(const std::string& name, const Network& faulty, const std::string& instance,
                      const Decide& decide) const;

private:
    std::optional<std::int64_t> longest_time(Network network, const std::string& instance, Id<Expr> condition) const;
    /// The number of quiescent states in which each pair of literals is true. The pair (k, k) is the literal k.
    struct Pairs {
        std::vector<std::uint32_t> counts = {};
        /// True if a pair with the number 0 is false in each quiescent state of all runs in dense time.
        bool exact = false;
    };
    /// Returns an empty result if a limit ends the search.
    std::optional<Pairs> pairs_in(Network network) const;
    /// Returns the literals and pairs that are true only with the fault. The pair (k, l) has the number k * literals +
    /// l. The pairs that are true in the most states come first.
    std::vector<std::size_t> candidates(const std::vector<std::uint32_t>& with_fault) const;
    /// Returns the name of a declared property that is violated in exactly the quiescent states in which the pair is
    /// true; empty if there is none.
    std::string declared(std::size_t pair) const;

    const Network& network_;
    Limits limits_;
    std::uint64_t max_states_;
    std::vector<ControllerSignal> signals_;
    std::optional<Pairs> normal_ = {};  ///< pairs of the loop without faults; empty if unknown
};

}  // namespace grafverif
