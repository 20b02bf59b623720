// SPDX-License-Identifier: MIT
// schedule_program: translates a Scan to a TransitionSystem. A state consists of the cells before a scan and of the
// inputs that it will read, which are free; one step is one scan. A property concerns the end of that scan. It is a
// term over the state before the scan, so that no copy of the inputs is needed. Only the cells on which the properties
// depend are variables.
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
    Id<Expr> condition = {};            ///< condition over the equations of the scan
    Span origin = {};
    bool about_fault = false;  ///< the condition is about the scan of the first fault, otherwise about scans before it
};

struct ProgramSystem {
    TransitionSystem system = {};
    /// Symbol of each variable of the equations; invalid if no property depends on it.
    std::vector<Id<TransitionSystem::Symbol>> symbols = {};
    /// The property that no scan has a fault; invalid if none can. The others are about scans until then.
    Id<Property> no_fault = {};
};

ProgramSystem schedule_program(const Scan& scan, const std::vector<ScanProperty>& properties);

/// For each variable of the equations: true if `roots` depend on it, directly or through next values.
std::vector<bool> variables_read(const Scan& scan, std::vector<Id<Expr>> roots);

}  // namespace grafverif
