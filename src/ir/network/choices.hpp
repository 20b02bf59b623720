// SPDX-License-Identifier: MIT
// Choices: the values that are free within an edge of a local network, one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

class Choices {
public:
    /// Between terms of `whole` and terms over choices in `to`.
    Choices(const Network& whole, Exprs& to) : whole_(whole), to_(to) {}

    void clear() { choices_.clear(); }
    /// The choice of what some terms of the whole are, with `op` between them; `writes`: the last write of the edge to
    /// what they read, before which they may be something else. A leaf Parameter.
    Id<Expr> leaf(std::vector<Id<Expr>> terms, Op op, std::size_t writes);
    /// Whether there are few enough values of all choices to go through.
    bool few() const;

    /// The first values of all choices, and the next; false: these were the last.
    void begin();
    bool next();
    /// A term over choices, with the values at hand.
    Id<Expr> chosen(Id<Expr> term) const;
    using Values = std::map<Id<Network::Variable>, std::int64_t>;
    /// Whether some choice reads nothing but these, as the edge leaves them.
    bool tell_of(const std::vector<Id<Network::Variable>>& variables) const;
    /// All values that some variables may have in the state that the edge leaves, with the values at hand; nothing where
    /// these say nothing of them, or there are too many.
    std::optional<std::vector<Values>> possible_before(const std::vector<Id<Network::Variable>>& variables) const;
    /// Whether the values at hand are those of the initial state.
    bool as_at_first() const;

private:
    struct Choice {
        std::vector<Id<Expr>> terms = {};
        Op op = Op::And;
        std::size_t writes = 0;
        std::vector<Id<Network::Variable>> reads = {};
        std::int64_t low = 0, high = 1;
        bool boolean = true;

        bool is(const Choice& other) const { return terms == other.terms && op == other.op && writes == other.writes; }
    };
    Id<Expr> value(std::size_t choice) const;
    std::optional<std::int64_t> value_of(const Choice& choice, const Values& values) const;
    const Network::Variable& variable(const Expr& leaf) const {
        return whole_.variables[{static_cast<std::uint32_t>(leaf.value)}];
    }

    const Network& whole_;
    Exprs& to_;
    std::vector<Choice> choices_ = {};
    std::vector<std::int64_t> values_ = {};  // one per choice
};

}  // namespace grafverif
