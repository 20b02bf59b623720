// SPDX-License-Identifier: MIT
#include "analyse/search.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace grafverif::analysis {

Bdd widened(const Bdd& fresh, const Bdd& known) {
    const Bdd care = fresh | ~known;
    return care.is_false() ? fresh : simplify(fresh, care);
}

void PathSearch::next() {
    if (instants_.empty()) return first_instant();
    const Bdd rest = instants_.back().rest;
    make_instant(machine_.sampled(widened(rest, rested_)));
}

void PathSearch::first_instant() {
    evolutions_ = 1;
    if (mode_ == ExecutionMode::StabilitySearch) return make_instant(machine_.started());
    landings_ = machine_.started();
    rested_ = machine_.rest(landings_);
    instants_.push_back({0, 0, rested_});
}

/// Adds the instant that begins with `points`. Under stability search, the instant contains further evolutions from all
/// points that are not stable; in every_cycle mode, it contains one evolution.
void PathSearch::make_instant(Bdd points) {
    Instant made{rings_.each.size(), 0, {}};
    Bdd ended, fresh;
    while (rings_.add(points)) {
        const Bdd good = machine_.unbroken(widened(rings_.each.back(), rings_.reached));
        fresh |= rings_.each.back();
        if (mode_ == ExecutionMode::EveryCycle) {
            ended = lands_ ? machine_.evolved(good) : machine_.evolved_rest(good);
            if (lands_) landings_ |= ended;
            if (lands_) ended = machine_.rest(ended);
            break;
        }
        const Bdd stable = machine_.stable(good);
        ended |= machine_.settled(stable);
        points = machine_.evolved(good & ~stable);
    }
    made.end = rings_.each.size();
    made.rest = ended & ~rested_;
    rested_ |= made.rest;
    fresh_ |= fresh;
    evolutions_ += static_cast<std::int64_t>(made.end - made.first);
    instants_.push_back(std::move(made));
}

Bdd PathSearch::first() const {
    Bdd all;
    for (std::size_t ring = 0; ring < instants_.front().end; ++ring) all |= rings_.each[ring];
    return all;
}

/// Correctness: with constant inputs, the result of an evolution is a function of its point. Since
/// the number of points is finite, an infinite path within an instant reaches a cycle of points.
/// All points of a cycle are reached in the same instant.
Bdd PathSearch::endless(const Bdd& within) const {
    if (mode_ == ExecutionMode::EveryCycle) return {};
    Bdd now = within;
    for (Bdd before; !(now == before);) {
        before = now;
        now = machine_.evolved(now) & within;
    }
    return now;
}

/// Returns a path within an instant that ends in `last`. The path is constructed backwards, from ring `ring` to the
/// first ring of the instant.
std::vector<Point> PathSearch::back_through(const Instant& instant, std::size_t ring, const Point& last) const {
    return bdd::path_back(ring - instant.first, last, [&](std::size_t before, const Point& next) {
        const Bdd transient = machine_.transient(rings_.each[instant.first + before]);
        return machine_.pick(machine_.with_inputs_of(machine_.origins(transient, next), last));
    });
}

std::optional<std::pair<std::size_t, Point>> PathSearch::end_of(const Instant& instant, const Point& next) const {
    const Bdd rest = machine_.origins_in_time(instant.rest, next);
    if (rest.is_false()) return {};
    if (instant.first == instant.end) return std::pair{instant.first, machine_.pick(machine_.started() & rest)};
    for (std::size_t ring = instant.first; ring < instant.end; ++ring) {
        const Bdd good = machine_.unbroken(rings_.each[ring]);
        if (mode_ == ExecutionMode::EveryCycle)
            return std::pair{ring, machine_.pick(machine_.origins(good, machine_.pick(rest)))};
        const Bdd stable = machine_.stable(good);
        const Bdd found = machine_.remembers() ? machine_.origins(stable, machine_.pick(rest)) : stable & rest;
        if (!found.is_false()) return std::pair{ring, machine_.pick(found)};
    }
    return {};
}

Bdd PathSearch::nearest(const Bdd& goal) const {
    const std::optional<std::size_t> ring = rings_.nearest(goal);
    return ring ? rings_.each[*ring] & goal : Bdd();
}

std::optional<Path> PathSearch::path_to(const Bdd& goal) const {
    const std::optional<std::size_t> nearest = rings_.nearest(goal);
    if (!nearest || instants_.empty() || *nearest >= instants_.back().end) return {};
    std::size_t ring = *nearest;
    auto instant = std::ranges::find_if(instants_, [ring](const Instant& one) { return ring < one.end; });
    Point last = machine_.pick(rings_.each[ring] & goal);
    Path path;
    for (;; --instant) {
        path.instants.push_back(back_through(*instant, ring, last));
        if (instant == instants_.begin()) break;
        std::tie(ring, last) = *end_of(*std::prev(instant), path.instants.back().front());
    }
    std::ranges::reverse(path.instants);
    return path;
}

}  // namespace grafverif::analysis
