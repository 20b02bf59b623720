// SPDX-License-Identifier: MIT
// Variable reordering by sifting (Rudell 1993) with groups (Panda and Somenzi 1995): each group is moved through all
// positions by exchanges of adjacent levels, and placed at the position with the smallest number of nodes. The largest
// groups are moved first. The movement in a direction stops if the diagrams are a fifth larger than at the best
// position.
//
// An exchange rewrites the nodes of two levels in place. A node denotes the same function before and after the
// exchange, so that handles remain valid. Between exchanges the space is consistent. Therefore reordering can be
// interrupted; the space then keeps the order reached so far. If the memory limit does not permit an exchange,
// reordering ends. Groups that were split by an interruption are reassembled at the start of the next reordering.
// During reordering, the table contains no garbage, and the number of edges to each node is counted.
#include <algorithm>
#include <new>
#include <numeric>

#include "bdd/kernel.hpp"

namespace grafverif::bdd {

namespace {

/// Maximum number of nodes in two levels that are exchanged; limits the time of an exchange, which
/// cannot be interrupted.
constexpr std::size_t longest_exchange = 1U << 18U;

struct NoMemory {};

class Sifter {
public:
    explicit Sifter(Kernel& kernel)
        : kernel_(kernel), table_(kernel.table), uses_(table_.capacity), at_(kernel.order.size()) {
        for (std::uint32_t n = 1; n < table_.used; ++n) {
            kernel_.watch.step();
            const Node& node = table_.nodes[n];
            if (node.level == free_level) continue;
            at_[node.level].push_back(n);
            uses_[n] += table_.refs[n];
            ++uses_[index_of(node.low)];
            ++uses_[index_of(node.high)];
        }
    }

    void sift() {
        gather();
        std::vector<std::uint32_t> groups = groups_by_size();
        for (const std::uint32_t group : groups) sift(group);
    }

private:
    /// The current position of a group: its first level and its number of levels.
    struct Span {
        std::uint32_t first = 0, count = 0;
        std::uint32_t end() const { return first + count; }
    };

    std::uint32_t group_at(std::uint32_t level) const {
        return kernel_.order.group_of[kernel_.order.variable_at[level]];
    }

    /// Returns the group at `level`. Requires that groups are contiguous.
    Span span_at(std::uint32_t level) const {
        Span span{level, 1};
        const std::uint32_t group = group_at(level);
        while (span.first > 0 && group_at(span.first - 1) == group) --span.first, ++span.count;
        while (span.end() < at_.size() && group_at(span.end()) == group) ++span.count;
        return span;
    }

    /// Makes groups contiguous. Each group is placed at the position of its topmost variable.
    void gather() {
        for (std::uint32_t level = 0; level < at_.size();) {
            const std::uint32_t group = group_at(level);
            std::uint32_t end = level + 1;
            for (std::uint32_t other = end; other < at_.size(); ++other) {
                if (group_at(other) != group) continue;
                for (std::uint32_t up = other; up > end; --up) exchange(up - 1);
                ++end;
            }
            level = end;
        }
    }

    std::vector<std::uint32_t> groups_by_size() const {
        std::vector<std::pair<std::size_t, std::uint32_t>> found;
        for (std::uint32_t level = 0; level < at_.size();) {
            const Span span = span_at(level);
            std::size_t nodes = 0;
            for (; level < span.end(); ++level) nodes += at_[level].size();
            if (nodes > 0) found.emplace_back(nodes, kernel_.order.variable_at[span.first]);
        }
        std::ranges::sort(found, [](const auto& a, const auto& b) {
            return a.first != b.first ? a.first > b.first : a.second < b.second;
        });
        std::vector<std::uint32_t> groups;
        for (const auto& [nodes, variable] : found) groups.push_back(variable);
        return groups;
    }

    /// Exchanges a group with the next lower group.
    void move_down(Span upper, Span lower) {
        for (std::uint32_t i = 0; i < lower.count; ++i)
            for (std::uint32_t level = lower.first + i; level > upper.first + i; --level) exchange(level - 1);
    }

    void sift(std::uint32_t variable) {
        Span here = span_at(kernel_.order.level_of[variable]);
        std::uint32_t best = table_.in_use, best_first = here.first;
        const auto note = [&] {
            if (table_.in_use < best) {
                best = table_.in_use;
                best_first = here.first;
            }
            return table_.in_use <= best + best / 5;
        };
        const auto down = [&] {
            const Span lower = span_at(here.end());
            move_down(here, lower);
            here.first += lower.count;
        };
        const auto up = [&] {
            const Span upper = span_at(here.first - 1);
            move_down(upper, here);
            here.first = upper.first;
        };
        const auto all_down = [&] {
            while (here.end() < at_.size()) {
                down();
                if (!note()) break;
            }
        };
        const auto all_up = [&] {
            while (here.first > 0) {
                up();
                if (!note()) break;
            }
        };
        if (here.first > at_.size() / 2) all_down(), all_up();
        else all_up(), all_down();
        while (here.first < best_first) down();
        while (here.first > best_first) up();
    }

