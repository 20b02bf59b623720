// SPDX-License-Identifier: MIT
// Alternatives: abstraction levels with which a property can be searched instead of the levels that its refinement has
// reached.
//
// A spurious run is usually impossible for several groups of processes, and it is not known which of these groups the
// proof needs. The refinement raises the group that is most likely needed. The other groups become alternatives. The
// cost of an alternative is the number of preferred groups that were not raised on the way to this alternative. Each
// refinement of an alternative adds 1 to the cost, and each search that reached its bound adds 2 (compare limited
// discrepancy search; Harvey, Ginsberg 1995).
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "ir/network_inputs.hpp"

namespace grafverif {

/// The alternatives for one property.
class Alternatives {
public:
    using Levels = std::vector<InputLevel>;

    struct Alternative {
        Levels levels = {};
        bool rounded = false;  ///< true if clock bounds of observers are rounded
        std::size_t cost = 0;
        bool operator==(const Alternative&) const = default;
    };

    /// Adds an alternative, unless its levels were added or excluded before.
    void add(Alternative alternative) {
        if (known_.insert(alternative.levels).second) open_.push_back(std::move(alternative));
    }
    /// Excludes levels that another search uses.
    void exclude(const Levels& levels) { known_.insert(levels); }
    /// Adds an alternative again whose search must be repeated, with exact clock bounds or in a later round.
    void add_again(Alternative alternative) { open_.push_back(std::move(alternative)); }
    void postpone(Alternative alternative) { postponed_.push_back(std::move(alternative)); }
    /// Begins a round: the postponed alternatives can be searched again.
    void begin_round() { std::ranges::move(std::exchange(postponed_, {}), std::back_inserter(open_)); }

    bool has_for_round() const { return !open_.empty(); }
    bool has_any() const { return !open_.empty() || !postponed_.empty(); }

    /// Removes and returns the alternative with the lowest cost; among these, the one that was added first. Requires
    /// that the round has an alternative.
    Alternative take() {
        const auto cheapest = std::ranges::min_element(open_, {}, &Alternative::cost);
        Alternative taken = std::move(*cheapest);
        open_.erase(cheapest);
        return taken;
    }

private:
    std::vector<Alternative> open_ = {}, postponed_ = {};
    std::set<Levels> known_ = {};
};

}  // namespace grafverif
