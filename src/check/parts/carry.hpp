// SPDX-License-Identifier: MIT
// What a verdict on some sub-loops says of the whole: when it carries over, and the words for either (docs/engines.md,
// "Sub-loops", has the proofs).
#pragma once

#include <string>
#include <vector>

#include "check/timed/timed.hpp"

namespace grafverif {

/// What a verdict claims; each kind has its premises.
enum class Claim {
    Everywhere,   ///< of every reachable state
    Somewhere,    ///< of one reachable state, or that some run avoids something for ever
    Unavoidable,  ///< of every maximal run
    Possible,     ///< from every state
};
/// Of a verdict that is decided.
Claim claim_of(const Verdict& verdict);

/// A sub-loop that is left out, as far as it matters to others.
struct Neighbour {
    std::string name = {};
    bool searched = false;     ///< to its end
    bool faulty = false;       ///< the model breaks off in it
    bool diverges = false;     ///< it has a run in which time passes for ever
    bool never_locks = false;  ///< from each of its states time can pass again, in dense time
    bool rests = false;        ///< none of its runs goes on for ever within one instant
    bool settles = false;      ///< time passes in its settled states only
    bool time_passes = false;  ///< in some state
};

/// Why the verdict, found without `left_out`, says nothing of the whole; empty: it is that of the whole. It is decided.
std::string objection(const Verdict& verdict, bool at_stable, const std::vector<const Neighbour*>& left_out);

/// Why what is left out has no say in the verdict. Requires: there is no objection.
std::string because(const Verdict& verdict, bool at_stable);

/// The same where time is abstract, and sub-loops share nothing. `settles` is there: some of its states is settled; `rests`:
/// none of its runs moves for ever.
std::string untimed_objection(const Verdict& verdict, bool at_stable, const std::vector<const Neighbour*>& left_out);
std::string untimed_because(const Verdict& verdict, bool at_stable);

/// Whether `at stable` can be judged by sub-loops at all.
bool settled_apart(Pattern pattern);

/// Marks what holds for want of anything to judge on account of what was left out.
void mark_vacuous(Verdict& verdict, const std::vector<const Neighbour*>& left_out);

}  // namespace grafverif
