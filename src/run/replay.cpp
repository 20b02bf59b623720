// SPDX-License-Identifier: MIT
#include "grafverif/run/replay.hpp"

#include <algorithm>
#include <vector>

#include "grafverif/ir/network_run.hpp"
#include "grafverif/run/interpreter.hpp"
#include "grafverif/support/overloaded.hpp"

namespace grafverif {

namespace {

std::string number(std::int64_t value) { return std::to_string(value); }

std::string listed(const std::vector<std::string>& names) {
    std::string text = "{";
    for (const std::string& name : names) text += (text.size() == 1 ? "" : ", ") + name;
    return text + "}";
}

/// One controller of the network beside its chart.
class Twin {
public:
    Twin(const Network& network, const Network::Controller& controller, const Chart& chart)
        : network_(network), controller_(controller), chart_(chart), elements_(timed_elements(chart)), state_(power_on(chart)) {
        inputs_.resize(chart.variables.size());
        index_time_conditions();
        // No location before W: the first evolution has nothing to do.
        if (!controller.start.valid()) state_ = evolve(chart, state_, inputs_, timed_).state;
    }

    void pass(std::int64_t milliseconds) { state_ = pass_time(std::move(state_), milliseconds); }

    /// What the network has that the rules do not give; empty: they agree.
    std::string fire(const Network::Edge& edge, const NetworkState& before, const NetworkState& after) {
        for (const Id<Network::Procedure> call : edge.calls) {
            std::string fault;
            if (call == controller_.start) fault = start(before, after);
            else if (call == controller_.fire) fault = sample(before);
            else if (call == controller_.evolve) fault = evolution(before, edge.calls.size() > 1 ? after : before, after);
            else if (call == controller_.write) fault = write(after);
            if (!fault.empty() || raced_) return fault;
        }
        return {};
    }

    std::size_t evolutions() const { return evolutions_; }
    /// Both have met a race: nothing is to be compared behind it.
    bool raced() const { return raced_; }
    const std::string& racing() const { return racing_; }
    const std::string& name() const { return controller_.name; }

private:
    void index_time_conditions() {
        for (std::size_t k = 0; k < elements_.size(); ++k) {
            if (elements_[k].watched.valid()) {
                const std::optional<std::size_t> timer = controller_.conditions[k];
                timers_.push_back(timer ? &controller_.timing[*timer] : nullptr);
                continue;
            }
            const auto found = std::ranges::find_if(controller_.timing, [&](const Network::TimerVariables& timing) {
                return timing.watched == controller_.steps[elements_[k].step.index].variable && timing.fall == 0 &&
                       timing.rise * network_.time_unit_ms == elements_[k].rise_ms;
            });
            timers_.push_back(found == controller_.timing.end() ? nullptr : &*found);
        }
        timed_.assign(timers_.size(), false);
    }

    void read_inputs(const NetworkState& now) {
        for (std::size_t i = 0; i < controller_.symbols.size(); ++i)
            if (controller_.symbols[i].role == Network::Role::Input)
                inputs_[i] = now.variables[controller_.symbols[i].variable.index];
    }

    std::string start(const NetworkState& before, const NetworkState& after) {
        read_inputs(before);
        return evolved(evolve(chart_, state_, inputs_, timed_), after);
    }

    std::string sample(const NetworkState& before) {
        read_inputs(before);
        for (std::size_t i = 0; i < timers_.size(); ++i) {
            if (timers_[i] == nullptr) continue;   // nothing waits for it
            timed_[i] = before.variables[timers_[i]->end.index] != 0;
            if (std::string fault = timer_fault(i); !fault.empty()) return fault;
        }
        return {};
    }

