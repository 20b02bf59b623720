// SPDX-License-Identifier: MIT
// Records causes in a ChartRun: translates terms of the model to elements of the charts and the plant.
#include <algorithm>
#include <map>
#include <optional>

#include "explain/causes.hpp"

namespace grafverif {

namespace {

/// Adds the cause `cause`, which concerns one event, to the run. If the run already contains the same cause up to the
/// event `before` or later, extends that cause instead.
void append(ChartRun& run, const ChartRun::Cause& cause, std::size_t before) {
    for (ChartRun::Cause& earlier : run.causes) {
        ChartRun::Cause same = earlier;
        same.first = cause.first;
        same.last = cause.last;
        if (same != cause || earlier.last < before) continue;
        earlier.last = cause.last;
        return;
    }
    run.causes.push_back(cause);
}

/// Returns the signal that a timer observes. The result is empty if the timer observes a term, or if the loop has no
/// signal with the name that the chart uses.
std::optional<Id<ChartRun::Signal>> watched_signal(const ChartRun& run, const ChartRun::Timer& timer) {
    for (const Id<ChartRun::Signal> id : run.signals.ids()) {
        const ChartRun::Role role = run.signals[id].role;
        const bool shared = role == ChartRun::Role::Input || role == ChartRun::Role::Output;
        const bool own = role == ChartRun::Role::Internal && run.controllers.size() == 1;
        if ((shared || own) && run.signals[id].name == timer.watched) return id;
    }
    return {};
}

/// Returns the value of the signal or step that the timer observes, after an event, or nothing if the value is unknown.
std::optional<bool> watched_value(const ChartRun& run, Id<ChartRun::Timer> id, std::size_t moment) {
    const ChartRun::Timer& timer = run.timers[id];
    const ChartRun::State& after = run.moments[moment].after;
    if (!timer.step) {
        const auto signal = watched_signal(run, timer);
        return signal ? std::optional(after.values[signal->index] != 0) : std::nullopt;
    }
    for (const ChartRun::Controller& controller : run.controllers)
        if (std::ranges::find(controller.timers, id) != controller.timers.end())
            return std::ranges::find(after.situation, controller.steps[*timer.step]) != after.situation.end();
    return {};
}

/// Marks the timer output, whose value is `over`, as a cause. Time conditions combine the output with the observed
/// term: `3s/v` is the conjunction of `v` and the output, and `v/3s` is the disjunction. The output is not marked if
/// the value of the condition differs from the output, or if the observed signal has no name. If the output is not
/// marked, the causes are recorded as not exact.
void append_time(ChartRun& run, Id<ChartRun::Timer> id, bool over, ChartRun::Cause cause, std::size_t before) {
    const ChartRun::Timer& timer = run.timers[id];
    const std::optional<bool> watched = watched_value(run, id, cause.first);
    const bool differs = watched && (over ? timer.fall_ms == 0 && !*watched : timer.rise_ms == 0 && *watched);
    if (!watched || differs) {
        run.causes_exact = false;
        return;
    }
    cause.timer = id;
    cause.value = over ? 1 : 0;
    append(run, cause, before);
}

/// Maps variables of the model to elements of the run.
struct Places {
    std::map<std::uint32_t, Id<ChartRun::Step>> steps = {};
    std::map<std::uint32_t, Id<ChartRun::Signal>> signals = {};
    std::map<std::uint32_t, Id<ChartRun::Timer>> times = {};  ///< timers by their output variables

    template <class Variable>
    void add(const ControllerWords<Variable>& words, const ChartRun::Controller& recorded) {
        for (std::size_t k = 0; k < words.steps.size(); ++k) steps[words.steps[k].variable.index] = recorded.steps[k];
        for (std::size_t k = 0; k < words.internals.size(); ++k)
            signals[words.internals[k].variable.index] = recorded.internals[k];
        for (std::size_t k = 0; k < words.timers.size(); ++k) times[words.timers[k].end.index] = recorded.timers[k];
    }

