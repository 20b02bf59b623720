// SPDX-License-Identifier: MIT
#include "draw/blocks.hpp"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <numeric>
#include <unordered_map>

namespace grafverif::draw {

namespace {

/// An edge of the graph that is being reduced. The edge connects two ends (vertices) and represents a block.
struct Edge {
    std::size_t from = 0, to = 0, block = 0;
    /// Blocks that are attached to removed ends inside the edge and that extend beyond the edge.
    std::vector<std::size_t> hanging = {};
    bool removed = false;
};

/// A vertex of the reduced graph. `in` is the exclusive or of the numbers of all incoming edges, and `out` is the
/// exclusive or of the numbers of all outgoing edges. If only one incoming (outgoing) edge remains, `in` (`out`) is
/// therefore the number of this edge.
struct End {
    std::size_t in_count = 0, out_count = 0;
    std::size_t in = 0, out = 0;
    std::vector<std::size_t> from_nowhere = {}, to_nowhere = {};  ///< attached blocks that have a free end
    bool removed = false;
};

class SeriesParallelReduction {
public:
    SeriesParallelReduction(const Flow& flow, const Order& order)
        : flow_(flow), order_(order), ends_(2 * flow.nodes.size()) {
        result_.of_node.assign(flow.nodes.size(), nowhere);
        result_.of_arc = result_.exits = result_.entries = std::vector<std::size_t>(flow.arcs.size(), nowhere);
    }

    Blocks run() {
        for (std::size_t node = 0; node < flow_.nodes.size(); ++node) add_node(node);
        for (std::size_t arc = 0; arc < flow_.arcs.size(); ++arc) add_arc(arc);
        for (std::size_t end = 0; end < ends_.size(); ++end) waiting_.push_back(end);
        while (!waiting_.empty()) {
            const std::size_t end = waiting_.front();
            waiting_.pop_front();
            reduce(end);
        }
        gather_cores();
        result_.root = joined(Block::Kind::Parallel, parts_);
        set_parents();
        return std::move(result_);
    }

private:
    std::size_t leaf(Block::Kind kind, std::size_t what, std::size_t key, std::size_t low, std::size_t high) {
        result_.blocks.push_back({.kind = kind, .what = what, .key = key, .low = low, .high = high});
        return result_.blocks.size() - 1;
    }

    void add_node(std::size_t node) {
        const std::size_t row = order_.rows[node];
        result_.of_node[node] = leaf(Block::Kind::Node, node, 2 * order_.found[node] + 1, 2 * row, 2 * row + 2);
        add_edge(2 * node, 2 * node + 1, result_.of_node[node]);
    }

    void add_arc(std::size_t arc) {
        const auto [from, to] = flow_.arcs[arc];
        const std::size_t below = 2 * order_.rows[from] + 2, above = 2 * order_.rows[to];
        if (!order_.upward[arc]) {
            result_.of_arc[arc] = leaf(Block::Kind::Arc, arc, 2 * order_.found[to], below, above);
            add_edge(2 * from + 1, 2 * to, result_.of_arc[arc]);
            return;
        }
        if (flow_.nodes[from].out.size() > 1) {
            result_.exits[arc] = leaf(Block::Kind::Exit, arc, 2 * order_.found[from], below, below);
            ends_[2 * from + 1].to_nowhere.push_back(result_.exits[arc]);
        }
        if (flow_.nodes[to].bar && flow_.nodes[to].in.size() > 1) {
            result_.entries[arc] = leaf(Block::Kind::Entry, arc, 2 * order_.found[to], above, above);
            ends_[2 * to].from_nowhere.push_back(result_.entries[arc]);
        }
    }

    static std::uint64_t pair(std::size_t from, std::size_t to) {
        return static_cast<std::uint64_t>(from) << 32U | static_cast<std::uint64_t>(to);
    }

