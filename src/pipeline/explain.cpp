// SPDX-License-Identifier: MIT
#include "pipeline/explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <utility>

#include "check/decomposition/interleaved.hpp"
#include "explain/causes.hpp"
#include "explain/counterfactual.hpp"
#include "explain/dead_steps.hpp"
#include "explain/inputs.hpp"
#include "explain/instability.hpp"
#include "explain/instants.hpp"
#include "explain/moves.hpp"
#include "explain/standstill.hpp"
#include "ir/network_run.hpp"
#include "ir/patterns.hpp"
#include "ir/step_names.hpp"
#include "pipeline/models.hpp"

namespace grafverif {

namespace {

/// Checks each property that is violated at power-on again with `at stable`, and adds a note that states the result.
void explain_power_on(const Network& network, const std::vector<Violation>& violations, const PropertyChecker& search,
                      Report& report) {
    Network settled = network;
    std::vector<std::string> names;
    std::vector<std::size_t> trapped;
    for (const Violation& each : violations) {
        const Id<Property> about = report.answers[each.answer].verdict.about;
        if (!about.valid() || !is_violated_at_power_on(network, network.properties[about], each.run)) continue;
        settled.properties[about].at_stable = true;
        names.push_back(network.properties[about].name);
        trapped.push_back(each.answer);
    }
    if (names.empty()) return;
    const std::vector<Verdict> found = search ? search(settled, names) : std::vector<Verdict>{};
    for (const std::size_t answer : trapped) {
        Verdict& verdict = report.answers[answer].verdict;
        const auto at_stable = std::ranges::find(found, verdict.property, &Verdict::property);
        verdict.notes.push_back(power_on_text(at_stable == found.end() ? Verdict{} : *at_stable));
    }
}

std::string gave_up(std::size_t count, std::string_view what, std::size_t tried) {
    return fmt::format("among the {} {} of the counterexample, no minimal set of causes was found in {} attempts",
                       count, what, tried);
}

/// Returns a function that returns true if a search must stop because of `limits`. `limits` must outlive the returned
/// function.
StopRequested stopped_by(const Limits& limits) {
    return [&limits] {
        if (limits.stop != nullptr && limits.stop->load(std::memory_order_relaxed)) return true;
        return limits.deadline && std::chrono::steady_clock::now() >= *limits.deadline;
    };
}

/// Maximum effort of a search for the shortest change that removes a violation: `most_moves` is the total number of
/// executed moves of a network; `most_steps` is the number of steps of a system or of evolutions of a chart.
constexpr std::size_t most_moves = 5000, most_steps = 20'000;

/// Marks the values in the trace that cause the violation, and searches for a smallest set of moves without which the
/// run does not violate the property.
void explain_run(const Network& network, const Run& run, const Limits& limits, PropertyResult& answer) {
    if (!answer.verdict.about.valid() || !answer.trace) return;
    const Property& property = network.properties[answer.verdict.about];
    const auto states = replay(network, run);
    const auto causes = states ? causes_of(network, property, *states, run.loop) : std::nullopt;
    if (!causes) return;
    mark(network, *states, *causes, *answer.trace);
    const ShortestChange change = shortest_change(network, property, run, most_moves, stopped_by(limits));
    if (change.found)
        for (const std::size_t move : change.found->left_out) answer.trace->left_out.push_back(move + 1);
    if (change.exhausted && change.tried > 0)
        answer.verdict.notes.push_back(gave_up(change.free_moves, "free moves", change.tried));
}

/// Explains a violated `no timelock`: adds notes that state why time cannot pass at the end of `run`.
void explain_standstill(const Network& network, const Run& run, PropertyResult& answer) {
    const Standstill found = standstill(network, run);
    const std::string unsettled = unstable_text(*answer.trace);
    if (!unsettled.empty()) answer.verdict.notes.push_back(unsettled);
    if (!unsettled.empty() && found.blockers.empty()) return;
    if (std::string words = standstill_words(network, found); !words.empty())
        answer.verdict.notes.push_back(std::move(words));
}

/// Explains a violation in a model without a plant, whose inputs are free.
void explain_inputs(const TransitionSystem& system, const Property& property, const SystemRun& run,
                    const Limits& limits, PropertyResult& answer) {
    const InputChange change = fewest_input_changes(system, property, run, most_steps, stopped_by(limits));
    if (change.left_out) mark(system, *change.left_out, *answer.trace);
    if (change.exhausted && change.tried > 0)
        answer.verdict.notes.push_back(gave_up(change.events.size(), "input changes and timer expiries", change.tried));
}

/// Explains a violation in an untimed model with interleaved plant automata.
void explain_moves(const Network& timed, const TransitionSystem& system, const Property& property, const SystemRun& run,
                   const Limits& limits, PropertyResult& answer) {
    const Network played = system.ticks.valid() ? timed : without_clocks(timed);
    const auto requested = std::ranges::find(played.properties, property.name, &Property::name);
    if (requested == played.properties.end() || requested->pattern != property.pattern) return;
    const auto moves = moves_of(played, system, run);
    if (!moves) return;
    const ShortestChange change =
        shortest_change(played, timed, *requested, moves->run, most_moves, stopped_by(limits));
    if (change.found) mark(*moves, change.found->left_out, *answer.trace);
    if (change.exhausted && change.tried > 0)
        answer.verdict.notes.push_back(gave_up(change.free_moves, "free moves", change.tried));
}

/// Explains a violated `no timelock` in discrete time, where this property means that a tick is always possible.
void explain_time(const SystemToCheck& check, const Property& property, const SystemRun& run, PropertyResult& answer) {
    const std::optional<Network>* const network = check.network ? &check.network() : nullptr;
    if (network == nullptr || !*network) return;
    const auto requested = std::ranges::find((*network)->properties, property.name, &Property::name);
    if (requested == (*network)->properties.end() || requested->pattern != Pattern::NoTimelock) return;
    if (const auto moves = moves_of(**network, check.system, run)) explain_standstill(**network, moves->run, answer);
}

}  // namespace

void explain(const Network& network, const std::vector<Violation>& violations, const PropertyChecker& search,
             const Limits& limits, Report& report) {
    explain_power_on(network, violations, search, report);
    for (const Violation& each : violations) {
        PropertyResult& answer = report.answers[each.answer];
        explain_run(network, each.run, limits, answer);
        if (answer.verdict.pattern != Pattern::NoTimelock || !answer.trace) continue;
        explain_standstill(network, each.run, answer);
    }
}

void explain(const SystemToCheck& check, const SystemRun& run, const Limits& limits, PropertyResult& answer) {
    const TransitionSystem& system = check.system;
    if (!answer.verdict.about.valid() || !answer.trace) return;
    const Property& property = system.properties[answer.verdict.about];
    if (system.ticks.valid() && property.pattern == Pattern::AlwaysPossible) explain_time(check, property, run, answer);
    const auto causes = causes_of(system, property, run);
    if (!causes) return;
    mark(system, run, *causes, *answer.trace);
    if (!is_about_all_states(property.pattern)) return;
    const std::optional<Network>* const network = check.network ? &check.network() : nullptr;
    if (network != nullptr && *network) explain_moves(**network, system, property, run, limits, answer);
    else explain_inputs(system, property, run, limits, answer);
}

Deadline explanation_deadline(const Deadline& deadline, double seconds) {
    using Clock = std::chrono::steady_clock;
    const auto end =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(2 + seconds));
    return std::min(deadline.value_or(end), end);
}

