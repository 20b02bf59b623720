// SPDX-License-Identifier: MIT
#include "pipeline/variants/fault_detection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "check/shares.hpp"
#include "check/timed/timed.hpp"
#include "compose/observe.hpp"
#include "ir/network_run.hpp"
#include "pipeline/models.hpp"

namespace grafverif {

namespace {

/// Maximum number of pairs of literals for which a check decides whether the pair reveals the fault in every run.
constexpr std::size_t most_tried = 6;
/// Duration in time units of the observer that measures the time to detection. A large value costs nothing, because the
/// engine has states only for the times that occur.
constexpr std::int64_t longest_units = 1'000'000;

/// Returns literal k: literal 2i is signal i, and literal 2i + 1 is its complement.
Id<Expr> literal(Network& network, std::size_t k) {
    const Id<Network::Variable> variable = controller_signals(network, true)[k / 2].variable;
    const Id<Expr> positive = network.exprs.leaf(Op::Variable, variable.index);
    return k % 2 == 0 ? positive : network.exprs.negation(positive);
}

/// Returns the conjunction of the literals of `pair`; for the pair (k, k), returns literal k. `literals` is the number
/// of literals.
Id<Expr> conjunction(Network& network, std::size_t pair, std::size_t literals) {
    const Id<Expr> first = literal(network, pair / literals), second = literal(network, pair % literals);
    return first == second ? first : network.exprs.conjunction(first, second);
}

/// Returns the term that is true when the fault of the process `instance` occurs.
Id<Expr> occurs(Network& network, const std::string& instance) {
    for (const Id<Network::Process> id : network.processes.ids())
        if (network.processes[id].name == instance)
            return network.exprs.at(id.index, static_cast<std::uint32_t>(automaton(network, id).locations.size() - 1));
    return network.exprs.constant(false);
}

Outcome outcome_of(const std::vector<Verdict>& verdicts, const std::string& property) {
    const auto found = std::ranges::find(verdicts, property, &Verdict::property);
    return found == verdicts.end() ? Outcome::Unknown : found->outcome;
}

}  // namespace

std::vector<ControllerSignal> controller_signals(const Network& network, bool inputs) {
    std::vector<ControllerSignal> found;
    std::set<std::uint32_t> known;
    const auto add = [&](std::string name, Id<Network::Variable> variable) {
        if (network.variables[variable].type.boolean && known.insert(variable.index).second)
            found.push_back({std::move(name), variable});
    };
    for (const Network::Controller& controller : network.controllers) {
        const std::string prefix = network.controllers.size() > 1 ? controller.words.name + "." : "";
        if (inputs)
            for (const auto& input : controller.words.inputs) add(input.name, input.variable);
        for (const auto& step : controller.words.steps) add(prefix + step.name.variable(), step.variable);
        for (const auto& output : controller.words.outputs) add(output.name, output.variable);
    }
    return found;
}

Id<Expr> any_of_signals(Network& network, const std::vector<std::string>& names) {
    std::vector<Id<Expr>> terms;
    for (const ControllerSignal& each : controller_signals(network, false))
        if (std::ranges::find(names, each.name) != names.end())
            terms.push_back(network.exprs.leaf(Op::Variable, each.variable.index));
    return network.exprs.disjunction(terms);
}

FaultDetection::FaultDetection(const Network& network, const Limits& limits, std::uint64_t max_states)
    : network_(network),
      limits_(limits),
      max_states_(max_states),
      signals_(controller_signals(network, true)),
      normal_(pairs_in(network)) {}

FaultDetection::Detected FaultDetection::detected(Network faulty, const std::string& instance,
                                                  const std::vector<std::string>& names, const Decide& decide) const {
    const Id<Expr> condition = any_of_signals(faulty, names);
    faulty.properties = {};
    faulty.properties.add(
        {.name = "shown", .pattern = Pattern::LeadsTo, .operands = {occurs(faulty, instance), condition}});
    Detected found{outcome_of(decide(faulty), "shown"), {}};
    if (found.in_every_run == Outcome::Holds) found.within_ms = longest_time(std::move(faulty), instance, condition);
    return found;
}

/// Returns the longest time from the fault to `condition`, in ms. Requires that the fault leads to the condition.
std::optional<std::int64_t> FaultDetection::longest_time(Network network, const std::string& instance,
                                                         Id<Expr> condition) const {
    network.properties = {};
    network.properties.add(
        {.name = "shown",
         .pattern = Pattern::Watched,
         .operands = {occurs(network, instance), condition},
         .watch = {.kind = Sentence::Kind::Response, .duration_ms = longest_units * network.time_unit_ms}});
    const Network observed = grafverif::observed(network, watched(network));
    const std::size_t observer = observed.processes.size() - 1;
    TimedOptions options{.max_states = max_states_, .timelock = false, .covering = false, .profile = ProfileFor::None};
    set_limits(options, limits_);
    std::int64_t units = 0;
    options.each_state = [&](const NetworkState& state) {
        for (const std::int64_t clock : state.clocks[observer]) units = std::max(units, clock);
    };
    const TimedResult result = check_timed(observed, options);
    if (!result.complete || outcome_of(result.verdicts, "shown") != Outcome::Holds) return {};
    return units * network.time_unit_ms;
}

std::optional<FaultDetection::Pairs> FaultDetection::pairs_in(Network network) const {
    network.properties = {};
    network.properties.add({.name = "any", .pattern = Pattern::Never, .operands = {network.exprs.constant(false)}});
    TimedOptions options{.max_states = max_states_, .timelock = false, .covering = false, .profile = ProfileFor::None};
    set_limits(options, limits_);
    const std::vector<ControllerSignal> signals = controller_signals(network, true);
    std::map<std::vector<bool>, std::uint32_t> valuations;  // of the signals, with their numbers of quiescent states
    std::vector<bool> now(signals.size());
    options.each_state = [&](const NetworkState& state) {
        if (value(network, state, network.settled).value_or(0) == 0) return;
        for (std::size_t k = 0; k < now.size(); ++k) now[k] = state.variables[signals[k].variable.index] != 0;
        ++valuations[now];
    };
    const TimedResult result = check_timed(network, options);
    if (!result.complete) return {};
    const std::size_t literals = 2 * signals.size();
    Pairs pairs{.counts = std::vector<std::uint32_t>(literals * literals),
                .exact = outcome_of(result.verdicts, "any") == Outcome::Holds};
    const auto true_literal = [](const std::vector<bool>& values, std::size_t k) {
        return 2 * k + (values[k] ? 0 : 1);
    };
    for (const auto& [values, states] : valuations)
        for (std::size_t k = 0; k < values.size(); ++k)
            for (std::size_t l = k; l < values.size(); ++l)
                pairs.counts[true_literal(values, k) * literals + true_literal(values, l)] += states;
    return pairs;
}

std::vector<std::size_t> FaultDetection::candidates(const std::vector<std::uint32_t>& with_fault) const {
    const std::size_t literals = 2 * signals_.size();
    const auto never = [&](std::size_t k, std::size_t l) { return normal_->counts[k * literals + l] == 0; };
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < literals; ++k)
        for (std::size_t l = k; l < literals; ++l) {
            if (!never(k, l) || with_fault[k * literals + l] == 0) continue;
            // A literal that is never true without faults is sufficient to reveal the fault, so no pair with it is
            // needed.
            if (k == l || (!never(k, k) && !never(l, l))) found.push_back(k * literals + l);
        }
    std::ranges::stable_sort(found, std::greater<>(), [&](std::size_t pair) { return with_fault[pair]; });
    return found;
}

