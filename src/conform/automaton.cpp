// SPDX-License-Identifier: MIT
// Searches the locations. A location is a state in which the controller waits for its next scan. In a location, no
// timer is marked as `fresh` or `falling`, because no event has yet occurred in the new instant. Each location is
// processed once, in the order of discovery.
//
// In every_cycle mode, each move that changes the state is an evolution of the automaton.
//
// With stability search, the inputs of a move that is not stable are kept constant and followed through transient
// states. The moves of each state partition the set of inputs: they are disjoint and cover all inputs. Therefore, each
// input has exactly one path, and the set of inputs that follow a path becomes smaller along the path. A path ends with
// a stable move (an arrival), or when it revisits one of its states. A path that revisits a state cycles forever (total
// instability), because the next state is unique for constant inputs. Since the number of states is finite, every path
// ends in one of these two ways.
//
// The marks `fresh` and `falling` of timers are kept along a path, because no time passes on the path. The resulting
// evolution records the marks.
#include "conform/automaton.hpp"

#include <algorithm>

#include "conform/moves.hpp"
#include "ir/words_of.hpp"
#include "support/messages.hpp"
#include "syntax/print/chart.hpp"

namespace grafverif {

namespace {

using namespace conform;
using Automaton = LocationAutomaton;
using Location = Automaton::Location;
using Role = Equations::Role;

// -- paths under constant inputs --------------------------------------------------------------------------------------

/// A stable state, and the set of constant inputs under which the evolutions end in this state.
struct Arrival {
    StateId state = 0;  ///< timers that were started on the path are marked as fresh
    Bdd set = {};
};
struct Loop {
    std::vector<StateId> states = {};
    Bdd set = {};
};
struct Followed {
    std::vector<Arrival> arrivals = {};  ///< arrivals in distinct states
    std::vector<Loop> loops = {};

    void arrive(StateId state, const Bdd& set) {
        const auto same = std::ranges::find(arrivals, state, &Arrival::state);
        if (same == arrivals.end()) arrivals.push_back({state, set});
        else same->set |= set;
    }
};

/// Follows the paths that begin with the moves in `first`, and returns their ends. `origin` is the location in which
/// the moves start, or `no_state`. A stable move to `origin` is not an arrival.
Followed followed(Moves& moves, const std::vector<StateMove>& first, StateId origin = no_state) {
    struct Leg {
        StateId state = 0;
        Bdd set = {};
        std::size_t depth = 0;  ///< number of preceding states on the path
    };
    Followed result;
    std::vector<StateId> path;
    if (origin != no_state) path.push_back(origin);
    std::vector<Leg> open;
    for (std::size_t k = first.size(); k-- > 0;)
        if (!first[k].stable) open.push_back({first[k].next, first[k].set, path.size()});
    for (const StateMove& move : first)
        if (move.stable && move.next != origin) result.arrive(move.next, move.set);
    while (!open.empty()) {
        Leg leg = std::move(open.back());
        open.pop_back();
        path.resize(leg.depth);
        if (const auto again = std::ranges::find(path, leg.state); again != path.end()) {
            result.loops.push_back({{again, path.end()}, std::move(leg.set)});
            continue;
        }
        path.push_back(leg.state);
        for (const StateMove& move : moves.of(leg.state)) {
            const Bdd both = leg.set & move.set;
            if (both.is_false()) continue;
            if (move.stable) result.arrive(move.next, both);
            else open.push_back({move.next, both, path.size()});
            if (both == leg.set) break;
        }
    }
    return result;
}

/// Merges cycles that consist of the same states. Each resulting cycle begins with its state with the smallest number.
std::vector<Loop> merged(std::vector<Loop> loops) {
    for (Loop& loop : loops) std::ranges::rotate(loop.states, std::ranges::min_element(loop.states));
    std::ranges::stable_sort(loops, {}, &Loop::states);
    std::vector<Loop> result;
    for (Loop& loop : loops)
        if (result.empty() || result.back().states != loop.states) result.push_back(std::move(loop));
        else result.back().set |= loop.set;
    return result;
}

// -- the search -------------------------------------------------------------------------------------------------------

class LocationSearch {
public:
    LocationSearch(const Equations& equations, const AutomatonOptions& options, const InputOf& inputs,
                   const InputSpace& space, Automaton& automaton, Diagnostics& diagnostics)
        : equations_(equations),
          options_(options),
          space_(space),
          automaton_(automaton),
          diagnostics_(diagnostics),
          moves_(equations, inputs, space),
          conditions_(space, automaton.exprs),
          kept_(kept(equations)) {
        std::uint32_t outputs = 0;
        for (const Equations::Variable& variable : equations.variables)
            outputs_.push_back(variable.role == Role::Output ? Id<Automaton::Output>{outputs++}
                                                             : Id<Automaton::Output>{});
    }

