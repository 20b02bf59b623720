// SPDX-License-Identifier: MIT
// The counterexample of a liveness property: a short run to a state that lies on a cycle, or where everything ends,
// outside `met` from a root on.
//
// First a breadth-first walk outside `met`, in which each root enters at its own depth in the search; it gives every
// state met a near root and a short path from it. Then the strongly connected components of what the walk met
// (Tarjan 1972, without recursion); the first state of the walk on a cycle, or stuck, is the one. Its cycle is found
// breadth first inside its component.
#include <algorithm>
#include <unordered_map>

#include "check/timed/fixpoints.hpp"

namespace grafverif::timed {

namespace {

constexpr std::uint32_t none = Store::none;

/// The states reached outside `met`, in the order of the walk, and where each was reached from (a root: from itself).
struct Walk {
    Column<std::uint32_t> order = {};
    Column<std::uint32_t> from = {};  // per state of the graph; none: not reached

    bool has(std::uint32_t state) const { return from[state] != none; }
};

Walk walk(Graph& graph, const StateSet& met, const std::vector<std::uint32_t>& roots) {
    Walk walk;
    walk.from.assign(graph.states(), none);
    std::size_t next_root = 0;
    std::size_t done = 0;
    const auto reach = [&](std::uint32_t state, std::uint32_t from) {
        if (walk.has(state)) return;
        walk.from[state] = from;
        walk.order.push_back(state);
    };
    for (std::size_t depth = 0; depth < graph.levels.size() || done < walk.order.size(); ++depth) {
        for (const std::size_t level = walk.order.size(); done < level; ++done) {
            const std::uint32_t state = walk.order[done];
            graph.each(state, [&](std::uint32_t next) {
                if (!met.has(next)) reach(next, state);
            });
        }
        const std::uint32_t end = depth + 1 < graph.levels.size() ? graph.levels[depth + 1] : none;
        for (; next_root < roots.size() && roots[next_root] < end; ++next_root)
            reach(roots[next_root], roots[next_root]);
    }
    return walk;
}

/// The component of each state of a walk, and whether it holds a cycle.
class Components {
public:
    Components(Graph& graph, const Walk& walk) : graph_(graph), walk_(walk) {
        number_.assign(graph.states(), none);
        component_.assign(graph.states(), none);
        for (std::size_t i = 0; i < walk.order.size(); ++i)
            if (number_[walk.order[i]] == none) visit(walk.order[i]);
    }

    std::uint32_t of(std::uint32_t state) const { return component_[state]; }
    bool has_cycle(std::uint32_t state) const { return cyclic_[of(state)]; }

private:
    struct Frame {
        std::uint32_t state = 0;
        std::uint32_t low = 0;
        std::uint32_t first = 0;  // in successors_, where its own end at the top
        bool loops = false;       // an edge to itself
    };

    void enter(std::uint32_t state) {
        number_[state] = next_number_;
        open_.push_back(state);
        Frame frame{.state = state, .low = next_number_++, .first = static_cast<std::uint32_t>(successors_.size())};
        graph_.each(state, [&](std::uint32_t next) {
            if (walk_.has(next)) successors_.push_back(next);
            frame.loops = frame.loops || next == state;
        });
        frames_.push_back(frame);
    }

    void visit(std::uint32_t root) {
        enter(root);
        while (!frames_.empty()) {
            Frame& frame = frames_.back();
            if (successors_.size() > frame.first) {
                const std::uint32_t next = successors_.back();
                successors_.pop_back();
                if (number_[next] == none) enter(next);
                else if (component_[next] == none) frame.low = std::min(frame.low, number_[next]);
                continue;
            }
            close(frame);
            const std::uint32_t low = frame.low;
            frames_.pop_back();
            if (!frames_.empty()) frames_.back().low = std::min(frames_.back().low, low);
        }
    }

    void close(const Frame& frame) {
        if (frame.low != number_[frame.state]) return;
        const auto component = static_cast<std::uint32_t>(cyclic_.size());
        cyclic_.push_back(frame.loops || open_.back() != frame.state);
        for (std::uint32_t state = none; state != frame.state;) {
            state = open_.back();
            open_.pop_back();
            component_[state] = component;
        }
    }

    Graph& graph_;
    const Walk& walk_;
    Column<std::uint32_t> number_ = {}, component_ = {}, open_ = {}, successors_ = {};
    Column<Frame> frames_ = {};
    std::vector<bool> cyclic_ = {};
    std::uint32_t next_number_ = 0;
};

/// The shortest path from `state` back to it inside its component, without its first state, `state` last.
std::vector<std::uint32_t> cycle(Graph& graph, const Components& components, std::uint32_t state) {
    std::unordered_map<std::uint32_t, std::uint32_t> from;
    std::vector<std::uint32_t> queue = {state};
    for (std::size_t done = 0; done < queue.size() && !from.contains(state); ++done) {
        const std::uint32_t now = queue[done];
        graph.each(now, [&](std::uint32_t next) {
            if (components.of(next) == components.of(state) && from.emplace(next, now).second) queue.push_back(next);
        });
    }
    std::vector<std::uint32_t> path = {state};
    for (std::uint32_t now = from.at(state); now != state; now = from.at(now)) path.push_back(now);
    std::ranges::reverse(path);
    return path;
}

}  // namespace

Lasso avoiding(Graph& graph, const StateSet& met, const std::vector<std::uint32_t>& roots, bool endless) {
    const Walk reached = walk(graph, met, roots);
    const Components components(graph, reached);
    for (std::size_t i = 0; i < reached.order.size(); ++i) {
        const std::uint32_t state = reached.order[i];
        const bool stuck = !endless && graph.kind(state) == StateKind::Stuck;
        if (!stuck && !components.has_cycle(state)) continue;
        std::vector<std::uint32_t> tail;
        std::uint32_t now = state;
        for (; reached.from[now] != now; now = reached.from[now]) tail.push_back(now);
        Lasso lasso{.path = graph.path_to(now)};
        lasso.path.insert(lasso.path.end(), tail.rbegin(), tail.rend());
        if (stuck) return lasso;
        lasso.loop = lasso.path.size() - 1;
        const std::vector<std::uint32_t> loop = cycle(graph, components, state);
        lasso.path.insert(lasso.path.end(), loop.begin(), loop.end());
        return lasso;
    }
    return {};
}

}  // namespace grafverif::timed