std::string FaultDetection::declared(std::size_t pair) const {
    const std::size_t literals = 2 * signals_.size();
    const std::size_t first = pair / literals, second = pair % literals;
    const auto is_read = [&](const Expr& leaf) {
        return leaf.op == Op::Variable &&
               (signals_[first / 2].variable.index == leaf.value || signals_[second / 2].variable.index == leaf.value);
    };
    for (const Property& property : network_.properties) {
        if (!property.at_stable || (property.pattern != Pattern::Always && property.pattern != Pattern::Never))
            continue;
        if (!std::ranges::all_of(leaves(network_.exprs, property.operands.front()),
                                 [&](Id<Expr> leaf) { return is_read(network_.exprs[leaf]); }))
            continue;
        NetworkState state;
        state.variables.resize(network_.variables.size());
        // The pair is the only combination of values of its variables that violates the property.
        bool same = true;
        for (std::size_t bits = 0; bits < 4; ++bits) {
            state.variables[signals_[first / 2].variable.index] = (bits & 1) != 0 ? 1 : 0;
            state.variables[signals_[second / 2].variable.index] = (bits & 2) != 0 ? 1 : 0;
            const auto is_true = [&](std::size_t k) {
                return (state.variables[signals_[k / 2].variable.index] != 0) == (k % 2 == 0);
            };
            const auto condition = value(network_, state, property.operands.front());
            const bool violated = condition && (*condition != 0) == (property.pattern == Pattern::Never);
            same = same && violated == (is_true(first) && is_true(second));
        }
        if (same) return property.name;
    }
    return {};
}