    /// A timer changes when its duration is over; at that very moment it may not have done so yet.
    std::string timer_fault(std::size_t index) const {
        if (!timers_[index]->pending.valid()) return {};  // timers as published are wrong, and are meant to be
        const TimedElement& element = elements_[index];
        const Timing& timing = state_.timing[index];
        const bool lasts = timing.risen >= 0 && timing.risen >= element.rise_ms;
        const bool remains = element.fall_ms > 0 && timing.fallen >= 0 && timing.fallen <= element.fall_ms;
        const bool just_over = element.rise_ms > 0 && timing.risen == element.rise_ms;
        const bool may = lasts || remains;
        const bool must = (lasts && !just_over) || (remains && timing.fallen < element.fall_ms);
        if (timed_[index] ? may : !must) return {};
        return "the timer of " + number(element.rise_ms > 0 ? element.rise_ms : element.fall_ms) + " ms of " +
               watched_name(element) + " is " + (timed_[index] ? "over" : "not over") + ", but by the rules its age is " +
               number(timing.fallen < 0 ? timing.risen : timing.fallen) + " ms";
    }

    std::string watched_name(const TimedElement& element) const {
        if (element.step.valid()) return step_variable(chart_, element.step);
        const Expr& node = chart_.exprs[element.watched];
        if (node.op != Op::Step) return "what it watches";
        return step_variable(chart_, {static_cast<std::uint32_t>(node.value)});
    }

    /// Per element, whether its t1 is over: a timer may end in the instant of a cycle, after the inputs were sampled and
    /// before the evolution. Its end variable does not tell, since it may still be true of an earlier rise.
    std::vector<bool> ended(const NetworkState& now) const {
        std::vector<bool> ended;
        for (const Network::TimerVariables* const timer : timers_) ended.push_back(timer != nullptr && is_done(*timer, now));
        return ended;
    }

    bool is_done(const Network::TimerVariables& timer, const NetworkState& now) const {
        const Id<Network::Process> process = controller_.timers[static_cast<std::size_t>(&timer - controller_.timing.data())];
        const Network::Template& automaton = network_.templates[network_.processes[process].automaton];
        return automaton.locations[now.locations[process.index]].name == "done";
    }

    std::string evolution(const NetworkState& before, const NetworkState& fired_in, const NetworkState& after) {
        ++evolutions_;
        Evolution result = evolve(chart_, state_, inputs_, timed_, ended(before));
        std::vector<std::string> network_fired, rules_fired;
        for (const Network::Named& transition : controller_.transitions)
            if (fired_in.variables[transition.variable.index] != 0) network_fired.push_back(transition.name);
        for (const Id<Chart::Transition> id : result.fired) rules_fired.push_back(chart_.transitions[id].name);
        if (network_fired != rules_fired)
            return "transitions cleared: " + listed(network_fired) + ", by the rules " + listed(rules_fired);
        const bool stable = after.variables[controller_.stable.index] != 0;
        if (!result.race && !result.fault && stable != result.stable)
            return std::string("the situation is ") + (stable ? "stable" : "not stable") + ", by the rules it is " +
                   (result.stable ? "stable" : "not stable");
        return evolved(std::move(result), after);
    }

    std::string evolved(Evolution result, const NetworkState& after) {
        const bool flagged = network_.race.valid() && after.variables[network_.race.index] != 0;
        // Which of several faults of one evolution is met first is left open.
        raced_ = flagged && (result.race || result.fault);
        if (result.race) racing_ = variable_name(result.race->variable);
        if (raced_) return {};
        if (result.race) return "no race, by the rules two actions race for " + variable_name(result.race->variable);
        if (flagged) return "two actions race, by the rules none do";
        if (result.fault) return "an evolution that by the rules has no result";
        state_ = std::move(result.state);
        if (std::string fault = situation_fault(after); !fault.empty()) return fault;
        return stored_fault(after);
    }

    std::string situation_fault(const NetworkState& now) const {
        std::vector<std::string> network_steps, rules_steps;
        for (const Id<Chart::Step> id : chart_.steps.ids()) {
            const Network::Named& step = controller_.steps[id.index];
            if (now.variables[step.variable.index] != 0) network_steps.push_back(step.name);
            if (state_.situation[id.index]) rules_steps.push_back(step.name);
        }
        if (network_steps == rules_steps) return {};
        return "situation " + listed(network_steps) + ", by the rules " + listed(rules_steps);
    }

