// SPDX-License-Identifier: MIT
// Macro-steps: sequences of moves through transient states of PLC cycles. The search treats a macro-step as one move
// and does not store its transient states.
//
// A state is *transient* if it satisfies one of the conditions below. A macro-step that leads to a transient state
// continues only with the edges that the condition names.
//   - Only observers can move. The observers read the state that the last move has reached (compose/observe.hpp).
//   - A PLC is within a cycle, and only its urgent edges are enabled. Time cannot pass, and no other process can move.
//     Two types of edges of the timers of the PLC may also be enabled: urgent edges, if the edges of the PLC in this
//     location neither read nor write the variables of the timers; and edges that are not urgent, if the timer is in
//     InputAbstraction::deferred.
//   - A PLC is within a cycle, and all other enabled edges belong to processes whose moves can be postponed until after
//     the enabled edges of the PLC (see Independence). Only the PLC moves. For example, the PLC writes its outputs, and
//     no output changes its value. Properties about quiescent states are false within a cycle. Requests to observers
//     are ignored, because reading equal states repeatedly does not change an observer.
//   - A PLC has begun a cycle, but has not sampled its inputs yet, and this PLC may begin a cycle whenever it waits
//     (MacroStepOptions::unprompted). Only the PLC moves, because the other processes can also move before the cycle
//     begins. Both orders of these moves lead to the same states, except that a flag that requests a cycle may also be
//     true. The flag has no effect, because the PLC may begin this cycle without the flag.
//   - No PLC is within a cycle, and a timer can accept a request of its PLC. Only this timer moves. Before the request
//     is accepted, the PLC cannot leave its waiting location W. The edges of all other processes are independent of the
//     request and remain enabled.
// The conditions that name timers change the order of edges of timers. These conditions require that only the PLC and
// its timers use the variables that the timers write, and that no property reads these variables. The order is also
// irrelevant for observers, because consecutive readings of equal states change the location of an observer at most
// once.
//
// A PLC is *within a cycle* in each location from which every infinite path of its automaton passes through the waiting
// location W. Therefore macro-steps are finite. The search with macro-steps preserves
//   - the values of locations and variables in reachable states that are not transient, except for the changed order of
//     edges,
//   - properties about single states: a transient state is stored if it decides a search of the property monitor, and
//     neither the first state of the macro-step nor a successor decides the same search,
//   - model errors: a transient state with a model error or a race is stored.
// Runs have the minimum number of macro-steps instead of the minimum number of moves.
//
// Dead outputs: only properties about quiescent states read some outputs, and the PLC writes these outputs before it is
// stable again. Within a cycle, and in W while the PLC is not stable, the search replaces the values of these outputs
// by their initial values, so that equivalent states become equal.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "check/timed/machine.hpp"
#include "check/timed/property_monitor.hpp"
#include "check/timed/store/packed_states.hpp"
#include "check/timed/timed.hpp"

namespace grafverif::timed {

class MacroSteps {
public:
    /// The buffers of one thread.
    struct Buffers {
        std::vector<std::unique_ptr<Moves>> levels = {};  // per depth: the moves of a transient state
        Moves made = {};                                  // the macro-steps of the expanded state
        std::optional<PackedStates> known = {};           // the states that the macro-steps have reached
        std::vector<Word> marks = {}, others = {};
        std::size_t computed = 0;  // number of computed moves, including moves of transient states
    };
    /// One move of a macro-step.
    struct Step {
        std::uint32_t edge = 0;
        std::vector<Word> words = {};   ///< the state after the move
        std::vector<Word> chosen = {};  ///< Moves::chosen of the move
    };

    /// Disables macro-steps: each move of the search is one edge.
    explicit MacroSteps(const Machine& machine) : machine_(&machine) {}
    /// `monitor` contains the searches of all properties; `races` contains the fields of the flags for races.
    MacroSteps(const Machine& machine, PropertyMonitor monitor, std::vector<Field> races,
               const MacroStepOptions& options);
    /// True if macro-steps are enabled, so that a move of the search may consist of several edges.
    bool applies() const { return !cycles_.empty(); }

    /// Computes the macro-steps that begin in the state `words`, with the interface of Machine::expand. Moves::edges
    /// contains the first edge of each macro-step. Each successor occurs only once. Returns the number of computed
    /// moves, including moves of transient states.
    std::size_t expand(const Word* words, Moves& moves, Buffers& buffers) const;
    /// True if the state `words` and the stored state `stored` differ only in the values of dead outputs.
    bool are_equivalent(const Word* words, const Word* stored) const;
    /// Returns the moves of a macro-step from one state to another. Requires that such a macro-step exists.
    std::vector<Step> between(const Word* from, const Word* to) const;

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    struct Reset {
        Field field = {};
        std::int64_t value = 0;
    };

    template <class Keeps>
    void keep(Moves& moves, const Keeps& keeps) const;
    std::size_t cycle_of(const Word* words) const;
    std::size_t location_of(std::uint32_t process, const Word* words) const;
    bool is_transient(const Word* words, Moves& moves) const;
    bool is_covered(const Word* words, const Moves& moves, const Word* first, Buffers& buffers) const;
    void normalize(Word* words) const;
    void append(Word* words, std::uint32_t edge, std::size_t depth, const Word* first, Buffers& buffers) const;
    bool find(const Word* words, const Word* to, PackedStates& visited, std::vector<Step>& steps) const;

    const Machine* machine_;
    PropertyMonitor monitor_ = {};
    std::vector<Field> races_ = {};
    MacroStepAblations without_ = {};
    struct Cycle {
        struct Edge {
            std::vector<bool> always = {}, if_unchanged = {};  // see Independence
            std::vector<Field> shared = {};
        };
        std::uint32_t process = 0;
        std::vector<bool> within = {};       // per location of the PLC: true if the PLC is within a cycle
        std::vector<bool> independent = {};  // per location: true if its edges are independent of the edges of the
                                             // timers
        std::vector<Edge> edges = {};
        std::vector<bool> like_waiting = {};  // per location: true if the cycle has begun, but the inputs are not
                                              // sampled yet
        std::size_t waiting = 0;              // the waiting location W
        Field stable = {};
        std::vector<Reset> outputs = {};  // dead outputs, with their initial values
    };
    std::vector<Cycle> cycles_ = {};
    std::vector<bool> observers_ = {}, deferred_ = {};  // per process: true for observers; true for deferred processes
    std::vector<std::size_t> accepts_ = {};             // per process: for a timer that accepts requests, the index of
                                                        // its PLC in `cycles_`; otherwise `none`
    std::vector<std::uint32_t> prompt_ = {};  // the processes whose moves can make a state transient although no PLC is
                                              // within a cycle
};

}  // namespace grafverif::timed
