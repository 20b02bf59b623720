// SPDX-License-Identifier: MIT
// State store: contains the states, numbered in the order of discovery, each as a tree of pairs.
//
// The 32-bit halves of a state are the leaves of a binary tree. An inner node has a table of all pairs of numbers that
// its children have had; the number of the node is the number of the pair in this table. The pairs in the table of the
// root represent the states (Laarman, van de Pol, Weber: Parallel recursive state space compression for free, 2011).
// Adjacent parts of a state are under one node (see Layout), so that nearly all tables except that of the root stay
// small. The compression is exact: different states have different root pairs.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "check/timed/layout.hpp"
#include "check/timed/store/pairs.hpp"

namespace grafverif::timed {

/// A state with the numbers of its tree: first the leaves, then the inner nodes except the root, children first.
struct Unfolded {
    std::vector<Word> words = {};  ///< the layout.words words that represent the state
    std::vector<std::uint32_t> numbers = {};
};

class Store {
public:
    static constexpr std::uint32_t none = Pairs::none;
    static constexpr std::uint32_t most = (1U << 29U) - 2;  ///< maximum number of states (see Graph)

    explicit Store(const Layout& layout);

    /// Adds the pairs of all nodes of the state in `words` and returns its root pair. Stores the numbers of the nodes
    /// in `now`. The numbers of subtrees that are equal to those of the unfolded state `before` are copied.
    Word fold(const Word* words, const Unfolded& before, Unfolded& now);
    /// Returns the root pair if all subtrees are known; otherwise the state is not in the store, and the result is
    /// empty.
    std::optional<Word> root_of(const Word* words, const Unfolded& before, Unfolded& now) const;
    /// Returns the table of the root pairs of all states. An appended state is found only after it is indexed (see
    /// Pairs).
    const Pairs& roots() const { return root_; }
    Pairs& roots() { return root_; }
    /// Returns the number of the state in `words`, or none.
    std::uint32_t find(const Word* words, Unfolded& now) const {
        const std::optional<Word> root = root_of(words, {}, now);
        return root ? root_.find(*root) : none;
    }
    /// Unfolds `state` into `unfolded`. Subtrees of `unfolded` that have the same numbers are reused.
    void load(std::uint32_t state, Unfolded& unfolded) const;

    std::size_t size() const { return root_.size(); }
    /// Returns the size of one packed state in bytes.
    std::size_t state_bytes() const { return halves_ * 4; }
    std::size_t bytes() const;
    std::size_t index_bytes() const { return root_.index_bytes(); }
    /// Frees the index; afterwards `find` does not find any state.
    void drop_index() { root_.drop_index(); }

private:
    struct Node {
        std::uint32_t low = 0, high = 0;  // children of the node, as indices of Unfolded::numbers
    };
    std::uint32_t grow(const std::vector<std::size_t>& seams, std::uint32_t first, std::uint32_t end);
    void unfold(std::size_t node, Word pair, std::uint32_t* numbers) const;
    void take(const Word* words, Unfolded& now) const;
    template <class Number>
    std::optional<Word> numbered(const Word* words, const Unfolded& before, Unfolded& now, Number number) const;

    std::uint32_t words_, stored_, halves_;
    std::vector<Node> nodes_ = {};    // children first, the root last
    std::vector<Pairs> tables_ = {};  // tables of the nodes except the root
    Pairs root_;
};

}  // namespace grafverif::timed
