// SPDX-License-Identifier: MIT
// Preservation of verdicts from some independent subsystems to the complete system: the conditions, and their
// explanations (proofs: docs/explanation/decomposition.md, "Sub-loops").
#pragma once

#include <string>
#include <vector>

#include "check/timed/timed.hpp"

namespace grafverif {

/// Classes of statements of a verdict; each has different premises.
enum class PreservationClass {
    Everywhere,   ///< about every reachable state
    Somewhere,    ///< about one reachable state, or that some run avoids something forever
    Unavoidable,  ///< about every maximal run
    Possible,     ///< about the states reachable from every state
};
/// Requires a decided verdict.
PreservationClass preservation_class_of(const Verdict& verdict);

/// The relevant properties of an omitted subsystem.
struct OmittedSubsystem {
    std::string name = {};
    bool searched = false;     ///< completely
    bool faulty = false;       ///< a model error is reachable in it
    bool diverges = false;     ///< it has a run in which time diverges
    bool never_locks = false;  ///< from each of its states time can pass again, in dense time
    bool rests = false;        ///< none of its runs continues forever within one instant
    bool settles = false;      ///< time passes in its quiescent states only
    bool time_passes = false;  ///< in some state
};

/// The reason why the verdict, which was found without `left_out`, does not hold for the complete system; empty if it
/// does. Requires a decided verdict.
std::string preservation_obstacle(const Verdict& verdict, bool at_stable,
                                  const std::vector<const OmittedSubsystem*>& left_out);

/// The reason why the omitted subsystems do not affect the verdict. Requires that there is no objection.
std::string because(const Verdict& verdict, bool at_stable);

/// The same functions for abstract time, where subsystems share nothing. Here `settles` means that some state is
/// quiescent, and `rests` that no run moves forever.
std::string untimed_objection(const Verdict& verdict, bool at_stable,
                              const std::vector<const OmittedSubsystem*>& left_out);
std::string untimed_because(const Verdict& verdict, bool at_stable);

/// True if `at stable` can be checked compositionally for properties of this pattern.
bool settled_separately(Pattern pattern);

/// Marks verdicts that hold vacuously because time cannot pass in an omitted subsystem.
void mark_vacuous(Verdict& verdict, const std::vector<const OmittedSubsystem*>& left_out);

}  // namespace grafverif
