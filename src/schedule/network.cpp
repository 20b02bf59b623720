// SPDX-License-Identifier: MIT
#include "schedule/network.hpp"

#include <algorithm>
#include <cassert>

#include "schedule/observers.hpp"
#include "schedule/plant_instances.hpp"
#include "schedule/scope.hpp"
#include "schedule/slots.hpp"

namespace grafverif {

namespace {

using namespace schedule;
using System = TransitionSystem;

/// Which variables main holds: those that several processes write.
std::vector<bool> shared_variables(const Network& network) {
    std::vector<std::size_t> writers(network.variables.size());
    for (const Id<Network::Process> process : network.processes.ids())
        for (const Id<Network::Variable> variable : Slots(network, process).written()) ++writers[variable.index];
    std::vector<bool> shared;
    for (const std::size_t count : writers) shared.push_back(count > 1);
    return shared;
}

class LoopBuilder {
public:
    LoopBuilder(const Network& network, const ScheduleOptions& options)
        : network_(network),
          options_(options),
          context_{network, Discipline::Turns, shared_variables(network), options.fairness, clocks(network, options)} {}

    System build() {
        system_.name = network_.name;
        system_.main = system_.modules.add({"main", {}, {}, {}, {}});
        modules_.fresh("main");
        add_move();
        add_instances(plant_);
        add_turns();
        add_effects(plant_);
        add_offers();
        if (options_.fairness) add_fair_runs();
        add_watchers();
        add_questions();
        add_range_property(plant_);
        add_trace_names();
        return std::move(system_);
    }

private:
    static std::vector<ProcessClocks> clocks(const Network& network, const ScheduleOptions& options) {
        if (options.time == TimeModel::Abstract) return {};
        return analyse_clocks(expand(network));
    }
    bool is_discrete() const { return options_.time == TimeModel::Discrete; }

    System::Module& main() { return system_.modules[system_.main]; }
    Exprs& exprs() { return system_.exprs; }

    void add_move() {
        std::vector<std::string> values;
        for (const Network::Process& process : network_.processes) values.push_back("of_" + process.name);
        values.emplace_back("none");
        if (is_discrete()) values.emplace_back("of_time");
        move_ = main().symbols.add({names_.fresh("move"), integer_type(0, static_cast<std::int64_t>(values.size()) - 1),
                                    System::ChoiceSymbol{}, "who moves in a step", {}, std::move(values)});
    }

    Id<Expr> moves(std::size_t who) {
        return exprs().apply(Op::Equal, plant_.leaf(move_), exprs().integer(static_cast<std::int64_t>(who)));
    }

    void add_turns() {
        std::vector<Id<Symbol>> turns;
        for (std::size_t process = 0; process < network_.processes.size(); ++process) {
            const std::string& name = network_.processes[{static_cast<std::uint32_t>(process)}].name;
            turns.push_back(define(plant_, name + "_moves", moves(process), "turns"));
        }
        Id<Symbol> tick;
        if (is_discrete()) tick = define(plant_, "tick", moves(network_.processes.size() + 1), "turns");
        wire(plant_, {std::move(turns), {}, {}, tick});
        if (!is_discrete()) return;
        system_.ticks = plant_.leaf(tick);
        system_.tick_ms = network_.time_unit_ms;
    }

    Id<Expr> none_urgent() {
        return exprs().negation(exprs().disjunction(plant_.each(&AutomatonModule::must_move)));
    }

    Id<Expr> implies(Id<Expr> condition, Id<Expr> then) {
        return exprs().disjunction(exprs().negation(condition), then);
    }

