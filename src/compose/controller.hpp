// SPDX-License-Identifier: MIT
// ControllerParts: the elements of one controller in the network under construction.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "compose/compose.hpp"
#include "support/unique_names.hpp"

namespace grafverif {

struct ControllerParts {
    const Equations* equations = nullptr;
    std::string name = {};
    std::string prefix = {};  ///< prefix of the controller's names; empty if there is only one controller
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    /// Task cycle; if empty, the cycle time is zero.
    std::optional<TaskCycle> cycle = {};
    /// True if the template of the PLC cycle has an edge from the location `init`, which executes the first evolution.
    bool starts = false;
    Span origin = {};

    /// Three variables for each variable of the equations: the variable that other processes read, the variable that
    /// stores an output until it is written, and the variable that stores an input after fire(). An id is invalid if
    /// the network does not contain this variable.
    std::vector<Id<Network::Variable>> variable = {}, image = {}, sample = {};
    std::vector<Id<Equations::Variable>> sampled = {};  ///< variables of the equations with a sample, in order
    std::vector<bool> sample_written = {};              ///< for each variable: true if write() reads its sample

    /// Flags of the controller. `evol_ti` is valid only if there are timers. With a task cycle, time starts the scans,
    /// and EVOL_PL and EVOL_TI do not exist.
    Id<Network::Variable> evol_pl = {}, evol_ti = {}, stable = {};
    /// For each timer: the variable by which the controller requests a start or stop of the timer; empty if
    /// Ablations::timers_as_published is true.
    std::vector<Id<Network::Variable>> pending = {};

    /// True if a scan of the task cycle can have several evolutions. Each scan of this controller samples the inputs
    /// once, when the scan starts, and `stable` is false until the last evolution of the scan.
    bool holds_inputs() const { return cycle && mode == ExecutionMode::StabilitySearch; }
    /// True if the variable is an input whose sample is kept for all evolutions of a scan.
    bool is_held(Id<Equations::Variable> id) const {
        return holds_inputs() && equations->variables[id].role == Equations::Role::Input;
    }
};

/// Data shared while a network is composed.
struct Composition {
    Network network = {};
    UniqueNames names = {};  ///< names of variables, templates and processes
    Ablations ablations = {};
    std::vector<ControllerParts> controllers = {};
    /// For each variable of the plant: the controllers without a task cycle that have this variable as an input.
    std::vector<std::vector<std::uint32_t>> readers = {};
    /// Flag of a race; valid only if a race of stored actions is possible.
    Id<Network::Variable> race = {};
    /// Templates of timers by type. The type consists of the delays that the timer has, and of the members `flags` and
    /// `waits` of its coupling (timers.cpp). A template is added with the first timer of its type.
    std::map<std::tuple<int, bool, bool>, Id<Network::Template>> timers = {};
};

/// Adds the variables of a controller: steps, internal variables, firing conditions, images, samples, timers, flags.
void declare(Composition& composition, const ClosedLoop& loop, ControllerParts& parts);

/// Adds the template and the process of the controller's PLC cycle, and the controller. The timers of the controller
/// are added later.
Id<Network::Controller> add_cycle(Composition& composition, const ControllerParts& parts);

/// Adds the timers of `controller`.
void add_timers(Composition& composition, const ControllerParts& parts, Id<Network::Controller> controller);

/// Extends every edge of the plant that assigns an input of a controller, so that the edge sets the flag EVOL_PL of
/// this controller.
void add_plant_flags(Composition& composition);

/// Returns the term Network::settled, which is true if the network is quiescent.
Id<Expr> settled(Composition& composition);

/// Adds the properties of the loop that read no observer, the constraints as properties and, if the network has the
/// flag `race`, the property `no_race`.
void add_properties(Composition& composition, const ClosedLoop& loop);

inline Id<Expr> leaf(Network& network, Id<Network::Variable> variable) {
    return network.exprs.leaf(Op::Variable, variable.index);
}

}  // namespace grafverif
