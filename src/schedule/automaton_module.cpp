// SPDX-License-Identifier: MIT
// Builds the module of an automaton in three stages:
//   Declared     the symbols that edges read: parameters, the choice of an edge, the location, clocks, and the
//                variables that only this automaton writes
//   Taken        the edges, as terms over the values before the step
//   next values  the next value of every symbol, with one case for each edge that the step can take
//
// Correctness: the module has the same steps as the process, and no other steps. The choice selects one edge or no
// edge. The module's `guard` of an edge holds if and only if the edge is enabled in the network. The module's guard
// combines the source location, the guard and the clock constraint of the edge, and the target's invariant after the
// resets. A transition constraint relates choice and guard. Next values are defined by disjoint cases over the choice.
// The discipline determines if the automaton is allowed to take no edge in a step.
#include "schedule/automaton_module.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "ir/network_clocks.hpp"
#include "schedule/automaton_edges.hpp"

namespace grafverif::schedule {

namespace {

using System = TransitionSystem;
using Place = Id<Network::Variable>;
using Edge = Id<Network::Edge>;

// -- symbols ----------------------------------------------------------------------------------------------------------

/// Declares the symbols, in the order of the members. All symbols are declared when the constructor returns.
class Declared {
public:
    Declared(const AutomatonContext& laid_out, Id<Network::Process> process, Draft& drafted)
        : context(laid_out),
          slots(context.network, process),
          draft(drafted),
          written(slots.written()),
          symbols(context.network.variables.size()),
          clocks(slots.automaton.clocks.size()) {
        draft.module.name = slots.automaton.name;
        add_parameters();
        add_choices();
        if (counts()) add_clocks(context.clocks[process.index]);
        for (const Place variable : written) {
            if (!owns(variable)) continue;
            symbols[variable.index] = draft.add(slots.name(variable), of(variable).type, System::StateSymbol{});
            made.owned.emplace_back(variable, symbols[variable.index]);
        }
    }

    const Network::Template& automaton() const { return slots.automaton; }
    const Network::Variable& of(Place variable) const { return context.network.variables[variable]; }
    bool owns(Place variable) const { return !context.shared[variable.index] && !of(variable).scratch; }
    bool counts() const { return !context.clocks.empty(); }

    Id<Expr> at(Id<Network::Location> location) const {
        return made.location.valid() ? draft.is(made.location, location.index) : draft.exprs.constant(true);
    }
    Id<Expr> takes(Edge edge) const { return draft.is(made.edge, edge.index + 1); }
    Id<Expr> clock(Id<Network::Clock> id) const {
        return clocks[id.index].valid() ? draft.leaf(clocks[id.index]) : draft.exprs.integer(0);
    }
    /// Returns a term whose value is the entry in `cases` for the edge that the step takes. If the step takes no edge,
    /// or an edge without an entry, the value is `otherwise`.
    template <class Cases>
    Id<Expr> by_edge(const Cases& cases, Id<Expr> otherwise) const {
        for (auto one = cases.rbegin(); one != cases.rend(); ++one)
            otherwise = draft.exprs.conditional(takes(one->first), one->second, otherwise);
        return otherwise;
    }

    const AutomatonContext& context;
    const Slots slots;
    Draft& draft;
    const std::vector<Place> written;
    std::vector<Id<Symbol>> symbols;  ///< symbol of each variable in the module
    std::vector<Id<Symbol>> clocks;   ///< symbol of each clock; invalid if the clock is never compared
    AutomatonModule made = {};        ///< module with its parameters, choice, location and owned variables

private:
    void add_parameters() {
        const auto parameter = [&](const char* name) { return draft.add(name, Type{}, System::ParameterSymbol{}); };
        if (context.discipline != Discipline::Together) made.turn = parameter("turn");
        if (context.discipline == Discipline::Rounds) {
            made.first = parameter("first");
            made.round = parameter("round");
        }
        if (counts() && !automaton().clocks.empty()) made.tick = parameter("tick");
        for (const Place variable : slots.read()) {
            const bool own = owns(variable) && std::ranges::find(written, variable) != written.end();
            if (own || of(variable).scratch) continue;
            symbols[variable.index] = draft.add(slots.name(variable), of(variable).type, System::ParameterSymbol{});
            made.reads.push_back(variable);
        }
    }

