// SPDX-License-Identifier: MIT
#include "bdd/saturation.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "bdd/kernel.hpp"

namespace grafverif::bdd {

namespace {

/// Number of bytes that are charged to the memory budget for each stored result.
constexpr std::uint64_t result_size = 96;

std::vector<std::uint32_t> written(const std::vector<NextBit>& bits, std::span<const std::uint32_t> free) {
    std::vector<std::uint32_t> all(free.begin(), free.end());
    for (const NextBit& bit : bits) all.push_back(bit.before);
    return all;
}

}  // namespace

ClusterSteps::ClusterSteps(const BddSpace& space, std::vector<NextBit> bits, std::vector<Bdd> conditions,
                           std::vector<std::uint32_t> choices, std::span<const std::uint32_t> free)
    : relation(space, std::move(bits), std::move(conditions), std::move(choices)),
      quantified(relation.quantified(written(relation.bits(), free))) {}

Saturation::Saturation(const BddSpace& space, const std::deque<ClusterSteps>& kinds) : space_(space) {
    std::map<std::uint32_t, std::vector<const ClusterSteps*>> by_level;
    for (const ClusterSteps& kind : kinds) {
        if (kind.relation.bits().empty()) continue;  // the cluster does not change any bit
        std::uint32_t top = constant_level;
        for (const std::uint32_t variable : kind.relation.variables())
            top = std::min(top, space.kernel().order.level_of[variable]);
        by_level[top].push_back(&kind);
    }
    for (auto& [level, found] : by_level) levels_.push_back({level, std::move(found)});
}

/// Returns the closure of `states` under all clusters of the levels with index `from` or greater. The recursion depth
/// is at most the number of levels.
Bdd Saturation::closed(const Bdd& states, std::size_t from) {
    if (states.is_constant() || from == levels_.size()) return states;
    const CacheKey requested{states, from};
    if (const auto known = known_.find(requested); known != known_.end()) return known->second;
    Bdd result;
    if (space_.kernel().level(states.edge()) < levels_[from].level) {
        const Bdd low = closed(states.low(), from), high = closed(states.high(), from);
        result = ite(space_.variable(states.top()), high, low);
    } else {
        result = closed_here(states, from);
    }
    remember(requested, result);
    return result;
}

Bdd Saturation::closed_here(const Bdd& states, std::size_t from) {
    Bdd result = closed(states, from + 1);
    for (Bdd before; before != result;) {
        before = result;
        for (const ClusterSteps* kind : levels_[from].kinds) {
            const Bdd found = kind->relation.image(result, kind->quantified) & ~result;
            // The union stays closed, because a union of closed sets is closed.
            if (!found.is_false()) result |= closed(found, from + 1);
        }
    }
    return result;
}

void Saturation::remember(const CacheKey& requested, const Bdd& result) {
    if (!space_.kernel().budget.charge(result_size)) return forget();
    known_.emplace(requested, result);
}

void Saturation::forget() {
    space_.kernel().budget.used -= known_.size() * result_size;
    known_.clear();
}

}  // namespace grafverif::bdd
