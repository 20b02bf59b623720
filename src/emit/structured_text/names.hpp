// SPDX-License-Identifier: MIT
// The names of a controller in Structured Text.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "emit/structured_text/structured_text.hpp"
#include "grafverif/ir/equations.hpp"
#include "syntax/print/legal_names.hpp"

namespace grafverif::structured_text {

/// What a tester and a controller must agree on. They come first, so that nothing within a block takes their names.
struct InterfaceNames {
    std::string block = {};
    std::vector<std::string> variables = {};  ///< inputs, then outputs
};
InterfaceNames interface_names(const std::string& chart, std::span<const std::string> inputs,
                               std::span<const std::string> outputs);

struct TimerNames {
    std::string on = {};      ///< the TON; empty: no rise time
    std::string lasted = {};  ///< whether the rise time is over; where there are both times
    std::string off = {};     ///< the TOF; empty: no fall time
};

struct Names {
    std::string block = {};
    std::vector<std::string> variables = {};  ///< per variable: as the interface has it
    std::vector<std::string> storage =
        {};  ///< per variable: where its value is kept; outputs of stored actions: an image
    std::vector<std::string> fresh = {};  ///< per variable: for its new value, where it has to wait
    std::vector<TimerNames> timers = {};
    std::string started = {}, stable = {}, evolutions = {}, limit = {}, fault = {};
    std::vector<Renaming> changed = {};
};
Names names_of(const Equations& equations);

}  // namespace grafverif::structured_text
