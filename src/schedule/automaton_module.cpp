// SPDX-License-Identifier: MIT
#include "schedule/plant_instances.hpp"

#include <algorithm>
#include <map>

#include "schedule/automaton_edges.hpp"
#include "support/unique_names.hpp"

namespace grafverif::schedule {

namespace {

using System = TransitionSystem;
using Place = Id<Network::Variable>;

class AutomatonBuilder {
public:
    AutomatonBuilder(const AutomatonContext& context, Id<Network::Process> process, Exprs& exprs)
        : context_(context), process_(process), slots_(context.network, process), exprs_(exprs),
          symbols_(context.network.variables.size()) {}

    AutomatonModule build() {
        result_.module.name = slots_.automaton.name;
        add_parameters();
        add_choice();
        add_location();
        add_clocks();
        add_owned();
        for (const Id<Network::Edge> edge : slots_.automaton.edges.ids()) add_edge(edge);
        set_location();
        set_clocks();
        set_variables();
        set_definitions();
        set_fault();
        set_transitions();
        if (context_.fairness) add_movements();
        return std::move(result_);
    }

private:
    const Network& network() const { return context_.network; }
    const Network::Template& automaton() const { return slots_.automaton; }
    Id<Expr> leaf(Id<Symbol> symbol) { return exprs_.leaf(Op::Variable, symbol.index); }

    Id<Symbol> add(const std::string& wish, Type type, const char* section, decltype(Symbol::kind) kind,
                   std::vector<std::string> values = {}) {
        return result_.module.symbols.add({names_.fresh(wish), type, std::move(kind), section, {}, std::move(values)});
    }
    Id<Symbol> define(const std::string& wish, Id<Expr> value, const char* section = "") {
        return add(wish, {}, section, System::DefineSymbol{value});
    }

    bool owns(Place variable) const {
        return !context_.shared[variable.index] && !network().variables[variable].scratch;
    }

    void add_parameters() {
        const auto parameter = [&](const char* name) { return add(name, {}, "", System::ParameterSymbol{}); };
        if (context_.discipline != Discipline::Together) result_.turn = parameter("turn");
        if (context_.discipline == Discipline::Rounds) {
            result_.first = parameter("first");
            result_.round = parameter("round");
        }
        if (is_discrete() && !automaton().clocks.empty()) result_.tick = parameter("tick");
        const std::vector<Place> written = slots_.written();
        for (const Place variable : slots_.read()) {
            const Network::Variable& of = network().variables[variable];
            const bool own = owns(variable) && std::ranges::find(written, variable) != written.end();
            if (own || of.scratch) continue;
            symbols_[variable.index] = add(slots_.name(variable), of.type, "", System::ParameterSymbol{});
            result_.reads.push_back(variable);
        }
    }

    std::string edge_name(const Network::Edge& edge) const {
        return automaton().locations[edge.from].name + "_to_" + automaton().locations[edge.to].name;
    }

    void add_choice() {
        UniqueNames labels;
        std::vector<std::string> values{labels.fresh("stay")};
        for (const Network::Edge& edge : automaton().edges) values.push_back(labels.fresh(edge_name(edge)));
        const Type type = integer_type(0, static_cast<std::int64_t>(values.size()) - 1);
        result_.edge = add("edge", type, "the edge taken in a step", System::ChoiceSymbol{}, std::move(values));
    }

    void add_location() {
        if (automaton().locations.size() == 1) return;
        std::vector<std::string> values;
        for (const Network::Location& location : automaton().locations) values.push_back(location.name);
        const Type type = integer_type(0, static_cast<std::int64_t>(values.size()) - 1);
        result_.location = add("location", type, "", System::StateSymbol{}, std::move(values));
    }

    Id<Expr> at(Id<Network::Location> location) {
        if (!result_.location.valid()) return exprs_.constant(true);
        return exprs_.apply(Op::Equal, leaf(result_.location), exprs_.integer(location.index));
    }
    Id<Expr> takes(Id<Network::Edge> edge) {
        return exprs_.apply(Op::Equal, leaf(result_.edge), exprs_.integer(edge.index + 1));
    }
    Id<Expr> constant(Type type, std::int64_t value) {
        return type.boolean ? exprs_.constant(value != 0) : exprs_.integer(value);
    }

    void add_owned() {
        for (const Place variable : slots_.written()) {
            if (!owns(variable)) continue;
            const Network::Variable& of = network().variables[variable];
            symbols_[variable.index] = add(slots_.name(variable), of.type, "", System::StateSymbol{});
            result_.owned.emplace_back(variable, symbols_[variable.index]);
        }
    }