    void add_choices() {
        std::vector<std::string> locations;
        for (const Network::Location& location : automaton().locations) locations.push_back(location.name);
        UniqueNames labels;
        std::vector<std::string> edges{labels.fresh("stay")};
        for (const Network::Edge& edge : automaton().edges)
            edges.push_back(labels.fresh(locations[edge.from.index] + "_to_" + locations[edge.to.index]));
        made.edge = draft.add("edge", std::move(edges), System::ChoiceSymbol{}, "the edge that the automaton takes");
        if (locations.size() > 1) made.location = draft.add("location", std::move(locations), System::StateSymbol{});
    }

    void add_clocks(const ProcessClocks& caps) {
        for (const Id<Network::Clock> id : automaton().clocks.ids())
            if (const std::int64_t greatest = caps.greatest[id.index]; greatest > 0)
                clocks[id.index] = draft.add(automaton().clocks[id].name, integer_type(0, greatest),
                                             System::StateSymbol{}, "clocks, in units of time");
    }
};

// -- clocks that count ------------------------------------------------------------------------------------------------

class Clocks {
public:
    Clocks(const Declared& declared, Id<Network::Process> process)
        : declared_(declared), exprs_(declared.draft.exprs), caps_(declared.context.clocks[process.index]) {}

    /// Returns the clock constraint of an edge, and the invariant of its target after its resets.
    Id<Expr> admit(const Network::Edge& edge) const {
        std::vector<Id<Expr>> all;
        for (const Network::ClockConstraint& constraint : edge.constraint)
            all.push_back(admits(values(constraint), declared_.clock(constraint.clock)));
        for (const Network::ClockConstraint& bound : declared_.automaton().locations[edge.to].invariant)
            all.push_back(
                admits(values(bound), resets(edge, bound.clock) ? exprs_.integer(0) : declared_.clock(bound.clock)));
        return exprs_.conjunction(all);
    }

    /// Returns one condition for each clock constraint of an invariant: if the automaton is in the location, the
    /// constraint still holds after one more time unit.
    std::vector<Id<Expr>> wait() const {
        std::vector<Id<Expr>> waits;
        for (const Id<Network::Location> id : declared_.automaton().locations.ids())
            for (const Network::ClockConstraint& bound : declared_.automaton().locations[id].invariant)
                waits.push_back(implies(exprs_, declared_.at(id),
                                        admits({0, values(bound).high - 1}, declared_.clock(bound.clock))));
        return waits;
    }

    Id<Expr> next(Id<Network::Clock> id) const {
        std::vector<std::pair<Edge, Id<Expr>>> cases;
        for (const Edge edge : declared_.automaton().edges.ids())
            if (const Id<Expr> after = after_edge(declared_.automaton().edges[edge], id); after != declared_.clock(id))
                cases.emplace_back(edge, after);
        const Id<Expr> tick = declared_.draft.leaf(declared_.made.tick);
        return declared_.by_edge(cases, exprs_.conditional(tick, after_tick(id), declared_.clock(id)));
    }

private:
    /// Returns the range of clock values that satisfy a constraint. Constants in the constraint have the values of the
    /// arguments of the process.
    ClockInterval values(const Network::ClockConstraint& constraint) const {
        return admitted(constraint.relation,
                        bound_value(declared_.context.network, declared_.slots.process, constraint.bound));
    }
    Id<Expr> admits(const ClockInterval& interval, Id<Expr> value) const {
        const Id<Expr> low = interval.low <= 0 ? exprs_.constant(true)
                                               : exprs_.apply(Op::GreaterEqual, value, exprs_.integer(interval.low));
        const Id<Expr> high = interval.high >= ClockInterval::unbounded
                                  ? exprs_.constant(true)
                                  : exprs_.apply(Op::LessEqual, value, exprs_.integer(interval.high));
        return exprs_.conjunction(low, high);
    }

