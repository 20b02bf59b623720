// SPDX-License-Identifier: MIT
// Preservation of verdicts from some independent subsystems to the complete system: conditions and their explanations
// (proofs: docs/explanation/decomposition.md, "Sub-loops").
#pragma once

#include <string>
#include <vector>

#include "check/timed/timed.hpp"

namespace grafverif {

/// Classes of statements that a verdict makes. Each class has different premises.
enum class PreservationClass {
    Everywhere,   ///< about every reachable state
    Somewhere,    ///< about one reachable state, or a run that avoids some states forever
    Unavoidable,  ///< about every maximal run
    Possible,     ///< about the states reachable from every state
};
/// Returns the class of a verdict, which must be decided.
PreservationClass preservation_class_of(const Verdict& verdict);

/// Properties of an omitted subsystem on which preservation depends.
struct OmittedSubsystem {
    std::string name = {};
    bool searched = false;     ///< the subsystem was explored completely
    bool faulty = false;       ///< a model error is reachable in it
    bool diverges = false;     ///< it has a run in which time diverges
    bool never_locks = false;  ///< from each of its states, a state in which time passes is reachable, in dense time
    bool rests = false;        ///< none of its runs continues forever within one instant
    bool settles = false;      ///< time passes only in its quiescent states
    bool time_passes = false;  ///< time passes in some state
};

/// Returns the reason why the verdict, which was found without `left_out`, may not hold for the complete system, or an
/// empty string if it holds. Requires a decided verdict.
std::string preservation_obstacle(const Verdict& verdict, bool at_stable,
                                  const std::vector<const OmittedSubsystem*>& left_out);

/// Returns the reason why the omitted subsystems do not affect the verdict. Requires that preservation_obstacle is
/// empty.
std::string because(const Verdict& verdict, bool at_stable);

/// The same functions for abstract time, in which subsystems share nothing. In this case `settles` means that some
/// state is quiescent, and `rests` means that no run moves forever.
std::string untimed_objection(const Verdict& verdict, bool at_stable,
                              const std::vector<const OmittedSubsystem*>& left_out);
std::string untimed_because(const Verdict& verdict, bool at_stable);

/// True if `at stable` can be checked compositionally for properties of this pattern.
bool settled_separately(Pattern pattern);

/// Marks verdicts that hold vacuously because time cannot pass in an omitted subsystem.
void mark_vacuous(Verdict& verdict, const std::vector<const OmittedSubsystem*>& left_out);

}  // namespace grafverif
