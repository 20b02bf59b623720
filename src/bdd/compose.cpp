// SPDX-License-Identifier: MIT
// Renaming and substitution, all variables at once. Both branches are done first; where the new variable still lies
// above what they depend on, they are joined by a node, otherwise by a choice.
//
// The maps are by level, made when first used and again when the order has changed. In the cache each has a number.
#include "bdd/compose.hpp"

#include <algorithm>

#include "bdd/steps.hpp"

namespace grafverif {

namespace bdd {

namespace {

constexpr Edge itself = false_edge - 1;   // no edge: the variable stays

/// `high` where the variable of `level` is true, else `low`, of a frame at work.
Edge joined(Kernel& kernel, std::uint32_t level, Edge low, Edge high) {
    if (level < kernel.level(low) && level < kernel.level(high)) return make(kernel, level, low, high);
    kernel.frames.top().h = high;   // nobody else holds it while the variable is made
    return if_then_else(kernel, make(kernel, level, false_edge, true_edge), high, low);
}

/// What both rules share; Derived has `joined_at`.
template <class Map>
struct Mapping : Branching {
    const Map& map;

    explicit Mapping(const Map& mapped) : map(mapped) {}

    bool settled(const Kernel& kernel, Call& call, Edge& result, bool& flip, std::size_t levels) const {
        flip = complement_bit(call.f) != 0;
        call.f &= ~1U;
        result = call.f;
        return is_constant(call.f) || kernel.level(call.f) >= levels;
    }

    static std::uint32_t level(const Kernel& kernel, const Call& call) { return kernel.level(call.f); }
    std::uint32_t third(const Call&) const { return map.number; }
    static Call low(const Kernel& kernel, const Frame& at) { return {kernel.low(at.f), 0, 0}; }
    static Call high(const Kernel& kernel, const Frame& at) { return {kernel.high(at.f), 0, 0}; }
};

struct Renamed : Mapping<BddRenaming::Map> {
    static constexpr Operation operation = Operation::Rename;
    using Mapping::Mapping;

    bool settle(const Kernel& kernel, Call& call, Edge& result, bool& flip) const {
        return settled(kernel, call, result, flip, map.to.size());
    }
    Edge join(Kernel& kernel, Frame at, Edge high) const { return joined(kernel, map.to[at.level], at.low, high); }
};

struct Substituted : Mapping<BddSubstitution::Map> {
    static constexpr Operation operation = Operation::Substitute;
    using Mapping::Mapping;

    bool settle(const Kernel& kernel, Call& call, Edge& result, bool& flip) const {
        return settled(kernel, call, result, flip, map.by.size());
    }
    Edge join(Kernel& kernel, Frame at, Edge high) const {
        const Edge value = map.by[at.level];
        return value == itself ? joined(kernel, at.level, at.low, high) : if_then_else(kernel, value, high, at.low);
    }
};

std::uint32_t new_number(Kernel& kernel) {
    if (++kernel.numbers == 0) {   // all were given: what is known of the old ones goes
        kernel.cache.clear(kernel.watch);
        kernel.numbers = 1;
    }
    return kernel.numbers;
}

/// Whether the map is for another kernel or order; it counts as up to date from now on.
template <class Map>
bool outdated(Map& map, Kernel& kernel) {
    if (map.kernel == &kernel && map.version == kernel.order.version) return false;
    map.number = new_number(kernel);
    map.kernel = &kernel;
    map.version = kernel.order.version;
    return true;
}

void update(BddRenaming::Map& map, Kernel& kernel) {
    if (!outdated(map, kernel)) return;
    map.to.clear();
    for (const auto& [from, to] : map.pairs) {
        const std::uint32_t level = kernel.order.level_of[from];
        while (map.to.size() <= level) map.to.push_back(static_cast<std::uint32_t>(map.to.size()));
        map.to[level] = kernel.order.level_of[to];
    }
}

void update(BddSubstitution::Map& map, Kernel& kernel) {
    if (!outdated(map, kernel)) return;
    map.by.clear();
    for (const auto& [variable, value] : map.values) {
        const std::uint32_t level = kernel.order.level_of[variable];
        if (map.by.size() <= level) map.by.resize(level + 1, itself);
        map.by[level] = value.edge();
    }
}

template <class Rule, class Map>
Bdd mapped(Map& map, const Bdd& f) {
    if (f.is_constant()) return f;
    Kernel& kernel = *f.kernel();
    const Session session(kernel);
    update(map, kernel);
    return {kernel, run(kernel, Rule(map), {f.edge(), 0, 0})};
}

}  // namespace

}  // namespace bdd

BddRenaming::BddRenaming(std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs) : map_(std::make_unique<Map>()) {
    map_->pairs.assign(pairs.begin(), pairs.end());
}

BddRenaming::~BddRenaming() = default;

Bdd BddRenaming::operator()(const Bdd& f) const { return bdd::mapped<bdd::Renamed>(*map_, f); }

BddSubstitution::BddSubstitution(std::span<const std::pair<std::uint32_t, Bdd>> values) : map_(std::make_unique<Map>()) {
    map_->values.assign(values.begin(), values.end());
}

BddSubstitution::~BddSubstitution() = default;

Bdd BddSubstitution::operator()(const Bdd& f) const { return bdd::mapped<bdd::Substituted>(*map_, f); }

}  // namespace grafverif