    void add_edge(std::size_t from, std::size_t to, std::size_t block, std::vector<std::size_t> hanging = {}) {
        const auto [same, added] = between_.try_emplace(pair(from, to), edges_.size());
        if (!added) {
            Edge& other = edges_[same->second];
            other.block = joined(Block::Kind::Parallel, {other.block, block});
            append(other.hanging, hanging);
            other.block = with_hanging(other.block, other.hanging);
        } else {
            ends_[from].out ^= edges_.size();
            ends_[to].in ^= edges_.size();
            ++ends_[from].out_count;
            ++ends_[to].in_count;
            edges_.push_back({from, to, block, {}});
            edges_.back().block = with_hanging(block, hanging);
            edges_.back().hanging = std::move(hanging);
        }
        waiting_.push_back(from);
        waiting_.push_back(to);
    }

    static void append(std::vector<std::size_t>& list, std::vector<std::size_t>& more) {
        if (list.size() < more.size()) list.swap(more);
        list.insert(list.end(), more.begin(), more.end());
        more.clear();
    }

    Edge remove(std::size_t number) {
        edges_[number].removed = true;
        Edge edge = std::move(edges_[number]);
        between_.erase(pair(edge.from, edge.to));
        ends_[edge.from].out ^= number;
        ends_[edge.to].in ^= number;
        --ends_[edge.from].out_count;
        --ends_[edge.to].in_count;
        return edge;
    }

    /// Returns a block of type `kind` that consists of `parts`. A part of the same type is replaced by its own parts.
    std::size_t joined(Block::Kind kind, const std::vector<std::size_t>& parts) {
        if (parts.size() == 1 && kind != Block::Kind::Core) return parts.front();
        Block block{.kind = kind, .key = nowhere};
        std::vector<Block>& blocks = result_.blocks;
        for (const std::size_t part : parts) {
            const bool flat = blocks[part].kind == kind;
            const std::size_t first = flat ? blocks[part].first : part, last = flat ? blocks[part].last : part;
            if (block.first == nowhere) block.first = first;
            else blocks[block.last].next = first;
            block.last = last;
            block.key = std::min(block.key, blocks[part].key);
            block.low = std::min(block.low, blocks[part].low);
            block.high = std::max(block.high, blocks[part].high);
            if (flat) blocks[part].first = blocks[part].last = nowhere;
        }
        blocks.push_back(block);
        return blocks.size() - 1;
    }

    /// Returns a block that contains `block` in parallel with blocks of `hanging`: with all blocks of `hanging` if
    /// `all` is true, otherwise with the blocks that do not extend beyond `block`.
    std::size_t with_hanging(std::size_t block, std::vector<std::size_t>& hanging, bool all = false) {
        std::vector<Block>& blocks = result_.blocks;
        std::vector<std::size_t> parts{block}, others;
        for (const std::size_t one : hanging) {
            const bool fits = all || (blocks[one].low >= blocks[block].low && blocks[one].high <= blocks[block].high);
            (fits ? parts : others).push_back(one);
            blocks[one].open = fits;
        }
        hanging = std::move(others);
        return joined(Block::Kind::Parallel, parts);
    }

    void reduce(std::size_t number) {
        End& end = ends_[number];
        if (end.removed || end.in_count > 1 || end.out_count > 1) return;
        end.removed = true;
        if (end.in_count == 1 && end.out_count == 1) {
            Edge in = remove(end.in), out = remove(end.out);
            in.block = with_hanging(in.block, end.from_nowhere);
            out.block = with_hanging(out.block, end.to_nowhere);
            for (std::vector<std::size_t>* more : {&out.hanging, &end.from_nowhere, &end.to_nowhere})
                append(in.hanging, *more);
            add_edge(in.from, out.to, joined(Block::Kind::Series, {in.block, out.block}), std::move(in.hanging));
        } else if (end.out_count == 1) {
            Edge out = remove(end.out);
            out.block = with_hanging(out.block, end.to_nowhere);
            append(out.hanging, end.to_nowhere);
            hang(end.from_nowhere, out, false, ends_[out.to].from_nowhere);
            waiting_.push_back(out.to);
        } else if (end.in_count == 1) {
            Edge in = remove(end.in);
            in.block = with_hanging(in.block, end.from_nowhere);
            append(in.hanging, end.from_nowhere);
            hang(end.to_nowhere, in, true, ends_[in.from].to_nowhere);
            waiting_.push_back(in.from);
        } else {
            finish(end);
        }
    }