    /// Abstract time: nobody need move where nothing is urgent. Discrete time: somebody moves, or time does, where
    /// anything can.
    void add_offers() {
        const Id<Expr> nobody = moves(network_.processes.size());
        if (!is_discrete()) {
            main().transitions.push_back(implies(nobody, none_urgent()));
            return;
        }
        std::vector<Id<Expr>> waits = plant_.each(&AutomatonModule::may_wait);
        waits.push_back(none_urgent());
        can_wait_ = exprs().conjunction(waits);
        can_move_ = exprs().disjunction(plant_.each(&AutomatonModule::can_move));
        main().transitions.push_back(implies(system_.ticks, can_wait_));
        main().transitions.push_back(
            implies(nobody, exprs().negation(exprs().disjunction(can_move_, can_wait_))));
    }

    /// Movements end, and time goes on: what is urgent is not put off for ever.
    void add_fair_runs() {
        add_fairness(plant_);
        main().justice.push_back(none_urgent());
    }

    /// A term of the network over the symbols of main.
    Id<Expr> term(Id<Expr> root) {
        return translate(network_.exprs, root, exprs(), [&](const Expr& leaf) {
            if (leaf.op == Op::Integer) return exprs().integer(leaf.value);
            if (leaf.op == Op::Variable)
                return plant_.leaf(plant_.variables[static_cast<std::size_t>(leaf.value)]);
            const std::uint32_t process = at_process(leaf), location = at_location(leaf);
            if (process >= network_.processes.size())
                return is_at(system_, observers_[process - network_.processes.size()], location);
            return plant_.at(process, location);
        });
    }

    void add_watchers() {
        for (const Network::Observer& observer : network_.observers)
            observers_.push_back(declare_observer(
                members_, {observer.name, observer.locations, observer.initial, observer.origin}, names_, modules_));
        for (const Id<Network::Observer> id : network_.observers.ids()) {
            std::vector<ObserverGuard> edges;
            for (const Network::ObserverEdge& edge : network_.observers[id].edges)
                edges.push_back({edge.from, edge.to, term(edge.guard)});
            watch(members_, observers_[id.index], edges);
        }
    }

    /// One `reachable` per step, in the order of the operands.
    void add_all_steps(const Property& property) {
        std::size_t k = 0;
        for (const Network::Controller& controller : network_.controllers) {
            const std::string chart = network_.controllers.size() > 1 ? controller.name + "." : "";
            for (const Network::Named& step : controller.steps) {
                Property one = property;
                const std::size_t dot = step.name.rfind('.');
                const std::size_t own = dot == std::string::npos ? 0 : dot + 1;
                one.name = property.name + "." + chart + step.name.substr(0, own) + "X" + step.name.substr(own);
                one.pattern = Pattern::Reachable;
                one.operands = {property.operands[k++]};
                system_.properties.add(std::move(one));
            }
        }
    }

    void add_question(const Property& from) {
        Property property = from;
        const bool of_time = from.pattern == Pattern::NoDeadlock || from.pattern == Pattern::NoTimelock;
        if (is_discrete() && of_time) {
            // Where no edge is enabled, time alone goes on until one is; so `possible` is `in the end`.
            property.pattern = Pattern::AlwaysPossible;
            property.operands = {from.pattern == Pattern::NoDeadlock ? can_move_ : can_wait_};
            system_.properties.add(std::move(property));
            return;
        }
        std::string reason = untimed_refusal(from.pattern);
        if (!reason.empty()) {
            property.operands.clear();
            system_.omitted.push_back({std::move(property), std::move(reason), system_.properties.size()});
            return;
        }
        for (Id<Expr>& operand : property.operands) operand = term(operand);
        if (property.pattern == Pattern::ReachableAllSteps) add_all_steps(property);
        else system_.properties.add(std::move(property));
    }

    void add_questions() {
        for (const Property& property : network_.properties) add_question(property);
        for (const Property& property : network_.observed) add_question(property);
        system_.settled = term(network_.settled);
        system_.scope = network_scope(network_, options_);
    }

    // -- what traces say -------------------------------------------------------------------------------------------

