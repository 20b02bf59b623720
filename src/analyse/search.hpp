// SPDX-License-Identifier: MIT
// The search of all points, instant by instant, and the paths to them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analyse/machine.hpp"
#include "bdd/rings.hpp"

namespace grafverif::analysis {

/// One instant of all runs at once: the points that no earlier one has, in rings by the number of its evolutions before
/// them, and the new rests in which it ends. In the first instant of every_cycle mode there are no points: it is the first
/// evolution alone.
struct Instant {
    std::size_t first = 0, end = 0;  ///< its rings are those from `first` on, before `end`
    Bdd rest = {};
};

/// `fresh`, and as many of `known` as make its diagram small: for steps that do not matter from those known.
Bdd widened(const Bdd& fresh, const Bdd& known);

/// A run to a point.
struct Path {
    /// Per instant the points it goes through, each about to make an evolution; the last is the end of the path. In the
    /// first instant the first evolution comes before its points; in every_cycle mode that is all of the first instant,
    /// and its point tells the inputs.
    std::vector<std::vector<Point>> instants = {};
    bool at_first = false;  ///< the path ends before the first evolution: its one point tells the inputs
};

class Search {
public:
    /// `landings`: whether they are asked for.
    Search(const Machine& machine, ExecutionMode mode, bool landings = true)
        : machine_(machine), mode_(mode), lands_(landings) {}

    /// Whether all points are found.
    bool done() const { return !instants_.empty() && instants_.back().rest.is_false(); }
    /// Finds the points of one more instant. May end with BddExhausted; what was found until then remains.
    void next();

    const std::vector<Instant>& instants() const { return instants_; }
    /// The points found since they were forgotten last.
    const Bdd& fresh() const { return fresh_; }
    void forget_fresh() { fresh_ = {}; }
    /// Those of `within`, fresh points that go on, that do so for ever in it; under stability search only.
    Bdd endless(const Bdd& within) const;
    /// No run to the end of the last instant has more evolutions.
    std::int64_t evolutions() const { return evolutions_; }
    /// All points, and in every_cycle mode all points right after an evolution, inputs kept.
    const Bdd& reached() const { return rings_.reached; }
    const Bdd& landings() const { return landings_; }
    /// All points, the nearest first.
    const std::vector<Bdd>& rings() const { return rings_.each; }
    /// The points of the first instant.
    Bdd first() const;
    /// Those of `goal` that are nearest: a shortest path leads to one of them.
    Bdd nearest(const Bdd& goal) const;
    /// A shortest path to a point of `goal`; empty: there is none.
    std::optional<Path> path_to(const Bdd& goal) const;

private:
    void first_instant();
    void make_instant(Bdd points);
    std::vector<Point> back_through(const Instant& instant, std::size_t ring, const Point& last) const;
    /// The last point of `instant`, with its ring, after which it ends in the state of `next`.
    std::optional<std::pair<std::size_t, Point>> end_of(const Instant& instant, const Point& next) const;

    const Machine& machine_;
    ExecutionMode mode_;
    bool lands_ = true;
    std::vector<Instant> instants_ = {};
    bdd::Rings rings_ = {};  ///< of all instants, and of one that was broken off
    Bdd landings_ = {}, rested_ = {}, fresh_ = {};
    std::int64_t evolutions_ = 0;
};

}  // namespace grafverif::analysis
