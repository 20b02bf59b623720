// SPDX-License-Identifier: MIT
// compose: translates the plant's Network and the Equations of its controllers to the Network of the closed loop (CEP13
// sections 5.4 and 6).
//
// Each controller has the generic PLC cycle of CEP13 Fig. 33a (`plc_cycle`), one timer per time condition (Fig. 33b,
// corrected: see timers.cpp), and the flags that couple it with the plant:
//   `EVOL_PL`: An edge of the plant, the environment or another controller has assigned an input. This edge sets the
//              flag, and the start of a cycle resets it.
//   `EVOL_TI`: The output of a timer has changed. The timers set the flag, and the start of a cycle resets it.
//   `stable`:  One more cycle with the same inputs would change nothing. The flag is false at power-on.
//
//   grain phased                                        grain atomic
//     W  -> P0 [(!stable || EVOL_PL || EVOL_TI)           W -> W [the same] flags reset, fire(), evolve(), write()
//               && no timer pending] flags reset
//     P0 -> P1 fire()    firing conditions, samples
//     P1 -> P2 evolve()  pending timers, stable, stored actions, steps
//     P2 -> W  [stable] write()    outputs
//     P2 -> W  [!stable]
//   Mode every_cycle: P2 -> W write(), also if the situation is not stable.
// If a controller has a task cycle LEAST..MOST, time starts its scans, and its flags EVOL_PL and EVOL_TI do not exist.
// Each edge to W resets the clock clk:
//     W  -> P0 [clk >= LEAST && no timer pending], not urgent; invariant of W: clk <= MOST
// Under stability search, the edge that starts a scan samples the inputs for all evolutions of the scan, and `stable`
// is false until the end of the scan. The urgent edge W -> P0 [!stable && no timer pending] continues the scan. Under
// stability search with a task cycle, the timers elapse only while `stable` is true. The scan at power-on begins with
// the edge from `init`.
//
// Except for the edge that starts a scan of a task cycle, all edges of the PLC cycle are urgent. If the first evolution
// has an effect, an edge from the location `init` to W calls start(). In mode every_cycle, and if the controller has a
// task cycle, the edge from `init` always exists; in mode every_cycle, this edge also writes the outputs.
//
// The assignments of a procedure are executed sequentially. If an assignment would read a variable that an earlier
// assignment of the procedure has overwritten, a scratch variable (`COUNT_old`) stores the old value. Inputs and timer
// outputs that evolve() and write() read are sampled in fire(), because these values may change during the cycle in the
// phased grain. An output with stored actions has an image (`LOCK_image`), which evolve() changes and write() copies to
// the output. If there are several controllers, names begin with the name of the controller: `press_X_2`.
#pragma once

#include <optional>
#include <span>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// The corrections of the published method. Each correction can be disabled to show the failure that it prevents. Only
/// tests and the documentation of the method disable corrections.
struct Ablations {
    bool cycle_always = false;         ///< as in CEP13 Fig. 17: guard of W -> P0 without flags and `stable`
    bool cycle_unless_stable = false;  ///< as in CEP13 Fig. 24: guard of W -> P0 without `stable`, mode every_cycle

    /// If true, timers are as published in CEP13 Fig. 33b: a timer does not detect that a step is deactivated and
    /// activated again within one instant.
    bool timers_as_published = false;
    bool sensors_not_urgent = false;  ///< as in CEP13 Fig. 12b: edges that assign inputs of controllers are not urgent

    bool operator==(const Ablations&) const = default;
};

struct ComposeOptions {
    std::optional<Grain> grain = {};         ///< overrides the granularity of the loop
    std::optional<ExecutionMode> mode = {};  ///< overrides the modes of the controllers
    Ablations ablations = {};
};

/// Composes the loop. Requires that `plant` is the result of plant(model, loop), and that `equations` contains the
/// equations of the loop's controllers, in order.
std::optional<Network> compose(const Network& plant, const ClosedLoop& loop, std::span<const Equations> equations,
                               const ComposeOptions& options, Diagnostics& diagnostics);

}  // namespace grafverif