    /// Returns the clock value after an edge, limited to the cap of the target location.
    Id<Expr> after_edge(const Network::Edge& edge, Id<Network::Clock> id) const {
        const std::int64_t cap = caps_.cap[edge.to.index][id.index];
        if (resets(edge, id) || cap <= 0) return exprs_.integer(0);
        const Id<Expr> now = declared_.clock(id), greatest = exprs_.integer(cap);
        if (caps_.cap[edge.from.index][id.index] <= cap) return now;
        return exprs_.conditional(exprs_.apply(Op::Greater, now, greatest), greatest, now);
    }

    /// Returns the clock value after a tick, limited to the cap of the current location.
    Id<Expr> after_tick(Id<Network::Clock> id) const {
        const Id<Expr> now = declared_.clock(id), more = exprs_.apply(Op::Plus, now, exprs_.integer(1));
        std::map<std::int64_t, std::vector<Id<Expr>>> locations;  // for each cap: the locations with this cap
        for (const Id<Network::Location> location : declared_.automaton().locations.ids())
            locations[caps_.cap[location.index][id.index]].push_back(declared_.at(location));
        Id<Expr> next = now;
        for (const auto& [cap, where] : locations) {
            if (cap <= 0) continue;
            const Id<Expr> below = exprs_.apply(Op::Less, now, exprs_.integer(cap));
            next = exprs_.conditional(exprs_.conjunction(exprs_.disjunction(where), below), more, next);
        }
        return next;
    }

