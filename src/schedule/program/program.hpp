// SPDX-License-Identifier: MIT
// schedule_program: Scan -> TransitionSystem. A state consists of the cells before a scan and of the inputs that it
// will read, which are free; one step is one scan. A property is about the end of that scan: a term over the state
// before it, so that no copy of the inputs is needed. Only the cells on which the properties depend are variables.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/transition_system.hpp"
#include "ir/program/scan.hpp"

namespace grafverif {

/// A property of the values at the end of a scan.
struct ScanProperty {
    std::string name = {};
    std::string text = {};
    Pattern pattern = Pattern::Always;  ///< Always, Never or Reachable
    Id<Expr> condition = {};            ///< over the equations of the scan
    Span origin = {};
};

struct ProgramSystem {
    TransitionSystem system = {};
    /// Per variable of the equations: its symbol; invalid if no property depends on it.
    std::vector<Id<TransitionSystem::Symbol>> symbols = {};
    /// The property that no scan divides by zero; invalid if none can. The others are about scans until then.
    Id<Property> no_fault = {};
};

ProgramSystem schedule_program(const Scan& scan, const std::vector<ScanProperty>& properties);

}  // namespace grafverif
