// SPDX-License-Identifier: MIT
// Computes forward and backward reachability between sets of points, over all points that a search has found, and
// terminal regions. A terminal region is a set of points that no run leaves and in which each point is reachable from
// every other point.
//
// A point whose evolution aborts has no successor, so that it would be a separate region. Therefore, regions are
// determined only among the points from which no run aborts.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analyse/search.hpp"

namespace grafverif::analysis {

class TerminalRegions {
public:
    /// Requires that the search is complete. `machine` and `search` must outlive the object.
    TerminalRegions(const Machine& machine, ExecutionMode mode, const PathSearch& search);

    const Bdd& reached() const { return reached_; }
    /// Returns the points at which an instant ends: stable points, or all points in every_cycle mode. Points whose
    /// evolution aborts are not included.
    const Bdd& ends() const { return ends_; }
    /// Returns the successors of `points`: the points after one evolution and, at the end of an instant, after some
    /// time with newly sampled inputs.
    Bdd after(const Bdd& points) const;
    /// Returns the predecessors of `points`.
    Bdd before(const Bdd& points) const;
    /// Returns the points that are reachable from `points`, including `points`.
    Bdd from(const Bdd& points) const { return rings_from(points).back(); }
    /// Returns the points from which `points` is reachable, including `points`.
    Bdd to(const Bdd& points) const;
    /// Returns terminal regions that a run from a point in `among` can enter. The maximum number of regions in the
    /// result is `most`; if the result has fewer regions, it contains all such regions. Requires that no run leaves
    /// `among`.
    std::vector<Bdd> regions(Bdd among, std::size_t most) const;
    /// Returns the points in `within` from which some run stays in `within` and visits `often` infinitely often.
    /// Requires that no run that leaves `within` enters it again.
    Bdd recurring(Bdd within, const Bdd& often) const;

private:
    /// Returns the terminal region of runs from `among` if there is only one and it contains all points after the first
    /// instant.
    std::optional<Bdd> single_region(const Bdd& among) const;
    template <class Step>
    Bdd instant_of(Bdd fresh, Bdd& all, const Step& step) const;
    /// Returns the new points of each instant, followed by the set of all these points.
    std::vector<Bdd> rings_from(const Bdd& points) const;

    const Machine& machine_;
    ExecutionMode mode_;
    Bdd reached_, first_, transient_, ends_;
    const std::vector<Bdd>& found_;  ///< reached points, in order of increasing distance
};

}  // namespace grafverif::analysis
