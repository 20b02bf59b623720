// SPDX-License-Identifier: MIT
#include "draw/flow.hpp"

#include <algorithm>

namespace grafverif::draw {

namespace {

/// Depth-first search of a flow. The search is iterative, because a recursion could exceed the call stack for long
/// charts.
class DepthFirstSearch {
public:
    explicit DepthFirstSearch(const Flow& flow) : flow_(flow), state_(flow.nodes.size(), State::New) {
        order_.rows.assign(flow.nodes.size(), 0);
        order_.found.assign(flow.nodes.size(), 0);
        order_.upward.assign(flow.arcs.size(), false);
    }

    Order run() {
        for (const std::size_t root : flow_.roots) visit(root);
        for (std::size_t node = 0; node < flow_.nodes.size(); ++node)
            if (flow_.nodes[node].in.empty()) visit(node);
        for (std::size_t node = 0; node < flow_.nodes.size(); ++node) visit(node);
        settle_rows();
        return std::move(order_);
    }

private:
    enum class State : unsigned char { New, Open, Left };
    struct Frame {
        std::size_t node = 0, next = 0;
    };

    void enter(std::size_t node, std::vector<Frame>& path) {
        state_[node] = State::Open;
        order_.found[node] = found_++;
        path.push_back({node, 0});
    }

    void visit(std::size_t root) {
        if (state_[root] != State::New) return;
        std::vector<Frame> path;
        enter(root, path);
        while (!path.empty()) {
            Frame& frame = path.back();
            const std::vector<std::size_t>& out = flow_.nodes[frame.node].out;
            if (frame.next == out.size()) {
                state_[frame.node] = State::Left;
                left_.push_back(frame.node);
                path.pop_back();
                continue;
            }
            const std::size_t arc = out[frame.next++], to = flow_.arcs[arc].to;
            order_.upward[arc] = state_[to] == State::Open;
            if (state_[to] == State::New) enter(to, path);
        }
    }

    /// Computes the row of each node. The nodes are visited in the reverse order of their completion in the search.
    /// Therefore, each node is visited before the nodes to which its downward links lead.
    void settle_rows() {
        std::vector<bool> led_to(flow_.nodes.size(), false);
        for (std::size_t node = 0; node < flow_.nodes.size(); ++node)
            if (flow_.nodes[node].bar) order_.rows[node] = 1;
        for (auto node = left_.rbegin(); node != left_.rend(); ++node)
            for (const std::size_t arc : flow_.nodes[*node].out) {
                if (order_.upward[arc]) continue;
                const std::size_t to = flow_.arcs[arc].to;
                order_.rows[to] = std::max(order_.rows[to], order_.rows[*node] + 1);
                led_to[to] = true;
            }
        for (std::size_t node = 0; node < flow_.nodes.size(); ++node)
            if (flow_.nodes[node].bar && !led_to[node]) lower_source(node);
        for (const std::size_t row : order_.rows) order_.row_count = std::max(order_.row_count, row + 1);
    }

    /// Places a source transition one row above the highest step that it activates.
    void lower_source(std::size_t node) {
        std::size_t lowest = 0;
        for (const std::size_t arc : flow_.nodes[node].out) {
            if (order_.upward[arc]) continue;
            const std::size_t row = order_.rows[flow_.arcs[arc].to];
            lowest = lowest == 0 ? row : std::min(lowest, row);
        }
        if (lowest > 0) order_.rows[node] = lowest - 1;
    }

    const Flow& flow_;
    std::vector<State> state_;
    std::vector<std::size_t> left_ = {};
    std::size_t found_ = 0;
    Order order_ = {};
};

}  // namespace

Order order_of(const Flow& flow) { return DepthFirstSearch(flow).run(); }

}  // namespace grafverif::draw
