// SPDX-License-Identifier: MIT
// The search for locations: each state found is looked at once, its evolutions are followed as the mode says.
#include "conform/automaton.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "conform/moves.hpp"
#include "conform/words.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

using namespace conform;
using Automaton = LocationAutomaton;
using Location = Automaton::Location;
using Role = Equations::Role;

/// Where a set of inputs ends up.
struct Arrival {
    StateId state = 0;       ///< timers that were started on the way are fresh
    Bdd set = {};
};
struct Loop {
    std::vector<StateId> states = {};
    Bdd set = {};
};
struct Followed {
    std::vector<Arrival> arrivals = {};
    std::vector<Loop> loops = {};
};

class Search {
public:
    Search(const Equations& equations, const AutomatonOptions& options, const std::vector<std::optional<std::size_t>>& inputs,
           const InputSpace& space, Automaton& automaton, Diagnostics& diagnostics)
        : equations_(equations), options_(options), space_(space), automaton_(automaton), diagnostics_(diagnostics),
          moves_(equations, inputs, space, diagnostics), conditions_(space, automaton.exprs), kept_(kept(equations)) {}

    /// False after an error.
    bool run() {
        automaton_.complete = false;
        if (!start()) return false;
        for (std::size_t next = 1; next < states_.size(); ++next) {
            automaton_.looked_at = next;
            if (moves_.failed() || !in_bounds(next)) return false;
            const Id<Location> from{static_cast<std::uint32_t>(next)};
            if (options_.mode == ExecutionMode::EveryCycle) step_from(from);
            else search_from(from);
        }
        automaton_.looked_at = automaton_.locations.size();
        automaton_.complete = true;
        return !moves_.failed();
    }

private:
    bool start() {
        Location init;
        for (std::uint32_t step = 0; step < equations_.steps.size(); ++step)
            if (equations_.variables[equations_.steps[step].variable].initial != 0) init.situation.push_back({step});
        for (const Automaton::Stored& stored : automaton_.stored) init.values.push_back(stored.initial);
        init.emissions = stored_emissions(init.values);
        automaton_.init = automaton_.locations.add(std::move(init));
        states_.push_back(no_state);
        const std::vector<StateMove> first = moves_.first();
        if (moves_.failed()) return false;
        if (options_.mode == ExecutionMode::EveryCycle) {
            for (const StateMove& move : first) add_evolution(automaton_.init, {move.next, move.set});
            return true;
        }
        Followed all;
        for (const StateMove& move : first) follow(move.next, move.set, all);
        if (moves_.failed()) return false;
        if (all.arrivals.empty()) return never_stabilises(all.loops.front());
        const bool unchanged = first.size() == 1 && moves_.fresh(first.front().next).empty() &&
                               nothing_happened(moves_.settled(first.front().next));
        for (const Arrival& arrival : all.arrivals)
            if (!unchanged || arrival.state != first.front().next) add_evolution(automaton_.init, arrival);
            else location(moves_.settled(arrival.state));
        add_instabilities(automaton_.init, all.loops);
        return !moves_.failed();
    }

    /// Whether the first evolution changed no variable, and `state` emits what power-on did.
    bool nothing_happened(StateId state) {
        const Location reached = described(state);
        const Location& init = automaton_.locations[automaton_.init];
        return reached.values == init.values && reached.emissions == init.emissions;
    }

    bool never_stabilises(const Loop& loop) {
        diagnostics_.add(messages::initial_never_stable(equations_.origin, inputs_words(loop.set), loop_words(loop)));
        return false;
    }

    bool in_bounds(std::size_t next) {
        if (automaton_.locations.size() > options_.max_locations) {
            if (options_.partial) throw BddExhausted(BddExhausted::Cause::Memory);
            diagnostics_.add(messages::too_many_locations(equations_.origin, options_.max_locations));
            return false;
        }
        if (next % 4096 == 0) {
            const bool late = options_.deadline && std::chrono::steady_clock::now() >= *options_.deadline;
            if (late || (options_.stop != nullptr && options_.stop->load())) throw BddExhausted(BddExhausted::Cause::Stopped);
            if (options_.progress) options_.progress({automaton_.locations.size(), next, automaton_.evolutions.size()});
        }
        return true;
    }