    /// Marks the value of `variable` at the event of `cause`. If the variable is a timer output, `over` is its value.
    /// Returns false if no element of the run corresponds to the variable.
    bool append_value(ChartRun& run, std::uint32_t variable, bool over, ChartRun::Cause cause,
                      std::size_t before) const {
        const ChartRun::State& after = run.moments[cause.first].after;
        if (const auto step = steps.find(variable); step != steps.end()) {
            cause.step = step->second;
            cause.value = std::ranges::find(after.situation, cause.step) != after.situation.end() ? 1 : 0;
        } else if (const auto signal = signals.find(variable); signal != signals.end()) {
            cause.signal = signal->second;
            cause.value = after.values[cause.signal.index];
        } else if (const auto time = times.find(variable); time != times.end()) {
            append_time(run, time->second, over, cause, before);
            return true;
        } else {
            return false;
        }
        append(run, cause, before);
        return true;
    }
};

/// Maps leaves of terms of a network to elements of the run.
class Marker {
public:
    Marker(const Network& network, const std::vector<NetworkState>& states, ChartRun& run)
        : network_(network), states_(states), run_(run) {
        std::uint32_t instances = 0;
        for (const Network::Process& process : network.processes)
            instances_.push_back(process.kind == Network::ProcessKind::Controller
                                     ? Id<ChartRun::Instance>{}
                                     : Id<ChartRun::Instance>{instances++});
        for (const Id<Network::Variable> id : network.variables.ids()) {
            const auto signal = std::ranges::find_if(run.signals, [&](const ChartRun::Signal& each) {
                return each.role != ChartRun::Role::Image && each.name == network.variables[id].display_name();
            });
            if (signal != run.signals.end())
                places_.signals[id.index] = {static_cast<std::uint32_t>(signal - run.signals.begin())};
        }
        for (const Id<Network::Controller> id : network.controllers.ids())
            places_.add(network.controllers[id].words, run.controllers[{id.index}]);
    }

    void mark(const Causes::Pair& pair) {
        for (const Id<Expr> leaf : leaves(network_.exprs, pair.term)) add(network_.exprs[leaf], pair.state);
    }

private:
    void add(const Expr& leaf, std::size_t state) {
        const std::size_t moment = std::min(state, run_.moments.size() - 1), before = moment == 0 ? 0 : moment - 1;
        ChartRun::Cause cause{.first = moment, .last = moment};
        if (leaf.op != Op::At) {
            const auto index = static_cast<std::uint32_t>(leaf.value);
            const bool over = states_[std::min(state, states_.size() - 1)].variables[index] != 0;
            if (!places_.append_value(run_, index, over, cause, before)) run_.causes_exact = false;
            return;
        }
        cause.instance = instances_[at_process(leaf)];
        if (!cause.instance.valid()) {
            run_.causes_exact = false;
            return;
        }
        cause.location = at_location(leaf);
        cause.value = location_of(cause.instance, moment) == cause.location ? 1 : 0;
        append(run_, cause, before);
    }

    std::size_t location_of(Id<ChartRun::Instance> instance, std::size_t moment) const {
        for (std::size_t k = moment; k > 0; --k)
            if (run_.moments[k].instance == instance && run_.moments[k].location) return *run_.moments[k].location;
        for (const Id<Network::Process> id : network_.processes.ids())
            if (instances_[id.index] == instance) return network_.processes[id].initial.index;
        return 0;
    }

    const Network& network_;
    const std::vector<NetworkState>& states_;
    ChartRun& run_;
    std::vector<Id<ChartRun::Instance>> instances_ = {};  // instance of the run for each process
    Places places_ = {};
};

/// Maps leaves of terms of an untimed model to elements of the run. The leaves are symbols of the module `main`.
class SystemMarker {
public:
    SystemMarker(const TransitionSystem& system, const SystemRun& shown, ChartRun& run)
        : system_(system), shown_(shown), run_(run), moments_(events_of_states(run)) {
        for (std::uint32_t index = 0; index < system.controllers.size(); ++index) add_words(index);
        for (std::uint32_t index = 0; index < system.components.size(); ++index) {
            const TransitionSystem::Component& component = system.components[index];
            if (component.location.valid()) instances_[component.location.index] = {index};
            for (const TransitionSystem::Named& named : component.variables)
                for (const Id<ChartRun::Signal> id : run.signals.ids())
                    if (run.signals[id].role == ChartRun::Role::Plant && run.signals[id].name == named.name)
                        places_.signals[named.variable.index] = id;
        }
    }

