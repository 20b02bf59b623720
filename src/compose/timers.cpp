// SPDX-License-Identifier: MIT
// Timers: one process per time condition, all of one template (CEP13 Fig. 33b), with two repairs. As published, a timer
// follows its step by level and sets EVOL_TI only at its end; a step that is left and activated anew within one instant
// is not seen, and the pulse chart `1 -> 2 when 5s/X1; 2 -> 1 when true` fires for ever after the first 5 s. Here the
// step update leaves a request (P) whenever it activates or deactivates the step, the timer takes it at once and
// restarts, no cycle starts before it is taken, and EVOL_TI is set on every change of Q. A run that ends leaves a
// request to stop alone.
#include <algorithm>
#include <utility>

#include "compose/controller.hpp"

namespace grafverif {

namespace {

class TimerBuilder {
public:
    TimerBuilder(Exprs& exprs, bool as_published) : exprs_(exprs), as_published_(as_published) {}

    Network::Template build(std::string name) {
        automaton_.name = std::move(name);
        duration_ = parameter("D", Network::ParameterKind::Constant, integer_type(least_integer, greatest_integer));
        step_ = parameter("X", Network::ParameterKind::Read, {});
        if (!as_published_) pending_ = parameter("P", Network::ParameterKind::Written, {});
        end_ = parameter("Q", Network::ParameterKind::Written, {});
        flag_ = parameter("EVOL_TI", Network::ParameterKind::Written, {});
        clock_ = automaton_.clocks.add({"t"});
        idle_ = automaton_.locations.add({"idle", {}, {}});
        running_ = automaton_.locations.add({"run", {{clock_, Op::LessEqual, duration_}}, {}});
        done_ = automaton_.locations.add({"done", {}, {}});
        automaton_.initial = idle_;
        if (as_published_) add_published();
        else add_repaired();
        return std::move(automaton_);
    }

private:
    Id<Expr> parameter(const char* name, Network::ParameterKind kind, Type type) {
        return exprs_.leaf(Op::Parameter, automaton_.parameters.add({name, kind, type}).index);
    }

    Network::Assignment set(Id<Expr> target, bool value) { return {target, exprs_.constant(value)}; }

    void urgent(Id<Network::Location> from, Id<Network::Location> to, Id<Expr> guard,
                std::vector<Network::Assignment> assignments) {
        Network::Edge edge{
            .from = from, .to = to, .urgent = true, .guard = guard, .assignments = std::move(assignments)};
        if (to == running_) edge.resets.push_back(clock_);
        automaton_.edges.add(std::move(edge));
    }

    void elapse(Id<Expr> guard) {
        automaton_.edges.add({.from = running_,
                              .to = done_,
                              .guard = guard,
                              .constraint = {{clock_, Op::Equal, duration_}},
                              .assignments = {set(end_, true), set(flag_, true)}});
    }

    void add_repaired() {
        const Id<Expr> started = exprs_.conjunction(pending_, step_);
        const Id<Expr> stopped = exprs_.conjunction(pending_, exprs_.negation(step_));
        const Network::Assignment taken = set(pending_, false);
        urgent(idle_, running_, started, {taken});
        urgent(idle_, idle_, stopped, {taken});
        elapse(exprs_.negation(pending_));
        urgent(running_, running_, started, {taken});
        urgent(running_, idle_, stopped, {taken});
        urgent(done_, running_, started, {set(end_, false), set(flag_, true), taken});
        urgent(done_, idle_, stopped, {set(end_, false), set(flag_, true), taken});
    }

    void add_published() {
        urgent(idle_, running_, step_, {});
        elapse(exprs_.constant(true));
        urgent(running_, idle_, exprs_.negation(step_), {});
        urgent(done_, idle_, exprs_.negation(step_), {set(end_, false)});
    }

    Exprs& exprs_;
    bool as_published_;
    Network::Template automaton_ = {};
    Id<Expr> duration_ = {}, step_ = {}, pending_ = {}, end_ = {}, flag_ = {};
    Id<Network::Clock> clock_ = {};
    Id<Network::Location> idle_ = {}, running_ = {}, done_ = {};
};

}  // namespace

void add_timers(Composition& composition, const ControllerParts& parts) {
    Network& network = composition.network;
    const std::vector<Equations::Timer>& timers = parts.equations->timers;
    if (timers.empty()) return;
    if (!composition.timer.valid()) {
        TimerBuilder builder(network.exprs, composition.ablations.timers_as_published);
        composition.timer = network.templates.add(builder.build(composition.names.fresh("timer")));
    }
    const Id<Network::Controller> controller{static_cast<std::uint32_t>(network.controllers.size() - 1)};
    for (std::size_t i = 0; i < timers.size(); ++i) {
        const std::int64_t duration = timers[i].duration_ms / network.time_unit_ms;
        Type& bound = network.templates[composition.timer].parameters[{0}].type;
        bound.high = std::max(bound.high, duration);
        Network::Process process{.name = composition.names.fresh(parts.prefix + timers[i].name),
                                 .automaton = composition.timer,
                                 .kind = Network::ProcessKind::Timer,
                                 .origin = timers[i].origin};
        process.arguments = {duration, parts.variable[timers[i].step.index]};
        if (!parts.pending.empty()) process.arguments.push_back(parts.pending[i]);
        process.arguments.push_back(parts.variable[timers[i].end.index]);
        process.arguments.push_back(parts.evol_ti);
        process.initial = network.templates[composition.timer].initial;
        const auto [step, end] = std::pair(parts.variable[timers[i].step.index], parts.variable[timers[i].end.index]);
        const Id<Network::Variable> pending = parts.pending.empty() ? Id<Network::Variable>{} : parts.pending[i];
        network.controllers[controller].timing.push_back({step, pending, end, duration});
        network.controllers[controller].timers.push_back(network.processes.add(std::move(process)));
    }
}

}  // namespace grafverif
