// SPDX-License-Identifier: MIT
// States that a guided search of a network has found, each with the run to it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_set>
#include <vector>

#include "check/timed/layout.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

class FoundStates {
public:
    explicit FoundStates(const timed::Layout& layout) : layout_(layout) {}
    FoundStates(FoundStates&&) = delete;

    /// Adds a state and returns its number; empty if the state is already known with this `mark`. `parent` is the state
    /// before `move`. The first state is the initial state.
    std::optional<std::size_t> add(const timed::Word* words, std::size_t parent, std::size_t mark, const Move& move);

    std::size_t size() const { return nodes_.size(); }
    /// Returns the approximate memory in bytes.
    std::uint64_t bytes() const;
    const timed::Word* words(std::size_t state) const { return words_.data() + state * layout_.words; }
    std::size_t mark(std::size_t state) const { return nodes_[state].mark; }
    Run run_to(std::size_t state) const;

private:
    struct Node {
        std::size_t parent = 0, mark = 0;
        Move move = {};
    };

    struct Hash {
        const FoundStates& states;
        std::size_t operator()(std::size_t state) const;
    };
    struct Equal {
        const FoundStates& states;
        bool operator()(std::size_t a, std::size_t b) const;
    };
    const timed::Layout& layout_;
    std::vector<Node> nodes_ = {};
    std::vector<timed::Word> words_ = {};
    std::unordered_set<std::size_t, Hash, Equal> known_{0, Hash{*this}, Equal{*this}};
};

}  // namespace grafverif