    void add_edge(Id<Network::Edge> id) {
        const Network::Edge& edge = automaton().edges[id];
        EdgeTerms terms = edge_terms(slots_, edge, symbols_, result_.module.symbols, exprs_, [&](const EdgeValue& value) {
            const Network::Variable& of = network().variables[value.variable];
            const Id<Symbol> then = add(slots_.name(value.variable) + "_then", of.type, "within a step",
                                        System::DefineSymbol{value.term});
            if (of.scratch && of.role == Network::Role::FiringCondition)
                result_.within.emplace_back(value.variable, then);
            return leaf(then);
        });
        if (is_discrete()) terms.guard = exprs_.conjunction(terms.guard, clocks_admit(edge));
        guards_.push_back(exprs_.conjunction(at(edge.from), terms.guard));
        for (const EdgeValue& value : terms.values) values_[value.variable].emplace_back(id, value.term);
        if (!is_false(exprs_, terms.guard_fault))
            faults_.push_back(exprs_.conjunction(at(edge.from), terms.guard_fault));
        if (!is_false(exprs_, terms.fault))
            faults_.push_back(exprs_.conjunction(takes(id), terms.fault));
    }

    // -- clocks that count -----------------------------------------------------------------------------------------

    bool is_discrete() const { return !context_.clocks.empty(); }
    const ProcessClocks& caps() const { return context_.clocks[process_.index]; }

    void add_clocks() {
        clocks_.resize(automaton().clocks.size());
        if (!is_discrete()) return;
        for (const Id<Network::Clock> id : automaton().clocks.ids()) {
            const std::int64_t greatest = caps().greatest[id.index];
            if (greatest <= 0) continue;
            clocks_[id.index] = add(automaton().clocks[id].name, integer_type(0, greatest), "clocks, in units of time",
                                    System::StateSymbol{});
        }
    }

    Id<Expr> clock(Id<Network::Clock> id) {
        return clocks_[id.index].valid() ? leaf(clocks_[id.index]) : exprs_.integer(0);
    }
    bool resets(const Network::Edge& edge, Id<Network::Clock> id) const {
        return std::ranges::find(edge.resets, id) != edge.resets.end();
    }

    /// The values that a constraint admits, under the arguments of the process.
    ClockInterval interval_of(const Network::ClockConstraint& constraint) const {
        return admitted(constraint.relation, bound_value(network(), slots_.process, constraint.bound));
    }
    Id<Expr> admits(const ClockInterval& interval, Id<Expr> value) {
        const Id<Expr> low = interval.low <= 0 ? exprs_.constant(true)
                                               : exprs_.apply(Op::GreaterEqual, value, exprs_.integer(interval.low));
        const Id<Expr> high = interval.high >= ClockInterval::unbounded
                                  ? exprs_.constant(true)
                                  : exprs_.apply(Op::LessEqual, value, exprs_.integer(interval.high));
        return exprs_.conjunction(low, high);
    }

    /// The constraint of an edge, and the invariant of its target after its resets.
    Id<Expr> clocks_admit(const Network::Edge& edge) {
        std::vector<Id<Expr>> all;
        for (const Network::ClockConstraint& constraint : edge.constraint)
            all.push_back(admits(interval_of(constraint), clock(constraint.clock)));
        for (const Network::ClockConstraint& bound : automaton().locations[edge.to].invariant)
            all.push_back(
                admits(interval_of(bound), resets(edge, bound.clock) ? exprs_.integer(0) : clock(bound.clock)));
        return exprs_.conjunction(all);
    }

    /// What an edge leaves in a clock: no more than its target compares it with.
    Id<Expr> clock_after(const Network::Edge& edge, Id<Network::Clock> id) {
        const std::int64_t cap = caps().cap[edge.to.index][id.index];
        if (resets(edge, id) || cap <= 0) return exprs_.integer(0);
        if (caps().cap[edge.from.index][id.index] <= cap) return clock(id);
        return exprs_.conditional(exprs_.apply(Op::Greater, clock(id), exprs_.integer(cap)), exprs_.integer(cap),
                                  clock(id));
    }

    /// One more, up to the cap of each location.
    Id<Expr> clock_after_tick(Id<Network::Clock> id) {
        const Id<Expr> more = exprs_.apply(Op::Plus, clock(id), exprs_.integer(1));
        std::map<std::int64_t, std::vector<Id<Expr>>> locations;   // by cap
        for (const Id<Network::Location> location : automaton().locations.ids())
            locations[caps().cap[location.index][id.index]].push_back(at(location));
        Id<Expr> next = clock(id);
        for (const auto& [cap, where] : locations) {
            if (cap <= 0) continue;
            const Id<Expr> below = exprs_.apply(Op::Less, clock(id), exprs_.integer(cap));
            next = exprs_.conditional(exprs_.conjunction(exprs_.disjunction(where), below), more, next);
        }
        return next;
    }

