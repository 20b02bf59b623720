// SPDX-License-Identifier: MIT
// Moves: one evolution of the chart from a state, for all inputs at once.
//
// A state is what the chart remembers between two evolutions: step activities, stored variables, previous values, the
// levels that timers watch, and of each timer what happened to its level within the same instant: it became true
// (`fresh`), its fall time may have started (`falling`). The moves of a state are disjoint sets of inputs that together
// are all that is assumed, each with the state that follows.
//
// Ends of timers are inputs. In the sets of a state those do not occur whose value is known: `3s/v` is false where v is,
// or has just become true; `v/2s` is true where v is, or has just become false.
#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "conform/input_space.hpp"
#include "conform/location_terms.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif::conform {

// Packed states, each stored once and numbered in the order of discovery.

using StateId = std::uint32_t;
inline constexpr StateId no_state = std::numeric_limits<StateId>::max();

class StateStore {
public:
    /// The number of 64-bit words of a state. Called once, before the first state.
    void shape(std::size_t words) { words_ = words; }

    std::size_t words() const { return words_; }
    std::size_t size() const { return words_ == 0 ? 0 : packed_.size() / words_; }
    std::span<const std::uint64_t> at(StateId state) const { return {packed_.data() + std::size_t{state} * words_, words_}; }

    /// The number of the state, new or known.
    StateId intern(std::span<const std::uint64_t> state);

private:
    bool is(StateId state, std::span<const std::uint64_t> words) const;
    void grow();

    std::size_t words_ = 0;
    std::vector<std::uint64_t> packed_ = {};
    std::vector<StateId> slots_ = std::vector<StateId>(64, no_state);   ///< open addressing
};

struct StateMove {
    Bdd set = {};
    StateId next = 0;
    bool stable = false;   ///< nothing changes under these inputs but levels that timers watch, and they no more then
};

/// Where a variable of the equations stands in a packed state.
struct StateField {
    Id<Equations::Variable> variable = {};
    Type type = {};
    std::uint32_t word = 0, shift = 0;
    std::uint64_t mask = 0;           ///< before the shift
    Id<Expr> next = {}, first = {};   ///< as in Kept
};

class Moves {
public:
    /// `inputs`: per variable of the equations the input it is. All arguments outlive this.
    Moves(const Equations& equations, const std::vector<std::optional<std::size_t>>& inputs, const InputSpace& space,
          Diagnostics& diagnostics);

    /// The evolution that activates the initial steps; empty after an error.
    std::vector<StateMove> first();
    /// The evolutions of `state`, stable ones first. Empty after an error.
    const std::vector<StateMove>& of(StateId state);

    const StateStore& states() const { return store_; }
    bool failed() const { return failed_; }

    /// The state with no timer fresh; whether `state` is such a one.
    StateId settled(StateId state);
    /// Timers of the equations, by index, that are fresh, or falling, in `state`.
    std::vector<std::size_t> fresh(StateId state) const { return marked(state, fresh_bits_); }
    std::vector<std::size_t> falling(StateId state) const { return marked(state, falling_bits_); }

    /// The values of all variables in `state`, per variable of the equations; others are 0.
    const std::vector<std::int64_t>& load(StateId state);
    LocationTerms& terms() { return terms_; }

private:
    struct Cell {
        Bdd set = {};
        std::vector<std::uint32_t> fired = {};
    };
    using Changes = std::vector<std::pair<std::uint32_t, std::int64_t>>;   ///< field, value
    /// A part of a cell, with the values found so far.
    struct Part {
        Bdd set = {};
        Changes changes = {};
    };

    void add_field(const Kept& kept);
    void index_firings();
    void index_fields();
    Id<Expr> while_quiet(Id<Expr> term, Exprs& scratch) const;
    bool keeps_by_itself(const StateField& field);
    std::vector<Cell> cells(const Bdd& within);
    void fire(std::vector<Cell>& cells, Bdd& touched, std::uint32_t firing, const Bdd& within);
    std::vector<StateMove> moves_of(StateId state);
    void add_moves(StateId state, const Cell& cell, std::vector<StateMove>& moves);
    void split_by(std::vector<Part>& parts, std::uint32_t field, Id<Expr> term);
    std::vector<Part> split(const Part& part, const BddTerm& value);
    void add_pieces(StateId state, Part part, bool stable, std::vector<StateMove>& moves);
    std::vector<Part> watched(Part part);
    Changes exchange_values(const Changes& changes);
    StateId changed(StateId state, const Part& part, bool power_on = false);
    void mark_timers(std::vector<std::uint64_t>& words, bool power_on) const;
    std::vector<std::size_t> marked(StateId state, const std::vector<std::uint32_t>& bits) const;
    bool check_races(const Cell& cell);
    void check_race(Id<Expr> race, const Equations::Variable& variable, const Bdd& within);
    void complain(Diagnostic diagnostic);
    std::string circumstances(const Bdd& set) const;
    Bdd known_ends(StateId state);
    static void suppose(const Bdd& idle, std::vector<StateMove>& moves);

    const Equations& equations_;
    const std::vector<std::optional<std::size_t>>& inputs_;
    const InputSpace& space_;
    Diagnostics& diagnostics_;
    LocationTerms terms_;
    StateStore store_;
    std::vector<StateField> fields_ = {};
    std::size_t evolving_ = 0;                                   ///< fields before those of watched levels
    std::vector<std::uint32_t> fresh_bits_ = {}, falling_bits_ = {};   ///< per timer: its bits in the packed state
    std::vector<std::uint32_t> level_fields_ = {};               ///< per timer: the field of what it watches
    std::vector<std::vector<std::uint32_t>> guarded_ = {};       ///< per field: firings that need the step to be active
    std::vector<std::uint32_t> unguarded_ = {};                  ///< the other firings
    std::vector<std::vector<std::uint32_t>> affected_ = {};      ///< per firing: fields to compute where it fires
    std::vector<std::uint32_t> restless_ = {};                   ///< fields to compute in every evolution
    std::vector<std::vector<std::uint32_t>> races_ = {};         ///< per firing: stored variables that may race then
    std::vector<std::uint32_t> restless_races_ = {};             ///< stored variables that may race where nothing fires
    bool fires_unstable_ = false;                                ///< whether a firing alone decides that nothing is stable
    StateId loaded_ = no_state;
    std::vector<std::uint64_t> scratch_ = {};
    std::deque<std::optional<std::vector<StateMove>>> known_ = {};   ///< per state
    bool failed_ = false;
};

}  // namespace grafverif::conform
