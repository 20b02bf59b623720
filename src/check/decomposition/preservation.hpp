// SPDX-License-Identifier: MIT
// Preservation of verdicts: conditions under which a verdict on some independent subsystems applies to the complete
// system, and their explanations (proofs: docs/explanation/decomposition.md, "Sub-loops").
#pragma once

#include <string>
#include <vector>

#include "check/timed/timed.hpp"

namespace grafverif {

/// Classes of statements that a verdict makes. The premises of preservation depend on the class.
enum class PreservationClass {
    Everywhere,   ///< a statement about every reachable state
    Somewhere,    ///< a statement about one reachable state, or about a run that avoids some states forever
    Unavoidable,  ///< a statement about every maximal run
    Possible,     ///< a statement about the states that are reachable from every state
};
/// Returns the class of a verdict. Requires that the verdict is decided.
PreservationClass preservation_class_of(const Verdict& verdict);

/// Properties of an omitted subsystem on which preservation depends.
struct OmittedSubsystem {
    std::string name = {};
    bool searched = false;  ///< the subsystem was explored completely
    bool faulty = false;    ///< a model error is reachable in the subsystem
    bool diverges = false;  ///< the subsystem has a run in which time diverges
    /// From each state of the subsystem, a state in which time passes is reachable, in dense time.
    bool never_locks = false;
    bool rests = false;        ///< no run of the subsystem has infinitely many moves in one instant
    bool settles = false;      ///< time passes only in quiescent states of the subsystem
    bool time_passes = false;  ///< time passes in some state of the subsystem
};

/// Returns the reason why the verdict, which was computed without `left_out`, might not apply to the complete system,
/// or an empty string if it applies. Requires a decided verdict.
std::string preservation_obstacle(const Verdict& verdict, bool at_stable,
                                  const std::vector<const OmittedSubsystem*>& left_out);

/// Returns the reason why the omitted subsystems do not affect the verdict. Requires that preservation_obstacle is
/// empty.
std::string because(const Verdict& verdict, bool at_stable);

/// The same functions for abstract time. Subsystems then do not share anything. With abstract time, `settles` means
/// that some state is quiescent, and `rests` means that there is no infinite run of moves.
std::string untimed_preservation_obstacle(const Verdict& verdict, bool at_stable,
                                          const std::vector<const OmittedSubsystem*>& left_out);
std::string untimed_because(const Verdict& verdict, bool at_stable);

/// True if `at stable` can be checked compositionally for properties of this pattern.
bool settled_separately(Pattern pattern);

/// Marks the verdict as vacuous if time does not pass in an omitted subsystem and the property, which is not
/// `reachable`, holds.
void mark_vacuous(Verdict& verdict, const std::vector<const OmittedSubsystem*>& left_out);

}  // namespace grafverif
