// SPDX-License-Identifier: MIT
// States which property patterns the embedded engines for untimed models do not support.
#pragma once

#include <string>

#include "grafverif/ir/property.hpp"
#include "support/overloaded.hpp"

namespace grafverif {

/// Returns the reason why no embedded engine decides properties of this pattern on a transition system, or an empty
/// string if an embedded engine supports this pattern.
inline std::string unsupported_reason(Pattern pattern) {
    switch (pattern) {
    case Pattern::NoDeadlock:
    case Pattern::NoTimelock: return "not applicable to an untimed model";
    case Pattern::Watched: return "the observer of this property is not part of this model";
    case Pattern::RawUppaal: return "UPPAAL formulas require UPPAAL";
    case Pattern::RawCtl: return "CTL formulas of NuSMV require NuSMV or nuXmv";
    case Pattern::RawLtl: return "LTL formulas of NuSMV require NuSMV or nuXmv";
    case Pattern::ReachableAllSteps: return "each step is checked separately";
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
