// SPDX-License-Identifier: MIT
// State store: the states found, numbered in the order of discovery, each as a tree of pairs.
//
// The 32-bit halves of a state are the leaves of a binary tree. An inner node has a table of the pairs of its
// children's numbers that occurred, and its own number is that of the pair; the pairs of the root are the states
// (Laarman, van de Pol, Weber: Parallel recursive state space compression for free, 2011). Adjacent parts of a state
// are under one node (see Layout), so that nearly all tables except the root's stay small. The compression is exact:
// two different states have different pairs at the root.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "check/timed/layout.hpp"
#include "check/timed/pairs.hpp"

namespace grafverif::timed {

/// A state with the numbers in its tree: the leaves, then the inner nodes except the root, children first.
struct Unfolded {
    std::vector<Word> words = {};  ///< layout.words words
    std::vector<std::uint32_t> numbers = {};
};

class Store {
public:
    static constexpr std::uint32_t none = Pairs::none;
    static constexpr std::uint32_t most = (1U << 29U) - 2;  ///< maximum number of states (see Graph)

    explicit Store(const Layout& layout);

    /// The root's pair for the state in `words`, after interning those of its nodes. Fills `now` with its numbers;
    /// subtrees equal to those of `before`, an unfolded state, are not looked up.
    Word fold(const Word* words, const Unfolded& before, Unfolded& now);
    /// The root's pair if all subtrees are known; otherwise nothing, and the state is not stored.
    std::optional<Word> root_of(const Word* words, const Unfolded& before, Unfolded& now) const;
    /// The states by their roots' pairs; an appended state is found after it is indexed (see Pairs).
    const Pairs& roots() const { return root_; }
    Pairs& roots() { return root_; }
    /// The number of the state in `words`, or none.
    std::uint32_t find(const Word* words, Unfolded& now) const {
        const std::optional<Word> root = root_of(words, {}, now);
        return root ? root_.find(*root) : none;
    }
    /// Keeps subtrees of `unfolded` that have the same numbers.
    void load(std::uint32_t state, Unfolded& unfolded) const;

    std::size_t size() const { return root_.size(); }
    /// Size of one packed state.
    std::size_t state_bytes() const { return halves_ * 4; }
    std::size_t bytes() const;
    std::size_t index_bytes() const { return root_.index_bytes(); }
    /// Frees the index: from here on no state can be looked up.
    void drop_index() { root_.drop_index(); }

private:
    struct Node {
        std::uint32_t low = 0, high = 0;  // its children, as indices of Unfolded::numbers
    };
    std::uint32_t grow(const std::vector<std::size_t>& seams, std::uint32_t first, std::uint32_t end);
    void unfold(std::size_t node, Word pair, std::uint32_t* numbers) const;
    void take(const Word* words, Unfolded& now) const;
    template <class Number>
    std::optional<Word> numbered(const Word* words, const Unfolded& before, Unfolded& now, Number number) const;

    std::uint32_t words_, stored_, halves_;
    std::vector<Node> nodes_ = {};    // children first, the root last
    std::vector<Pairs> tables_ = {};  // of nodes_, except the root
    Pairs root_;
};

}  // namespace grafverif::timed
