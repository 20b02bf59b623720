// SPDX-License-Identifier: MIT
// Equations executed as they stand, cycle by cycle: what they mean, without any network around them. For the law that
// they agree with the interpreter, and for tests that look at single cycles.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/equations.hpp"

namespace grafverif {

struct EquationsState {
    std::vector<std::int64_t> values =
        {};  ///< per variable, at the end of the cycle; firing conditions 0, inputs initial
    std::vector<std::int64_t> outputs = {};   ///< per variable: outputs as written
    std::vector<std::int64_t> ages = {};      ///< per timer: since its step was activated; inactive: -1
    bool started = false;

    auto operator<=>(const EquationsState&) const = default;
};

struct EquationsCycle {
    EquationsState state = {};
    std::vector<std::vector<std::size_t>> fired = {};   ///< per evolution: indices into Equations::firings
    bool stable = false;
    bool race = false;
    bool no_value = false;
    bool out_of_range = false;
    bool endless = false;
};

EquationsState power_on(const Equations& equations);

/// `inputs`: per variable; only the entries of inputs are read.
EquationsCycle cycle(const Equations& equations, const EquationsState& state, std::span<const std::int64_t> inputs,
                     ExecutionMode mode);

EquationsState pass_time(EquationsState state, std::int64_t milliseconds);

}  // namespace grafverif
