// SPDX-License-Identifier: MIT
// Moves: computes one evolution of the chart from a state, for all inputs simultaneously. Each move consists of a set
// of input values and the next state. The input sets of the moves of a state are disjoint and together cover the
// assumed inputs.
//
// Timer outputs are treated as inputs. If the state determines the value of a timer output, the input sets do not
// depend on this output: `3s/v` is false if v is false or has just become true; `v/2s` is true if v is true or has just
// become false.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "conform/dependencies.hpp"
#include "conform/input_space.hpp"
#include "conform/location_terms.hpp"
#include "conform/state_store.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif::conform {

struct StateMove {
    Bdd set = {};
    StateId next = 0;
    /// True if, under the inputs of `set`, the move changes nothing except previous values and levels that timers observe.
    bool stable = false;
};

/// Thrown if an evolution has no result, because of a race or of a value that is undefined or out of range.
struct NoResult {
    Diagnostic why;
};

class Moves {
public:
    /// All arguments must outlive this object. The constructor and all member functions can throw NoResult.
    Moves(const Equations& equations, const InputOf& inputs, const InputSpace& space);

    /// Returns the moves of the first evolution, after which the initial steps are active.
    std::vector<StateMove> first();
    /// Returns the moves of `state`; stable moves precede all other moves.
    const std::vector<StateMove>& of(StateId state);

    /// Returns `state` with the flags `fresh` and `falling` of all timers cleared.
    StateId settled(StateId state);
    /// `fresh` and `falling` return the indices of the timers of the equations that have this mark in `state`.
    std::vector<std::size_t> fresh(StateId state) const { return marked(state, &StateLayout::Timer::fresh); }
    std::vector<std::size_t> falling(StateId state) const { return marked(state, &StateLayout::Timer::falling); }

    /// Returns the values of all variables in `state`. Variables that the state does not contain have their initial
    /// values.
    Values values(StateId state) const;
    LocationCondition condition(Id<Expr> term, const Values& at) { return terms_.condition(term, at); }

private:
    struct Cell {
        Bdd set = {};
        std::vector<std::uint32_t> fired = {};
    };
    class Partition;
    /// Pairs of field and value.
    using Changes = std::vector<std::pair<std::uint32_t, std::int64_t>>;
    /// A subset of the inputs of a class, together with the changes that the evolution makes for these inputs.
    struct Region {
        Bdd set = {};
        Changes changes = {};
    };

    std::vector<StateMove> moves_of(StateId state);
    std::vector<Cell> cells(const Values& at, const Bdd& within);
    void add_moves(const Cell& cell, StateId state, const Values& at, std::vector<StateMove>& moves);
    std::vector<Region> evolved(const Cell& cell, const Values& at);
    std::vector<Region> given(std::vector<Region> parts, std::uint32_t field, Id<Expr> term, const Values& at);
    std::vector<Region> with_levels(Region part, const Values& at);
    StateId changed(StateId state, const Changes& changes, const Values& before);
    Bdd known_ends(StateId state, const Values& at) const;
    std::vector<std::size_t> marked(StateId state, std::uint32_t StateLayout::Timer::*bit) const;

    void check_races(const Cell& cell, const Values& at);
    void check_race(Id<Expr> race, const Equations::Variable& variable, const Bdd& within, const Values& at);
    void demand_value(const Bdd& undefined, const Bdd& within, Span where, const Values& at) const;
    std::string circumstances(const Values& at, const Bdd& set) const;

    const Equations& equations_;
    const InputOf& inputs_;
    const InputSpace& space_;
    Values initial_ = {};
    LocationTerms terms_;
    StateLayout layout_;
    Dependencies dependencies_;
    StateStore store_;
    std::deque<std::optional<std::vector<StateMove>>> known_ = {};  ///< moves of each state
};

}  // namespace grafverif::conform