    void step_from(Id<Location> from) {
        for (const StateMove& move : moves_.of(states_[from.index]))
            if (!move.stable || move.next != states_[from.index]) add_evolution(from, {move.next, move.set});
    }

    void search_from(Id<Location> from) {
        Followed all;
        const std::vector<StateMove>& moves = moves_.of(states_[from.index]);
        for (const StateMove& move : moves) {
            if (!move.stable) follow(move.next, move.set, all, states_[from.index]);
            else if (move.next != states_[from.index]) arrive(move.next, move.set, all);
        }
        for (const Arrival& arrival : all.arrivals) add_evolution(from, arrival);
        add_instabilities(from, all.loops);
    }

    struct Leg {
        StateId state = 0;
        Bdd set = {};
        std::size_t depth = 0;   ///< the states of the path before it
    };

    /// Follows `set` from `state`, the inputs held, until it is stable or on a loop.
    void follow(StateId state, const Bdd& set, Followed& result, StateId origin = no_state) {
        if (const std::vector<StateMove>& moves = moves_.of(state); !moves.empty() && moves.front().stable)
            if (Bdd both = set & moves.front().set; both == set) return arrive(moves.front().next, std::move(both), result);   // as most do
        std::vector<Leg> open{{state, set, 0}};
        std::vector<StateId> path;
        if (origin != no_state) path.push_back(origin), open.back().depth = 1;
        while (!open.empty() && !moves_.failed()) {
            Leg leg = std::move(open.back());
            open.pop_back();
            path.resize(leg.depth);
            if (const auto again = std::ranges::find(path, leg.state); again != path.end()) {
                result.loops.push_back({{again, path.end()}, std::move(leg.set)});
                continue;
            }
            path.push_back(leg.state);
            for (const StateMove& move : moves_.of(leg.state)) {
                Bdd both = leg.set & move.set;
                if (both.is_false()) continue;
                const bool all = both == leg.set;
                if (move.stable) arrive(move.next, std::move(both), result);
                else open.push_back({move.next, std::move(both), path.size()});
                if (all) break;
            }
        }
    }

    static void arrive(StateId state, Bdd set, Followed& result) {
        const auto same = std::ranges::find(result.arrivals, state, &Arrival::state);
        if (same == result.arrivals.end()) result.arrivals.push_back({state, std::move(set)});
        else same->set |= set;
    }

    void add_evolution(Id<Location> from, const Arrival& arrival) {
        Automaton::Evolution evolution{from, location(moves_.settled(arrival.state)), conditions_.term(arrival.set), {}, {}};
        for (const std::size_t timer : moves_.fresh(arrival.state)) evolution.restarted.push_back(timer_input(timer));
        for (const std::size_t timer : moves_.falling(arrival.state)) evolution.falling.push_back(timer_input(timer));
        automaton_.evolutions.push_back(std::move(evolution));
    }

    Id<Automaton::Input> timer_input(std::size_t timer) const {
        return {static_cast<std::uint32_t>(automaton_.inputs.size() - equations_.timers.size() + timer)};
    }

    void add_instabilities(Id<Location> from, std::vector<Loop>& loops) {
        for (Loop& loop : loops)
            std::ranges::rotate(loop.states, std::ranges::min_element(loop.states));
        std::ranges::stable_sort(loops, {}, &Loop::states);
        for (std::size_t first = 0, last = 0; first < loops.size(); first = last) {
            Bdd set = loops[first].set;
            for (last = first + 1; last < loops.size() && loops[last].states == loops[first].states; ++last) set |= loops[last].set;
            Automaton::Instability instability{from, conditions_.term(set), small_count(set & space_.assumed(), space_.bits()),
                                               space_.witness(set & space_.assumed()), {}};
            for (const StateId state : loops[first].states) instability.cycle.push_back(situation(state));
            automaton_.instabilities.push_back(std::move(instability));
        }
    }

    Id<Location> location(StateId state) {
        if (location_of_.size() <= state) location_of_.resize(std::max<std::size_t>(state + 1, 2 * location_of_.size()));
        Id<Location>& known = location_of_[state];
        if (known.valid()) return known;
        known = automaton_.locations.add(described(state));
        states_.push_back(state);
        return known;
    }