    /// In this step the PLC takes an edge that calls the procedure; not valid: there is no such procedure.
    Id<Expr> calls(const Network::Controller& controller, Id<Network::Procedure> procedure) {
        if (!procedure.valid()) return {};
        const Network::Template& cycle = network_.templates[network_.processes[controller.process].automaton];
        const Id<Expr> edge = plant_.inner(controller.process.index, plant_.automata[controller.process.index].edge);
        std::vector<Id<Expr>> found;
        for (const Id<Network::Edge> id : cycle.edges.ids())
            if (std::ranges::find(cycle.edges[id].calls, procedure) != cycle.edges[id].calls.end())
                found.push_back(exprs().apply(Op::Equal, edge, exprs().integer(id.index + 1)));
        return exprs().disjunction(found);
    }

    /// A firing condition that lives within a step is a definition of the PLC's module.
    Id<Symbol> firing(const Network::Controller& controller, Id<Network::Variable> variable) {
        for (const auto& [known, symbol] : plant_.automata[controller.process.index].within)
            if (known == variable) return member(members_, plant_.instances[controller.process.index], symbol);
        return plant_.variables[variable.index];
    }

    System::Controller named(const Network::Controller& controller) {
        System::Controller made{.name = controller.name, .mode = controller.mode};
        const auto in_main = [&](Id<Network::Variable> variable) { return plant_.variables[variable.index]; };
        for (const Network::Named& step : controller.steps) made.steps.push_back({step.name, in_main(step.variable)});
        for (const Network::Named& transition : controller.transitions)
            made.transitions.push_back({transition.name, firing(controller, transition.variable)});
        for (const Network::Symbol& symbol : controller.symbols) {
            if (symbol.role == Network::Role::Input) made.inputs.push_back({symbol.name, in_main(symbol.variable)});
            if (symbol.role == Network::Role::Output) made.outputs.push_back({symbol.name, in_main(symbol.variable)});
            if (symbol.role == Network::Role::Internal)
                made.internals.push_back({symbol.name, in_main(symbol.variable)});
        }
        for (const Network::TimerVariables& timer : controller.timing) {
            const auto step = std::ranges::find(controller.steps, timer.watched, &Network::Named::variable);
            std::optional<std::size_t> watched;
            if (step != controller.steps.end()) watched = static_cast<std::size_t>(step - controller.steps.begin());
            made.timers.push_back({in_main(timer.end), watched, timer.rise * network_.time_unit_ms,
                                   timer.fall * network_.time_unit_ms});
        }
        made.conditions = controller.conditions;
        made.starts = calls(controller, controller.start);
        made.samples = calls(controller, controller.fire);
        made.evolves = calls(controller, controller.evolve);
        made.writes = calls(controller, controller.write);
        return made;
    }

    void add_trace_names() {
        for (const Network::Controller& controller : network_.controllers)
            system_.controllers.push_back(named(controller));
        for (const Id<Network::Process> process : network_.processes.ids())
            if (network_.processes[process].kind != Network::ProcessKind::Controller)
                system_.components.push_back(plant_.component(process.index));
    }

    const Network& network_;
    const ScheduleOptions& options_;
    const AutomatonContext context_;
    System system_ = {};
    UniqueNames names_ = {}, modules_ = {};
    Members members_{system_, {}, {}};
    PlantInstances plant_{members_, context_, names_, modules_, {}, {}, {}};
    Id<Symbol> move_ = {};
    Id<Expr> can_move_ = {}, can_wait_ = {};   ///< of some process; of time: with clocks that count
    std::vector<ObserverInstance> observers_ = {};
};

}  // namespace

std::optional<TransitionSystem> schedule_network(const Network& network, const ScheduleOptions& options,
                                                 Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.errors();
    check_widths(network, diagnostics);
    if (diagnostics.errors() != errors) return {};
    TransitionSystem system = LoopBuilder(network, options).build();
    assert(verify(system).empty());
    return system;
}

}  // namespace grafverif
