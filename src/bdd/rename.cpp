// SPDX-License-Identifier: MIT
// Renames variables simultaneously. Both branches of a node are renamed first. The renamed branches are combined by a
// node if the new variable of the node is above all their variables, otherwise by if-then-else.
//
// The map from old to new variables is indexed by level. The map is computed at the first use and after each change of
// the variable order. A cache entry identifies the map by a number.
#include <utility>
#include <vector>

#include "bdd/explicit_stack.hpp"
#include "bdd/kernel.hpp"

namespace grafverif {

/// The pairs of an old and a new variable of a renaming, and the map from levels to new variables that was last
/// computed from these pairs.
struct BddRenaming::Map {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs = {};
    bdd::Kernel* kernel = nullptr;       ///< kernel to which the following members belong
    std::uint64_t version = 0;           ///< version of the order for which the map was computed
    std::uint32_t number = 0;            ///< number of the map in the cache
    std::vector<std::uint32_t> to = {};  ///< new variable for each level, up to the deepest level that is renamed
};

namespace bdd {

namespace {

struct Renamed : Branching {
    static constexpr Operation operation = Operation::Rename;
    const BddRenaming::Map& map;

    explicit Renamed(const BddRenaming::Map& renaming) : map(renaming) {}

    bool terminal_case(const Kernel& kernel, Call& call, Edge& result, bool& flip) const {
        flip = complement_bit(call.f) != 0;
        call.f &= ~1U;
        result = call.f;
        return is_constant(call.f) || kernel.level(call.f) >= map.to.size();
    }

    static std::uint32_t level(const Kernel& kernel, const Call& call) { return kernel.level(call.f); }
    std::uint32_t third(const Call&) const { return map.number; }
    static Call low(const Kernel& kernel, const Frame& at) { return {kernel.low(at.f), 0, 0}; }
    static Call high(const Kernel& kernel, const Frame& at) { return {kernel.high(at.f), 0, 0}; }

    Edge join(Kernel& kernel, Frame at, Edge high) const {
        const std::uint32_t level = map.to[at.level];
        if (level < kernel.level(at.low) && level < kernel.level(high)) return make(kernel, level, at.low, high);
        kernel.frames.top().h = high;  // the frame protects `high` from a collection while the variable is created
        return if_then_else(kernel, make(kernel, level, false_edge, true_edge), high, at.low);
    }
};

std::uint32_t new_number(Kernel& kernel) {
    if (++kernel.numbers == 0) {  // numbers start again, so that the cached results of old maps must be discarded
        kernel.cache.clear(kernel.watch);
        kernel.numbers = 1;
    }
    return kernel.numbers;
}

void update(BddRenaming::Map& map, Kernel& kernel) {
    if (map.kernel == &kernel && map.version == kernel.order.version) return;
    map.number = new_number(kernel);
    map.kernel = &kernel;
    map.version = kernel.order.version;
    map.to.clear();
    for (const auto& [from, to] : map.pairs) {
        const std::uint32_t level = kernel.order.level_of[from];
        while (map.to.size() <= level) map.to.push_back(static_cast<std::uint32_t>(map.to.size()));
        map.to[level] = kernel.order.level_of[to];
    }
}

}  // namespace

}  // namespace bdd

BddRenaming::BddRenaming(std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs)
    : map_(std::make_unique<Map>()) {
    map_->pairs.assign(pairs.begin(), pairs.end());
}

BddRenaming::~BddRenaming() = default;

Bdd BddRenaming::operator()(const Bdd& f) const {
    if (f.is_constant()) return f;
    bdd::Kernel& kernel = *f.kernel();
    const bdd::Session session(kernel);
    bdd::update(*map_, kernel);
    return {kernel, bdd::run(kernel, bdd::Renamed(*map_), {f.edge(), 0, 0})};
}

}  // namespace grafverif