    /// Computes the automaton, whose variables have already been declared. Throws if an evolution has no result; other
    /// errors are added to `diagnostics`.
    void run() {
        automaton_.complete = false;
        start();
        for (std::size_t next = 1; next < states_.size(); ++next) {
            automaton_.looked_at = next;
            if (!in_bounds(next)) return;
            look_at({static_cast<std::uint32_t>(next)});
        }
        automaton_.looked_at = automaton_.locations.size();
        automaton_.complete = true;
    }

private:
    void start() {
        Location init;
        for (std::uint32_t step = 0; step < equations_.steps.size(); ++step)
            if (equations_.variables[equations_.steps[step].variable].initial != 0) init.situation.push_back({step});
        for (const Automaton::Stored& stored : automaton_.stored) init.values.push_back(stored.initial);
        init.emissions = stored_emissions(init.values);
        automaton_.init = automaton_.locations.add(init);
        states_.push_back(no_state);
        const std::vector<StateMove> first = moves_.first();
        if (options_.mode == ExecutionMode::EveryCycle) {
            for (const StateMove& move : first) add_evolution(automaton_.init, {move.next, move.set});
            return;
        }
        const Followed all = followed(moves_, first);
        if (all.arrivals.empty()) {
            const Loop& loop = all.loops.front();
            throw NoResult{messages::initial_never_stable(equations_.origin, inputs_text(loop.set), loop_text(loop))};
        }
        const StateId only =
            first.size() == 1 && moves_.fresh(first.front().next).empty() ? first.front().next : no_state;
        const bool unchanged = only != no_state && nothing_happened(init, described(moves_.settled(only)));
        for (const Arrival& arrival : all.arrivals)
            if (!unchanged || arrival.state != only) add_evolution(automaton_.init, arrival);
            else location(moves_.settled(only));
        add_instabilities(automaton_.init, all.loops);
    }

    /// True if the first evolution, which leads from `init` to `reached`, changes no variable, and both locations emit
    /// the same outputs.
    static bool nothing_happened(const Location& init, const Location& reached) {
        return reached.values == init.values && reached.emissions == init.emissions;
    }

    bool in_bounds(std::size_t next) {
        if (automaton_.locations.size() > options_.max_locations) {
            if (options_.partial) throw BddExhausted(BddExhausted::Cause::Memory);
            diagnostics_.add(messages::too_many_locations(equations_.origin, options_.max_locations));
            return false;
        }
        if (next % 4096 == 0) {
            stop_if_requested(options_);
            if (options_.progress) options_.progress({automaton_.locations.size(), next, automaton_.evolutions.size()});
        }
        return true;
    }

    void look_at(Id<Location> from) {
        const StateId state = states_[from.index];
        const std::vector<StateMove>& moves = moves_.of(state);
        if (options_.mode == ExecutionMode::EveryCycle) {
            for (const StateMove& move : moves)
                if (!move.stable || move.next != state) add_evolution(from, {move.next, move.set});
            return;
        }
        const Followed all = followed(moves_, moves, state);
        for (const Arrival& arrival : all.arrivals) add_evolution(from, arrival);
        add_instabilities(from, all.loops);
    }

    void add_evolution(Id<Location> from, const Arrival& arrival) {
        Automaton::Evolution evolution{
            from, location(moves_.settled(arrival.state)), conditions_.term(arrival.set), {}, {}};
        for (const std::size_t timer : moves_.fresh(arrival.state)) evolution.restarted.push_back(timer_input(timer));
        for (const std::size_t timer : moves_.falling(arrival.state)) evolution.falling.push_back(timer_input(timer));
        automaton_.evolutions.push_back(std::move(evolution));
    }

    /// Returns the input of the automaton for a timer output. Timer outputs are the last inputs of the automaton.
    Id<Automaton::Input> timer_input(std::size_t timer) const {
        return {static_cast<std::uint32_t>(automaton_.inputs.size() - equations_.timers.size() + timer)};
    }

    void add_instabilities(Id<Location> from, const std::vector<Loop>& loops) {
        for (const Loop& loop : merged(loops)) {
            const Bdd set = loop.set & space_.assumed();
            Automaton::Instability instability{
                from, conditions_.term(loop.set), small_count(set, space_.bits()), space_.witness(set), {}};
            for (const StateId state : loop.states) instability.cycle.push_back(situation(moves_.values(state)));
            automaton_.instabilities.push_back(std::move(instability));
        }
    }

