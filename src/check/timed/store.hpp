// SPDX-License-Identifier: MIT
// State store: contains the states, numbered in the order of discovery, each as a tree of pairs.
//
// The 32-bit halves of a state are the leaves of a binary tree. An inner node has a table of the pairs of numbers of
// its children that have occurred; its number is the number of the pair. The pairs of the root are the states (Laarman,
// van de Pol, Weber: Parallel recursive state space compression for free, 2011). Adjacent parts of a state are under
// one node (see Layout), so that nearly all tables except that of the root stay small. The compression is exact: two
// different states have different pairs at the root.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "check/timed/layout.hpp"
#include "check/timed/pairs.hpp"

namespace grafverif::timed {

/// A state with the numbers of its tree: first the leaves, then the inner nodes except the root, children first.
struct Unfolded {
    std::vector<Word> words = {};  ///< layout.words words of the state
    std::vector<std::uint32_t> numbers = {};
};

class Store {
public:
    static constexpr std::uint32_t none = Pairs::none;
    static constexpr std::uint32_t most = (1U << 29U) - 2;  ///< maximum number of states (see Graph)

    explicit Store(const Layout& layout);

    /// Returns the root pair of the state in `words`, after interning the pairs of its nodes. Fills `now` with its
    /// numbers. Subtrees equal to those of `before`, an unfolded state, are not looked up.
    Word fold(const Word* words, const Unfolded& before, Unfolded& now);
    /// Returns the root pair if all subtrees are known. Otherwise the result is empty, and the state is not stored.
    std::optional<Word> root_of(const Word* words, const Unfolded& before, Unfolded& now) const;
    /// Returns the states by their root pairs. An appended state can be found after it is indexed (see Pairs).
    const Pairs& roots() const { return root_; }
    Pairs& roots() { return root_; }
    /// Returns the number of the state in `words`, or none.
    std::uint32_t find(const Word* words, Unfolded& now) const {
        const std::optional<Word> root = root_of(words, {}, now);
        return root ? root_.find(*root) : none;
    }
    /// Unfolds `state` into `unfolded`. Subtrees of `unfolded` with the same numbers are not copied again.
    void load(std::uint32_t state, Unfolded& unfolded) const;

    std::size_t size() const { return root_.size(); }
    /// Returns the size of one packed state in bytes.
    std::size_t state_bytes() const { return halves_ * 4; }
    std::size_t bytes() const;
    std::size_t index_bytes() const { return root_.index_bytes(); }
    /// Frees the index; afterwards no state can be looked up.
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
