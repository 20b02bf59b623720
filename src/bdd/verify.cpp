// SPDX-License-Identifier: MIT
// Checks the invariants of a space between operations, without using cached results.
#include <string>
#include <unordered_set>

#include "bdd/kernel.hpp"

namespace grafverif {

namespace bdd {

namespace {

class Check {
public:
    explicit Check(Kernel& kernel) : kernel_(kernel), table_(kernel.table) {}

    std::vector<std::string> faults() {
        look_at_order();
        if (table_.capacity == 0) return std::move(faults_);
        look_at_nodes();
        if (!table_.stale) look_at_chains();
        look_at_cache();
        return std::move(faults_);
    }

private:
    void demand(bool holds, const char* what, std::uint64_t where) {
        if (!holds) faults_.push_back(std::string(what) + " " + std::to_string(where));
    }

    /// True if the node is in use. After an interrupted sweep, garbage is treated as free.
    bool in_use(std::uint32_t n) const {
        return n < table_.used && table_.nodes[n].level != free_level &&
               (!table_.sweeping || n == 0 || table_.marked(n));
    }

    void look_at_order() {
        const Order& order = kernel_.order;
        for (std::uint32_t variable = 0; variable < order.size(); ++variable) {
            const std::uint32_t level = order.level_of[variable];
            demand(level < order.size() && order.variable_at[level] == variable,
                   "the variable order is inconsistent at variable", variable);
        }
    }

    void look_at_nodes() {
        std::uint64_t in_use_now = 1, handles = 0;
        demand(table_.nodes[0].level == constant_level, "the constant node has the level of a variable: node", 0);
        for (std::uint32_t n = 1; n < table_.used; ++n) {
            handles += table_.refs[n];
            demand(table_.sweeping || !table_.marked(n), "a mark remains on node", n);
            demand(in_use(n) || table_.refs[n] == 0, "a handle refers to free node", n);
            if (!in_use(n)) continue;
            ++in_use_now;
            const Node& node = table_.nodes[n];
            demand(node.level < kernel_.order.size(), "the level does not exist: node", n);
            demand(complement_bit(node.low) == 0, "the low edge is complemented: node", n);
            demand(node.low != node.high, "both edges are equal: node", n);
            for (const Edge child : {node.low, node.high}) {
                demand(in_use(index_of(child)), "an edge leads to a free node: node", n);
                demand(kernel_.level(child) > node.level, "an edge does not lead to a lower level: node", n);
            }
        }
        demand(handles == kernel_.handles, "the number of handles is wrong:", handles);
        if (!table_.stale) demand(in_use_now == table_.in_use, "the number of nodes is wrong:", in_use_now);
    }

    void look_at_chains() {
        std::unordered_set<std::uint32_t> found;
        std::uint64_t free = 0;
        for (std::uint32_t bucket = 0; bucket < table_.buckets.size(); ++bucket)
            for (std::uint32_t n = table_.buckets[bucket]; n != 0 && found.insert(n).second; n = table_.nodes[n].next) {
                const Node& node = table_.nodes[n];
                demand(in_use(n), "a free node is in a chain: node", n);
                demand(table_.bucket(node.level, node.low, node.high) == bucket, "a node is in the wrong chain: node",
                       n);
                demand(table_.find(node.level, node.low, node.high) == n, "stored twice: node", n);
            }
        demand(found.size() + 1 == table_.in_use, "nodes in chains:", found.size());
        for (std::uint32_t n = table_.free; n != 0 && free <= table_.used; n = table_.nodes[n].next) ++free;
        demand(free + table_.in_use == table_.used, "the number of free nodes is wrong:", free);
    }

    bool value(Edge edge, std::uint64_t seed) {
        for (; !is_constant(edge); --steps_)
            edge = assigned(kernel_.level(edge), seed) ? kernel_.high(edge) : kernel_.low(edge);
        return edge == true_edge;
    }

    /// Returns the value of the variable of a level in a pseudo-random assignment.
    static bool assigned(std::uint64_t level, std::uint64_t seed) {
        const std::uint64_t mixed = (level + seed * 1000003U + 1) * 0x9E3779B97F4A7C15U;
        return ((mixed ^ mixed >> 29U) * 0xD6E8FEB86659FD93U >> 63U) != 0;
    }

    void look_at_cache() {
        for (std::size_t slot = 0; slot < kernel_.cache.size(); ++slot) {
            const Cache::CachedResult known = kernel_.cache.known(slot);
            if (known.f == 0) continue;
            const bool numbered = known.operation == Operation::Rename;
            const Edge third = numbered ? false_edge : known.h;
            bool live = true;
            for (const Edge edge : {known.f, known.g, third, known.result}) live = live && in_use(index_of(edge));
            demand(live, "the cache refers to a free node in slot", slot);
            if (!live || steps_ < 0) continue;
            for (std::uint64_t seed = 0; seed < 4; ++seed) {
                const bool f = value(known.f, seed), g = value(known.g, seed), h = value(third, seed),
                           r = value(known.result, seed);
                switch (known.operation) {
                case Operation::And: demand(r == (f && g), "the cached conjunction is wrong in slot", slot); break;
                case Operation::Xor: demand(r == (f != g), "the cached exclusive or is wrong in slot", slot); break;
                case Operation::Ite: demand(r == (f ? g : h), "the cached if-then-else is wrong in slot", slot); break;
                case Operation::Exists: demand(r || !f, "the cached quantification is wrong in slot", slot); break;
                case Operation::AndExists:
                    demand(r || !(f && g), "the cached relational product is wrong in slot", slot);
                    break;
                case Operation::Cofactor: demand(r == f || !g, "the cached cofactor is wrong in slot", slot); break;
                case Operation::Simplify:
                    demand(r == f || !g, "the cached simplification is wrong in slot", slot);
                    break;
                case Operation::Rename: break;  // the third operand is a number, not an edge
                }
            }
        }
    }

    Kernel& kernel_;
    NodeTable& table_;
    std::vector<std::string> faults_ = {};
    std::int64_t steps_ = 5'000'000;  ///< maximum number of steps for recomputing cache entries
};

}  // namespace

}  // namespace bdd

std::vector<std::string> verify(const BddSpace& space) { return bdd::Check(space.kernel()).faults(); }

}  // namespace grafverif
