// SPDX-License-Identifier: MIT
#include "analyse/terminal_regions.hpp"

#include <utility>

namespace grafverif::analysis {

namespace {

constexpr std::size_t most_starts = 32;

}  // namespace

TerminalRegions::TerminalRegions(const Machine& machine, ExecutionMode mode, const PathSearch& search)
    : machine_(machine), mode_(mode), reached_(search.reached()), first_(search.first()), found_(search.rings()) {
    ends_ = machine_.unbroken(reached_);
    if (mode_ == ExecutionMode::EveryCycle) return;
    const Bdd good = std::exchange(ends_, machine_.stable(ends_));
    transient_ = good & ~ends_;
}

Bdd TerminalRegions::after(const Bdd& points) const {
    const Bdd ends = points & ends_;
    if (mode_ == ExecutionMode::EveryCycle) return machine_.sampled(machine_.evolved_rest(ends));
    return machine_.evolved(points & transient_) | machine_.sampled(machine_.settled(ends));
}

Bdd TerminalRegions::before(const Bdd& points) const {
    const Bdd rest = machine_.before_time(points);
    if (mode_ == ExecutionMode::EveryCycle) return ends_ & machine_.origins(rest);
    return (transient_ & machine_.origins(points)) | (ends_ & (machine_.remembers() ? machine_.origins(rest) : rest));
}

/// Adds to `all` the points that repeated application of `step` reaches from `fresh` within an instant. Each instant is
/// computed separately, because this keeps the diagrams small.
template <class Step>
Bdd TerminalRegions::instant_of(Bdd fresh, Bdd& all, const Step& step) const {
    if (mode_ == ExecutionMode::EveryCycle) return fresh;
    Bdd instant = fresh;
    while (!fresh.is_false()) {
        fresh = step(widened(fresh, all)) & ~all;
        all |= fresh;
        instant |= fresh;
    }
    return instant;
}

Bdd TerminalRegions::to(const Bdd& points) const {
    Bdd all = points & reached_;
    for (Bdd fresh = all; !fresh.is_false();) {
        const Bdd instant =
            instant_of(fresh, all, [this](const Bdd& next) { return transient_ & machine_.origins(next); });
        fresh = before(widened(instant, all)) & ~all;
        all |= fresh;
    }
    return all;
}

std::vector<Bdd> TerminalRegions::rings_from(const Bdd& points) const {
    std::vector<Bdd> rings{points};
    Bdd all = points;
    for (Bdd fresh = points; !fresh.is_false();) {
        rings.back() =
            instant_of(fresh, all, [this](const Bdd& before) { return machine_.evolved(before & transient_); });
        fresh = after(widened(rings.back(), all)) & ~all;
        all |= fresh;
        rings.push_back(fresh);
    }
    rings.back() = all;
    return rings;
}

/// Most charts return to their initial situation, so that they have a single terminal region.
/// Assume that each rest (assignment to kept variables) of the first instant leads to every other
/// rest of this instant, and that all points lead to one of these rests. Under this assumption, all
/// points after the first instant form one region, and no forward search is necessary.
std::optional<Bdd> TerminalRegions::single_region(const Bdd& among) const {
    Bdd starts = first_ & ends_;
    if (mode_ == ExecutionMode::EveryCycle || starts.is_false()) return {};
    const Bdd start = machine_.only(machine_.pick(starts));
    if (!(among & ~to(start)).is_false()) return {};
    for (std::size_t tried = 0; !starts.is_false(); ++tried) {
        const Bdd one = machine_.only(machine_.pick(starts));
        if (tried == most_starts || (start & to(one)).is_false()) return {};
        starts &= ~machine_.rest(one);
    }
    Bdd all = reached_ & ~first_;
    for (Bdd fresh = all | start; !fresh.is_false();) {
        fresh = after(fresh) & ~all;
        all |= fresh;
    }
    return all;
}

/// Heuristic: points that the search found late are more likely to be in a terminal region. Therefore, the search
/// starts from one of the points that were found last. If some points that are reachable from the start point do not
/// lead back to it, the search continues from the farthest of these points.
std::vector<Bdd> TerminalRegions::regions(Bdd among, std::size_t most) const {
    if (among == reached_)
        if (const auto only = single_region(among)) return {*only};
    std::vector<Bdd> found;
    while (!among.is_false() && found.size() < most) {
        std::size_t last = found_.size() - 1;
        while ((found_[last] & among).is_false()) --last;
        Bdd start = machine_.only(machine_.pick(found_[last] & among));
        while (true) {
            const std::vector<Bdd> rings = rings_from(start);
            const Bdd back = to(start), onward = rings.back() & ~back;
            if (onward.is_false()) {
                found.push_back(rings.back());
                among &= ~back;
                break;
            }
            std::size_t ring = rings.size() - 2;
            while ((rings[ring] & onward).is_false()) --ring;
            start = machine_.only(machine_.pick(rings[ring] & onward));
        }
    }
    return found;
}

Bdd TerminalRegions::recurring(Bdd within, const Bdd& often) const {
    for (Bdd last; !(within == last);) {
        last = within;
        within &= before(to(within & often) & last);
    }
    return within;
}

}  // namespace grafverif::analysis
