// SPDX-License-Identifier: MIT
// Choices: enumerates the values of the free variables that an edge of a localized network reads
// (ir/network_fragments.hpp).
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
    /// `whole` is the complete network; the table `to` stores the terms of the localized network.
    Choices(const Network& whole, Exprs& to) : whole_(whole), to_(to) {}

    void clear() { choices_.clear(); }
    /// Returns a Parameter leaf that represents a choice: the value of `terms`, connected by `op`. The writes of the
    /// edge to omitted variables are numbered from 1. `writes` is the number of the last write that changes a variable
    /// read by `terms`, or 0 if no write changes such a variable. Calls with the same arguments return the same choice.
    /// A choice of the same terms with another value of `writes` is a different choice, so the two choices may have
    /// different values.
    Id<Expr> leaf(std::vector<Id<Expr>> terms, Op op, std::size_t writes);
    /// True if the number of value combinations of all choices is small enough to enumerate.
    bool few() const;

    /// `begin` selects the first combination of values of all choices. `next` selects the next combination, or returns
    /// false if there is none.
    void begin();
    bool next();
    /// Returns `term` with each choice replaced by its current value.
    Id<Expr> chosen(Id<Expr> term) const;
    using Values = std::map<Id<Network::Variable>, std::int64_t>;
    /// True if some choice reads only `variables` and represents their values before the edge changes them.
    bool report_of(const std::vector<Id<Network::Variable>>& variables) const;
    /// Returns all values that `variables` can have before the edge, given the current values of the choices. The
    /// result is nullopt if the choices do not constrain the variables or there are too many values.
    std::optional<std::vector<Values>> possible_before(const std::vector<Id<Network::Variable>>& variables) const;
    /// True if the current value of each choice is the value of its terms in the initial state.
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
    std::vector<std::int64_t> values_ = {};  // current value of each choice
};

}  // namespace grafverif
