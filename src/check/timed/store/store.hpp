// SPDX-License-Identifier: MIT
// Store: contains the states of a search, numbered in the order of discovery. A tree of pairs represents each state.
//
// The 32-bit halves of a state are the leaves of a binary tree. Each inner node of the tree has a table with all pairs
// of numbers that its two children have in some state. For a given state, the number of the node is the number of its
// pair in this table. The pairs in the table of the root represent the states (Laarman, van de Pol, Weber: Parallel
// recursive state space compression for free, 2011). Fields of the same subsystem are leaves of the same subtree (see
// Layout::seams), so that nearly all tables except the table of the root stay small. The compression is exact:
// different states have different root pairs.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "check/timed/layout.hpp"
#include "check/timed/store/pairs.hpp"

namespace grafverif::timed {

/// A state, and the numbers of the nodes of its tree: first the leaves, then the inner nodes except the root. Children
/// precede their parents.
struct Unfolded {
    std::vector<Word> words = {};  ///< the packed state, with Layout::words words
    std::vector<std::uint32_t> numbers = {};
};

class Store {
public:
    static constexpr std::uint32_t none = Pairs::none;
    static constexpr std::uint32_t most = (1U << 29U) - 2;  ///< maximum number of states (see Graph)

    explicit Store(const Layout& layout);

    /// Adds the pairs of all nodes of the state in `words` and returns its root pair. Stores the numbers of the nodes
    /// in `now`. If a subtree is equal to the same subtree of the state `before`, the number of the subtree is copied.
    Word fold(const Word* words, const Unfolded& before, Unfolded& now);
    /// Returns the root pair of the state in `words` if the store contains all subtrees of the state. Returns nullopt
    /// otherwise; in this case, the store does not contain the state.
    std::optional<Word> root_of(const Word* words, const Unfolded& before, Unfolded& now) const;
    /// Returns the table of the root pairs of all states. A state that was added by Pairs::append is found only after a
    /// call of Pairs::index.
    const Pairs& roots() const { return root_; }
    Pairs& roots() { return root_; }
    /// Returns the number of the state in `words`, or `none` if the store does not contain the state.
    std::uint32_t find(const Word* words, Unfolded& now) const {
        const std::optional<Word> root = root_of(words, {}, now);
        return root ? root_.find(*root) : none;
    }
    /// Stores state number `state` and the numbers of its nodes in `unfolded`. Reuses subtrees of the previous content
    /// of `unfolded` that have the same numbers.
    void load(std::uint32_t state, Unfolded& unfolded) const;

    std::size_t size() const { return root_.size(); }
    /// Returns the size of one packed state in bytes.
    std::size_t state_bytes() const { return halves_ * 4; }
    std::size_t bytes() const;
    std::size_t index_bytes() const { return root_.index_bytes(); }
    /// Frees the index; after this call, `find` does not find any state.
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
    std::vector<Node> nodes_ = {};    // inner nodes: children before parents, the root last
    std::vector<Pairs> tables_ = {};  // tables of the nodes except the root
    Pairs root_;
};

}  // namespace grafverif::timed
