// SPDX-License-Identifier: MIT
// Counts satisfying assignments exactly, bottom-up. Numbers of assignments can be large, with one bit per variable;
// therefore their memory is charged to the space. Each number is freed after its last use.
#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cassert>
#include <limits>
#include <new>
#include <unordered_map>

#include "bdd/kernel.hpp"

namespace grafverif {

namespace {

using Number = boost::multiprecision::cpp_int;
using bdd::Edge;
using bdd::Kernel;

class Counter {
public:
    /// The position of a node is the index of its variable in `variables`, after these are sorted in the order of the
    /// space. Constants are below all variables.
    Counter(Kernel& kernel, std::span<const std::uint32_t> variables)
        : kernel_(kernel), places_(variables.size()), place_of_(kernel.order.size(), 0) {
        std::vector<std::uint32_t> levels;
        levels.reserve(places_);
        for (const std::uint32_t variable : variables) levels.push_back(kernel.order.level_of[variable]);
        std::ranges::sort(levels);
        for (std::size_t place = 0; place < places_; ++place) place_of_[levels[place]] = place;
    }
    Counter(const Counter&) = delete;
    Counter& operator=(const Counter&) = delete;
    ~Counter() { kernel_.budget.used -= charged_; }

    Number of(Edge root) {
        const std::vector<std::uint32_t> nodes = bdd::nodes_of(kernel_, root);
        counts_.reserve(nodes.size());
        for (const std::uint32_t n : nodes) {
            ++counts_[n].parents;  // the 1 that Count::parents adds to the number of edges
            meet(kernel_.table.nodes[n].low);
            meet(kernel_.table.nodes[n].high);
        }
        for (const std::uint32_t n : nodes) {
            const bdd::Node& node = kernel_.table.nodes[n];
            const std::size_t next = place_of_[node.level] + 1;
            keep(n, below(node.low, next) + below(node.high, next));
            drop(node.low);
            drop(node.high);
        }
        return below(root, 0);
    }

private:
    struct Count {
        Number number = 0;
        std::uint32_t parents = 0;  ///< 1 plus the number of edges to the node that are not yet processed
    };

    std::size_t place(Edge edge) const { return bdd::is_constant(edge) ? places_ : place_of_[kernel_.level(edge)]; }

    void meet(Edge edge) {
        kernel_.watch.step();
        if (!bdd::is_constant(edge)) ++counts_[bdd::index_of(edge)].parents;
    }

    static std::uint64_t bytes(const Number& number) {
        return sizeof(Count) + number.backend().size() * sizeof(boost::multiprecision::limb_type);
    }

    void keep(std::uint32_t n, Number number) {
        const std::uint64_t more = bytes(number);
        if (!kernel_.budget.charge(more)) throw BddExhausted(BddExhausted::Cause::Memory);
        charged_ += more;
        kernel_.watch.step(static_cast<std::uint32_t>(1 + number.backend().size() / 8));
        counts_[n].number = std::move(number);
    }

    void drop(Edge edge) {
        if (bdd::is_constant(edge)) return;
        Count& count = counts_[bdd::index_of(edge)];
        if (--count.parents != 1) return;  // the number of this node is still needed
        const std::uint64_t less = bytes(count.number);
        kernel_.budget.used -= less;
        charged_ -= less;
        count.number = Number();
    }

    /// Returns the number of assignments to the variables from position `from` on.
    Number below(Edge edge, std::size_t from) {
        Number number = bdd::is_constant(edge) ? Number(0) : counts_[bdd::index_of(edge)].number;
        if (bdd::complement_bit(edge) != 0) number = (Number(1) << (places_ - place(edge))) - number;
        return number << (place(edge) - from);
    }

    Kernel& kernel_;
    std::size_t places_ = 0;
    std::vector<std::size_t> place_of_ = {};
    std::unordered_map<std::uint32_t, Count> counts_ = {};
    std::uint64_t charged_ = 0;
};

Number counted(const Bdd& f, std::span<const std::uint32_t> variables) {
    if (f.is_constant()) return f.is_true() ? Number(Number(1) << variables.size()) : Number(0);
    try {
        return Counter(*f.kernel(), variables).of(f.edge());
    } catch (const std::bad_alloc&) {
        throw BddExhausted(BddExhausted::Cause::Memory);
    }
}

}  // namespace

std::string count(const Bdd& f, std::span<const std::uint32_t> variables) { return counted(f, variables).str(); }

std::optional<std::uint64_t> small_count(const Bdd& f, std::span<const std::uint32_t> variables) {
    const Number number = counted(f, variables);
    if (number > std::numeric_limits<std::uint64_t>::max()) return {};
    return number.convert_to<std::uint64_t>();
}

}  // namespace grafverif
