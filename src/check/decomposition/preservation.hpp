// SPDX-License-Identifier: MIT
// Preservation of verdicts: conditions under which a verdict on some independent subsystems applies to the complete
// system, and texts that explain the conditions (proofs: docs/explanation/decomposition.md, "Sub-loops").
#pragma once

#include <string>
#include <vector>

#include "check/timed/timed.hpp"

namespace grafverif {

/// Classes of statements that a verdict makes. The premises of preservation depend on the class.
enum class PreservationClass {
    Everywhere,   ///< a statement about every reachable state
    Somewhere,    ///< a statement that some state is reachable, or that some run avoids a set of states forever
    Unavoidable,  ///< a statement about every maximal run
    Possible,     ///< a statement that a state with some condition is reachable from every reachable state
};
/// Returns the class of a verdict. Requires that the outcome of the verdict is not Unknown.
PreservationClass preservation_class_of(const Verdict& verdict);

/// Facts about an omitted subsystem on which the preservation of verdicts depends.
struct OmittedSubsystem {
    std::string name = {};
    bool searched = false;  ///< true if the subsystem was explored completely
    bool faulty = false;    ///< true if a model error is reachable in the subsystem
    bool diverges = false;  ///< true if the subsystem has a run in which time diverges

    /// True if, in dense time, a state in which time passes is reachable from each state of the subsystem.
    bool never_locks = false;
    bool rests = false;        ///< true if no run of the subsystem has infinitely many moves in one instant
    bool settles = false;      ///< true if time passes only in quiescent states of the subsystem
    bool time_passes = false;  ///< true if time passes in some state of the subsystem
};

/// Returns the reason why the verdict, which was computed without `left_out`, might not apply to the complete system,
/// or an empty string if the verdict applies. Requires that the outcome of the verdict is not Unknown.
std::string preservation_obstacle(const Verdict& verdict, bool at_stable,
                                  const std::vector<const OmittedSubsystem*>& left_out);

/// Returns the reason why the omitted subsystems do not affect the verdict. Requires that `preservation_obstacle`
/// returned an empty string for the verdict.
std::string because(const Verdict& verdict, bool at_stable);

/// `preservation_obstacle` and `because` for models with abstract time, in which subsystems do not share time. With
/// abstract time, `settles` is true if some state of the subsystem is quiescent, and `rests` is true if the subsystem
/// has no infinite sequence of moves.
std::string untimed_preservation_obstacle(const Verdict& verdict, bool at_stable,
                                          const std::vector<const OmittedSubsystem*>& left_out);
std::string untimed_because(const Verdict& verdict, bool at_stable);

/// True if properties of this pattern with `at stable` can be checked compositionally.
bool settled_separately(Pattern pattern);

/// Marks the verdict as vacuous if the property holds, its pattern is not `reachable`, and time does not pass in an
/// omitted subsystem.
void mark_vacuous(Verdict& verdict, const std::vector<const OmittedSubsystem*>& left_out);

}  // namespace grafverif
