// SPDX-License-Identifier: MIT
// Minimum-cost flow on arcs of unlimited capacity, by the primal-dual method: shortest distances under reduced costs,
// then as much flow as the arcs of reduced cost zero take.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace grafverif::conform {

class Flow {
public:
    explicit Flow(std::size_t nodes) : out_(nodes), supply_(nodes) {}

    /// An arc of unlimited capacity; its number. `cost` is not negative.
    std::size_t add_arc(std::uint32_t from, std::uint32_t to, std::int64_t cost);
    /// What has to leave `node` (negative: has to enter it). All supplies together are 0.
    void add_supply(std::uint32_t node, std::int64_t amount) { supply_[node] += amount; }

    /// The least cost; empty where the supplies cannot be met.
    std::optional<std::int64_t> solve();
    /// After solve: how much goes over arc `arc`.
    std::int64_t flow(std::size_t arc) const { return halves_[2 * arc + 1].capacity; }

private:
    /// An arc forwards (even) or backwards (odd).
    struct Half {
        std::uint32_t to = 0;
        std::int64_t cost = 0;
        std::int64_t capacity = 0;
    };

    bool shortest_paths();
    void saturate();
    std::int64_t reduced(std::uint32_t from, const Half& half) const { return half.cost + potential_[from] - potential_[half.to]; }

    std::vector<Half> halves_ = {};
    std::vector<std::vector<std::uint32_t>> out_ = {};   ///< per node: halves
    std::vector<std::int64_t> supply_ = {};              ///< still to leave, or to enter
    std::vector<std::int64_t> potential_ = {};
    std::int64_t cost_ = 0;
};

}  // namespace grafverif::conform