    void set_clocks() {
        if (!is_discrete()) return;
        std::vector<Id<Expr>> waits;
        for (const Id<Network::Location> id : automaton().locations.ids())
            for (const Network::ClockConstraint& bound : automaton().locations[id].invariant)
                waits.push_back(implies(at(id), admits({0, interval_of(bound).high - 1}, clock(bound.clock))));
        if (!waits.empty())
            result_.may_wait = define("may_wait", exprs_.conjunction(waits), "whether a unit of time can pass");
        for (const Id<Network::Clock> id : automaton().clocks.ids()) {
            if (!clocks_[id.index].valid()) continue;
            Id<Expr> next = exprs_.conditional(leaf(result_.tick), clock_after_tick(id), clock(id));
            for (std::size_t k = automaton().edges.size(); k-- > 0;) {
                const Id<Network::Edge> edge{static_cast<std::uint32_t>(k)};
                const Id<Expr> after = clock_after(automaton().edges[edge], id);
                if (after != clock(id)) next = exprs_.conditional(takes(edge), after, next);
            }
            result_.module.symbols[clocks_[id.index]].kind = System::StateSymbol{exprs_.integer(0), next};
        }
    }

    // -- values ------------------------------------------------------------------------------------------------------

    void set_location() {
        if (!result_.location.valid()) return;
        Id<Expr> next = leaf(result_.location);
        for (std::size_t k = automaton().edges.size(); k-- > 0;) {
            const Id<Network::Edge> id{static_cast<std::uint32_t>(k)};
            const Network::Edge& edge = automaton().edges[id];
            if (edge.from != edge.to) next = exprs_.conditional(takes(id), exprs_.integer(edge.to.index), next);
        }
        result_.module.symbols[result_.location].kind =
            System::StateSymbol{exprs_.integer(slots_.process.initial.index), next};
    }

    void set_variables() {
        for (const auto& [variable, symbol] : result_.owned) {
            const Network::Variable& of = network().variables[variable];
            if (const auto known = location_values(slots_, variable)) {
                result_.module.symbols[symbol].kind = System::DefineSymbol{by_location(of.type, *known)};
                continue;
            }
            result_.module.symbols[symbol].kind =
                System::StateSymbol{constant(of.type, of.initial), by_edge(variable, leaf(symbol))};
        }
        for (const Place variable : slots_.written())
            if (!owns(variable) && !network().variables[variable].scratch) add_effect(variable);
    }

    /// `location = a | location = b` for a Boolean, cases for a number.
    Id<Expr> by_location(Type type, const std::vector<std::int64_t>& values) {
        std::vector<Id<Expr>> on;
        Id<Expr> number = exprs_.integer(values.front());
        for (std::uint32_t index = 0; index < values.size(); ++index) {
            if (type.boolean && values[index] != 0) on.push_back(at({index}));
            number = exprs_.conditional(at({index}), exprs_.integer(values[index]), number);
        }
        return type.boolean ? exprs_.disjunction(on) : number;
    }

    Id<Expr> by_edge(Place variable, Id<Expr> kept) {
        Id<Expr> next = kept;
        const auto& values = values_[variable];
        for (auto value = values.rbegin(); value != values.rend(); ++value)
            next = exprs_.conditional(takes(value->first), value->second, next);
        return next;
    }

    void add_effect(Place variable) {
        const Network::Variable& of = network().variables[variable];
        std::vector<Id<Expr>> writes;
        for (const auto& [edge, value] : values_[variable]) writes.push_back(takes(edge));
        const std::string name = slots_.name(variable);
        AutomatonModule::Effect effect{variable, {}, {}};
        effect.writes = define(name + "_written", exprs_.disjunction(writes), "what it does to variables of all");
        const Id<Expr> value = by_edge(variable, constant(of.type, of.type.low));
        effect.value = add(name + "_value", of.type, "what it does to variables of all", System::DefineSymbol{value});
        result_.effects.push_back(effect);
    }

