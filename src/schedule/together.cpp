// SPDX-License-Identifier: MIT
#include "schedule/together.hpp"

#include <algorithm>
#include <cassert>
#include <optional>

#include "schedule/observers.hpp"
#include "schedule/scope.hpp"
#include "schedule/sequencer.hpp"
#include "syntax/print/sentence.hpp"

namespace grafverif {

namespace {

using namespace schedule;

class TogetherBuilder {
public:
    TogetherBuilder(const Model& model, const ClosedLoop& loop, std::span<const Equations> equations,
                    const Network& plant, const ScheduleOptions& options, Schedule schedule)
        : model_(model), loop_(loop), equations_(equations),
          sequenced_(schedule == Schedule::Sequenced), fairness_(options.fairness),
          parts_(parts(loop, equations, options)), assembly_(assemble(parts_, sequenced_, true)),
          context_{plant, sequenced_ ? Discipline::Rounds : Discipline::Together,
                   std::vector<bool>(plant.variables.size()), options.fairness, {}} {
        assembly_.system.name = loop.name;
        assembly_.system.scope = together_scope(schedule, parts_, options.fairness);
    }

    TransitionSystem build() {
        for (std::size_t index = 0; index < parts_.size(); ++index) {
            std::string& name = system().instances[controller_instance(index)].name;
            name = assembly_.names.fresh(name);
        }
        if (sequenced_) sequencer_.emplace(assembly_, plant_);
        add_plant();
        wire_controllers();
        if (sequenced_) sequencer_->run(evolution_over());
        if (fairness_) add_fairness(plant_);
        add_questions();
        add_trace_names();
        return std::move(assembly_.system);
    }

private:
    static std::vector<ControllerPart> parts(const ClosedLoop& loop, std::span<const Equations> equations,
                                             const ScheduleOptions& options) {
        std::vector<ControllerPart> found;
        for (const Id<ClosedLoop::Controller> id : loop.controllers.ids())
            found.push_back({equations[id.index], options.mode.value_or(loop.controllers[id].mode)});
        return found;
    }

    TransitionSystem& system() { return assembly_.system; }
    Exprs& exprs() { return assembly_.system.exprs; }

    /// Outputs of controllers first, which automata read as variables of the network of the same index.
    void add_plant() {
        shared_.resize(loop_.shared.size());
        share_outputs(members_, loop_, equations_, shared_);
        plant_.variables = shared_;
        add_instances(plant_);
        std::copy_n(plant_.variables.begin(), shared_.size(), shared_.begin());
        wire(plant_, sequenced_ ? sequencer_->signals() : Signals{});
    }

    void wire_controllers() {
        wire_inputs(members_, loop_, equations_, shared_);
        Id<Symbol> turn, elapse;
        if (sequenced_)
            turn = define(plant_, "controllers_run", sequencer_->is(Sequencer::Controllers), "turns");
        const bool timers =
            std::ranges::any_of(equations_, [](const Equations& one) { return !one.timers.empty(); });
        if (timers)
            elapse = define(plant_, "time_passes",
                            sequenced_ ? sequencer_->is(Sequencer::InputsRead) : exprs().constant(true), "turns");
        for (std::size_t index = 0; index < equations_.size(); ++index) {
            std::vector<Id<Symbol>>& arguments = system().instances[controller_instance(index)].arguments;
            if (turn.valid()) arguments.push_back(turn);
            if (!equations_[index].timers.empty()) arguments.push_back(elapse);
        }
        if (turn.valid()) runs_.assign(equations_.size(), plant_.leaf(turn));
    }

    /// The controllers that search for stability have settled; the others have run their one cycle, which follows the
    /// first evolution at once.
    Id<Expr> evolution_over() {
        std::vector<Id<Expr>> over;
        for (std::size_t index = 0; index < parts_.size(); ++index) {
            const ControllerModule& module = assembly_.modules[index];
            const bool searches = parts_[index].mode == ExecutionMode::StabilitySearch;
            const Id<Symbol> when = searches ? module.settled : module.started;
            if (when.valid()) over.push_back(plant_.leaf(member(members_, index, when)));
        }
        return exprs().conjunction(over);
    }

    void add_questions() {
        if (sequenced_) {
            system().settled = sequencer_->judged();
        } else {
            const Id<Expr> urgent = exprs().disjunction(plant_.each(&AutomatonModule::must_move));
            system().settled = exprs().conjunction(settled_controllers(members_), exprs().negation(urgent));
        }
        LoopMeaning meaning{.system = system(),
                            .model = model_,
                            .loop = loop_,
                            .equations = equations_,
                            .shared = shared_,
                            .variable = of_controllers(members_),
                            .at = [this](std::size_t process, std::uint32_t location) { return plant_.at(process, location); },
                            .judged_when_settled = sequenced_};
        add_observers(members_, meaning, assembly_.names, assembly_.module_names,
                      sequenced_ ? system().settled : Id<Expr>{});
        for (const Property& property : loop_.properties) add_property(meaning, property);
        for (const Property& constraint : constraints_to_prove(loop_)) add_property(meaning, constraint);
        add_fault_properties(members_, equations_);
        add_range_property(plant_);
        if (sequenced_) sequencer_->add_properties();
    }

    void add_trace_names() {
        add_names(members_, parts_, runs_);
        for (std::size_t process = 0; process < plant_.automata.size(); ++process)
            system().components.push_back(plant_.component(process));
    }

    const Model& model_;
    const ClosedLoop& loop_;
    std::span<const Equations> equations_;
    bool sequenced_ = false, fairness_ = false;
    std::vector<ControllerPart> parts_;
    Assembly assembly_;
    const AutomatonContext context_;
    Members members_{assembly_.system, assembly_.modules, {}};
    PlantInstances plant_{members_, context_, assembly_.names, assembly_.module_names, {}, {}, {}};
    std::vector<Id<Symbol>> shared_ = {};
    std::optional<Sequencer> sequencer_ = {};
    std::vector<Id<Expr>> runs_ = {};
};

}  // namespace

std::optional<TransitionSystem> schedule_together(const Model& model, const ClosedLoop& loop,
                                                  std::span<const Equations> equations, const Network& plant,
                                                  const ScheduleOptions& options, Diagnostics& diagnostics) {
    const Schedule schedule = options.schedule.value_or(loop.schedule.value_or(Schedule::Interleaved));
    assert(schedule != Schedule::Interleaved);
    const std::size_t errors = diagnostics.errors();
    check_widths(plant, diagnostics);
    if (diagnostics.errors() != errors) return {};
    TransitionSystem system = TogetherBuilder(model, loop, equations, plant, options, schedule).build();
    assert(verify(system).empty());
    return system;
}

}  // namespace grafverif
