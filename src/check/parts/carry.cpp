// SPDX-License-Identifier: MIT
#include "check/parts/carry.hpp"

#include <algorithm>

#include "ir/patterns.hpp"

namespace grafverif {

namespace {

std::string objection(const Neighbour& other, const Verdict& verdict, bool at_stable) {
    const Claim claim = claim_of(verdict);
    const std::string name = "`" + other.name + "` ";
    if (claim == Claim::Everywhere && !at_stable) return {};
    if (!other.searched) return name + "could not be explored completely";
    if (other.faulty && (at_stable || !settled_apart(verdict.pattern))) return name + "has a model error";
    if (claim == Claim::Somewhere || claim == Claim::Everywhere) {
        if (!other.diverges) return name + "cannot let time pass forever";
        return at_stable && !other.settles ? "time passes in " + name + "while it is not quiescent" : "";
    }
    if (!other.never_locks) return "it is unknown whether " + name + "is free of timelocks";
    if (claim == Claim::Unavoidable && !other.rests) return name + "can move forever within one instant";
    return {};
}

}  // namespace

Claim claim_of(const Verdict& verdict) {
    const bool holds = verdict.outcome == Outcome::Holds;
    switch (verdict.pattern) {
    case Pattern::Always:
    case Pattern::Never:
    case Pattern::ExactlyOneOf: return holds ? Claim::Everywhere : Claim::Somewhere;
    case Pattern::Reachable:
    case Pattern::ReachableAllSteps: return holds ? Claim::Somewhere : Claim::Everywhere;
    case Pattern::Inevitable:
    case Pattern::LeadsTo: return holds ? Claim::Unavoidable : Claim::Somewhere;
    default: return holds ? Claim::Possible : Claim::Somewhere;
    }
}

std::string objection(const Verdict& verdict, bool at_stable, const std::vector<const Neighbour*>& left_out) {
    for (const Neighbour* const other : left_out)
        if (std::string why = objection(*other, verdict, at_stable); !why.empty()) return why;
    return {};
}

std::string untimed_objection(const Verdict& verdict, bool at_stable, const std::vector<const Neighbour*>& left_out) {
    for (const Neighbour* const other : left_out) {
        const std::string name = "`" + other->name + "` ";
        if (!at_stable && claim_of(verdict) != Claim::Unavoidable) continue;
        if (!other->searched) return name + "could not be explored completely";
        if (at_stable && !other->settles) return name + "is never quiescent";
        if (claim_of(verdict) == Claim::Unavoidable && !other->rests) return name + "can move forever";
    }
    return {};
}

std::string untimed_because(const Verdict& verdict, bool at_stable) {
    if (at_stable) return "shares nothing with it and has a quiescent state";
    if (claim_of(verdict) == Claim::Unavoidable) return "shares nothing with it and cannot move forever";
    return "shares nothing with it";
}

std::string because(const Verdict& verdict, bool at_stable) {
    const Claim claim = claim_of(verdict);
    const bool of_states = claim == Claim::Everywhere || claim == Claim::Somewhere;
    if (of_states && at_stable)
        return "shares only time with it, can let time pass forever and is quiescent whenever time passes";
    switch (claim) {
    case Claim::Everywhere: return "shares only time with it and adds no state";
    case Claim::Somewhere: return "shares only time with it and can let time pass forever";
    case Claim::Unavoidable:
        return "shares only time with it, has no timelock and cannot move forever within one instant";
    case Claim::Possible: break;
    }
    return "shares only time with it and has no timelock";
}

bool settled_apart(Pattern pattern) { return is_about_single_states(pattern) || pattern == Pattern::ReachableAllSteps; }

void mark_vacuous(Verdict& verdict, const std::vector<const Neighbour*>& left_out) {
    const char* const why = "time does not pass in this model";
    const bool wanted = verdict.pattern == Pattern::Reachable || verdict.pattern == Pattern::ReachableAllSteps;
    if (verdict.outcome != Outcome::Holds || wanted) return;
    for (const Neighbour* const other : left_out) {
        if (!other->searched || other->time_passes) continue;
        verdict.vacuous = true;
        if (std::ranges::find(verdict.notes, why) == verdict.notes.end()) verdict.notes.emplace_back(why);
    }
}

}  // namespace grafverif
