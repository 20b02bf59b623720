// SPDX-License-Identifier: MIT
// Saturation (Ciardo, Luettgen, Siminiceanu 2001): computes the reachable states of a disjunctively partitioned
// transition relation. The algorithm is efficient if each cluster of the relation reads and writes only few variables.
// A set is closed if no step leaves it. A diagram is closed bottom-up. First, each subdiagram is closed under the steps
// that concern only variables below the top variable of the diagram. Then, the complete diagram is closed under the
// steps whose topmost variable is the top variable of the diagram. The closures of the subdiagrams
// and of the diagram are repeated until the diagram no longer changes. Results for subdiagrams are
// cached and reused. The algorithm does not compute the layers of a breadth-first search.
#pragma once

#include <cstdint>
#include <deque>
#include <unordered_map>
#include <vector>

#include "bdd/relation.hpp"

namespace grafverif::bdd {

/// Steps of one cluster, with the variables that their images quantify.
struct ClusterSteps {
    ClusterSteps(const BddSpace& space, std::vector<NextBit> bits, std::vector<Bdd> conditions,
                 std::vector<std::uint32_t> choices, std::span<const std::uint32_t> free);

    Relation relation;
    Relation::Quantified quantified;
};

class Saturation {
public:
    /// The clusters must outlive this object, and the variable order must not change while this object exists.
    Saturation(const BddSpace& space, const std::deque<ClusterSteps>& kinds);
    Saturation(const Saturation&) = delete;
    Saturation& operator=(const Saturation&) = delete;
    ~Saturation() { forget(); }

    /// Returns the states that are reachable from `from` by any number of steps.
    Bdd closure(const Bdd& from) { return closed(from, 0); }

private:
    struct Level {
        std::uint32_t level = 0;  ///< level of the topmost variable of the clusters
        std::vector<const ClusterSteps*> kinds = {};
    };
    struct CacheKey {
        Bdd states = {};
        std::size_t from = 0;
        bool operator==(const CacheKey&) const = default;
    };
    struct Hash {
        std::size_t operator()(const CacheKey& requested) const { return requested.states.hash() + requested.from; }
    };

    Bdd closed(const Bdd& states, std::size_t from);
    Bdd closed_here(const Bdd& states, std::size_t from);
    void remember(const CacheKey& requested, const Bdd& result);
    void forget();

    const BddSpace& space_;
    std::vector<Level> levels_ = {};  ///< levels, topmost first
    std::unordered_map<CacheKey, Bdd, Hash> known_ = {};
};

}  // namespace grafverif::bdd
