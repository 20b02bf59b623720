// SPDX-License-Identifier: MIT
// Direct execution of equations, cycle by cycle, without a network: the reference for their comparison with the
// interpreter, and for tests of single cycles.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/equations.hpp"

namespace grafverif {

/// The duration of the level that a timer watches; -1: it is false.
struct EquationsTiming {
    std::int64_t risen = -1;   ///< since it became true
    std::int64_t fallen = -1;  ///< since it became false after being true for t1

    auto operator<=>(const EquationsTiming&) const = default;
};

struct EquationsState {
    std::vector<std::int64_t> values =
        {};  ///< per variable, at the end of the cycle; firing conditions 0, inputs initial
    std::vector<std::int64_t> outputs = {};    ///< per variable: outputs as written
    std::vector<EquationsTiming> timing = {};  ///< per timer
    bool started = false;

    auto operator<=>(const EquationsState&) const = default;
};

struct EquationsCycle {
    EquationsState state = {};
    std::vector<std::vector<std::size_t>> fired = {};  ///< per evolution: indices into Equations::firings
    bool stable = false;
    bool race = false;
    bool conflict = false;  ///< of forcing orders
    bool no_value = false;
    bool out_of_range = false;
    bool endless = false;
    bool torn = false;  ///< a step's `activated` or `deactivated` contradicts its activity before and after
};

/// True if `timer` has expired.
bool is_over(const Equations::Timer& timer, const EquationsTiming& timing);

/// Updates the timer with the level before and after a cycle.
void note_level(const Equations::Timer& timer, bool before, bool after, EquationsTiming& timing);

EquationsState power_on(const Equations& equations);

/// `inputs`: per variable; only the entries of inputs are read.
EquationsCycle cycle(const Equations& equations, const EquationsState& state, std::span<const std::int64_t> inputs,
                     ExecutionMode mode);

void pass_time(EquationsTiming& timing, std::int64_t milliseconds);
EquationsState pass_time(EquationsState state, std::int64_t milliseconds);

}  // namespace grafverif