    std::string stored_fault(const NetworkState& now) const {
        for (const Id<Chart::Variable> id : chart_.variables.ids()) {
            const auto& [role, variable, image, name] = controller_.symbols[id.index];
            if (role == Network::Role::Input || (role == Network::Role::Output && !image.valid())) continue;
            const std::int64_t value = now.variables[(image.valid() ? image : variable).index];
            if (value != state_.values[id.index])
                return variable_name(id) + " holds " + number(value) + ", by the rules " +
                       number(state_.values[id.index]);
        }
        return {};
    }

    std::string write(const NetworkState& now) {
        const bool atomic_search =
            network_.grain == Grain::Atomic && controller_.mode == ExecutionMode::StabilitySearch;
        if (atomic_search && now.variables[controller_.stable.index] == 0) return {};  // nothing is written then
        const auto outputs = output_values(chart_, state_, inputs_, timed_);
        if (!outputs) return "outputs are written that by the rules have no value";
        for (const Id<Chart::Variable> id : chart_.variables.ids()) {
            if (chart_.variables[id].kind != Chart::VariableKind::Output) continue;
            const std::int64_t value = now.variables[controller_.symbols[id.index].variable.index];
            if (value != (*outputs)[id.index])
                return "output " + variable_name(id) + " is " + number(value) + ", by the rules " +
                       number((*outputs)[id.index]);
        }
        return {};
    }

    const std::string& variable_name(Id<Chart::Variable> id) const { return chart_.variables[id].name; }

    const Network& network_;
    const Network::Controller& controller_;
    const Chart& chart_;
    std::vector<TimedElement> elements_;
    State state_;
    std::vector<std::int64_t> inputs_ = {};                    ///< as sampled
    std::vector<bool> timed_ = {};                             ///< as sampled
    std::vector<const Network::TimerVariables*> timers_ = {};  ///< per element; null: nothing waits for it
    std::size_t evolutions_ = 0;
    bool raced_ = false;
    std::string racing_ = {};                                  ///< the variable
};

/// Replays the run on `twins`, one per controller, up to the first disagreement or race.
std::optional<Disagreement> replay(const Network& network, std::span<const Chart* const> charts, const Run& run,
                                   std::vector<Twin>& twins) {
    std::vector<Twin*> of_process(network.processes.size(), nullptr);
    twins.reserve(charts.size());
    for (const Id<Network::Controller> id : network.controllers.ids()) {
        twins.emplace_back(network, network.controllers[id], *charts[id.index]);
        of_process[network.controllers[id].process.index] = &twins.back();
    }
    NetworkState state = initial_state(network);
    for (std::size_t i = 0; i < run.moves.size(); ++i) {
        const NetworkState before = state;
        if (perform(network, state, run.moves[i]).result != Step::Result::Done)
            return Disagreement{i, "the network", "the move cannot be made there"};
        if (const auto* delay = std::get_if<Delay>(&run.moves[i])) {
            for (Twin& twin : twins) twin.pass(delay->units * network.time_unit_ms);
            continue;
        }
        const Fire& fire = std::get<Fire>(run.moves[i]);
        Twin* const twin = of_process[fire.process.index];
        if (twin == nullptr) continue;
        const Network::Edge& edge = network.templates[network.processes[fire.process].automaton].edges[fire.edge];
        std::string what = twin->fire(edge, before, state);
        if (twin->raced() && what.empty()) return {};
        if (!what.empty())
            return Disagreement{i, "controller " + twin->name() + ", evolution " + std::to_string(twin->evolutions()),
                                std::move(what)};
    }
    return {};
}

}  // namespace

std::optional<Disagreement> disagreement(const Network& network, std::span<const Chart* const> charts, const Run& run) {
    std::vector<Twin> twins;
    return replay(network, charts, run, twins);
}

std::optional<Clash> clash(const Network& network, std::span<const Chart* const> charts, const Run& run) {
    std::vector<Twin> twins;
    if (replay(network, charts, run, twins)) return {};
    const auto raced = std::ranges::find_if(twins, &Twin::raced);
    if (raced == twins.end()) return {};
    return Clash{raced->name(), raced->racing()};
}

}  // namespace grafverif