FaultDetection::Proposal FaultDetection::observer(const std::string& name, const Network& faulty,
                                                  const std::string& instance, const Decide& decide) const {
    const auto pairs = normal_ ? pairs_in(faulty) : std::nullopt;
    if (!pairs && is_over(limits_.deadline, limits_.stop)) return {{}, "the search for an observer was stopped"};
    if (!pairs) return {{}, fmt::format("the search for an observer ended at {} states", max_states_)};
    const std::size_t literals = 2 * signals_.size();
    std::vector<std::size_t> candidates = this->candidates(pairs->counts);
    Proposal proposal;
    if (candidates.size() > most_tried) {
        proposal.limit =
            fmt::format("the search for an observer tried {} of {} conditions", most_tried, candidates.size());
        candidates.resize(most_tried);
    }
    if (candidates.empty()) return {};
    if (!normal_->exact) return proposal;

    Network after = faulty;
    after.properties = {};
    std::vector<Id<Expr>> conditions;
    for (const std::size_t pair : candidates) {
        conditions.push_back(after.exprs.conjunction(conjunction(after, pair, literals), after.settled));
        after.properties.add({.name = "pair_" + std::to_string(pair),
                              .pattern = Pattern::LeadsTo,
                              .operands = {occurs(after, instance), conditions.back()}});
    }
    const std::vector<Verdict> verdicts = decide(after);
    const auto in_every_run = [&](std::size_t pair) { return outcome_of(verdicts, "pair_" + std::to_string(pair)); };
    auto chosen = std::ranges::find(candidates, Outcome::Holds, in_every_run);
    if (chosen == candidates.end()) chosen = candidates.begin();
    const auto text = [&](std::size_t k) { return (k % 2 == 0 ? "" : "!") + signals_[k / 2].name; };
    const std::size_t first = *chosen / literals, second = *chosen % literals;
    const std::string declared = this->declared(*chosen);
    proposal.observer = FaultAnalysis::Observer{
        .property = fmt::format("property {}: never {}{} at stable;", declared.empty() ? name : declared, text(first),
                                first == second ? "" : " && " + text(second)),
        .in_every_run = in_every_run(*chosen),
        .declared = declared};
    if (proposal.observer->in_every_run != Outcome::Holds) return proposal;
    proposal.limit.clear();  // a condition that is true in every run is the best result
    proposal.observer->within_ms =
        longest_time(std::move(after), instance, conditions[static_cast<std::size_t>(chosen - candidates.begin())]);
    return proposal;
}

}  // namespace grafverif