    Id<Location> location(StateId state) {
        if (location_of_.size() <= state)
            location_of_.resize(std::max<std::size_t>(state + 1, 2 * location_of_.size()));
        Id<Location>& known = location_of_[state];
        if (known.valid()) return known;
        known = automaton_.locations.add(described(state));
        states_.push_back(state);
        return known;
    }

    // -- data of a state ----------------------------------------------------------------------------------------------

    std::vector<Id<Automaton::Step>> situation(const Values& values) const {
        std::vector<Id<Automaton::Step>> active;
        for (std::uint32_t step = 0; step < equations_.steps.size(); ++step)
            if (values[equations_.steps[step].variable.index] != 0) active.push_back({step});
        return active;
    }

    Location described(StateId state) {
        const Values values = moves_.values(state);
        Location result{situation(values), {}, {}};
        for (const Kept& each : kept_)
            if (equations_.variables[each.variable].role != Role::Step)
                result.values.push_back(values[each.variable.index]);
        result.emissions = stored_emissions(result.values);
        for (const Equations::Output& output : equations_.outputs) {
            const LocationCondition value = moves_.condition(output.value, values);
            if (!(value.undefined & space_.assumed()).is_false())
                diagnostics_.add(messages::no_value_in_location(
                    output.origin,
                    situation_text(automaton_, result.situation) + " with " + inputs_text(value.undefined)));
            if (!(value.holds & space_.assumed()).is_false())
                result.emissions.push_back({output_of(output.variable), conditions_.term(value.holds)});
        }
        std::ranges::sort(result.emissions, {}, &Automaton::Emission::output);
        return result;
    }

    /// Returns the emissions of the outputs with stored actions whose current values are not 0.
    std::vector<Automaton::Emission> stored_emissions(const std::vector<std::int64_t>& values) {
        std::vector<Automaton::Emission> result;
        for (std::size_t k = 0; k < equations_.stored.size(); ++k) {
            const Equations::Variable& variable = equations_.variables[equations_.stored[k].variable];
            if (variable.role != Role::Output || values[k] == 0) continue;
            const Id<Expr> value =
                variable.type.boolean ? automaton_.exprs.constant(true) : automaton_.exprs.integer(values[k]);
            result.push_back({output_of(equations_.stored[k].variable), value});
        }
        std::ranges::sort(result, {}, &Automaton::Emission::output);
        return result;
    }

    /// Returns the output of the automaton for a variable. The outputs of the automaton have the order of the
    /// equations.
    Id<Automaton::Output> output_of(Id<Equations::Variable> variable) const { return outputs_[variable.index]; }

    std::string inputs_text(const Bdd& set) const { return space_.witness_text(set & space_.assumed()); }

    std::string loop_text(const Loop& loop) const {
        std::string text;
        for (const StateId state : loop.states)
            text += situation_text(automaton_, situation(moves_.values(state))) + " -> ";
        return text + situation_text(automaton_, situation(moves_.values(loop.states.front())));
    }

