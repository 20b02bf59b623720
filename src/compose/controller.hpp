// SPDX-License-Identifier: MIT
// ControllerParts: where the parts of one controller stand in the network being composed.
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
    std::string prefix = {};  ///< of its names: empty for the only controller
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    bool starts = false;  ///< the first evolution has something to do, and an edge of its own
    Span origin = {};

    /// Per variable of the equations: the variable that others see; the one that stores an output until it is written;
    /// the one that holds an input from fire() on. Not valid where there is none.
    std::vector<Id<Network::Variable>> variable = {}, image = {}, sample = {};
    std::vector<Id<Equations::Variable>> sampled = {};  ///< those with a sample, in order
    std::vector<bool> sample_written = {};              ///< per variable: its sample lives until write()

    Id<Network::Variable> evol_pl = {}, evol_ti = {}, stable = {};  ///< evol_ti: only with timers
    std::vector<Id<Network::Variable>> pending = {};                ///< per timer; empty for timers as published
};

/// What is shared while a network is composed.
struct Composition {
    Network network = {};
    UniqueNames names = {};  ///< of variables, templates and processes
    Ablations ablations = {};
    std::vector<ControllerParts> controllers = {};
    std::vector<std::vector<std::uint32_t>> readers =
        {};                           ///< per variable of the plant: the controllers whose input it is
    Id<Network::Variable> race = {};  ///< only where two stored actions can race
    /// Templates of timers, each added with the first one of its kind: t1/v, v/t2, t1/v/t2.
    Id<Network::Template> on_delay = {}, off_delay = {}, both_delays = {};
};

/// Adds the variables of a controller: steps, internals, firing conditions, images, samples, timers, flags.
void declare(Composition& composition, const ClosedLoop& loop, ControllerParts& parts);

/// Adds the template and process of its PLC cycle, and the controller, whose timers are to follow.
Id<Network::Controller> add_cycle(Composition& composition, const ControllerParts& parts);

/// Adds the timers of `controller`.
void add_timers(Composition& composition, const ControllerParts& parts, Id<Network::Controller> controller);

/// Makes every edge of the plant that assigns an input of a controller set its EVOL_PL.
void add_plant_flags(Composition& composition);

/// The formula of Network::settled.
Id<Expr> settled(Composition& composition);

/// The properties of the loop in terms of the network, and `no_race`.
void add_properties(Composition& composition, const ClosedLoop& loop);

inline Id<Expr> leaf(Network& network, Id<Network::Variable> variable) {
    return network.exprs.leaf(Op::Variable, variable.index);
}

}  // namespace grafverif
