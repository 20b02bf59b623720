// SPDX-License-Identifier: MIT
// Machine: a network that is compiled for the search. For a packed state, the machine computes the successors as packed
// states.
//
// To test an edge, the machine first compares one masked word of the state with a constant, and then evaluates the
// remaining conjuncts of the guard and the clock constraint. One program applies the effect of an edge to a copy of the
// state: assignments, procedures, the new location, clock resets and clock caps. The program also tests the invariant
// of the target location.
//
// While testing the edges of a state, the machine also determines whether integer time is exact in this state
// (docs/explanation/timed-engine.md, "Exactness"). For this purpose, it determines the bounds that edges cover. An edge
// with a true guard covers a bound `c <= d` of its source location if, at c == d, all values of the other clocks enable
// the edge.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "check/timed/layout.hpp"
#include "check/timed/program.hpp"
#include "grafverif/ir/network.hpp"

namespace grafverif::timed {

/// A model error with its edge and variable.
struct Fault {
    End kind = End::OutOfRange;
    std::uint32_t edge = 0;      ///< index in Machine::edges
    std::uint32_t variable = 0;  ///< index of the variable; only for OutOfRange
};

/// A bound `c <= d` of the invariant of a current location. No edge covers the bound Moves::stuck_bound. The bound
/// Moves::locked_bound is less than one time unit, or no edge ends it (EdgeTiming::frees).
struct UncoveredBound {
    std::uint32_t process = 0;
    std::uint32_t bound = 0;  ///< index of the constraint in the invariant
};

/// The moves of one state. Callers reuse the object to avoid allocation.
struct Moves {
    std::vector<std::uint32_t> edges = {};  ///< the enabled edges, ordered by process and then by edge
    std::vector<Word> words = {};  ///< successors by the moves; each successor has Machine::layout().words words
    std::vector<std::int64_t> registers = {};
    Forks forks = {};
    /// If true, `chosen` is computed, and the values of variables that are not stored are copied to the successors.
    bool record_choices = false;
    /// Only if `record_choices` is true: per move and input choice, the set of valuations that remain possible; 0 if the
    /// move belongs to a process other than the PLC of the choice.
    std::vector<Word> chosen = {};
    bool cut = false;     ///< true if an edge reads more than Machine::most_choices combinations of chosen inputs
    bool urgent = false;  ///< true if some urgent edge is enabled, so that time cannot pass
    std::optional<Fault> fault = {};
    /// A bound at which, in dense time, a run may end at a time that is not an integer.
    std::optional<UncoveredBound> stuck_bound = {};
    /// A bound at which, in dense time, a timelock may occur at a time that is not an integer.
    std::optional<UncoveredBound> locked_bound = {};
};

/// A network compiled to code. Several threads may use the machine at the same time, as long as no thread compiles
/// code.
class Machine {
public:
    static constexpr std::size_t most_choices = std::size_t{1} << 14U;

    /// Compiles `network`, which must be expanded and outlive the machine. If an edge of a PLC reads inputs of
    /// `choices`, this edge represents one edge for each combination of the values of these inputs. Requires that the
    /// number of valuations in `choices` is at most Choices::most_splits. States do not contain the variables for which
    /// `unread` is true.
    explicit Machine(const Network& network, std::vector<InputChoice> choices = {}, const VariableSet& unread = {});

    const Network& network() const { return network_; }
    const Layout& layout() const { return layout_; }
    const std::vector<ProcessClocks>& clocks() const { return clocks_; }
    Program& program() { return program_; }
    Compiler& compiler() { return compiler_; }

    /// Computes the moves by every edge that is enabled in `words` (layout().words words).
    void expand(const Word* words, Moves& moves) const;
    /// Returns false if no edge of the process is enabled in `words`. May return true although the invariant of the
    /// target location forbids each enabled edge, or although a guard is undefined.
    bool may_move(std::uint32_t process, const Word* words, std::vector<std::int64_t>& registers) const;
    /// Lets one unit of time pass in the state `words`; urgent edges are ignored. Returns false if an invariant forbids
    /// the delay.
    bool delay(Word* words) const;
    /// True if two stored actions have assigned different values to a variable: a model error, with which a run ends.
    bool has_race(const Word* words) const {
        return network().race.valid() && layout().variables[network().race.index].get(words) != 0;
    }
    /// Evaluates the compiled predicate that begins at instruction `predicate`. Returns NoValue if its value is
    /// undefined.
    End holds(std::uint32_t predicate, const Word* words, std::vector<std::int64_t>& registers) const;

