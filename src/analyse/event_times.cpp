// SPDX-License-Identifier: MIT
#include "analyse/event_times.hpp"

#include <algorithm>
#include <iterator>

namespace grafverif::analysis {

namespace {

/// The constraint time[later] - time[earlier] >= least; `least` may be negative.
struct DifferenceConstraint {
    std::size_t earlier = 0, later = 0;
    std::int64_t least = 0;
};

/// Returns the constraints of one clock on the event times. The constraints restrict the age of the watched level of
/// the clock at each sampling of inputs.
std::vector<DifferenceConstraint> constraints_of(const Equations::Timer& clock, const Machine& machine,
                                                 const Path& path) {
    std::vector<DifferenceConstraint> result;
    bool level = false;
    std::size_t risen = 0;
    std::optional<std::size_t> fallen;
    const auto see = [&](std::size_t instant, const Point& point) {
        const bool now = machine.value(point, clock.watched) != 0;
        if (now && !level) risen = instant;
        if (!now && level) fallen = instant;
        level = now;
    };
    const auto demand = [&](std::size_t since, std::size_t now, std::int64_t duration, bool over) {
        if (over) result.push_back({since, now, duration});
        else result.push_back({now, since, 1 - duration});
    };
    for (std::size_t instant = 0; instant < path.instants.size(); ++instant) {
        // At the first point of an instant, the level still has its value from the end of the previous instant.
        if (instant > 0) {
            const Point& sampled = path.instants[instant].front();
            const bool ended = machine.value(sampled, clock.end) != 0;
            see(instant - 1, sampled);
            if (level && clock.rise_ms > 0) demand(risen, instant, clock.rise_ms, ended);
            if (!level && clock.fall_ms > 0 && fallen) demand(*fallen, instant, clock.fall_ms, !ended);
        }
        for (const Point& point : path.instants[instant]) see(instant, point);
    }
    return result;
}

}  // namespace

std::optional<std::vector<std::int64_t>> moments(const Machine& machine, const Path& path) {
    const std::size_t count = path.instants.size();
    std::vector<DifferenceConstraint> constraints;
    for (std::size_t instant = 1; instant < count; ++instant) constraints.push_back({instant - 1, instant, 0});
    for (const Equations::Timer& clock : machine.clocks())
        if (machine.matters(clock.end))
            std::ranges::copy(constraints_of(clock, machine, path), std::back_inserter(constraints));
    std::vector<std::int64_t> result(count);
    bool changed = true;
    for (std::size_t round = 0; changed && round <= count; ++round) {
        changed = false;
        for (const DifferenceConstraint& each : constraints) {
            if (result[each.later] - result[each.earlier] >= each.least) continue;
            result[each.later] = result[each.earlier] + each.least;
            changed = true;
        }
    }
    if (changed) return {};
    return result;
}

}  // namespace grafverif::analysis