    /// Removes an edge with a free end, that is, an end without other edges. The block of the edge, together with the
    /// blocks `free` at the free end, is added to `list`, the list of blocks that are attached to the other end.
    void hang(const std::vector<std::size_t>& free, Edge& edge, bool below, std::vector<std::size_t>& list) {
        std::size_t block = edge.block;
        if (!free.empty()) {
            const std::size_t all = joined(Block::Kind::Parallel, free);
            block = joined(Block::Kind::Series, below ? std::vector{block, all} : std::vector{all, block});
        }
        list.push_back(with_hanging(block, edge.hanging, true));
    }

    /// Completes a connected component of the flow: all its ends except `end` have been removed.
    void finish(const End& end) {
        std::vector<std::size_t> halves;
        for (const std::vector<std::size_t>* hanging : {&end.from_nowhere, &end.to_nowhere})
            if (!hanging->empty()) halves.push_back(joined(Block::Kind::Parallel, *hanging));
        if (!halves.empty()) parts_.push_back(joined(Block::Kind::Series, halves));
    }

    std::size_t part_of(std::size_t end) {
        while (part_[end] != end) end = part_[end] = part_[part_[end]];
        return end;
    }

    void gather_cores() {
        part_.resize(ends_.size());
        std::iota(part_.begin(), part_.end(), std::size_t{0});
        for (const Edge& edge : edges_)
            if (!edge.removed) part_[part_of(edge.from)] = part_of(edge.to);
        std::vector<std::vector<std::size_t>> cores(ends_.size());
        const auto strip = [&](std::size_t block, std::size_t above, std::size_t below) {
            result_.blocks[block].above = above;
            result_.blocks[block].below = below;
            cores[part_of(above == nowhere ? below : above)].push_back(block);
        };
        for (Edge& edge : edges_)
            if (!edge.removed) strip(with_hanging(edge.block, edge.hanging, true), edge.from, edge.to);
        for (std::size_t end = 0; end < ends_.size(); ++end) {
            if (ends_[end].removed) continue;
            for (const std::size_t block : ends_[end].from_nowhere) strip(block, nowhere, end);
            for (const std::size_t block : ends_[end].to_nowhere) strip(block, end, nowhere);
        }
        for (const std::vector<std::size_t>& core : cores)
            if (!core.empty()) parts_.push_back(joined(Block::Kind::Core, core));
    }

    /// Sets the parents of all descendants of the root, and sorts the parts of each Parallel by their keys.
    void set_parents() {
        std::vector<Block>& blocks = result_.blocks;
        if (blocks.empty()) return;
        for (std::size_t number = result_.root + 1; number-- > 0;) {
            if (!result_.contains(number)) continue;
            Block& block = blocks[number];
            std::vector<std::size_t> parts;
            for (std::size_t part = block.first; part != nowhere; part = blocks[part].next) parts.push_back(part);
            for (const std::size_t part : parts) blocks[part].parent = number;
            if (block.kind != Block::Kind::Parallel || parts.empty()) continue;
            std::ranges::stable_sort(parts, {}, [&](std::size_t part) { return blocks[part].key; });
            block.first = parts.front();
            block.last = parts.back();
            for (std::size_t k = 0; k < parts.size(); ++k)
                blocks[parts[k]].next = k + 1 < parts.size() ? parts[k + 1] : nowhere;
        }
    }

    const Flow& flow_;
    const Order& order_;
    Blocks result_ = {};
    std::vector<End> ends_;  ///< ends of the nodes: node n has the upper end 2n and the lower end 2n + 1
    std::vector<Edge> edges_ = {};
    std::unordered_map<std::uint64_t, std::size_t> between_ = {};
    std::deque<std::size_t> waiting_ = {};
    std::vector<std::size_t> parts_ = {};  ///< blocks of the connected components of the flow
    std::vector<std::size_t> part_ = {};   ///< parent of each end in the union-find structure of components
};

}  // namespace

Blocks blocks_of(const Flow& flow, const Order& order) { return SeriesParallelReduction(flow, order).run(); }

}  // namespace grafverif::draw