    /// Exchanges `level` with the next level.
    void exchange(std::uint32_t level) {
        const std::size_t nodes = at_[level].size() + at_[level + 1].size();
        kernel_.watch.step(static_cast<std::uint32_t>(4 * nodes + 1));
        if (nodes > longest_exchange) throw NoMemory{};
        while (table_.free_nodes() < 2 * at_[level].size())
            if (!grow(kernel_)) throw NoMemory{};
        if (uses_.size() < table_.capacity) uses_.resize(table_.capacity);
        std::vector<std::uint32_t> upper, lower, rewritten;
        lower.reserve(nodes + 2 * at_[level].size());
        upper.reserve(nodes);
        rewritten.reserve(at_[level].size());
        // From here on, no operation can fail, so that the exchange is never left incomplete.
        for (const std::uint32_t n : at_[level]) table_.unlink(n);
        for (const std::uint32_t n : at_[level + 1]) table_.unlink(n);
        for (const std::uint32_t n : at_[level]) {
            Node& node = table_.nodes[n];
            if (kernel_.level(node.low) == level + 1 || kernel_.level(node.high) == level + 1) {
                rewritten.push_back(n);
                continue;
            }
            node.level = level + 1;
            table_.link(n);
            lower.push_back(n);
        }
        const std::size_t kept = lower.size();
        for (const std::uint32_t n : rewritten) rewrite(n, level, lower, kept);
        for (const std::uint32_t n : at_[level + 1]) {
            if (uses_[n] == 0) {
                --uses_[index_of(table_.nodes[n].low)];
                --uses_[index_of(table_.nodes[n].high)];
                table_.release(n);
                continue;
            }
            table_.nodes[n].level = level;
            table_.link(n);
            upper.push_back(n);
        }
        for (const std::uint32_t n : rewritten) table_.link(n);
        upper.insert(upper.end(), rewritten.begin(), rewritten.end());
        at_[level] = std::move(upper);
        at_[level + 1] = std::move(lower);
        Order& order = kernel_.order;
        std::swap(order.variable_at[level], order.variable_at[level + 1]);
        order.level_of[order.variable_at[level]] = level;
        order.level_of[order.variable_at[level + 1]] = level + 1;
        ++order.version;
    }

    /// Rewrites a node of the upper variable that also depends on the lower variable. The rewritten
    /// node belongs to the lower variable and has the same function.
    void rewrite(std::uint32_t n, std::uint32_t level, std::vector<std::uint32_t>& lower, std::size_t) {
        const Edge low = table_.nodes[n].low, high = table_.nodes[n].high;
        const Edge first = made(level + 1, kernel_.low(low, level + 1), kernel_.low(high, level + 1), lower);
        const Edge second = made(level + 1, kernel_.high(low, level + 1), kernel_.high(high, level + 1), lower);
        table_.nodes[n].low = first;
        table_.nodes[n].high = second;
        ++uses_[index_of(first)];
        ++uses_[index_of(second)];
        --uses_[index_of(low)];
        --uses_[index_of(high)];
    }

    Edge made(std::uint32_t level, Edge low, Edge high, std::vector<std::uint32_t>& lower) {
        if (low == high) return low;
        const Edge flip = complement_bit(low);
        low ^= flip;
        high ^= flip;
        if (const std::uint32_t n = table_.find(level, low, high)) return n << 1U | flip;
        const std::uint32_t n = table_.add(level, low, high);
        uses_[n] = 0;
        ++uses_[index_of(low)];
        ++uses_[index_of(high)];
        lower.push_back(n);
        return n << 1U | flip;
    }

    Kernel& kernel_;
    NodeTable& table_;
    std::vector<std::uint32_t> uses_;             ///< number of edges and handles to each node
    std::vector<std::vector<std::uint32_t>> at_;  ///< the nodes at each level
};

/// Charges memory to the budget during the lifetime of the object.
struct Charge {
    Charge(Budget& all, std::uint64_t wanted) : budget(all), bytes(all.charge(wanted) ? wanted : 0) {}
    Charge(const Charge&) = delete;
    Charge& operator=(const Charge&) = delete;
    ~Charge() { budget.used -= bytes; }

    Budget& budget;
    std::uint64_t bytes = 0;
};

}  // namespace

void reorder(Kernel& kernel) {
    if (kernel.table.capacity == 0) return;
    collect(kernel, {});
    kernel.cache.clear(kernel.watch);
    const Charge charge(kernel.budget,
                        16 * std::uint64_t{kernel.table.capacity} + 64 * std::uint64_t{kernel.order.size()});
    if (charge.bytes == 0) return;  // reordering is skipped, because there is not enough memory
    try {
        Sifter(kernel).sift();
    } catch (const NoMemory&) {
    } catch (const std::bad_alloc&) {
    }
}

}  // namespace grafverif::bdd