namespace {

constexpr std::size_t most_candidates = 200;

bool is_reachable(const Exprs& exprs, const Property& property, std::uint32_t variable) {
    if (property.pattern != Pattern::Reachable) return false;
    const Expr& term = exprs[property.operands[0]];
    return term.op == Op::Variable && term.value == variable;
}

/// True if `answer` is the verdict on the reachability of the step whose variable is `step`.
bool is_about(const Network& network, const PropertyResult& answer, Id<Network::Variable> step) {
    const Property& property = network.properties[answer.verdict.about];
    if (property.pattern == Pattern::ReachableAllSteps)
        return answer.verdict.property == property.name + '.' + step_variable_name(network, step);
    return is_reachable(network.exprs, property, step.index);
}

bool is_about(const TransitionSystem& system, const PropertyResult& answer, Id<TransitionSystem::Symbol> step) {
    return is_reachable(system.exprs, system.properties[answer.verdict.about], step.index);
}

/// Returns a term that is true in the states in which a transition is cleared. If the variable `firing` is not stored
/// in states, returns the constant false.
Id<Expr> clearing(Network& network, Id<Network::Variable> firing) {
    // The value of a scratch variable is computed from the state before the edge and is not stored. The conjuncts of
    // the condition, which are the other operands in the property, are evaluated in the same state and suffice without
    // the scratch variable.
    return network.variables[firing].scratch ? network.exprs.constant(false)
                                             : network.exprs.leaf(Op::Variable, firing.index);
}

Id<Expr> clearing(TransitionSystem& system, Id<TransitionSystem::Symbol> firing) {
    return system.exprs.leaf(Op::Variable, firing.index);
}

/// Adds notes to the verdicts on unreachable steps. A note names a transition that would activate the step and is never
/// cleared. `decide` returns the verdicts on the properties of the model with the given names.
template <class Model, class Decide>
void name_dead_transitions(Model model, const std::vector<const Chart*>& charts, const Decide& decide, Report& report) {
    struct Requested {
        PropertyResult* answer = nullptr;
        std::string words = {};
        std::pair<std::size_t, std::uint32_t> transition = {};  // index of the controller and index of the transition
    };
    std::vector<Requested> requested;
    std::vector<std::string> names;
    for (PropertyResult& answer : report.answers) {
        if (answer.verdict.outcome != Outcome::Violated || !answer.verdict.about.valid()) continue;
        if (names.size() > most_candidates) break;
        std::size_t index = 0;
        for (const auto& controller : model.controllers) {
            const Chart& chart = *charts[index++];
            const std::string prefix = charts.size() > 1 ? controller.words.name + ": " : "";
            for (const Id<Chart::Step> step : chart.steps.ids()) {
                if (!is_about(model, answer, controller.words.steps[step.index].variable)) continue;
                for (const DeadTransition& each :
                     dead_transitions(chart, condition_leaves(controller.words), step, model.exprs)) {
                    const auto firing = controller.words.transitions[each.transition.index].variable;
                    Property property{.name = "dead.(" + std::to_string(names.size()) + ')', .pattern = Pattern::Never};
                    property.operands = {model.exprs.disjunction(each.never, clearing(model, firing))};
                    names.push_back(property.name);
                    model.properties.add(std::move(property));
                    requested.push_back({&answer, prefix + each.words, {index, each.transition.index}});
                }
            }
        }
    }
    if (requested.empty()) return;
    const std::vector<Verdict> verdicts = decide(std::as_const(model), names);
    const Requested* last = nullptr;
    for (std::size_t k = 0; k < requested.size(); ++k) {
        const bool again =
            last != nullptr && last->answer == requested[k].answer && last->transition == requested[k].transition;
        const auto found = std::ranges::find(verdicts, names[k], &Verdict::property);
        if (again || found == verdicts.end() || found->outcome != Outcome::Holds) continue;
        last = &requested[k];
        last->answer->verdict.notes.push_back(last->words);
    }
}

}  // namespace

