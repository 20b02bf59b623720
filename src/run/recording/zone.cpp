// SPDX-License-Identifier: MIT
#include "run/recording/zone.hpp"

#include <algorithm>

namespace grafverif {

std::size_t Zone::add() {
    const std::size_t size = size_ + 1;
    std::vector<Ticks> bounds(size * size, unbounded);
    for (std::size_t x = 0; x < size_; ++x)
        std::copy_n(bounds_.begin() + static_cast<std::ptrdiff_t>(x * size_), size_,
                    bounds.begin() + static_cast<std::ptrdiff_t>(x * size));
    bounds.back() = 0;
    bounds_ = std::move(bounds);
    size_ = size;
    return size - 1;
}

bool Zone::constrain(std::size_t x, std::size_t y, Ticks bound) {
    if (at(y, x) < unbounded && at(y, x) + bound < 0) return false;
    if (bound >= at(x, y)) return true;
    for (std::size_t from = 0; from < size_; ++from) {
        const Ticks first = at(from, x);
        if (first >= unbounded) continue;
        for (std::size_t to = 0; to < size_; ++to) {
            const Ticks last = at(y, to);
            if (last < unbounded) at(from, to) = std::min(at(from, to), first + bound + last);
        }
    }
    return true;
}

void Zone::assign(std::size_t x, Ticks value) {
    for (std::size_t y = 0; y < size_; ++y) {
        if (y == x) continue;
        // uses x - y = (x - 0) + (0 - y)
        at(x, y) = at(0, y) >= unbounded ? unbounded : value + at(0, y);
        at(y, x) = at(y, 0) >= unbounded ? unbounded : at(y, 0) - value;
    }
    at(x, 0) = value;
    at(0, x) = -value;
}

Zone Zone::projection(std::span<const std::size_t> variables) const {
    Zone result;
    result.size_ = variables.size();
    result.bounds_.clear();
    for (const std::size_t x : variables)
        for (const std::size_t y : variables) result.bounds_.push_back(bounds_[x * size_ + y]);
    return result;
}

bool Zone::includes(const Zone& other) const {
    return std::ranges::equal(other.bounds_, bounds_, [](Ticks theirs, Ticks own) { return theirs <= own; });
}

std::optional<Zone> Zone::joined(const Zone& other) const {
    Zone hull = *this;  // the smallest zone that includes both
    for (std::size_t k = 0; k < bounds_.size(); ++k) hull.bounds_[k] = std::max(bounds_[k], other.bounds_[k]);
    // The hull is the union if `other` includes each element of the hull that violates a bound of this zone.
    for (std::size_t x = 0; x < size_; ++x)
        for (std::size_t y = 0; y < size_; ++y) {
            if (at(x, y) == hull.at(x, y)) continue;
            Zone rest = hull;
            if (rest.constrain(y, x, -at(x, y) - 1) && !other.includes(rest)) return {};
        }
    return hull;
}

}  // namespace grafverif
