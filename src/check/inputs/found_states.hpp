// SPDX-License-Identifier: MIT
// States that a guided search of a network has found, each with the run that leads to the state.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "check/timed/layout.hpp"
#include "check/timed/store/packed_states.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

class FoundStates {
public:
    explicit FoundStates(const timed::Layout& layout) : layout_(layout), states_(layout.stored + 1) {}
    FoundStates(FoundStates&&) = delete;

    /// Adds a state and returns its number; returns nullopt if the state has already been added with the same `mark`.
    /// `parent` is the number of the state in which `move` starts. The first state to be added is the initial state.
    std::optional<std::size_t> add(const timed::Word* words, std::size_t parent, std::size_t mark, const Move& move);

    std::size_t size() const { return states_.size(); }
    /// Returns the approximate memory in bytes.
    std::uint64_t bytes() const { return nodes_.capacity() * sizeof(Node) + states_.bytes(); }
    /// Copies a state to `words`, and resizes `words` to the size of the layout.
    void load(std::size_t state, std::vector<timed::Word>& words) const;
    std::size_t mark(std::size_t state) const { return states_.words(state)[layout_.stored]; }
    Run run_to(std::size_t state) const;

private:
    struct Node {
        std::size_t parent = 0;
        Move move = {};
    };

    const timed::Layout& layout_;
    std::vector<Node> nodes_ = {};
    PackedStates states_;                  // the stored words and the mark of each state
    std::vector<timed::Word> added_ = {};  // buffer of `add`: the packed form of the new state
};

}  // namespace grafverif
