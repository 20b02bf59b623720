// SPDX-License-Identifier: MIT
// Properties that the embedded engines of untimed models do not support.
#pragma once

#include <string>

#include "grafverif/ir/property.hpp"
#include "support/overloaded.hpp"

namespace grafverif {

/// The reason why no embedded engine decides a property of this pattern on a transition system; empty if one does.
inline std::string untimed_refusal(Pattern pattern) {
    switch (pattern) {
    case Pattern::NoDeadlock:
    case Pattern::NoTimelock: return "an untimed model has no deadlock and no time to lock";
    case Pattern::Watched: return "its observer is not part of this model";
    case Pattern::RawUppaal: return "UPPAAL's formulas are decided by UPPAAL only";
    case Pattern::RawCtl: return "CTL formulas of NuSMV are decided by NuSMV and nuXmv only";
    case Pattern::RawLtl: return "LTL formulas of NuSMV are decided by NuSMV and nuXmv only";
    case Pattern::ReachableAllSteps: return "it is asked step by step";
    case Pattern::Always:
    case Pattern::Never:
    case Pattern::Reachable:
    case Pattern::Inevitable:
    case Pattern::LeadsTo:
    case Pattern::ExactlyOneOf:
    case Pattern::AlwaysPossible: return {};
    }
    unreachable();
}

}  // namespace grafverif