    std::vector<Id<Automaton::Step>> situation(StateId state) {
        const std::vector<std::int64_t>& values = moves_.load(state);
        std::vector<Id<Automaton::Step>> active;
        for (std::uint32_t step = 0; step < equations_.steps.size(); ++step)
            if (values[equations_.steps[step].variable.index] != 0) active.push_back({step});
        return active;
    }

    Location described(StateId state) {
        Location result{situation(state), {}, {}};
        const std::vector<std::int64_t>& values = moves_.load(state);
        for (const Kept& each : kept_)
            if (equations_.variables[each.variable].role != Role::Step) result.values.push_back(values[each.variable.index]);
        result.emissions = stored_emissions(result.values);
        for (const Equations::Output& output : equations_.outputs) {
            Bdd undefined;
            const Bdd value = moves_.terms().condition(output.value, undefined);
            if (!(undefined & space_.assumed()).is_false()) {
                diagnostics_.add(messages::no_value_in_location(
                    output.origin, situation_text(automaton_, result.situation) + " with " + inputs_words(undefined)));
                unsound_ = true;
            }
            if (!(value & space_.assumed()).is_false()) result.emissions.push_back({output_of(output.variable), conditions_.term(value)});
        }
        std::ranges::sort(result.emissions, {}, &Automaton::Emission::output);
        return result;
    }

    /// Outputs with stored actions, where they are not 0.
    std::vector<Automaton::Emission> stored_emissions(const std::vector<std::int64_t>& values) {
        std::vector<Automaton::Emission> result;
        for (std::size_t k = 0; k < equations_.stored.size(); ++k) {
            const Equations::Variable& variable = equations_.variables[equations_.stored[k].variable];
            if (variable.role != Role::Output || values[k] == 0) continue;
            const Id<Expr> value = variable.type.boolean ? automaton_.exprs.constant(true) : automaton_.exprs.integer(values[k]);
            result.push_back({output_of(equations_.stored[k].variable), value});
        }
        std::ranges::sort(result, {}, &Automaton::Emission::output);
        return result;
    }

    Id<Automaton::Output> output_of(Id<Equations::Variable> variable) {
        if (outputs_.empty())
            for (const Id<Equations::Variable> id : equations_.variables.ids())
                if (equations_.variables[id].role == Role::Output)
                    outputs_.emplace(id, Id<Automaton::Output>{static_cast<std::uint32_t>(outputs_.size())});
        return outputs_.at(variable);
    }

    std::string inputs_words(const Bdd& set) const {
        std::vector<std::pair<std::string, Type>> names;
        for (const Automaton::Input& input : automaton_.inputs) names.emplace_back(input.name, input.type);
        return inputs_text(names, space_.witness(set & space_.assumed()));
    }

    std::string loop_words(const Loop& loop) {
        std::string text;
        for (const StateId state : loop.states) text += situation_text(automaton_, situation(state)) + " -> ";
        return text + situation_text(automaton_, situation(loop.states.front()));
    }

public:
    bool unsound() const { return unsound_; }

private:
    const Equations& equations_;
    const AutomatonOptions& options_;
    const InputSpace& space_;
    Automaton& automaton_;
    Diagnostics& diagnostics_;
    Moves moves_;
    Conditions conditions_;
    std::vector<Kept> kept_;
    std::vector<StateId> states_ = {};                ///< per location; INIT has none
    std::vector<Id<Location>> location_of_ = {};      ///< per state
    std::map<Id<Equations::Variable>, Id<Automaton::Output>> outputs_ = {};
    bool unsound_ = false;
};

/// Inputs of the chart, then the ends of its timers; per variable of the equations which input it is.
std::vector<std::optional<std::size_t>> declare_inputs(const Equations& equations, Automaton& automaton) {
    std::vector<std::optional<std::size_t>> inputs(equations.variables.size());
    for (const Id<Equations::Variable> id : equations.variables.ids()) {
        const Equations::Variable& variable = equations.variables[id];
        if (variable.role == Role::Input)
            inputs[id.index] = automaton.inputs.add({variable.name, variable.type, {}, {}, 0, 0, variable.origin}).index;
    }
    for (const Equations::Timer& timer : equations.timers) {
        Automaton::Input input{equations.variables[timer.end].name, {}, {}, {}, timer.rise_ms, timer.fall_ms, timer.origin};
        const auto step = std::ranges::find(equations.steps, timer.watched, &Equations::StepActivity::variable);
        const auto watch = std::ranges::find(equations.watches, timer.watched, &Equations::Watch::variable);
        if (step != equations.steps.end()) input.timed = {static_cast<std::uint32_t>(step - equations.steps.begin())};
        else input.watched = {static_cast<std::uint32_t>(equations.stored.size() + equations.previous.size() +
                                                         static_cast<std::size_t>(watch - equations.watches.begin()))};
        inputs[timer.end.index] = automaton.inputs.add(std::move(input)).index;
    }
    return inputs;
}

