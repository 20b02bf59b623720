// SPDX-License-Identifier: MIT
// schedule_program: translates a Scan to a TransitionSystem. A state consists of the stored variables before a scan and
// of the inputs of this scan, which are free. One step is one scan. A property concerns the values at the end of the
// scan, but is a term over the state before the scan, so that inputs need not be copied. Only stored variables on which
// properties depend are variables of the system.
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
    Id<Expr> condition = {};            ///< term over the variables of the equations of the scan
    Span origin = {};
    /// True: the condition concerns the scan with the first fault; false: the scans before it.
    bool about_fault = false;
};

struct ProgramSystem {
    TransitionSystem system = {};
    /// Symbol of each variable of the equations; invalid if no property depends on it.
    std::vector<Id<TransitionSystem::Symbol>> symbols = {};
    /// The property that no scan has a fault; invalid if faults are impossible. The other properties, except those with
    /// `about_fault`, concern the scans before the first fault.
    Id<Property> no_fault = {};
};

ProgramSystem schedule_program(const Scan& scan, const std::vector<ScanProperty>& properties);

}  // namespace grafverif
