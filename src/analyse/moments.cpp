// SPDX-License-Identifier: MIT
#include "analyse/moments.hpp"

namespace grafverif::analysis {

namespace {

/// moment[later] - moment[earlier] >= least, which may be negative.
struct Constraint {
    std::size_t earlier = 0, later = 0;
    std::int64_t least = 0;
};

/// What one clock asks of the moments, going along the way.
class Asks {
public:
    Asks(const Machine& machine, const Equations::Timer& clock, std::vector<Constraint>& constraints)
        : machine_(machine), clock_(clock), constraints_(constraints) {}

    void go(const Way& way) {
        for (std::size_t instant = 0; instant < way.instants.size(); ++instant) {
            // The first point tells the level as the last instant left it.
            if (instant > 0) sample(instant, way.instants[instant].front());
            for (const Point& point : way.instants[instant]) see(instant, point);
            if (instant + 1 < way.instants.size()) see(instant, way.instants[instant + 1].front());
        }
    }

private:
    void see(std::size_t instant, const Point& point) {
        const bool level = machine_.value(point, clock_.watched) != 0;
        if (level && !level_) risen_ = instant;
        if (!level && level_) fallen_ = instant;
        level_ = level;
    }

    void sample(std::size_t instant, const Point& point) {
        const bool ended = machine_.value(point, clock_.end) != 0;
        if (level_ && clock_.rise_ms > 0) ask(risen_, instant, clock_.rise_ms, ended);
        if (!level_ && clock_.fall_ms > 0 && fallen_) ask(*fallen_, instant, clock_.fall_ms, !ended);
    }

    void ask(std::size_t since, std::size_t now, std::int64_t duration, bool over) {
        if (over) constraints_.push_back({since, now, duration});
        else constraints_.push_back({now, since, 1 - duration});
    }

    const Machine& machine_;
    const Equations::Timer& clock_;
    std::vector<Constraint>& constraints_;
    bool level_ = false;
    std::size_t risen_ = 0;
    std::optional<std::size_t> fallen_ = {};
};

}  // namespace

std::optional<std::vector<std::int64_t>> moments(const Machine& machine, const Way& way) {
    const std::size_t count = way.instants.size();
    std::vector<Constraint> constraints;
    for (std::size_t instant = 1; instant < count; ++instant) constraints.push_back({instant - 1, instant, 0});
    for (const Equations::Timer& clock : machine.clocks())
        if (machine.matters(clock.end)) Asks(machine, clock, constraints).go(way);
    std::vector<std::int64_t> result(count);
    bool changed = true;
    for (std::size_t round = 0; changed && round <= count; ++round) {
        changed = false;
        for (const Constraint& each : constraints) {
            if (result[each.later] - result[each.earlier] >= each.least) continue;
            result[each.later] = result[each.earlier] + each.least;
            changed = true;
        }
    }
    if (changed) return {};
    return result;
}

}  // namespace grafverif::analysis
