// SPDX-License-Identifier: MIT
// Searches all reachable points breadth-first, one instant after another, and computes shortest paths to points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analyse/machine.hpp"
#include "bdd/rings.hpp"

namespace grafverif::analysis {

/// All instants with the same number, over all runs. The points that no earlier instant contains
/// are grouped into rings by the number of preceding evolutions. `rest` contains the new
/// assignments to kept variables at the ends of the instants. In every_cycle mode, the first
/// instant has no points, because it consists only of the first evolution.
struct Instant {
    std::size_t first = 0, end = 0;  ///< range [first, end) of the rings of this instant
    Bdd rest = {};
};

/// Returns a set with a small diagram that contains `fresh` and possibly some points of `known`.
/// The set is used only in operations whose result does not depend on known points.
Bdd widened(const Bdd& fresh, const Bdd& known);

/// A run of the machine that ends at a point.
struct Path {
    /// The points of each instant, in their order; each point precedes an evolution, and the last point is the end of
    /// the path. In the first instant, the first evolution precedes all points. In every_cycle mode, the first
    /// evolution is the complete first instant, whose point contains only the inputs.
    std::vector<std::vector<Point>> instants = {};
    bool at_first = false;  ///< true if the path ends before the first evolution: its only point contains the inputs
};

class PathSearch {
public:
    /// If `landings` is true, the search also collects the points directly after evolutions.
    PathSearch(const Machine& machine, ExecutionMode mode, bool landings = true)
        : machine_(machine), mode_(mode), lands_(landings) {}

    /// True if the search has found all reachable points.
    bool done() const { return !instants_.empty() && instants_.back().rest.is_false(); }
    /// Finds the points of the next instant. May throw BddExhausted; the points that are already found are kept.
    void next();

    const std::vector<Instant>& instants() const { return instants_; }
    /// Returns the points that were found since the last call of forget_fresh().
    const Bdd& fresh() const { return fresh_; }
    void forget_fresh() { fresh_ = {}; }
    /// For stability search: returns the points in `within` from which an instant continues forever in `within`.
    /// `within` consists of new points that are not stable.
    Bdd endless(const Bdd& within) const;
    /// Returns an upper bound of the number of evolutions in a run to the end of the last instant.
    std::int64_t evolutions() const { return evolutions_; }
    /// Returns all points found so far; in every_cycle mode, these are the points directly after an evolution, with the
    /// inputs of the evolution.
    const Bdd& reached() const { return rings_.reached; }
    const Bdd& landings() const { return landings_; }
    /// Returns all points, grouped by distance.
    const std::vector<Bdd>& rings() const { return rings_.each; }
    /// Returns the points of the first instant.
    Bdd first() const;
    /// Returns the points in `goal` with the smallest distance from power-on. Each shortest path to `goal` leads to one
    /// of these points.
    Bdd nearest(const Bdd& goal) const;
    /// Returns a shortest path to a point of `goal`, or nothing if the search has found no point of `goal`.
    std::optional<Path> path_to(const Bdd& goal) const;

private:
    void first_instant();
    void make_instant(Bdd points);
    std::vector<Point> back_through(const Instant& instant, std::size_t ring, const Point& last) const;
    /// Returns a point at which `instant` ends, with its ring, such that `next` can follow this point after some time.
    /// Returns nothing if there is no such point.
    std::optional<std::pair<std::size_t, Point>> end_of(const Instant& instant, const Point& next) const;

    const Machine& machine_;
    ExecutionMode mode_;
    bool lands_ = true;
    std::vector<Instant> instants_ = {};
    bdd::Rings rings_ = {};  ///< rings of all instants, including an incomplete one
    Bdd landings_ = {}, rested_ = {}, fresh_ = {};
    std::int64_t evolutions_ = 0;
};

}  // namespace grafverif::analysis
