// SPDX-License-Identifier: MIT
// Forward and backward reachability between sets of points, over all points that a search has found, and terminal
// regions: sets of points that no run leaves, in which each point is reachable from each other one.
//
// An evolution that aborts has no successor, so its point would be a separate region: regions are searched among the
// points from which no run aborts.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analyse/search.hpp"

namespace grafverif::analysis {

class TerminalRegions {
public:
    /// Requires that the search is complete. Both arguments must outlive the object.
    TerminalRegions(const Machine& machine, ExecutionMode mode, const PathSearch& search);

    const Bdd& reached() const { return reached_; }
    /// The points at which an instant ends: stable, or all in every_cycle mode; without those whose evolution aborts.
    const Bdd& ends() const { return ends_; }
    /// The successors of `points` by one evolution, or by time and new inputs after it.
    Bdd after(const Bdd& points) const;
    /// The predecessors of `points`.
    Bdd before(const Bdd& points) const;
    /// The points reachable from `points`, including these.
    Bdd from(const Bdd& points) const { return rings_from(points).back(); }
    /// The points from which `points` is reachable, including these.
    Bdd to(const Bdd& points) const;
    /// At most `most` terminal regions of runs from `among`, which no run leaves. If there are fewer, these are all.
    std::vector<Bdd> regions(Bdd among, std::size_t most) const;
    /// Those of `within` from which a run stays in it and visits `often` infinitely often. No run may enter `within`
    /// again.
    Bdd recurring(Bdd within, const Bdd& often) const;

private:
    /// The only terminal region of runs from `among`, if it contains all points after the first instant.
    std::optional<Bdd> home(const Bdd& among) const;
    template <class Step>
    Bdd instant_of(Bdd fresh, Bdd& all, const Step& step) const;
    /// The new points of each instant, and all of them together.
    std::vector<Bdd> rings_from(const Bdd& points) const;

    const Machine& machine_;
    ExecutionMode mode_;
    Bdd reached_, first_, going_on_, ends_;
    const std::vector<Bdd>& found_;  ///< reached points, the nearest first
};

}  // namespace grafverif::analysis
