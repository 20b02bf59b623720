// SPDX-License-Identifier: MIT
// compose: translates the plant's Network and the Equations of its controllers to the Network of the closed loop (CEP13
// sections 5.4 and 6).
//
// Each controller has the generic PLC cycle of CEP13 Fig. 33a (`plc_cycle`), one timer per time condition (Fig. 33b,
// corrected: see timers.hpp), and the flags that couple it with the plant:
//   EVOL_PL   an edge of the plant or its environment has assigned an input     set there, reset when a cycle starts
//   EVOL_TI   the output of a timer has changed                                 set by the timers, reset with EVOL_PL
//   stable    one more cycle with the same inputs would change nothing          false at power-on
//
//   grain phased                                        grain atomic
//     W  -> P0 [(!stable || EVOL_PL || EVOL_TI)           W -> W [the same] flags reset, fire(), evolve(), write()
//               && no timer pending] flags reset
//     P0 -> P1 fire()    firing conditions, samples
//     P1 -> P2 evolve()  pending timers, stable, stored actions, steps
//     P2 -> W  [stable] write()    outputs
//     P2 -> W  [!stable]
//   every_cycle: P2 -> W write(), whether stable or not.
// All these edges are urgent. A location `init` before W calls start() if the initial steps have actions on activation,
// or in mode every_cycle; in this mode it also writes the outputs.
//
// Assignments are sequential. If an update would read a variable that an earlier one of its procedure has overwritten,
// a scratch variable (`COUNT_old`) keeps its value. Inputs and timer outputs that evolve() and write() read are sampled
// in fire(), because in the phased grain they may change during the cycle. Outputs of stored actions have an image
// (`LOCK_image`) that evolve() changes and write() copies. With several controllers, names are qualified by the
// controller: `press_X_2`.
#pragma once

#include <optional>
#include <span>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// The corrections of the published method. Each can be disabled to show the failure that it prevents. They are
/// disabled only by tests and by the documentation of the method.
struct Ablations {
    bool cycle_always = false;         ///< guard of W -> P0 without flags: the cycle of CEP13 Fig. 17
    bool cycle_unless_stable = false;  ///< guard of W -> P0 without `stable`, outputs in every cycle: CEP13 Fig. 24
    bool timers_as_published =
        /// CEP13 Fig. 33b: if a step is deactivated and activated again within one instant, the timer does not detect
        /// this.
        false;
    bool sensors_not_urgent = false;  ///< edges that assign an input of a controller let time pass: CEP13 Fig. 12b

    bool operator==(const Ablations&) const = default;
};

struct ComposeOptions {
    std::optional<Grain> grain = {};         ///< overrides the granularity of the loop
    std::optional<ExecutionMode> mode = {};  ///< overrides the modes of the controllers
    Ablations ablations = {};
};

/// Composes the loop. Requires that `plant` is the result of plant(model, loop), and that `equations` are those of the
/// loop's controllers, in order.
std::optional<Network> compose(const Network& plant, const ClosedLoop& loop, std::span<const Equations> equations,
                               const ComposeOptions& options, Diagnostics& diagnostics);

}  // namespace grafverif
