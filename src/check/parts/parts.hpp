// SPDX-License-Identifier: MIT
// The timed engine by sub-loops: each property is decided on the sub-loops that it reads, without those that share only
// time with them, wherever that gives the verdict of the whole (docs/engines.md, "Sub-loops"). What the others must be
// for that is found out by a search of each alone; where it fails or stays unknown, the whole is searched.
//
// `no deadlock` is judged of each sub-loop by itself: it holds where from every state of each of them an edge of it can
// fire, now or after a delay. That is more than the same of the whole, where one that goes on hides others that cannot.
//
// Every verdict says what was left out and why. Runs are runs of the whole.
#pragma once

#include "check/timed/timed.hpp"

namespace grafverif {

/// As check_timed; the bounds are those of each search. Requires verify(network).empty().
TimedResult check_timed_by_parts(const Network& network, const TimedOptions& options = {});

}  // namespace grafverif
