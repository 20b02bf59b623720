// SPDX-License-Identifier: MIT
// Breadth-first search of all points, instant by instant, and shortest paths to them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analyse/machine.hpp"
#include "bdd/rings.hpp"

namespace grafverif::analysis {

/// One instant of all runs together: the new points, in rings by the number of evolutions before them, and the new
/// rests at its end. In the first instant of every_cycle mode there are no points: it is only the first evolution.
struct Instant {
    std::size_t first = 0, end = 0;  ///< its rings are the range [first, end)
    Bdd rest = {};
};

/// A set between `fresh` and `fresh | known` with a small diagram: for operations to which known points may be added.
Bdd widened(const Bdd& fresh, const Bdd& known);

/// A run to a point.
struct Path {
    /// Per instant its points, each before an evolution; the last is the end of the path. In the first instant, the
    /// first evolution comes before its points; in every_cycle mode it is the complete first instant, whose point
    /// contains only the inputs.
    std::vector<std::vector<Point>> instants = {};
    bool at_first = false;  ///< the path ends before the first evolution: its only point contains the inputs
};

class PathSearch {
public:
    /// `landings`: true to collect the points directly after evolutions.
    PathSearch(const Machine& machine, ExecutionMode mode, bool landings = true)
        : machine_(machine), mode_(mode), lands_(landings) {}

    /// True if all points are found.
    bool done() const { return !instants_.empty() && instants_.back().rest.is_false(); }
    /// Finds the points of one more instant. May throw BddExhausted, which keeps the points found so far.
    void next();

    const std::vector<Instant>& instants() const { return instants_; }
    /// The points found since the last call of forget_fresh().
    const Bdd& fresh() const { return fresh_; }
    void forget_fresh() { fresh_ = {}; }
    /// Those of `within`, new points that are not stable, from which an instant continues in it forever; for stability
    /// search.
    Bdd endless(const Bdd& within) const;
    /// Upper bound of the number of evolutions of a run to the end of the last instant.
    std::int64_t evolutions() const { return evolutions_; }
    /// All points; in every_cycle mode all points directly after an evolution, with its inputs.
    const Bdd& reached() const { return rings_.reached; }
    const Bdd& landings() const { return landings_; }
    /// All points, by distance.
    const std::vector<Bdd>& rings() const { return rings_.each; }
    /// The points of the first instant.
    Bdd first() const;
    /// Those of `goal` with the least distance: a shortest path leads to one of them.
    Bdd nearest(const Bdd& goal) const;
    /// A shortest path to a point of `goal`; empty if there is none.
    std::optional<Path> path_to(const Bdd& goal) const;

private:
    void first_instant();
    void make_instant(Bdd points);
    std::vector<Point> back_through(const Instant& instant, std::size_t ring, const Point& last) const;
    /// The last point of `instant`, with its ring, from which the instant ends in the state of `next`.
    std::optional<std::pair<std::size_t, Point>> end_of(const Instant& instant, const Point& next) const;

    const Machine& machine_;
    ExecutionMode mode_;
    bool lands_ = true;
    std::vector<Instant> instants_ = {};
    bdd::Rings rings_ = {};  ///< of all instants, including an incomplete one
    Bdd landings_ = {}, rested_ = {}, fresh_ = {};
    std::int64_t evolutions_ = 0;
};

}  // namespace grafverif::analysis
