// SPDX-License-Identifier: MIT
// Assigns the names of a controller that are legal in a target language.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/equations.hpp"
#include "syntax/print/legal_names.hpp"

namespace grafverif::controller {

/// The names that a test program and the tested controller share. Interface names are assigned before internal names,
/// so that no internal name conflicts with an interface name.
struct InterfaceNames {
    std::string block = {};
    std::vector<std::string> variables = {};  ///< names of inputs, followed by names of outputs
};
InterfaceNames interface_names(const std::string& chart, std::span<const std::string> inputs,
                               std::span<const std::string> outputs, Target target,
                               std::span<const std::string_view> reserved = {});

struct TimerNames {
    /// Name of the TON; empty if there is no rise time.
    std::string on = {};
    /// Name of the condition that the rise time has elapsed; empty unless there are both a rise time and a fall time.
    std::string lasted = {};
    std::string off = {};  ///< name of the TOF; empty if there is no fall time
};

struct Names {
    std::string block = {};
    /// Name of each variable in the interface.
    std::vector<std::string> variables = {};
    /// Name of the cell that stores each variable; for an output with stored actions, the name of its image.
    std::vector<std::string> storage = {};
    std::vector<std::string> fresh = {};  ///< temporary variable for the new value of each variable, if needed
    std::vector<TimerNames> timers = {};
    std::string started = {}, stable = {}, evolutions = {}, limit = {}, fault = {};
    std::vector<Renaming> changed = {};
};
/// Returns names that are legal in the target and differ from the names in `reserved`.
Names names_of(const Equations& equations, Target target, std::span<const std::string_view> reserved = {});

}  // namespace grafverif::controller