    const Equations& equations_;
    const AutomatonOptions& options_;
    const InputSpace& space_;
    Automaton& automaton_;
    Diagnostics& diagnostics_;
    Moves moves_;
    Conditions conditions_;
    std::vector<Kept> kept_;
    std::vector<Id<Automaton::Output>> outputs_ = {};  ///< output of each variable
    std::vector<StateId> states_ = {};                 ///< state of each location except INIT
    std::vector<Id<Location>> location_of_ = {};       ///< location of each state
};

// -- declarations -----------------------------------------------------------------------------------------------------

/// Returns the name of a timer in the notation of conditions, such as `3s/X2` or `3s/a/2s`.
std::string name_of(const Equations& equations, const Equations::Timer& timer) {
    const std::string watched = watched_name(equations, timer);
    return time_text(timer.rise_ms, watched.empty() ? equations.variables[timer.watched].name : watched, timer.fall_ms);
}

/// Declares the inputs of the chart, followed by the outputs of its timers. Returns the input for each variable of the
/// equations.
InputOf declare_inputs(const Equations& equations, Automaton& automaton) {
    InputOf inputs(equations.variables.size());
    for (const Id<Equations::Variable> id : equations.variables.ids()) {
        const Equations::Variable& variable = equations.variables[id];
        if (variable.role == Role::Input)
            inputs[id.index] =
                automaton.inputs.add({variable.name, variable.type, {}, {}, 0, 0, variable.origin}).index;
    }
    for (const Equations::Timer& timer : equations.timers) {
        Automaton::Input input{name_of(equations, timer), {}, {}, {}, timer.rise_ms, timer.fall_ms, timer.origin};
        const auto step = std::ranges::find(equations.steps, timer.watched, &Equations::StepActivity::variable);
        const auto watch = std::ranges::find(equations.watches, timer.watched, &Equations::ObservedTerm::variable);
        if (step != equations.steps.end()) input.timed = {static_cast<std::uint32_t>(step - equations.steps.begin())};
        else
            input.watched = {static_cast<std::uint32_t>(equations.stored.size() + equations.previous.size() +
                                                        static_cast<std::size_t>(watch - equations.watches.begin()))};
        inputs[timer.end.index] = automaton.inputs.add(std::move(input)).index;
    }
    return inputs;
}

/// Excludes impossible combinations of outputs of timers that observe the same term. The output of timer `one` implies
/// the output of timer `other` in the following case: compared with `other`, the rise time of `one` is not shorter, and
/// its fall time is not longer.
void order_timers(const Equations& equations, const InputOf& inputs, InputSpace& space) {
    const auto end = [&](const Equations::Timer& timer) { return space.term(*inputs[timer.end.index]).bits.front(); };
    for (const Equations::Timer& one : equations.timers)
        for (const Equations::Timer& other : equations.timers)
            if (&one != &other && one.watched == other.watched && one.rise_ms >= other.rise_ms &&
                one.fall_ms <= other.fall_ms)
                space.assume(~end(one) | end(other));
}

/// Declares the variables. Returns false after an error, for example if the chart has no inputs or no outputs, which
/// JESA13 section 2.2 requires.
bool declare(const Equations& equations, Automaton& automaton, Diagnostics& diagnostics) {
    for (const Equations::Variable& variable : equations.variables)
        if (variable.role == Role::Output) automaton.outputs.add({variable.name, variable.type});
    for (const Equations::StepActivity& step : equations.steps) automaton.steps.add({step.step.text()});
    for (const Kept& each : kept(equations))
        if (const Equations::Variable& variable = equations.variables[each.variable]; variable.role != Role::Step)
            automaton.stored.add({variable.name, variable.type, variable.initial});
    const bool inputs = !automaton.inputs.empty(), outputs = !automaton.outputs.empty();
    if (!inputs) diagnostics.add(messages::nothing_to_test(equations.origin, equations.name, "inputs"));
    if (!outputs) diagnostics.add(messages::nothing_to_test(equations.origin, equations.name, "outputs"));
    return inputs && outputs;
}

/// Restricts the considered inputs to those that satisfy the constraints. Returns false after an error.
bool assume(const Equations& equations, const InputOf& inputs, InputSpace& space, Diagnostics& diagnostics) {
    BddTerms terms(equations.exprs,
                   [&](const Expr& leaf) { return space.term(inputs[static_cast<std::size_t>(leaf.value)].value()); });
    for (const Equations::Assumption& assumption : equations.assumptions) {
        const BddTerm& term = terms(assumption.condition);
        space.assume(term.bits.front() & ~term.undefined);
        if (!space.assumed().is_false()) continue;
        diagnostics.add(messages::excludes_every_input(assumption.origin));
        return false;
    }
    return true;
}

Id<Expr> assumed_term(const Equations& equations, const InputOf& inputs, Exprs& exprs) {
    std::vector<Id<Expr>> terms;
    for (const Equations::Assumption& assumption : equations.assumptions)
        terms.push_back(translate(equations.exprs, assumption.condition, exprs, [&](const Expr& leaf) {
            return exprs.leaf(Op::Variable,
                              static_cast<std::uint32_t>(inputs[static_cast<std::size_t>(leaf.value)].value()));
        }));
    return exprs.conjunction(terms);
}

}  // namespace

std::optional<LocationAutomaton> location_automaton(const Equations& equations, const AutomatonOptions& options,
                                                    Diagnostics& diagnostics) {
    Automaton automaton;
    automaton.name = equations.name;
    automaton.mode = options.mode;
    automaton.origin = equations.origin;
    const InputOf inputs = declare_inputs(equations, automaton);
    if (!declare(equations, automaton, diagnostics)) return {};
    const std::size_t errors = diagnostics.errors();
    try {
        InputSpace space(named(automaton.inputs), {options.max_memory, options.deadline, options.stop});
        if (!assume(equations, inputs, space, diagnostics)) return {};
        order_timers(equations, inputs, space);
        automaton.assumed = assumed_term(equations, inputs, automaton.exprs);
        LocationSearch(equations, options, inputs, space, automaton, diagnostics).run();
    } catch (const NoResult& none) {
        diagnostics.add(none.why);
    } catch (const BddExhausted& failure) {
        if (options.partial && !automaton.locations.empty()) return automaton;
        diagnostics.add(limit_reached(failure, equations.origin, options.stop));
    }
    if (diagnostics.errors() != errors) return {};
    return automaton;
}

}  // namespace grafverif