    void set_definitions() {
        std::vector<Id<Expr>> any, urgent;
        for (const Id<Network::Edge> id : automaton().edges.ids()) {
            any.push_back(guards_[id.index]);
            if (automaton().edges[id].urgent) urgent.push_back(guards_[id.index]);
        }
        if (is_discrete())
            result_.can_move = define("can_move", exprs_.disjunction(any), "whether an edge can be taken");
        result_.must_move = define("must_move", exprs_.disjunction(urgent), "whether an urgent edge can be taken");
        result_.stays = define("stays", exprs_.apply(Op::Equal, leaf(result_.edge), exprs_.integer(0)), "");
    }

    void set_fault() {
        if (faults_.empty()) return;
        result_.out_of_range = add("out_of_range", {}, "", System::StateSymbol{});
        faults_.insert(faults_.begin(), leaf(result_.out_of_range));
        result_.module.symbols[result_.out_of_range].kind =
            System::StateSymbol{exprs_.constant(false), exprs_.disjunction(faults_)};
    }

    Id<Expr> implies(Id<Expr> condition, Id<Expr> then) {
        return exprs_.disjunction(exprs_.negation(condition), then);
    }

    void set_transitions() {
        std::vector<Id<Expr>>& list = result_.module.transitions;
        const Id<Expr> stays = leaf(result_.stays);
        for (const Id<Network::Edge> id : automaton().edges.ids()) {
            Id<Expr> guard = guards_[id.index];
            const bool urgent = automaton().edges[id].urgent;
            if (context_.discipline == Discipline::Rounds && !urgent)
                guard = exprs_.conjunction(leaf(result_.first), guard);
            list.push_back(implies(takes(id), guard));
        }
        const Id<Expr> idle = exprs_.negation(leaf(result_.must_move));
        switch (context_.discipline) {
        case Discipline::Together: list.push_back(implies(stays, idle)); break;
        case Discipline::Turns:
            list.push_back(exprs_.apply(Op::NotEqual, stays, leaf(result_.turn)));
            break;
        case Discipline::Rounds:
            add_done();
            list.push_back(implies(leaf(result_.turn), exprs_.negation(leaf(result_.done))));
            list.push_back(implies(exprs_.negation(leaf(result_.turn)), stays));
            list.push_back(implies(exprs_.conjunction(leaf(result_.turn), stays), idle));
            break;
        }
    }

    void add_done() {
        result_.done = add("done", {}, "whether it has had its turn in this round", System::StateSymbol{});
        const Id<Expr> had = exprs_.disjunction(leaf(result_.done), leaf(result_.turn));
        result_.module.symbols[result_.done].kind =
            System::StateSymbol{exprs_.constant(false), exprs_.conjunction(leaf(result_.round), had)};
    }

    /// A location that time must leave (it has an invariant), by an edge that time opens.
    void add_movements() {
        for (const Id<Network::Location> id : automaton().locations.ids()) {
            if (automaton().locations[id].invariant.empty()) continue;
            std::vector<Id<Expr>> again;
            for (const Id<Network::Edge> edge : automaton().edges.ids()) {
                const Network::Edge& of = automaton().edges[edge];
                if (of.from == id && of.to == id && !of.urgent) again.push_back(takes(edge));
            }
            const std::string& name = automaton().locations[id].name;
            Movement movement{name, define("is_" + name, at(id), "movements"), {}};
            if (!again.empty())
                movement.ended = add(name + "_ended", {}, "movements",
                                     System::StateSymbol{exprs_.constant(false), exprs_.disjunction(again)});
            result_.movements.push_back(movement);
        }
    }

    const AutomatonContext& context_;
    Id<Network::Process> process_;
    Slots slots_;
    Exprs& exprs_;
    AutomatonModule result_ = {};
    UniqueNames names_ = {};
    std::vector<Id<Symbol>> symbols_;             ///< per variable: what stands for it in the module
    std::vector<Id<Symbol>> clocks_ = {};         ///< per clock; not valid: it never matters
    std::vector<Id<Expr>> guards_ = {};           ///< per edge, its location included
    std::map<Place, std::vector<std::pair<Id<Network::Edge>, Id<Expr>>>> values_ = {};
    std::vector<Id<Expr>> faults_ = {};
};

}  // namespace

std::vector<std::int64_t> module_key(const AutomatonContext& context, Id<Network::Process> process) {
    const Slots slots(context.network, process);
    std::vector<std::int64_t> key{slots.process.automaton.index, slots.process.initial.index};
    for (const Network::Argument& argument : slots.process.arguments)
        if (const auto* constant = std::get_if<std::int64_t>(&argument)) key.push_back(*constant);
    std::map<Place, std::int64_t> seen;   // which arguments are one variable
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
    return AutomatonBuilder(context, process, exprs).build();
}

}  // namespace grafverif::schedule
