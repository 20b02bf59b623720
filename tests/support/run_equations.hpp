// SPDX-License-Identifier: MIT
// Executes equations directly, cycle by cycle, without a network. This implementation is the
// reference for the comparison of equations with the interpreter, and for tests of single cycles.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/equations.hpp"

namespace grafverif {

/// The times since the level that a timer watches became true and false, in milliseconds; -1 if a time does not apply.
struct EquationsTiming {
    std::int64_t risen = -1;   ///< time since the level became true
    std::int64_t fallen = -1;  ///< time since the level became false after it had been true for t1

    auto operator<=>(const EquationsTiming&) const = default;
};

struct EquationsState {
    /// Values at the end of the cycle, indexed by variable. Firing conditions are 0, and inputs have initial values.
    std::vector<std::int64_t> values = {};
    std::vector<std::int64_t> outputs = {};    ///< the outputs that were written, indexed by variable
    std::vector<EquationsTiming> timing = {};  ///< indexed by timer
    bool started = false;

    auto operator<=>(const EquationsState&) const = default;
};

struct EquationsCycle {
    EquationsState state = {};
    std::vector<std::vector<std::size_t>> fired = {};  ///< indices into Equations::firings, for each evolution
    bool stable = false;
    bool race = false;
    bool conflict = false;  ///< forcing orders conflict
    bool no_value = false;
    bool out_of_range = false;
    bool endless = false;
    bool torn = false;  ///< an `activated` or `deactivated` value contradicts the step's activity
};

/// True if `timer` has expired.
bool is_over(const Equations::Timer& timer, const EquationsTiming& timing);

/// Updates the timer with the level of the watched term before and after a cycle.
void note_level(const Equations::Timer& timer, bool before, bool after, EquationsTiming& timing);

EquationsState power_on(const Equations& equations);

/// Executes one cycle. `inputs` is indexed by variable; only the entries of inputs are read.
EquationsCycle cycle(const Equations& equations, const EquationsState& state, std::span<const std::int64_t> inputs,
                     ExecutionMode mode);

void pass_time(EquationsTiming& timing, std::int64_t milliseconds);
EquationsState pass_time(EquationsState state, std::int64_t milliseconds);

}  // namespace grafverif
