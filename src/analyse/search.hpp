// SPDX-License-Identifier: MIT
// The search of all points, instant by instant, and the ways to them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analyse/machine.hpp"

namespace grafverif::analysis {

/// One instant of all runs at once: the points that no earlier one has, by the number of its evolutions before them, and
/// the new rests in which it ends. In the first instant of every_cycle mode there are no points: it is the first
/// evolution alone.
struct Instant {
    std::vector<Bdd> points = {};
    Bdd rest = {};
};

/// A run to a point.
struct Way {
    /// Per instant the points it goes through, each about to make an evolution; the last is the end of the way. In the
    /// first instant the first evolution comes before its points; in every_cycle mode that is all of the first instant,
    /// and its point tells the inputs.
    std::vector<std::vector<Point>> instants = {};
    bool at_first = false;   ///< the way ends before the first evolution: its one point tells the inputs
};

class Search {
public:
    Search(const Machine& machine, ExecutionMode mode) : machine_(machine), mode_(mode) {}

    /// Finds all points. May end with BddExhausted; what was found until then remains.
    void run();

    const std::vector<Instant>& instants() const { return instants_; }
    /// All points, and in every_cycle mode all points right after an evolution, inputs kept.
    const Bdd& reached() const { return reached_; }
    const Bdd& landings() const { return landings_; }
    /// All points that go on for ever within their instant; under stability search only.
    const Bdd& endless() const { return endless_; }

    /// A shortest way to a point of `goal`; empty: there is none.
    std::optional<Way> way(const Bdd& goal) const;

private:
    void first_instant();
    void next_instant();
    void make_instant(Bdd points);
    void find_endless();
    bool meets(const Bdd& goal, std::size_t& instant, std::size_t& ring) const;
    std::vector<Point> back_through(const Instant& instant, std::size_t ring, const Point& last) const;
    /// The last point of `instant`, with its ring, after which it ends in the state of `next`.
    std::optional<std::pair<std::size_t, Point>> end_of(const Instant& instant, const Point& next) const;

    const Machine& machine_;
    ExecutionMode mode_;
    std::vector<Instant> instants_ = {};
    Bdd reached_ = {}, landings_ = {}, rested_ = {}, endless_ = {};
};

}  // namespace grafverif::analysis
