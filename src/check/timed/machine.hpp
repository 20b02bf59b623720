// SPDX-License-Identifier: MIT
// Machine: a network compiled for the search. For a packed state, the machine computes the successors as packed states.
//
// To test an edge, the machine first compares one masked word of the state with a constant, and then evaluates the
// remaining conjuncts of the guard and the clock constraint. One program applies the effect of an edge to a copy of the
// state: assignments, procedures, the new location, clock resets and clock caps. The program also tests the invariant
// of the target location.
//
// While testing the edges of a state, the machine also determines if integer time is exact in this state
// (docs/explanation/timed-engine.md, "Exactness"). An edge covers a bound `c <= d` of its source location if its guard
// holds and, at c == d, it is enabled for all values of the other clocks (see UncoveredBound).
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
    std::uint32_t variable = 0;  ///< variable, only for OutOfRange
};

/// A bound of the invariant of a current location. Moves::stuck_bound is a bound that no edge covers.
/// Moves::locked_bound is a bound that no edge releases (EdgeTiming::frees), or that is less than one time unit.
struct UncoveredBound {
    std::uint32_t process = 0;
    std::uint32_t bound = 0;  ///< index in the invariant of its location
};

/// The moves of one state. Callers reuse the object to avoid allocation.
struct Moves {
    std::vector<std::uint32_t> edges = {};  ///< the enabled edges, in the order of processes and edges
    std::vector<Word> words = {};  ///< successors by the moves; each successor has Machine::layout().words words
    std::vector<std::int64_t> registers = {};
    Forks forks = {};
    /// True: `chosen` is computed, and the values of variables that are not stored are copied to the successors.
    bool record_choices = false;
    /// If `record_choices`: per move and input choice, the valuations that remain possible.
    std::vector<Word> chosen = {};
    bool cut = false;     ///< true if an edge reads more than Machine::most_choices combinations of chosen inputs
    bool urgent = false;  ///< true if some urgent edge is enabled, so that time cannot pass
    std::optional<Fault> fault = {};
    /// A bound at which, in dense time, a run may end at a time that is not an integer.
    std::optional<UncoveredBound> stuck_bound = {};
    /// A bound at which, in dense time, a timelock may occur at a time that is not an integer.
    std::optional<UncoveredBound> locked_bound = {};
};

/// A network as code. Several threads may use the machine at the same time, while none of them compiles code.
class Machine {
public:
    static constexpr std::size_t most_choices = std::size_t{1} << 14U;

    /// Compiles `network`, which must be expanded and outlive the machine. An edge of a PLC that reads inputs of
    /// `choices` represents one edge per combination of the values of these inputs. Requires at most
    /// Choices::most_splits valuations in total. States do not contain the variables of `unread`.
    explicit Machine(const Network& network, std::vector<InputChoice> choices = {}, const VariableSet& unread = {});

    const Network& network() const { return network_; }
    const Layout& layout() const { return layout_; }
    const std::vector<ProcessClocks>& clocks() const { return clocks_; }
    Program& program() { return program_; }
    Compiler& compiler() { return compiler_; }

    /// Computes the moves by every edge that is enabled in `words` (layout().words words).
    void expand(const Word* words, Moves& moves) const;
    /// Lets one unit of time pass in the state `words`; urgent edges are ignored. Returns false if an invariant forbids
    /// the delay.
    bool delay(Word* words) const;
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
        Word mask = 0, value = 0;            // first test: the masked word has this value
        std::uint32_t guard = Program::yes;  // code of the remaining conjuncts of the guard
        std::uint32_t clocks = Program::yes;
        std::uint32_t effect = Program::yes;
        std::uint32_t process = 0, index = 0;
        Word covers = 0, frees = 0;  // masks of bounds of the source's invariant: see UncoveredBound
        std::uint16_t word = 0;
        std::uint32_t first_set = 0, last_set = 0;  // range in sets_: the choices of its PLC
        bool urgent = false;
        bool always = false;  // true if the edge does not depend on clocks: it covers all bounds of all processes
    };
    struct Set {  // a set of valuations of a choice, in an edge
        std::uint32_t choice = 0;
        Word all = 0;
        bool widened = false;  // true if the edge makes all valuations possible again
    };
    struct Tick {
        Word mask = 0;
        Word greatest = 0;  // time can pass while the clock has a smaller value
        Word cap = 0;
        std::uint16_t word = 0;
        std::uint8_t shift = 0;
    };
    struct Row {                                      // one location of one process
        std::uint32_t first = 0, last = 0;            // range in edges_
        std::uint32_t first_tick = 0, last_tick = 0;  // range in ticks_
        Word bounds = 0, late = 0;                    // masks: its bounds; its bounds of at least one time unit
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
    std::vector<Field> until_delay_ = {};  // sets of valuations of choices; after a delay, all are possible
    struct Rest {  // states in which a PLC waits and is stable: all valuations of the choice become possible again
        Field stable = {}, location = {};
        Word waiting = 0;
        bool is_reached(const Word* words) const { return stable.raw(words) != 0 && location.raw(words) == waiting; }
    };
    std::vector<std::optional<Rest>> rests_ = {};  // per choice
    bool timed_ = false;
};

}  // namespace grafverif::timed
