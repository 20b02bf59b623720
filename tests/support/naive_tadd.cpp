// SPDX-License-Identifier: MIT
#include "support/naive_tadd.hpp"

#include <algorithm>
#include <deque>
#include <stdexcept>

#include "plant/plant.hpp"

namespace grafverif {

namespace {

bool related(std::int64_t clock, Op relation, std::int64_t bound) {
    switch (relation) {
    case Op::Less: return clock < bound;
    case Op::LessEqual: return clock <= bound;
    case Op::Equal: return clock == bound;
    case Op::GreaterEqual: return clock >= bound;
    case Op::Greater: return clock > bound;
    default: throw std::logic_error("not a clock relation");
    }
}

std::int64_t largest_constant(const Network& network) {
    std::int64_t largest = 0;
    for (const Network::Process& process : network.processes) {
        const auto note = [&](const std::vector<Network::ClockConstraint>& constraints) {
            for (const Network::ClockConstraint& constraint : constraints)
                largest = std::max(largest, bound_value(network, process, constraint.bound));
        };
        const Network::Template& automaton = network.templates[process.automaton];
        for (const Network::Location& location : automaton.locations) note(location.invariant);
        for (const Network::Edge& edge : automaton.edges) note(edge.constraint);
    }
    return largest;
}

}  // namespace

NaiveTadd::NaiveTadd(const Network& network) : network_(network), cap_(largest_constant(network) + 1) {
    for (const Network::Process& process : network.processes) {
        first_clock_.push_back(clocks_);
        clocks_ += network.templates[process.automaton].clocks.size();
    }
    for (const Network::Template& automaton : network.templates) {
        leaving_.emplace_back(automaton.locations.size());
        for (const Id<Network::Edge> edge : automaton.edges.ids())
            leaving_.back()[automaton.edges[edge].from.index].push_back(edge);
    }
}

TaddState NaiveTadd::initial() const {
    TaddState state;
    for (const Network::Process& process : network_.processes) state.locations.push_back(process.initial.index);
    for (const Network::Variable& variable : network_.variables)
        state.variables.push_back(variable.scratch ? 0 : variable.initial);
    state.clocks.resize(clocks_);
    return state;
}

std::optional<std::int64_t> NaiveTadd::value(Id<Expr> root, const TaddState& state,
                                             const Network::Process* process) const {
    return evaluate(network_.exprs, root, [&](const Expr& leaf) -> std::int64_t {
        if (leaf.op == Op::At) return state.locations[at_process(leaf)] == at_location(leaf);
        if (leaf.op == Op::Variable) return state.variables[static_cast<std::size_t>(leaf.value)];
        const Network::Argument& argument = process->arguments[static_cast<std::size_t>(leaf.value)];
        const auto* variable = std::get_if<Id<Network::Variable>>(&argument);
        return variable ? state.variables[variable->index] : std::get<std::int64_t>(argument);
    });
}

bool NaiveTadd::satisfied(const std::vector<Network::ClockConstraint>& constraints, Id<Network::Process> process,
                          const TaddState& state) const {
    return std::ranges::all_of(constraints, [&](const Network::ClockConstraint& constraint) {
        const std::int64_t bound = bound_value(network_, network_.processes[process], constraint.bound);
        return related(state.clocks[first_clock_[process.index] + constraint.clock.index], constraint.relation, bound);
    });
}

bool NaiveTadd::invariants_hold(const TaddState& state) const {
    return std::ranges::all_of(network_.processes.ids(), [&](Id<Network::Process> process) {
        const Network::Template& automaton = network_.templates[network_.processes[process].automaton];
        return satisfied(automaton.locations[{state.locations[process.index]}].invariant, process, state);
    });
}

bool NaiveTadd::guard_holds(Id<Network::Process> process, const Network::Edge& edge, const TaddState& state) const {
    return value(edge.guard, state, &network_.processes[process]).value_or(0) != 0 &&
           satisfied(edge.constraint, process, state);
}

bool NaiveTadd::assign(const std::vector<Network::Assignment>& assignments, const Network::Process& process,
                       TaddState& state) const {
    return std::ranges::all_of(assignments, [&](const Network::Assignment& assignment) {
        const Expr& target = network_.exprs[assignment.target];
        const auto index = static_cast<std::uint32_t>(target.value);
        const Id<Network::Variable> variable = target.op == Op::Variable
                                                   ? Id<Network::Variable>{index}
                                                   : std::get<Id<Network::Variable>>(process.arguments[index]);
        const auto result = value(assignment.value, state, &process);
        const Type& type = network_.variables[variable].type;
        if (!result || *result < type.low || *result > type.high) return false;
        state.variables[variable.index] = *result;
        return true;
    });
}

/// Executes an edge according to CEP13, equation (10).
std::optional<TaddMove> NaiveTadd::fire(Id<Network::Process> id, Id<Network::Edge> edge_id,
                                        const TaddState& state) const {
    const Network::Process& process = network_.processes[id];
    const Network::Template& automaton = network_.templates[process.automaton];
    const Network::Edge& edge = automaton.edges[edge_id];
    if (!guard_holds(id, edge, state)) return {};
    TaddMove move{id, edge_id, state, false};
    for (const Id<Network::Clock> clock : edge.resets) move.next.clocks[first_clock_[id.index] + clock.index] = 0;
    move.next.locations[id.index] = edge.to.index;
    if (!invariants_hold(move.next)) return {};
    bool well = assign(edge.assignments, process, move.next);
    for (const Id<Network::Procedure> call : edge.calls)
        well = well && assign(automaton.procedures[call].assignments, process, move.next);
    move.out_of_range = !well;
    for (const Id<Network::Variable> variable : network_.variables.ids())
        if (network_.variables[variable].scratch) move.next.variables[variable.index] = 0;
    return move;
}

bool NaiveTadd::urgent_enabled(const TaddState& state) const {
    return std::ranges::any_of(network_.processes.ids(), [&](Id<Network::Process> id) {
        const Id<Network::Template> automaton = network_.processes[id].automaton;
        return std::ranges::any_of(leaving_[automaton.index][state.locations[id.index]], [&](Id<Network::Edge> edge) {
            return network_.templates[automaton].edges[edge].urgent && fire(id, edge, state).has_value();
        });
    });
}

std::vector<TaddMove> NaiveTadd::successors(const TaddState& state) const {
    std::vector<TaddMove> moves;
    bool urgent = false;
    for (const Id<Network::Process> id : network_.processes.ids()) {
        const Id<Network::Template> automaton = network_.processes[id].automaton;
        for (const Id<Network::Edge> edge : leaving_[automaton.index][state.locations[id.index]]) {
            auto move = fire(id, edge, state);
            if (!move) continue;
            urgent = urgent || network_.templates[automaton].edges[edge].urgent;
            moves.push_back(std::move(*move));
        }
    }
    if (urgent) return moves;
    TaddMove delay{{}, {}, state, false};  // implements CEP13 equation (9) for one unit of time
    for (std::int64_t& clock : delay.next.clocks) clock = std::min(clock + 1, cap_);
    if (invariants_hold(delay.next)) moves.push_back(std::move(delay));
    return moves;
}

Id<Network::Variable> NaiveTadd::variable_id(const std::string& name) const {
    for (const Id<Network::Variable> id : network_.variables.ids())
        if (network_.variables[id].name == name) return id;
    throw std::out_of_range("unknown variable " + name);
}

std::int64_t NaiveTadd::variable(const TaddState& state, const std::string& name) const {
    return state.variables[variable_id(name).index];
}

std::string NaiveTadd::location(const TaddState& state, const std::string& process) const {
    for (const Id<Network::Process> id : network_.processes.ids()) {
        if (network_.processes[id].name != process) continue;
        return network_.templates[network_.processes[id].automaton].locations[{state.locations[id.index]}].name;
    }
    throw std::out_of_range("unknown process " + process);
}

Reachable reachable(const Network& network, std::size_t limit) {
    const NaiveTadd tadd(network);
    Reachable result;
    std::deque<TaddState> open{tadd.initial()};
    result.states.insert(open.front());
    for (; !open.empty() && result.states.size() < limit; open.pop_front()) {
        for (TaddMove& move : tadd.successors(open.front())) {
            result.out_of_range = result.out_of_range || move.out_of_range;
            if (!move.out_of_range && result.states.insert(move.next).second) open.push_back(std::move(move.next));
        }
    }
    result.complete = open.empty();
    return result;
}

Bench::Bench(Network network) : network_(std::move(network)), tadd_(network_) {
    states_.insert(tadd_.initial());
    rest();
}

void Bench::rest() {
    std::set<TaddState> seen = states_;
    std::deque<TaddState> open(states_.begin(), states_.end());
    states_.clear();
    for (; !open.empty(); open.pop_front()) {
        for (TaddMove& move : tadd_.successors(open.front())) {
            if (move.out_of_range) throw std::out_of_range("a variable left its range");
            if (move.delay()) states_.insert(open.front());
            else if (seen.insert(move.next).second) open.push_back(std::move(move.next));
        }
    }
}

void Bench::set(const std::string& variable, std::int64_t value) {
    const Id<Network::Variable> id = tadd_.variable_id(variable);
    std::set<TaddState> changed;
    for (TaddState state : states_) {
        state.variables[id.index] = value;
        changed.insert(std::move(state));
    }
    states_ = std::move(changed);
    rest();
}

void Bench::wait(std::int64_t units) {
    for (; units > 0; --units) {
        std::set<TaddState> later;
        for (const TaddState& state : states_)
            for (TaddMove& move : tadd_.successors(state))
                if (move.delay()) later.insert(std::move(move.next));
        states_ = std::move(later);
        rest();
    }
}

std::set<std::int64_t> Bench::values(const std::string& variable) const {
    std::set<std::int64_t> found;
    for (const TaddState& state : states_) found.insert(tadd_.variable(state, variable));
    return found;
}

std::set<std::string> Bench::locations(const std::string& process) const {
    std::set<std::string> found;
    for (const TaddState& state : states_) found.insert(tadd_.location(state, process));
    return found;
}

namespace {

/// Returns a constant of a component: the given value, or its default, which may depend on other constants.
std::int64_t constant(const Component& component, const std::map<std::string, std::int64_t>& given,
                      std::uint32_t index) {
    const Component::Parameter& parameter = component.parameters[{index}];
    if (const auto found = given.find(parameter.name); found != given.end()) return found->second;
    if (!parameter.initial) throw std::invalid_argument("no value for " + parameter.name);
    return evaluate(
               component.exprs, *parameter.initial,
               [&](const Expr& leaf) { return constant(component, given, static_cast<std::uint32_t>(leaf.value)); })
        .value();
}

Type type_of(const Component& component, const std::map<std::string, std::int64_t>& given,
             const Component::Parameter& parameter) {
    if (parameter.value == Component::ValueKind::Boolean) return {};
    const auto value = [&](std::optional<Id<Expr>> bound, std::int64_t otherwise) {
        if (!bound) return otherwise;
        return evaluate(
                   component.exprs, *bound,
                   [&](const Expr& leaf) { return constant(component, given, static_cast<std::uint32_t>(leaf.value)); })
            .value();
    };
    return integer_type(value(parameter.low, least_integer), value(parameter.high, greatest_integer));
}

Id<Component::Location> location_named(const Component& component, const std::string& name) {
    for (const Id<Component::Location> id : component.locations.ids())
        if (component.locations[id].name == name) return id;
    if (!name.empty() || !component.initial.valid()) throw std::invalid_argument("no initial location");
    return component.initial;
}

}  // namespace

Network lone_component(const Component& component, const std::map<std::string, std::int64_t>& constants,
                       const std::string& initially) {
    Model model;
    ClosedLoop loop;
    loop.name = component.name;
    ClosedLoop::Instance instance{
        .name = "it", .component = model.components.add(component), .initial = location_named(component, initially)};
    for (const Id<Component::Parameter> id : component.parameters.ids()) {
        const Component::Parameter& parameter = component.parameters[id];
        if (parameter.kind == Component::ParameterKind::Constant)
            instance.arguments.push_back(constant(component, constants, id.index));
        else
            instance.arguments.push_back(
                loop.shared.add({.name = parameter.name, .type = type_of(component, constants, parameter)}));
    }
    loop.instances.add(std::move(instance));
    Diagnostics diagnostics;
    auto network = plant(model, loop, diagnostics);
    if (!network) throw std::invalid_argument(diagnostics.all().front().message);
    return std::move(*network);
}

}  // namespace grafverif