void explain_dead_steps(const Network& network, const std::vector<const Chart*>& charts, const PropertyChecker& search,
                        Report& report) {
    if (!search || charts.size() != network.controllers.size()) return;
    name_dead_transitions(network, charts, search, report);
}

void explain_dead_steps(const SystemToCheck& check, const Limits& limits, Report& report) {
    if (check.charts.size() != check.system.controllers.size()) return;
    double seconds = 0;
    for (const PropertyResult& answer : report.answers) seconds = std::max(seconds, answer.verdict.seconds);
    name_dead_transitions(
        check.system, check.charts,
        [&](const TransitionSystem& system, std::vector<std::string> names) {
            SymbolicOptions options{.properties = std::move(names), .witnesses = false};
            set_limits(options, limits);
            options.deadline = explanation_deadline(limits.deadline, seconds);
            return check_symbolic_by_parts(system, options).verdicts;
        },
        report);
}

void explain(const Chart& chart, ExecutionMode mode, const Limits& limits, PropertyResult& answer) {
    if (!answer.trace) return;
    InstantChange change = fewest_changes(chart, mode, *answer.trace, most_steps, stopped_by(limits));
    if (change.left_out) answer.trace->counterfactual_values = std::move(*change.left_out);
    if (change.exhausted && change.tried > 0)
        answer.verdict.notes.push_back(gave_up(change.events, "input changes", change.tried));
}

}  // namespace grafverif
