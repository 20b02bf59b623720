// SPDX-License-Identifier: MIT
// That nothing goes on for ever within one instant, and that time can pass for ever, are questions about cycles: of
// edges alone, and of edges and delays with a delay in it. Both are answered by strongly connected components (Tarjan
// 1972, without recursion). Most parts can rest: a state that time leaves as it is answers the second one at once.
#include "check/timed/premises.hpp"

#include <algorithm>
#include <unordered_map>

namespace grafverif::timed {

namespace {

constexpr std::uint32_t none = Store::none;

/// The moves that make the graph.
enum class Moving { All, Edges };

class Components {
public:
    Components(Graph& graph, Moving by, const Limits& limits) : graph_(graph), by_(by) {
        number_.assign(graph.states(), none);
        component_.assign(graph.states(), none);
        for (std::uint32_t state = 0; state < graph.states(); ++state)
            if (number_[state] == none) visit(state, limits);
    }

    std::uint32_t of(std::uint32_t state) const { return component_[state]; }
    bool any_cycle() const { return any_cycle_; }

private:
    struct Frame {
        std::uint32_t state = 0;
        std::uint32_t low = 0;
        std::uint32_t first = 0;  // in successors_, where its own end at the top
    };

    void enter(std::uint32_t state) {
        number_[state] = next_number_;
        open_.push_back(state);
        frames_.push_back({state, next_number_++, static_cast<std::uint32_t>(successors_.size())});
        const auto take = [&](std::uint32_t next) {
            successors_.push_back(next);
            any_cycle_ = any_cycle_ || next == state;
        };
        if (graph_.open(state)) return;  // the model breaks off here
        if (by_ == Moving::All) graph_.each(state, take);
        else graph_.each_action(state, take);
    }

    void visit(std::uint32_t root, const Limits& limits) {
        enter(root);
        while (!frames_.empty()) {
            limits.poll();
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
        any_cycle_ = any_cycle_ || open_.back() != frame.state;
        for (std::uint32_t state = none; state != frame.state;) {
            state = open_.back();
            open_.pop_back();
            component_[state] = frame.state;
        }
    }

    Graph& graph_;
    Moving by_;
    Column<std::uint32_t> number_ = {}, component_ = {}, open_ = {}, successors_ = {};
    Column<Frame> frames_ = {};
    bool any_cycle_ = false;
    std::uint32_t next_number_ = 0;
};

/// The path that time takes from `from` and that edges and delays then take back to it, within its component.
std::vector<std::uint32_t> back_to(Graph& graph, const Components& components, std::uint32_t from) {
    std::unordered_map<std::uint32_t, std::uint32_t> reached = {{graph.target(from), from}};
    std::vector<std::uint32_t> queue = {graph.target(from)};
    for (std::size_t done = 0; done < queue.size() && !reached.contains(from); ++done)
        graph.each(queue[done], [&](std::uint32_t next) {
            if (components.of(next) == components.of(from) && reached.emplace(next, queue[done]).second)
                queue.push_back(next);
        });
    std::vector<std::uint32_t> path = {from};
    for (std::uint32_t now = reached.at(from); now != from; now = reached.at(now)) path.push_back(now);
    std::ranges::reverse(path);
    return path;
}

/// A run in which time passes again and again, one that comes to rest where there is one.
std::optional<Run> divergent(Graph& graph, const Limits& limits) {
    const auto along = [&](std::uint32_t state, const std::vector<std::uint32_t>& cycle) {
        std::vector<std::uint32_t> path = graph.path_to(state);
        const std::size_t loop = path.size() - 1;
        path.insert(path.end(), cycle.begin(), cycle.end());
        return graph.run_along(path, loop);
    };
    for (std::uint32_t state = 0; state < graph.states(); ++state)
        if (graph.passes(state) && graph.target(state) == state) return along(state, {state});
    const Components components(graph, Moving::All, limits);
    for (std::uint32_t state = 0; state < graph.states(); ++state)
        if (graph.passes(state) && components.of(graph.target(state)) == components.of(state))
            return along(state, back_to(graph, components, state));
    return {};
}

}  // namespace

Premises premises_of(Graph& graph, std::uint32_t settled, const Limits& limits) {
    Premises premises;
    premises.diverges = divergent(graph, limits);
    premises.rests = !Components(graph, Moving::Edges, limits).any_cycle();
    premises.settles = true;
    for (std::uint32_t state = 0; state < graph.states() && premises.settles; ++state) {
        limits.poll();
        premises.settles = !graph.passes(state) || graph.holds(settled, state) == End::Yes;
    }
    return premises;
}

}  // namespace grafverif::timed
