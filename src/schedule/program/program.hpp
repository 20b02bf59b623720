// SPDX-License-Identifier: MIT
// schedule_program: translates a Scan to a TransitionSystem. A state consists of the stored variables before a scan and
// of the inputs of this scan, which are free. One step is one scan. A property concerns the values at the end of the
// scan. The property is expressed as a term over the state before the scan, so that inputs need not be copied. The
// system omits stored variables on which no property depends.
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
    /// True: the condition concerns the scans up to and including the scan with the first fault. False, or
    /// Pattern::Always: the condition concerns only the scans before the first fault.
    bool about_fault = false;
};

struct ProgramSystem {
    TransitionSystem system = {};
    /// Symbol of each variable of the equations; invalid if no property depends on the variable.
    std::vector<Id<TransitionSystem::Symbol>> symbols = {};
    /// The property that no scan has a fault; invalid if faults are impossible.
    Id<Property> no_fault = {};
};

ProgramSystem schedule_program(const Scan& scan, const std::vector<ScanProperty>& properties);

}  // namespace grafverif
