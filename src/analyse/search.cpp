// SPDX-License-Identifier: MIT
#include "analyse/search.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace grafverif::analysis {

namespace {

/// `fresh`, and as many of `known` as make its diagram small: what follows from those is known as well.
Bdd widened(const Bdd& fresh, const Bdd& known) {
    const Bdd care = fresh | ~known;
    return care.is_false() ? fresh : simplify(fresh, care);
}

}  // namespace

void Search::run() {
    first_instant();
    while (!instants_.back().rest.is_false()) next_instant();
    if (mode_ == ExecutionMode::StabilitySearch) find_endless();
}

void Search::first_instant() {
    if (mode_ == ExecutionMode::StabilitySearch) return make_instant(machine_.started());
    landings_ = machine_.started();
    rested_ = machine_.rest(landings_);
    instants_.push_back({{}, rested_});
}

void Search::next_instant() {
    const Bdd& rest = instants_.back().rest;
    make_instant(machine_.sampled(widened(rest, rested_ & ~rest)) & ~reached_);
}

/// Under stability search the instant goes on through the points that are not stable, in every_cycle mode it is over.
void Search::make_instant(Bdd points) {
    Instant& instant = instants_.emplace_back();
    Bdd ended;
    while (!points.is_false()) {
        instant.points.push_back(points);
        const Bdd good = widened(points, reached_) & ~machine_.breaks();
        reached_ |= points;
        if (mode_ == ExecutionMode::EveryCycle) {
            ended = machine_.evolved(good);
            landings_ |= ended;
            break;
        }
        ended |= good & machine_.stable();
        points = machine_.evolved(good & ~machine_.stable()) & ~reached_;
    }
    instant.rest = machine_.rest(ended) & ~rested_;
    rested_ |= instant.rest;
}

/// Evolutions with constant inputs are a function, and a function on finitely many points leads each that has endless
/// histories round a cycle.
void Search::find_endless() {
    const Bdd going_on = reached_ & ~machine_.stable() & ~machine_.breaks();
    Bdd now = going_on;
    for (Bdd before; !(now == before);) {
        before = now;
        now = machine_.evolved(now) & going_on;
    }
    endless_ = now;
}

std::vector<Point> Search::back_through(const Instant& instant, std::size_t ring, const Point& last) const {
    std::vector<Point> points{last};
    while (ring-- > 0) {
        const Bdd going_on = instant.points[ring] & ~machine_.breaks() & ~machine_.stable();
        points.push_back(machine_.pick(machine_.with_inputs_of(machine_.origins(going_on, points.back()), last)));
    }
    std::ranges::reverse(points);
    return points;
}

std::optional<std::pair<std::size_t, Point>> Search::end_of(const Instant& instant, const Point& next) const {
    const Bdd rest = machine_.origins_in_time(instant.rest, next);
    if (rest.is_false()) return {};
    if (instant.points.empty()) return std::pair{std::size_t{0}, machine_.pick(machine_.started() & rest)};
    for (std::size_t ring = 0; ring < instant.points.size(); ++ring) {
        const Bdd good = instant.points[ring] & ~machine_.breaks();
        if (mode_ == ExecutionMode::EveryCycle)
            return std::pair{ring, machine_.pick(machine_.origins(good, machine_.pick(rest)))};
        const Bdd found = good & machine_.stable() & rest;
        if (!found.is_false()) return std::pair{ring, machine_.pick(found)};
    }
    return {};
}

bool Search::meets(const Bdd& goal, std::size_t& instant, std::size_t& ring) const {
    if ((reached_ & goal).is_false()) return false;
    for (instant = 0; instant < instants_.size(); ++instant)
        for (ring = 0; ring < instants_[instant].points.size(); ++ring)
            if (!(instants_[instant].points[ring] & goal).is_false()) return true;
    return false;
}

std::optional<Way> Search::way(const Bdd& goal) const {
    std::size_t instant = 0, ring = 0;
    if (!meets(goal, instant, ring)) return {};
    Point last = machine_.pick(instants_[instant].points[ring] & goal);
    Way way;
    while (true) {
        const bool first_alone = instants_[instant].points.empty();
        way.instants.push_back(back_through(instants_[instant], first_alone ? 0 : ring, last));
        if (instant-- == 0) break;
        const auto end = end_of(instants_[instant], way.instants.back().front());
        std::tie(ring, last) = *end;
    }
    std::ranges::reverse(way.instants);
    return way;
}

}  // namespace grafverif::analysis
