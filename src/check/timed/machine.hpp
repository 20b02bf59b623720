// SPDX-License-Identifier: MIT
// Machine: a network compiled for the search: computes the moves of a packed state as packed states.
//
// An edge is tested by one comparison of a word, then by the rest of its guard and clock constraint. Its effect is one
// program on a copy of the state: assignments, procedures, the new location, resets, caps, the target's invariant.
//
// While testing the edges of a state, the machine also determines if integer time is exact there (design: "time can
// hide a lock between the ticks"). For each bound `c <= d` in force, an edge covers it if its data guard holds and it
// is enabled at c == d for all values of the other clocks; see `Exactness`.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "check/timed/layout.hpp"
#include "check/timed/program.hpp"
#include "grafverif/ir/network.hpp"

namespace grafverif::timed {

/// A model error and its place.
struct Fault {
    End kind = End::OutOfRange;
    std::uint32_t edge = 0;      ///< in Machine::edges
    std::uint32_t variable = 0;  ///< for OutOfRange
};

/// A bound in force that no edge covers.
struct UncoveredBound {
    std::uint32_t process = 0;
    std::uint32_t bound = 0;  ///< in the invariant of its location
};

/// The moves of one state; reused to avoid allocation.
struct Moves {
    std::vector<std::uint32_t> edges = {};  ///< the enabled edges, in the order of processes and edges
    std::vector<Word> words = {};           ///< their target states, at intervals of Machine::layout.words
    std::vector<std::int64_t> registers = {};
    bool record_choices = false;
    std::vector<Word> chosen = {};  ///< if recorded: per move and choice, the valuations that are possible after it
    bool cut = false;               ///< an edge has more than Machine::most_choices combinations of inputs
    bool urgent = false;            ///< some urgent edge is enabled: time stops
    std::optional<Fault> fault = {};
    std::optional<UncoveredBound> stuck_bound = {};   ///< a run may end here between the ticks
    std::optional<UncoveredBound> locked_bound = {};  ///< a timelock may occur here between the ticks
};

/// A network as code. Threads may share it as long as nothing is compiled.
class Machine {
public:
    static constexpr std::size_t most_choices = std::size_t{1} << 14U;

    /// `network` is expanded, and must outlive the machine. An edge of a PLC that reads chosen inputs represents one
    /// edge per combination of their values. Requires at most Choices::most_splits valuations in total.
    explicit Machine(const Network& network, std::vector<InputChoice> choices = {});

    const Network& network() const { return network_; }
    const Layout& layout() const { return layout_; }
    Program& program() { return program_; }
    Compiler& compiler() { return compiler_; }

    /// Every enabled edge in `words` (layout().words of them).
    void expand(const Word* words, Moves& moves) const;
    /// Lets one unit of time pass if invariants permit it; ignores urgency. False: some invariant forbids it.
    bool delay(Word* words) const;
    /// A term over variables and locations; undefined values are reported as NoValue.
    End holds(std::uint32_t predicate, const Word* words, std::vector<std::int64_t>& registers) const;

    Id<Network::Process> process_of(std::uint32_t edge) const { return {edges_[edge].process}; }
    Id<Network::Edge> edge_of(std::uint32_t edge) const { return {edges_[edge].index}; }
    bool urgent(std::uint32_t edge) const { return edges_[edge].urgent; }
    const std::vector<InputChoice>& choices() const { return choices_; }
    /// True if some clock is compared.
    bool timed() const { return timed_; }

private:
    struct Edge {
        Word mask = 0, value = 0;            // a first test
        std::uint32_t guard = Program::yes;  // the rest of the guard
        std::uint32_t clocks = Program::yes;
        std::uint32_t effect = Program::yes;
        std::uint32_t process = 0, index = 0;
        Word covers = 0, frees = 0;  // bounds of the source's invariant: see UncoveredBound
        std::uint16_t word = 0;
        std::uint32_t first_set = 0, last_set = 0;  // sets_: the choices of its PLC
        bool urgent = false;
        bool always = false;  // the edge is independent of clocks: it covers every bound of every process
    };
    struct Set {  // of valuations, in an edge
        std::uint32_t choice = 0;
        Word all = 0;
        bool widened = false;  // by the edge
    };
    struct Tick {
        Word mask = 0;
        Word greatest = 0;  // time passes below it
        Word cap = 0;
        std::uint16_t word = 0;
        std::uint8_t shift = 0;
    };
    struct Row {                                      // one location of one process
        std::uint32_t first = 0, last = 0;            // edges_
        std::uint32_t first_tick = 0, last_tick = 0;  // ticks_
        Word bounds = 0, late = 0;                    // its bounds, and those of at least one unit
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
    void check_bounds(Id<Network::Process> process, const Network::Edge& edge, Edge& compiled) const;
    void add_sets(Id<Network::Process> process, Id<Network::Edge> edge, Edge& compiled);
    void fire(std::uint32_t edge, const Word* words, Moves& moves) const;
    void fire_each_way(std::uint32_t edge, const Word* words, Moves& moves) const;
    Word* take(std::uint32_t edge, const Word* words, Moves& moves) const;

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
    std::vector<Field> until_delay_ = {};  // the sets of choices that a delay makes complete again
    bool timed_ = false;
};

}  // namespace grafverif::timed
