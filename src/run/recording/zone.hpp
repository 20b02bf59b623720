// SPDX-License-Identifier: MIT
// Zone: a set of values of instants, given by closed bounds of their differences (difference bound matrix). The bounds
// are integers; therefore, every non-empty zone contains integer times.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace grafverif {

/// A time of a recording in ticks. The caller of the check chooses the duration of a tick; the command-line program
/// uses one microsecond.
using Ticks = std::int64_t;

/// Variable 0 is the constant 0. The bounds are always as tight as possible, and the zone is never empty.
class Zone {
public:
    static constexpr Ticks unbounded = std::numeric_limits<Ticks>::max() / 4;

    /// Adds an instant without bounds, and returns its variable.
    std::size_t add();
    /// Adds the constraint `x - y <= bound`. Returns false if no value satisfies all constraints; the zone is then
    /// invalid. O(size^2).
    [[nodiscard]] bool constrain(std::size_t x, std::size_t y, Ticks bound);
    /// Removes all bounds of `x`, and then sets `x` to `value`.
    void assign(std::size_t x, Ticks value);

    std::size_t size() const { return size_; }
    Ticks lower(std::size_t x) const { return -bounds_[x]; }
    Ticks upper(std::size_t x) const { return bounds_[x * size_]; }

    /// Returns the projection to `variables`, in this order. The first element of `variables` must be variable 0.
    Zone projection(std::span<const std::size_t> variables) const;
    /// True if each element of `other` is an element of this zone. Requires that both zones have the same variables.
    bool includes(const Zone& other) const;
    /// Returns the union of this zone and `other`, or nothing if the union is not a zone. Requires that both zones have
    /// the same variables. O(size^4).
    std::optional<Zone> joined(const Zone& other) const;

private:
    Ticks& at(std::size_t x, std::size_t y) { return bounds_[x * size_ + y]; }
    Ticks at(std::size_t x, std::size_t y) const { return bounds_[x * size_ + y]; }

    std::size_t size_ = 1;
    std::vector<Ticks> bounds_ = {0};  ///< at x, y: upper bound of x - y for each pair of variables
};

}  // namespace grafverif
