// SPDX-License-Identifier: MIT
#include "schedule/network.hpp"

#include <algorithm>
#include <cassert>

#include "ir/words_of.hpp"
#include "schedule/observers.hpp"
#include "schedule/plant_instances.hpp"
#include "schedule/scope.hpp"
#include "schedule/slots.hpp"
#include "syntax/print/sentence.hpp"

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
    LoopBuilder(const Model& model, const ClosedLoop& loop, std::span<const Equations> equations,
                const Network& network, const ScheduleOptions& options)
        : model_(model), loop_(loop), equations_(equations), network_(network), options_(options),
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

    /// A variable of the network.
    Id<Symbol> in_main(Id<Network::Variable> variable) const { return plant_.variables[variable.index]; }

    LoopMeaning meaning() {
        return {.system = system_,
                .model = model_,
                .loop = loop_,
                .equations = equations_,
                .shared = {plant_.variables.begin(), plant_.variables.begin() + static_cast<std::ptrdiff_t>(loop_.shared.size())},
                .variable = [this](std::size_t controller, Id<Equations::Variable> variable) {
                    const Id<Network::Controller> id{static_cast<std::uint32_t>(controller)};
                    return in_main(network_.controllers[id].variables[variable.index]);
                },
                .at = [this](std::size_t process, std::uint32_t location) { return plant_.at(process, location); },
                .can_move = can_move_,
                .can_wait = can_wait_};
    }

    /// Those of the network first, then those that ask observers.
    void add_questions() {
        LoopMeaning known = meaning();
        add_observers(members_, known, names_, modules_);
        for (const Property& property : loop_.properties)
            if (!reads_observer(loop_, property)) add_property(known, property);
        for (const Property& constraint : constraints_to_prove(loop_)) add_property(known, constraint);
        if (network_.race.valid())
            add_never(system_, "no_race", "no two stored actions give one variable different values",
                      {plant_.leaf(in_main(network_.race))});
        for (const Property& property : loop_.properties)
            if (reads_observer(loop_, property)) add_property(known, property);
        system_.settled = translate(network_.exprs, network_.settled, exprs(), [this](const Expr& leaf) {
            if (leaf.op == Op::At) return plant_.at(at_process(leaf), at_location(leaf));
            return plant_.leaf(in_main({static_cast<std::uint32_t>(leaf.value)}));
        });
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

    System::Controller named(const Network::Controller& controller, const Equations& equations) {
        const auto place = [&](Id<Equations::Variable> id) {
            const Id<Network::Variable> variable = controller.variables[id.index];
            const bool fires = equations.variables[id].role == Equations::Role::FiringCondition;
            return fires ? firing(controller, variable) : in_main(variable);
        };
        return {.words = words_of<Symbol>(equations, controller.words.mode, place),
                .starts = calls(controller, controller.start),
                .samples = calls(controller, controller.fire),
                .evolves = calls(controller, controller.evolve),
                .writes = calls(controller, controller.write)};
    }

    void add_trace_names() {
        for (const Id<Network::Controller> id : network_.controllers.ids())
            system_.controllers.push_back(named(network_.controllers[id], equations_[id.index]));
        for (const Id<Network::Process> process : network_.processes.ids())
            if (network_.processes[process].kind != Network::ProcessKind::Controller)
                system_.components.push_back(plant_.component(process.index));
    }

    const Model& model_;
    const ClosedLoop& loop_;
    std::span<const Equations> equations_;
    const Network& network_;
    const ScheduleOptions& options_;
    const AutomatonContext context_;
    System system_ = {};
    UniqueNames names_ = {}, modules_ = {};
    Members members_{system_, {}, {}};
    PlantInstances plant_{members_, context_, names_, modules_, {}, {}, {}};
    Id<Symbol> move_ = {};
    Id<Expr> can_move_ = {}, can_wait_ = {};   ///< of some process; of time: with clocks that count
};

}  // namespace

std::optional<TransitionSystem> schedule_network(const Model& model, const ClosedLoop& loop,
                                                 std::span<const Equations> equations, const Network& network,
                                                 const ScheduleOptions& options, Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.errors();
    check_widths(network, diagnostics);
    if (diagnostics.errors() != errors) return {};
    TransitionSystem system = LoopBuilder(model, loop, equations, network, options).build();
    assert(verify(system).empty());
    return system;
}

}  // namespace grafverif
