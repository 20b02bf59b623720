// SPDX-License-Identifier: MIT
// ControllerParts: the elements of one controller in the network under construction.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compose/compose.hpp"
#include "support/unique_names.hpp"

namespace grafverif {

struct ControllerParts {
    const Equations* equations = nullptr;
    std::string name = {};
    std::string prefix = {};  ///< prefix of the controller's names; empty if there is only one controller
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    bool starts = false;  ///< true if the first evolution has an effect and therefore a separate edge
    Span origin = {};

    /// Three variables for each variable of the equations: the variable that other processes read, the variable that
    /// stores an output until it is written, and the variable that stores an input after fire(). An id is invalid if
    /// there is no such variable.
    std::vector<Id<Network::Variable>> variable = {}, image = {}, sample = {};
    std::vector<Id<Equations::Variable>> sampled = {};  ///< variables of the equations with a sample, in order
    std::vector<bool> sample_written = {};              ///< for each variable: true if write() reads its sample

    /// Flags of the controller. `evol_ti` is valid only if there are timers.
    Id<Network::Variable> evol_pl = {}, evol_ti = {}, stable = {};
    /// Request of each timer; empty if Ablations::timers_as_published.
    std::vector<Id<Network::Variable>> pending = {};
};

/// Data shared while a network is composed.
struct Composition {
    Network network = {};
    UniqueNames names = {};  ///< names of variables, templates and processes
    Ablations ablations = {};
    std::vector<ControllerParts> controllers = {};
    /// For each variable of the plant: controllers with this input.
    std::vector<std::vector<std::uint32_t>> readers = {};
    Id<Network::Variable> race = {};  ///< valid only if a race of stored actions is possible
    /// Templates of timers (t1/v, v/t2, t1/v/t2). A template is added with the first timer of its type.
    Id<Network::Template> on_delay = {}, off_delay = {}, both_delays = {};
};

/// Adds the variables of a controller: steps, internal variables, firing conditions, images, samples, timers, flags.
void declare(Composition& composition, const ClosedLoop& loop, ControllerParts& parts);

/// Adds the template and the process of the controller's PLC cycle, and the controller. The timers of the controller
/// are added later.
Id<Network::Controller> add_cycle(Composition& composition, const ControllerParts& parts);

/// Adds the timers of `controller`.
void add_timers(Composition& composition, const ControllerParts& parts, Id<Network::Controller> controller);

/// Extends every edge of the plant that assigns an input of a controller, so that it sets the EVOL_PL of this
/// controller.
void add_plant_flags(Composition& composition);

/// Builds the formula Network::settled.
Id<Expr> settled(Composition& composition);

/// Translates the properties of the loop to the network, and adds `no_race`.
void add_properties(Composition& composition, const ClosedLoop& loop);

inline Id<Expr> leaf(Network& network, Id<Network::Variable> variable) {
    return network.exprs.leaf(Op::Variable, variable.index);
}

}  // namespace grafverif
