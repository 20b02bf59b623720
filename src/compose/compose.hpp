// SPDX-License-Identifier: MIT
// compose: the plant's Network and the Equations of its controllers -> the Network of the closed loop (CEP13
// sections 5.4 and 6); a verb.
//
// Per controller, the generic PLC cycle of CEP13 Fig. 33a (`plc_cycle`), one timer per time condition (Fig. 33b,
// repaired: see timers.hpp), and the flags that couple it with the plant:
//   EVOL_PL   an edge of the plant or its environment has assigned an input     set there, reset when a cycle starts
//   EVOL_TI   the end of a timer has changed                                    set by the timers, reset likewise
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
// All these edges are urgent. A location `init` before W calls start() (actions on activation of the initial steps)
// where there are such actions, or the mode is every_cycle; then outputs are written there too.
//
// Assignments are sequential; where an update would read a variable that an earlier one of its procedure has
// overwritten, a scratch variable (`COUNT_old`) keeps its value. Inputs and timer ends that evolve() and write() read
// are sampled in fire(), for in the phased grain they may change meanwhile. Outputs of stored actions have an image
// (`LOCK_image`) that evolve() changes and write() copies. With several controllers, what belongs to one bears its
// name: `press_X_2`.
#pragma once

#include <optional>
#include <span>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// The cures of the method, each of which can be left out to see the failure that it removes. For tests and for the
/// page on the method only.
struct Ablations {
    bool cycle_always = false;         ///< guard of W -> P0 without flags: the cycle of CEP13 Fig. 17
    bool cycle_unless_stable = false;  ///< guard of W -> P0 without `stable`, outputs in every cycle: CEP13 Fig. 24
    bool timers_as_published =
        false;                        ///< CEP13 Fig. 33b: a step left and activated anew within one instant is not seen
    bool sensors_not_urgent = false;  ///< edges that assign an input of a controller let time pass: CEP13 Fig. 12b

    bool operator==(const Ablations&) const = default;
};

struct ComposeOptions {
    std::optional<Grain> grain = {};         ///< wins over the loop's
    std::optional<ExecutionMode> mode = {};  ///< wins over the controllers'
    Ablations ablations = {};
};

/// Requires: `plant` is what plant(model, loop) returned; `equations` are those of the loop's controllers, in order.
std::optional<Network> compose(const Network& plant, const ClosedLoop& loop, std::span<const Equations> equations,
                               const ComposeOptions& options, Diagnostics& diagnostics);

}  // namespace grafverif
