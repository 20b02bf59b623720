// SPDX-License-Identifier: MIT
// Computes the strongly connected components of a graph of states (algorithm of Tarjan 1972, without recursion), and
// cycles within components.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "check/timed/explore.hpp"
#include "check/timed/store/column.hpp"

namespace grafverif::timed {

/// Computes the components of all states that are reachable from the states that are passed to `visit`. The function
/// `each(state, take)` must call `take` for every successor of `state`.
template <class Each>
class Components {
public:
    Components(std::size_t states, const Limits& limits, Each each) : limits_(limits), each_(std::move(each)) {
        number_.assign(states, none);
        component_.assign(states, none);
    }

    void visit(std::uint32_t root) {
        if (number_[root] != none) return;
        enter(root);
        while (!frames_.empty()) {
            limits_.poll();
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

    std::uint32_t of(std::uint32_t state) const { return component_[state]; }
    /// True if the component of the state contains a cycle.
    bool has_cycle(std::uint32_t state) const { return cyclic_[of(state)]; }
    bool any_cycle() const { return std::ranges::find(cyclic_, true) != cyclic_.end(); }

    /// Returns the states of a shortest cycle through `state`; `state` is the last state of the list. If `first`, a
    /// successor of `state`, is given, the cycle is a shortest cycle whose first state after `state` is `first`.
    std::vector<std::uint32_t> cycle(std::uint32_t state, std::optional<std::uint32_t> first = {}) {
        std::unordered_map<std::uint32_t, std::uint32_t> from;
        std::vector<std::uint32_t> queue = {first.value_or(state)};
        if (first) from.emplace(*first, state);
        for (std::size_t done = 0; done < queue.size() && !from.contains(state); ++done)
            each_(queue[done], [&](std::uint32_t next) {
                if (of(next) == of(state) && from.emplace(next, queue[done]).second) queue.push_back(next);
            });
        std::vector<std::uint32_t> path = {state};
        for (std::uint32_t now = from.at(state); now != state; now = from.at(now)) path.push_back(now);
        std::ranges::reverse(path);
        return path;
    }

private:
    static constexpr std::uint32_t none = Store::none;
    struct Frame {
        std::uint32_t state = 0;
        std::uint32_t low = 0;
        std::uint32_t first = 0;  // start of this frame in successors_; the frame ends at the top of successors_
        bool loops = false;       // true if the state has an edge to itself
    };

    void enter(std::uint32_t state) {
        number_[state] = next_number_;
        open_.push_back(state);
        Frame frame{.state = state, .low = next_number_++, .first = static_cast<std::uint32_t>(successors_.size())};
        each_(state, [&](std::uint32_t next) {
            successors_.push_back(next);
            frame.loops = frame.loops || next == state;
        });
        frames_.push_back(frame);
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

    const Limits& limits_;
    Each each_;
    Column<std::uint32_t> number_ = {}, component_ = {}, open_ = {}, successors_ = {};
    Column<Frame> frames_ = {};
    std::vector<bool> cyclic_ = {};
    std::uint32_t next_number_ = 0;
};

}  // namespace grafverif::timed
