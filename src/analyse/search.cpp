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

void Search::next() {
    if (instants_.empty()) return first_instant();
    const Bdd rest = instants_.back().rest;
    make_instant(machine_.sampled(widened(rest, rested_ & ~rest)) & ~reached_);
}

void Search::first_instant() {
    evolutions_ = 1;
    if (mode_ == ExecutionMode::StabilitySearch) return make_instant(machine_.started());
    landings_ = machine_.started();
    rested_ = machine_.rest(landings_);
    instants_.push_back({{}, rested_});
}

/// Under stability search the instant goes on through the points that are not stable, in every_cycle mode it is over.
void Search::make_instant(Bdd points) {
    Instant made;
    Bdd ended, fresh;
    while (!points.is_false()) {
        made.points.push_back(points);
        const Bdd good = machine_.unbroken(widened(points, reached_));
        reached_ |= points;
        fresh |= points;
        if (mode_ == ExecutionMode::EveryCycle) {
            ended = lands_ ? machine_.evolved(good) : machine_.evolved_rest(good);
            if (lands_) landings_ |= ended;
            if (lands_) ended = machine_.rest(ended);
            break;
        }
        const Bdd stable = machine_.stable(good);
        ended |= machine_.settled(stable);
        points = machine_.evolved(good & ~stable) & ~reached_;
    }
    made.rest = ended & ~rested_;
    rested_ |= made.rest;
    fresh_ |= fresh;
    evolutions_ += static_cast<std::int64_t>(made.points.size());
    instants_.push_back(std::move(made));
}

/// Evolutions with constant inputs are a function, and a function on finitely many points leads each that has endless
/// histories round a cycle. The points of a cycle are reached in one instant.
Bdd Search::endless(const Bdd& within) const {
    if (mode_ == ExecutionMode::EveryCycle) return {};
    Bdd now = within;
    for (Bdd before; !(now == before);) {
        before = now;
        now = machine_.evolved(now) & within;
    }
    return now;
}

std::vector<Point> Search::back_through(const Instant& instant, std::size_t ring, const Point& last) const {
    std::vector<Point> points{last};
    while (ring-- > 0) {
        const Bdd going_on = machine_.going_on(instant.points[ring]);
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
        const Bdd good = machine_.unbroken(instant.points[ring]);
        if (mode_ == ExecutionMode::EveryCycle)
            return std::pair{ring, machine_.pick(machine_.origins(good, machine_.pick(rest)))};
        const Bdd stable = machine_.stable(good);
        const Bdd found = machine_.watches() ? machine_.origins(stable, machine_.pick(rest)) : stable & rest;
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