/// Excludes what timers of one level cannot do: of those that rise later and fall earlier none holds alone.
void order_timers(const Equations& equations, const std::vector<std::optional<std::size_t>>& inputs, InputSpace& space) {
    const auto end = [&](const Equations::Timer& timer) { return space.term(*inputs[timer.end.index]).bits.front(); };
    for (const Equations::Timer& one : equations.timers)
        for (const Equations::Timer& other : equations.timers)
            if (&one != &other && one.watched == other.watched && one.rise_ms >= other.rise_ms && one.fall_ms <= other.fall_ms)
                space.assume(~end(one) | end(other));
}

/// False after an error: JESA13 section 2.2 asks for inputs and outputs.
bool declare(const Equations& equations, Automaton& automaton, Diagnostics& diagnostics) {
    for (const Equations::Variable& variable : equations.variables)
        if (variable.role == Role::Output) automaton.outputs.add({variable.name, variable.type});
    for (const Equations::StepActivity& step : equations.steps) automaton.steps.add({step.step});
    for (const Kept& each : kept(equations))
        if (const Equations::Variable& variable = equations.variables[each.variable]; variable.role != Role::Step)
            automaton.stored.add({variable.name, variable.type, variable.initial});
    const bool inputs = !automaton.inputs.empty(), outputs = !automaton.outputs.empty();
    if (!inputs) diagnostics.add(messages::nothing_to_test(equations.origin, equations.name, "inputs"));
    if (!outputs) diagnostics.add(messages::nothing_to_test(equations.origin, equations.name, "outputs"));
    return inputs && outputs;
}

/// Restricts the inputs to what the constraints allow; false after an error.
bool assume(const Equations& equations, const std::vector<std::optional<std::size_t>>& inputs, InputSpace& space,
            Diagnostics& diagnostics) {
    BddTerms terms(equations.exprs, [&](const Expr& leaf) { return space.term(inputs[static_cast<std::size_t>(leaf.value)].value()); });
    for (const Equations::Assumption& assumption : equations.assumptions) {
        const BddTerm& term = terms(assumption.condition);
        space.assume(term.bits.front() & ~term.undefined);
        if (!space.assumed().is_false()) continue;
        diagnostics.add(messages::excludes_every_input(assumption.origin));
        return false;
    }
    return true;
}

Id<Expr> assumed_term(const Equations& equations, const std::vector<std::optional<std::size_t>>& inputs, Exprs& exprs) {
    std::vector<Id<Expr>> terms;
    for (const Equations::Assumption& assumption : equations.assumptions)
        terms.push_back(translate(equations.exprs, assumption.condition, exprs, [&](const Expr& leaf) {
            return exprs.leaf(Op::Variable, static_cast<std::uint32_t>(inputs[static_cast<std::size_t>(leaf.value)].value()));
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
    const std::vector<std::optional<std::size_t>> inputs = declare_inputs(equations, automaton);
    if (!declare(equations, automaton, diagnostics)) return {};
    std::vector<Type> types;
    for (const Automaton::Input& input : automaton.inputs) types.push_back(input.type);
    try {
        InputSpace space(types, {options.max_memory, options.deadline, options.stop});
        if (!assume(equations, inputs, space, diagnostics)) return {};
        order_timers(equations, inputs, space);
        automaton.assumed = assumed_term(equations, inputs, automaton.exprs);
        Search search(equations, options, inputs, space, automaton, diagnostics);
        if (!search.run() || search.unsound()) return {};
    } catch (const BddExhausted& failure) {
        if (options.partial && !automaton.locations.empty()) return automaton;
        diagnostics.add(limit_reached(failure, equations.origin, options.stop));
        return {};
    }
    return automaton;
}

}  // namespace grafverif