    void mark(const Causes::Pair& pair) {
        const std::size_t moment = moments_[pair.state];
        mark(pair, moment, pair.state == 0 ? 0 : moments_[pair.state - 1]);
        // The state before the loop is also the last state of each repetition of the loop.
        if (run_.loop && moment + 1 == *run_.loop)
            mark(pair, run_.moments.size() - 1, moments_[shown_.states.size() - 1]);
    }

private:
    void add_words(std::uint32_t index) {
        const auto& words = system_.controllers[index].words;
        const ChartRun::Controller& controller = run_.controllers[{index}];
        for (std::size_t k = 0; k < words.inputs.size(); ++k)
            places_.signals[words.inputs[k].variable.index] = controller.inputs[k];
        for (std::size_t k = 0; k < words.outputs.size(); ++k)
            places_.signals[words.outputs[k].variable.index] = controller.outputs[k];
        places_.add(words, controller);
    }

    void mark(const Causes::Pair& pair, std::size_t moment, std::size_t before) {
        for (const Id<Expr> leaf : leaves(system_.exprs, pair.term)) add(leaf, pair, moment, before);
    }

    void add(Id<Expr> leaf, const Causes::Pair& pair, std::size_t moment, std::size_t before) {
        const auto symbol = static_cast<std::uint32_t>(system_.exprs[leaf].value);
        const std::int64_t here = shown_.states[pair.state][symbol];
        ChartRun::Cause cause{.first = moment, .last = moment};
        if (places_.append_value(run_, symbol, here != 0, cause, before)) return;
        const auto instance = instances_.find(symbol);
        if (instance == instances_.end()) return look_through(symbol, pair, moment, before);
        const std::int64_t requested = compared_with(pair.term, leaf).value_or(here);
        const Type type = system_.modules[system_.main].symbols[{symbol}].type;
        cause.instance = instance->second;
        cause.location = static_cast<std::size_t>(requested - type.low);
        cause.value = here == requested ? 1 : 0;
        append(run_, cause, before);
    }

    /// Marks the symbols that the definition of `symbol` reads. If the run has no element for one of these symbols, the
    /// causes are recorded as not exact.
    void look_through(std::uint32_t symbol, const Causes::Pair& pair, std::size_t moment, std::size_t before) {
        const auto& kind = system_.modules[system_.main].symbols[{symbol}].kind;
        const auto* define = std::get_if<TransitionSystem::DefineSymbol>(&kind);
        if (define == nullptr) run_.causes_exact = false;
        else
            for (const Id<Expr> leaf : leaves(system_.exprs, define->value)) add(leaf, pair, moment, before);
    }

    /// Returns the number of the location with which `term` compares the symbol `leaf`, for example in
    /// `location = going_out`. The result is empty if `term` is not a comparison of this form.
    std::optional<std::int64_t> compared_with(Id<Expr> term, Id<Expr> leaf) const {
        if (system_.exprs[term].op != Op::Equal) return {};
        const auto sides = system_.exprs.operands(term);
        const Id<Expr> other = sides[0] == leaf ? sides[1] : sides[0];
        if (system_.exprs[other].op != Op::Integer) return {};
        return system_.exprs[other].value;
    }

    const TransitionSystem& system_;
    const SystemRun& shown_;
    ChartRun& run_;
    std::vector<std::size_t> moments_;
    std::map<std::uint32_t, Id<ChartRun::Instance>> instances_ = {};  // instance of the run for each location symbol
    Places places_ = {};
};

}  // namespace

void mark(const Network& network, const std::vector<NetworkState>& states, const Causes& causes, ChartRun& run) {
    Marker marker(network, states, run);
    run.causes_exact = causes.exact;
    for (const Causes::Pair& pair : causes.pairs) marker.mark(pair);
    // The event before the loop is also the last event of each repetition of the loop.
    for (const Causes::Pair& pair : causes.pairs)
        if (run.loop && pair.state + 1 == *run.loop) marker.mark({pair.term, run.moments.size() - 1});
    std::ranges::stable_sort(run.causes, {}, &ChartRun::Cause::first);
}

void mark(const TransitionSystem& system, const SystemRun& shown, const Causes& causes, ChartRun& run) {
    SystemMarker marker(system, shown, run);
    run.causes_exact = causes.exact;
    for (const Causes::Pair& pair : causes.pairs) marker.mark(pair);
    std::ranges::stable_sort(run.causes, {}, &ChartRun::Cause::first);
}

std::vector<std::size_t> events_of_states(const ChartRun& run) {
    std::vector<std::size_t> moments = {0};
    for (std::size_t moment = 1; moment < run.moments.size(); ++moment) {
        const bool last = moment + 1 == run.moments.size() || run.moments[moment + 1].move != run.moments[moment].move;
        if (last) moments.push_back(moment);
    }
    return moments;
}

}  // namespace grafverif