    Id<Network::Process> process_of(std::uint32_t edge) const { return {edges_[edge].process}; }
    Id<Network::Edge> edge_of(std::uint32_t edge) const { return {edges_[edge].index}; }
    bool urgent(std::uint32_t edge) const { return edges_[edge].urgent; }
    const std::vector<InputChoice>& choices() const { return choices_; }
    /// True if some clock is compared with a constant.
    bool timed() const { return timed_; }

private:
    struct Edge {
        Word mask = 0, value = 0;            // first test: word number `word`, masked with `mask`, is equal to `value`
        std::uint32_t guard = Program::yes;  // code of the remaining conjuncts of the guard
        std::uint32_t clocks = Program::yes;
        std::uint32_t effect = Program::yes;
        std::uint32_t process = 0, index = 0;
        Word covers = 0, frees = 0;  // masks of bounds of the invariant of the source location (see EdgeTiming)
        std::uint16_t word = 0;
        std::uint32_t first_set = 0, last_set = 0;  // range in sets_: the sets of the PLC to which the edge belongs
        bool urgent = false;
        bool always = false;  // true if the edge does not depend on clocks; the edge then covers all bounds of all
                              // processes
    };
    struct Set {  // a set of possible valuations of an input choice, which an edge uses
        std::uint32_t choice = 0;
        Word all = 0;
        bool widened = false;  // true if all valuations are possible again after the edge
    };
    struct Tick {
        Word mask = 0;
        Word greatest = 0;  // time can pass only while the clock is less than this value
        Word cap = 0;
        std::uint16_t word = 0;
        std::uint8_t shift = 0;
    };
    struct Row {                                      // the compiled data of one location of one process
        std::uint32_t first = 0, last = 0;            // range in edges_
        std::uint32_t first_tick = 0, last_tick = 0;  // range in ticks_
        Word bounds = 0, late = 0;                    // mask of all bounds of the invariant; mask of the bounds of at
                                                      // least one time unit
    };
    struct Place {
        Word mask = 0;
        std::uint32_t row = 0;
        std::uint16_t word = 0;
        std::uint8_t shift = 0;
    };

    void compile(Id<Network::Process> process);
    void compile_ticks(Id<Network::Process> process, Id<Network::Location> location, Row& row);
    Edge compile_edge(Id<Network::Process> process, Id<Network::Edge> edge);
    std::uint32_t compile_effect(Id<Network::Process> process, const Network::Edge& edge);
    void compile_guard(Id<Expr> guard, Edge& compiled);
    void add_sets(Id<Network::Process> process, Id<Network::Edge> edge, Edge& compiled);
    void fire(std::uint32_t edge, const Word* words, Moves& moves) const;
    void fire_each_path(std::uint32_t edge, const Word* words, Moves& moves) const;
    Word* next_successor(Moves& moves) const;
    void copy_stored(const Word* words, Word* next, const Moves& moves) const;
    bool add_move(std::uint32_t edge, const ExecutionResult& ran, Moves& moves) const;

    const Network& network_;
    const std::vector<InputChoice> choices_;
    std::vector<ProcessClocks> clocks_;
    Layout layout_;
    Program program_ = {};
    Compiler compiler_;
    std::vector<Edge> edges_ = {};
    std::vector<Set> sets_ = {};
    std::vector<Tick> ticks_ = {};
    std::vector<Row> rows_ = {};
    std::vector<Place> places_ = {};
    std::vector<Field> until_delay_ = {};  // fields of the sets of valuations that a delay resets: all valuations are
                                           // possible after a delay
    struct Rest {  // describes the states in which a PLC waits and is stable; in these states, all valuations of a
                   // choice become possible again
        Field stable = {}, location = {};
        Word waiting = 0;
        bool is_reached(const Word* words) const { return stable.raw(words) != 0 && location.raw(words) == waiting; }
    };
    std::vector<std::optional<Rest>> rests_ = {};  // one entry per input choice
    bool timed_ = false;
};

}  // namespace grafverif::timed