    const Declared& declared_;
    Exprs& exprs_;
    const ProcessClocks& caps_;
};

// -- edges ------------------------------------------------------------------------------------------------------------

/// All edges, expressed by terms over the values before the step.
struct Taken {
    /// For each edge: condition under which the edge can be taken, including the source location and clock constraints.
    std::vector<Id<Expr>> guards = {};
    /// For each written variable: the edges that write it, with the values that they write.
    std::map<Place, std::vector<std::pair<Edge, Id<Expr>>>> values = {};
    std::vector<Id<Expr>> faults = {};
};

/// Translates all edges. Appends to `within` the firing conditions, which are scratch variables that exist only within
/// a step.
Taken edges_taken(const Declared& declared, const std::optional<Clocks>& clocks,
                  std::vector<AutomatonModule::Held>& within) {
    Exprs& exprs = declared.draft.exprs;
    Taken taken;
    for (const Edge id : declared.automaton().edges.ids()) {
        const Network::Edge& edge = declared.automaton().edges[id];
        const auto name = [&](const EdgeValue& value) {
            const Network::Variable& of = declared.of(value.variable);
            const Id<Symbol> then = declared.draft.add(declared.slots.name(value.variable) + "_then", of.type,
                                                       System::DefineSymbol{value.term}, "within a step");
            if (of.scratch && of.role == Network::Role::FiringCondition) within.emplace_back(value.variable, then);
            return declared.draft.leaf(then);
        };
        EdgeTerms terms = edge_terms(declared.slots, edge, declared.symbols, declared.draft, name);
        if (clocks) terms.guard = exprs.conjunction(terms.guard, clocks->admit(edge));
        taken.guards.push_back(exprs.conjunction(declared.at(edge.from), terms.guard));
        for (const EdgeValue& value : terms.values) taken.values[value.variable].emplace_back(id, value.term);
        if (!is_false(exprs, terms.guard_fault))
            taken.faults.push_back(exprs.conjunction(declared.at(edge.from), terms.guard_fault));
        if (!is_false(exprs, terms.fault)) taken.faults.push_back(exprs.conjunction(declared.takes(id), terms.fault));
    }
    return taken;
}

// -- next values ------------------------------------------------------------------------------------------------------

void set_location(const Declared& declared) {
    const Id<Symbol> location = declared.made.location;
    if (!location.valid()) return;
    std::vector<std::pair<Edge, Id<Expr>>> cases;
    for (const Edge id : declared.automaton().edges.ids())
        if (const Network::Edge& edge = declared.automaton().edges[id]; edge.from != edge.to)
            cases.emplace_back(id, declared.draft.exprs.integer(edge.to.index));
    const Id<Expr> initial = declared.draft.exprs.integer(declared.slots.process.initial.index);
    declared.draft.set(location, System::StateSymbol{initial, declared.by_edge(cases, declared.draft.leaf(location))});
}

/// Returns the value that the location determines: `location = a | location = b` for a Boolean, a case distinction over
/// the locations for an integer.
Id<Expr> by_location(const Declared& declared, Type type, const std::vector<std::int64_t>& values) {
    Exprs& exprs = declared.draft.exprs;
    std::vector<Id<Expr>> on;
    Id<Expr> number = exprs.integer(values.front());
    for (std::uint32_t index = 0; index < values.size(); ++index) {
        if (type.boolean && values[index] != 0) on.push_back(declared.at({index}));
        number = exprs.conditional(declared.at({index}), exprs.integer(values[index]), number);
    }
    return type.boolean ? exprs.disjunction(on) : number;
}

void set_owned(const Declared& declared, Taken& taken) {
    for (const auto& [variable, symbol] : declared.made.owned) {
        const Network::Variable& of = declared.of(variable);
        if (const auto known = location_values(declared.slots, variable)) {
            declared.draft.set(symbol, System::DefineSymbol{by_location(declared, of.type, *known)});
            continue;
        }
        const Id<Expr> next = declared.by_edge(taken.values[variable], declared.draft.leaf(symbol));
        declared.draft.set(symbol, System::StateSymbol{literal(declared.draft.exprs, of.type, of.initial), next});
    }
}

std::vector<Effect> effects(const Declared& declared, Taken& taken) {
    constexpr const char* heading = "its assignments to shared variables";
    std::vector<Effect> effects;
    for (const Place variable : declared.written) {
        const Network::Variable& of = declared.of(variable);
        if (declared.owns(variable) || of.scratch) continue;
        std::vector<Id<Expr>> writes;
        for (const auto& [edge, value] : taken.values[variable]) writes.push_back(declared.takes(edge));
        const std::string name = declared.slots.name(variable);
        const Id<Symbol> written =
            declared.draft.define(name + "_written", declared.draft.exprs.disjunction(writes), heading);
        const Id<Expr> value =
            declared.by_edge(taken.values[variable], literal(declared.draft.exprs, of.type, of.type.low));
        effects.push_back(
            {variable, written, declared.draft.add(name + "_value", of.type, System::DefineSymbol{value}, heading)});
    }
    return effects;
}

/// Adds a flag that remains set after a fault. The result is invalid if no fault is possible.
Id<Symbol> out_of_range(Draft& draft, std::vector<Id<Expr>> faults) {
    if (faults.empty()) return {};
    const Id<Symbol> flag = draft.add("out_of_range", Type{}, System::StateSymbol{});
    faults.insert(faults.begin(), draft.leaf(flag));
    draft.set(flag, System::StateSymbol{draft.exprs.constant(false), draft.exprs.disjunction(faults)});
    return flag;
}

// -- choice of the edge -----------------------------------------------------------------------------------------------

/// Constrains the choice by the guards of the edges and the discipline. For Discipline::Rounds, also adds `done`.
void add_transitions(const Declared& declared, const std::vector<Id<Expr>>& guards, AutomatonModule& made) {
    Draft& draft = declared.draft;
    Exprs& exprs = draft.exprs;
    std::vector<Id<Expr>>& list = draft.module.transitions;
    const Id<Expr> stays = draft.leaf(made.stays), idle = exprs.negation(draft.leaf(made.must_move));
    const bool rounds = declared.context.discipline == Discipline::Rounds;
    for (const Edge id : declared.automaton().edges.ids()) {
        Id<Expr> guard = guards[id.index];
        if (rounds && !declared.automaton().edges[id].urgent) guard = exprs.conjunction(draft.leaf(made.first), guard);
        list.push_back(implies(exprs, declared.takes(id), guard));
    }
    if (declared.context.discipline == Discipline::Together) list.push_back(implies(exprs, stays, idle));
    if (declared.context.discipline == Discipline::Turns)
        list.push_back(exprs.apply(Op::NotEqual, stays, draft.leaf(made.turn)));
    if (!rounds) return;
    made.done = draft.add("done", Type{}, System::StateSymbol{}, "true if the automaton has moved in this round");
    const Id<Expr> turn = draft.leaf(made.turn), done = draft.leaf(made.done);
    const Id<Expr> had = exprs.conjunction(draft.leaf(made.round), exprs.disjunction(done, turn));
    draft.set(made.done, System::StateSymbol{exprs.constant(false), had});
    list.push_back(implies(exprs, turn, exprs.negation(done)));
    list.push_back(implies(exprs, exprs.negation(turn), stays));
    list.push_back(implies(exprs, exprs.conjunction(turn, stays), idle));
}

/// Returns one Movement for each location with an invariant: the movement is in progress while the automaton is in this
/// location, and terminates because the invariant bounds the time in the location.
std::vector<Movement> movements(const Declared& declared) {
    Draft& draft = declared.draft;
    std::vector<Movement> found;
    for (const Id<Network::Location> id : declared.automaton().locations.ids()) {
        const auto& [name, invariant, origin] = declared.automaton().locations[id];
        if (invariant.empty()) continue;
        std::vector<Id<Expr>> again;
        for (const Edge edge : declared.automaton().edges.ids()) {
            const Network::Edge& of = declared.automaton().edges[edge];
            if (of.from == id && of.to == id && !of.urgent) again.push_back(declared.takes(edge));
        }
        Movement movement{draft.define("is_" + name, declared.at(id), "movements"), {}};
        if (!again.empty())
            movement.ended = draft.add(name + "_ended", Type{},
                                       System::StateSymbol{draft.exprs.constant(false), draft.exprs.disjunction(again)},
                                       "movements");
        found.push_back(movement);
    }
    return found;
}

}  // namespace

std::vector<std::int64_t> module_key(const AutomatonContext& context, Id<Network::Process> process) {
    const Slots slots(context.network, process);
    std::vector<std::int64_t> key{slots.process.automaton.index, slots.process.initial.index};
    for (const Network::Argument& argument : slots.process.arguments)
        if (const auto* constant = std::get_if<std::int64_t>(&argument)) key.push_back(*constant);
    std::map<Place, std::int64_t> seen;  // a number for each variable, in the order of the arguments
    for (const Place variable : slots.used()) {
        const Network::Variable& of = context.network.variables[variable];
        key.push_back(of.type.low);
        key.push_back(of.type.high);
        key.push_back(context.shared[variable.index] ? 1 : 0);
    }
    for (const Network::Argument& argument : slots.process.arguments)
        if (const auto* variable = std::get_if<Place>(&argument))
            key.push_back(seen.emplace(*variable, static_cast<std::int64_t>(seen.size())).first->second);
    for (const Place variable : slots.written()) key.push_back(context.network.variables[variable].initial);
    return key;
}

AutomatonModule automaton_module(const AutomatonContext& context, Id<Network::Process> process, Exprs& exprs) {
    Draft draft{exprs};
    const Declared declared(context, process, draft);
    AutomatonModule made = declared.made;
    std::optional<Clocks> clocks;
    if (declared.counts()) clocks.emplace(declared, process);
    Taken taken = edges_taken(declared, clocks, made.within);

    set_location(declared);
    if (clocks) {
        if (const std::vector<Id<Expr>> waits = clocks->wait(); !waits.empty())
            made.may_wait = draft.define("may_wait", exprs.conjunction(waits), "true if a unit of time can pass");
        for (const Id<Network::Clock> id : declared.automaton().clocks.ids())
            if (const Id<Symbol> clock = declared.clocks[id.index]; clock.valid())
                draft.set(clock, System::StateSymbol{exprs.integer(0), clocks->next(id)});
    }
    set_owned(declared, taken);
    made.effects = effects(declared, taken);

    std::vector<Id<Expr>> urgent;
    for (const Edge id : declared.automaton().edges.ids())
        if (declared.automaton().edges[id].urgent) urgent.push_back(taken.guards[id.index]);
    if (clocks)
        made.can_move = draft.define("can_move", exprs.disjunction(taken.guards), "true if an edge can be taken");
    made.must_move = draft.define("must_move", exprs.disjunction(urgent), "true if an urgent edge can be taken");
    made.stays = draft.define("stays", draft.is(made.edge, 0), "true if the automaton takes no edge");
    made.out_of_range = out_of_range(draft, std::move(taken.faults));
    add_transitions(declared, taken.guards, made);
    if (context.fairness) made.movements = movements(declared);
    made.module = std::move(draft.module);
    return made;
}

}  // namespace grafverif::schedule
