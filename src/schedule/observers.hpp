// SPDX-License-Identifier: MIT
// Observers as modules of the TransitionSystem (DESDES06 Fig. 6): in each step, the first edge whose guard holds in the
// state at hand.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "schedule/properties.hpp"
#include "support/unique_names.hpp"

namespace grafverif::schedule {

/// An observer as main sees it: its instance, and the member of main that holds its location.
struct ObserverInstance {
    Id<TransitionSystem::Instance> instance = {};
    Id<Symbol> location = {};
};

struct ObserverShape {
    std::string name = {};
    std::vector<std::string> locations = {};
    std::uint32_t initial = 0;
    Span origin = {};
};
struct ObserverGuard {
    std::uint32_t from = 0, to = 0;
    Id<Expr> guard = {};               ///< over symbols of main; may read the locations of observers
};

/// An instance that has no edges yet, so that the guards of others can read its location. `names`: taken in main,
/// `modules`: those of modules.
ObserverInstance declare_observer(Members& members, const ObserverShape& shape, UniqueNames& names,
                                  UniqueNames& modules);
void watch(Members& members, const ObserverInstance& observer, std::span<const ObserverGuard> edges);

/// The condition that the observer is at a location.
Id<Expr> is_at(TransitionSystem& system, const ObserverInstance& observer, std::uint32_t location);

/// Every observer of `loop`; `meaning` learns what their locations are. `when`: the states in which they look; not valid:
/// all.
void add_observers(Members& members, const ClosedLoop& loop, LoopMeaning& meaning, UniqueNames& names,
                   UniqueNames& modules, Id<Expr> when = {});

}  // namespace grafverif::schedule
