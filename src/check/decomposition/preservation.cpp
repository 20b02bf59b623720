// SPDX-License-Identifier: MIT
#include "check/decomposition/preservation.hpp"

#include <algorithm>

#include "ir/patterns.hpp"

namespace grafverif {

namespace {

std::string preservation_obstacle(const OmittedSubsystem& other, const Verdict& verdict, bool at_stable) {
    const PreservationClass claim = preservation_class_of(verdict);
    const std::string name = "`" + other.name + "` ";
    if (claim == PreservationClass::Everywhere && !at_stable) return {};
    if (!other.searched) return name + "could not be explored completely";
    if (other.faulty && (at_stable || !settled_separately(verdict.pattern))) return name + "has a model error";
    if (claim == PreservationClass::Somewhere || claim == PreservationClass::Everywhere) {
        if (!other.diverges) return name + "cannot let time pass forever";
        return at_stable && !other.settles ? "time passes in " + name + "while this sub-loop is not quiescent" : "";
    }
    if (!other.never_locks) return "it is unknown whether " + name + "is free of timelocks";
    if (claim == PreservationClass::Unavoidable && !other.rests) return name + "can move forever within one instant";
    return {};
}

}  // namespace

PreservationClass preservation_class_of(const Verdict& verdict) {
    const bool holds = verdict.outcome == Outcome::Holds;
    switch (verdict.pattern) {
    case Pattern::Always:
    case Pattern::Never:
    case Pattern::ExactlyOneOf: return holds ? PreservationClass::Everywhere : PreservationClass::Somewhere;
    case Pattern::Reachable:
    case Pattern::ReachableAllSteps: return holds ? PreservationClass::Somewhere : PreservationClass::Everywhere;
    case Pattern::Inevitable:
    case Pattern::LeadsTo: return holds ? PreservationClass::Unavoidable : PreservationClass::Somewhere;
    default: return holds ? PreservationClass::Possible : PreservationClass::Somewhere;
    }
}

std::string preservation_obstacle(const Verdict& verdict, bool at_stable,
                                  const std::vector<const OmittedSubsystem*>& left_out) {
    for (const OmittedSubsystem* const other : left_out)
        if (std::string why = preservation_obstacle(*other, verdict, at_stable); !why.empty()) return why;
    return {};
}

std::string untimed_preservation_obstacle(const Verdict& verdict, bool at_stable,
                                          const std::vector<const OmittedSubsystem*>& left_out) {
    for (const OmittedSubsystem* const other : left_out) {
        const std::string name = "`" + other->name + "` ";
        if (!at_stable && preservation_class_of(verdict) != PreservationClass::Unavoidable) continue;
        if (!other->searched) return name + "could not be explored completely";
        if (at_stable && !other->settles) return name + "is never quiescent";
        if (preservation_class_of(verdict) == PreservationClass::Unavoidable && !other->rests)
            return name + "can move forever";
    }
    return {};
}

std::string untimed_because(const Verdict& verdict, bool at_stable) {
    if (at_stable) return "shares nothing with the checked sub-loops and has a quiescent state";
    if (preservation_class_of(verdict) == PreservationClass::Unavoidable)
        return "shares nothing with the checked sub-loops and makes only finitely many moves";
    return "shares nothing with the checked sub-loops";
}

std::string because(const Verdict& verdict, bool at_stable) {
    const PreservationClass claim = preservation_class_of(verdict);
    const bool of_states = claim == PreservationClass::Everywhere || claim == PreservationClass::Somewhere;
    if (of_states && at_stable)
        return "shares only time with the checked sub-loops, can let time pass forever and is quiescent whenever time "
               "passes";
    switch (claim) {
    case PreservationClass::Everywhere: return "shares only time with the checked sub-loops and adds no state to them";
    case PreservationClass::Somewhere:
        return "shares only time with the checked sub-loops and can let time pass forever";
    case PreservationClass::Unavoidable:
        return "shares only time with the checked sub-loops, has no timelock and makes only finitely many moves within "
               "one instant";
    case PreservationClass::Possible: break;
    }
    return "shares only time with the checked sub-loops and has no timelock";
}

bool settled_separately(Pattern pattern) { return is_about_states(pattern); }

void mark_vacuous(Verdict& verdict, const std::vector<const OmittedSubsystem*>& left_out) {
    const char* const why = "time does not pass in this model";
    const bool wanted = is_about_existence(verdict.pattern);
    if (verdict.outcome != Outcome::Holds || wanted) return;
    for (const OmittedSubsystem* const other : left_out) {
        if (!other->searched || other->time_passes) continue;
        verdict.vacuous = true;
        if (std::ranges::find(verdict.notes, why) == verdict.notes.end()) verdict.notes.emplace_back(why);
    }
}

}  // namespace grafverif
