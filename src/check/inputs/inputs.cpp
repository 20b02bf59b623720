// SPDX-License-Identifier: MIT
#include "check/inputs/inputs.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <map>

#include "check/inputs/input_check.hpp"
#include "check/timed/layout.hpp"
#include "check/timed/program.hpp"
#include "grafverif/ir/chart_run.hpp"
#include "ir/network_run.hpp"
#include "ir/patterns.hpp"

namespace grafverif {

void InputAbstractionCheck::collect() {
    for (const Id<Network::Process> id : observed_.processes.ids())
        for (const Id<Network::Variable> variable : Slots(observed_, id).written())
            writers_[variable.index].insert(id.index);
    std::map<std::pair<bool, Levels>, Task> groups;
    Task passing = passing_task(), possible{.kind = Kind::Possible}, response{.kind = Kind::Response};
    for (std::size_t k = 0; k < result_.verdicts.size(); ++k) {
        const Verdict& verdict = result_.verdicts[k];
        const bool is_limited = verdict.obstacle == UnknownReason::Bound || verdict.obstacle == UnknownReason::Stopped;
        if (is_limited && is_about_passing(verdict)) passing.verdicts.push_back(k);
        if (!verdict.about.valid()) continue;
        const Property& property = observed_.properties[verdict.about];
        // If a property has an observer, the property of the same name in `loop_` has another pattern. A proof of the
        // property would have to include the observer.
        const bool is_of_loop = std::ranges::any_of(loop_.properties, [&](const Property& of_loop) {
            return of_loop.name == property.name && of_loop.pattern == property.pattern;
        });
        if (is_of_loop && (is_limited || verdict.obstacle == UnknownReason::Inexact)) {
            if (property.pattern == Pattern::AlwaysPossible && (!property.at_stable || result_.settles))
                possible.verdicts.push_back(k);
            if (is_liveness(property.pattern) && !property.at_stable) {
                response.verdicts.push_back(k);
                explored_.push_back(k);
            }
        }
        if (!is_limited) continue;
        if (!is_about_states(property.pattern)) continue;
        if (property.at_stable && !result_.settles) continue;
        explored_.push_back(k);
        Levels levels = first_levels(property, false);
        Levels coarser = first_levels(property, true);
        const bool coarse = coarser != levels;
        if (coarse) levels = std::move(coarser);
        begin_with_known(property, levels);
        Task& task = groups[{!coarse, levels}];
        task.levels = std::move(levels);
        task.coarse = coarse;
        task.rounded = has_observer();
        task.verdicts.push_back(k);
    }
    for (auto& [order, task] : groups) tasks_.push_back(std::move(task));
    // True if the proof of an undecided property requires that time diverges.
    const bool progress = !possible.verdicts.empty() || !response.verdicts.empty();
    if (!possible.verdicts.empty()) tasks_.push_front(std::move(possible));
    if (!response.verdicts.empty()) tasks_.push_front(std::move(response));
    if (progress) tasks_.push_front(std::move(passing));
    else if (!passing.verdicts.empty()) tasks_.push_back(std::move(passing));
}

/// Searches the complete loop for runs that decide a property. Returns false if the next round would find no further
/// run. The function does not search a loop with observers, because observers multiply the number of states.
bool InputAbstractionCheck::explore() {
    const auto is_open_state_property = [&](std::size_t k) { return is_open(k) && !is_liveness(single(k).pattern); };
    // A response that holds is usually proved by a search with fewer states, which follows in the same round.
    const std::uint64_t share = std::ranges::any_of(explored_, is_open_state_property) ? 1 : 4;
    const std::uint64_t states = std::min(round_ / share, limits_.explored);
    const bool looks =
        !has_observer() && states > 0 && std::ranges::any_of(explored_, [&](std::size_t k) { return is_open(k); });
    if (looks && search_for_runs(states) && states < limits_.explored) return true;
    explored_.clear();
    novelty_.reset();
    return false;
}

/// Continues the search of the complete loop up to `states` states. Returns false if the search cannot be continued.
bool InputAbstractionCheck::search_for_runs(std::uint64_t states) {
    if (!novelty_) {
        std::vector<Property> properties;
        for (const std::size_t k : explored_) properties.push_back(single(k));
        novelty_.emplace(stricter_, std::move(properties), instances_);
    }
    const std::size_t before = novelty_->states();
    const bool more = novelty_->run(
        {.states = states, .bytes = options_.max_memory / 4, .deadline = deadline_, .stop = options_.stop});
    result_.states += novelty_->states() - before;
    for (std::size_t i = 0; i < explored_.size(); ++i) {
        std::optional<Run> run = is_open(explored_[i]) ? novelty_->run_of(i) : std::nullopt;
        if (run) run = in_units(stricter_, std::move(*run));
        if (!run) continue;
        Verdict found;
        found.outcome = is_about_existence(single(explored_[i]).pattern) ? Outcome::Holds : Outcome::Violated;
        found.run = std::move(run);
        found.states = std::to_string(novelty_->states());
        conclude(explored_[i], found, Levels(instances_.size(), InputLevel::Complete));
    }
    return more;
}

/// Returns the coarsest abstraction levels for `property`, a property of observe(loop). A process that the property or
/// an observer reads never gets the level Chosen. If `coarse` is false, only autonomous instances (which read only
/// their own variables) are abstracted.
InputAbstractionCheck::Levels InputAbstractionCheck::first_levels(const Property& property, bool coarse) const {
    std::set<std::uint32_t> variables, processes;
    const auto read = [&](Id<Expr> term) {
        for (const Id<Expr> leaf : leaves(observed_.exprs, term)) {
            const Expr& node = observed_.exprs[leaf];
            if (node.op == Op::Variable) variables.insert(static_cast<std::uint32_t>(node.value));
            if (node.op == Op::At) processes.insert(at_process(node));
        }
    };
    for (const Id<Expr> operand : property.operands) read(operand);
    for (const Network::Process& process : observed_.processes) {
        if (process.kind != Network::ProcessKind::Observer) continue;
        const Network::Template& automaton = observed_.templates[process.automaton];
        for (const Network::Edge& edge : automaton.edges) {
            read(edge.guard);
            for (const Network::Assignment& assignment : edge.assignments) read(assignment.value);
        }
    }
    // An observer reads the location of a process through an additional variable that only this process writes. An
    // additional variable with several writers records an event.
    for (const std::uint32_t variable : variables) {
        if (variable < loop_.variables.size()) continue;
        const std::set<std::uint32_t>& writers = writers_[variable];
        if (writers.size() == 1) processes.insert(*writers.begin());
    }
    Levels levels;
    for (const AbstractableProcess& process : instances_) {
        bool is_stored = process.valuations.empty() || processes.contains(process.process.index);
        // An observer that reads the condition of quiescence reads the flag EVOL_PL, which is not an output.
        const Slots slots(loop_, process.process);
        for (const Id<Network::Variable> written : has_observer() ? slots.written() : process.outputs)
            is_stored = is_stored || variables.contains(written.index);
        const bool by_itself = process.autonomous && !process.valuations.empty();
        if (!by_itself && !coarse) levels.push_back(InputLevel::Complete);
        else if (!is_stored) levels.push_back(InputLevel::Chosen);
        // At the level Paced, each value lasts for some time. An observer reads every state, but the PLC need not
        // sample a value that lasts no time.
        else levels.push_back(has_observer() && process.autonomous ? InputLevel::Paced : InputLevel::Untimed);
    }
    if (!ablations_.ignore_readers) store_what_is_read(instances_, levels);
    limit_choices(levels);
    return levels;
}

/// Raises instances from Chosen to Untimed if timed::Choices cannot represent the choices of all Chosen instances.
void InputAbstractionCheck::limit_choices(Levels& levels) const {
    std::size_t splits = 0;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        if (levels[i] != InputLevel::Chosen) continue;
        const std::size_t more =
            (instances_[i].valuations.size() - 1) * std::max<std::size_t>(loop_.controllers.size(), 1);
        if (splits + more <= timed::Choices::most_splits) splits += more;
        else levels[i] = InputLevel::Untimed;
    }
    if (!ablations_.ignore_readers) store_what_is_read(instances_, levels);
}

/// If InputLimits::known contains an abstraction for the property, raises the levels to the levels of this abstraction.
void InputAbstractionCheck::begin_with_known(const Property& property, Levels& levels) const {
    const auto known = limits_.known.find(property.name);
    if (known == limits_.known.end()) return;
    const auto has = [](const std::vector<std::string>& names, const std::string& name) {
        return std::ranges::find(names, name) != names.end();
    };
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const std::string& name = loop_.processes[instances_[i].process].name;
        const auto& [chosen, untimed, paced] = known->second;
        levels[i] = std::max(levels[i], has(chosen, name)    ? InputLevel::Chosen
                                        : has(untimed, name) ? InputLevel::Untimed
                                        : has(paced, name)   ? InputLevel::Paced
                                                             : InputLevel::Complete);
    }
    if (!ablations_.ignore_readers) store_what_is_read(instances_, levels);
}

TimedResult InputAbstractionCheck::searched(const Network& network, const InputAbstraction& abstraction,
                                            TimedOptions options, const Task& task) {
    options.profile = ProfileFor::None;
    options.many = {};
    options.choices = abstraction.choices;
    options.macro_steps = {.enabled = true, .deferred = abstraction.deferred, .unprompted = abstraction.unprompted};
    options.max_states = std::min(round_, bound_of(task));
    if (const auto transitions = most_transitions(task)) options.max_transitions = *transitions;
    options.deadline = deadline_;
    TimedResult found = check_timed(network, options);
    result_.states += found.states;
    result_.transitions += found.transitions;
    result_.bytes = std::max(result_.bytes, found.bytes);
    result_.seconds += found.seconds;
    if (task.kind == Kind::SingleStates && found.complete && found.errors.empty()) errors_are_excluded_ = true;
    return found;
}

namespace {

/// Returns the states of a run of an abstraction without Chosen instances, or nullopt if the network cannot perform the
/// run.
std::optional<std::vector<AbstractState>> path_of(const Network& network, const Run& run) {
    const std::optional<std::vector<NetworkState>> states = replay(network, run);
    if (!states) return {};
    std::vector<AbstractState> path;
    for (std::size_t i = 0; i < run.moves.size(); ++i) path.push_back({run.moves[i], (*states)[i + 1], {}});
    return path;
}

}  // namespace

void InputAbstractionCheck::search(const Task& task) {
    const InputAbstraction abstraction = abstract_inputs(loop_, instances_, task.levels, ablations_);
    Network observed = expand(observe_(abstraction.network));
    std::vector<Id<Network::Process>> rounded;
    for (const Id<Network::Process> id : observed.processes.ids())
        if (task.rounded && observed.processes[id].kind == Network::ProcessKind::Observer) rounded.push_back(id);
    Network network = in_longest_unit(observed, abstraction.paced, rounded, ablations_);
    const bool is_stronger =
        !rounded.empty() &&
        network.time_unit_ms != in_longest_unit(std::move(observed), abstraction.paced).time_unit_ms;
    TimedOptions options = options_;
    options.properties.clear();
    for (const std::size_t k : task.verdicts) {
        if (!is_open(k)) continue;
        const std::string& name = observed_.properties[result_.verdicts[k].about].name;
        if (std::ranges::find(options.properties, name) == options.properties.end()) options.properties.push_back(name);
    }
    if (options.properties.empty()) return;
    // Removes all properties that this search does not decide. Otherwise, each search would also decide a declared
    // `no timelock`, although its verdict is not used.
    for (const Property& property : std::exchange(network.properties, {}))
        if (std::ranges::find(options.properties, property.name) != options.properties.end())
            network.properties.add(property);
    options.timelock = false;
    options.paths = true;
    options.until_decided = true;
    const TimedResult found = searched(network, abstraction, options, task);
    const bool ends = ends_with_round(task, found);
    std::vector<Task> next;
    std::vector<std::size_t> open;
    for (const std::size_t k : task.verdicts) {
        if (!is_open(k)) continue;
        const auto at = std::ranges::find(found.verdicts, result_.verdicts[k].property, &Verdict::property);
        if (at == found.verdicts.end()) continue;
        const std::vector<AbstractState>& path = found.paths[static_cast<std::size_t>(at - found.verdicts.begin())];
        if (!path.empty()) {
            std::vector<Levels> raised;
            const AbstractRun abstract{network, instances_, task.levels, abstraction.choices, path};
            if (std::optional<Run> run = real_run(k, abstract, task, raised)) {
                Verdict verdict = *at;
                verdict.run = std::move(run);
                conclude(k, verdict, task.levels);
            } else if (stopped()) {
                open.push_back(k);
            } else {
                add_alternatives(k, task, raised);
                refine(k, task, is_stronger ? End::RoundedRun : End::SpuriousRun, raised.front(), next);
            }
        } else if (found.complete && at->outcome != Outcome::Unknown) {
            Verdict verdict = *at;
            verdict.run.reset();
            if (is_stronger)
                verdict.notes.push_back(
                    fmt::format("a stronger property was proved: its duration is rounded to a multiple of {}",
                                seconds_text(network.time_unit_ms)));
            conclude(k, verdict, task.levels);
        } else if (ends || stopped()) {
            open.push_back(k);
        } else {
            refine(k, task, End::Limit, task.levels, next);
        }
    }
    if (!task.alternative) limited_.insert(open.begin(), open.end());
    if (!open.empty()) postpone(task, std::move(open));
    std::ranges::move(next, std::back_inserter(tasks_));
}

/// Examines the postponed properties with the symbolic engine, until the symbolic engine has used its share of the time
/// (InputLimits::symbolic_share).
void InputAbstractionCheck::decide_symbolically() {
    constexpr double least = 0.5;  // minimum time for one property, in seconds
    for (const Task& task : postponed_) {
        if (task.kind != Kind::SingleStates) continue;
        for (const std::size_t k : task.verdicts) {
            const double left = limits_.symbolic_share * since(begin_) - symbolic_seconds_;
            if (left < least || stopped()) return;
            const Property& property = observed_.properties[result_.verdicts[k].about];
            if (!is_open(k) || !is_about_all_states(property.pattern)) continue;
            const double most = std::exp2(2 * std::min(symbolic_calls_[k]++, 8));
            const TimePoint begin = std::chrono::steady_clock::now();
            const auto end = begin + std::chrono::milliseconds(static_cast<std::int64_t>(1000 * std::min(left, most)));
            decide_symbolically(k, task, deadline_ ? std::min(*deadline_, end) : end);
            symbolic_seconds_ += since(begin);
        }
    }
}

/// Decides property k with the symbolic engine, and refines the abstraction until `end`. The next call for this
/// property begins with the levels that this call has reached.
void InputAbstractionCheck::decide_symbolically(std::size_t k, const Task& task, const Deadline& end) {
    const Property& property = observed_.properties[result_.verdicts[k].about];
    Task symbolic{.levels = task.levels, .coarse = true};
    for (InputLevel& level : symbolic.levels) level = std::max(level, InputLevel::Untimed);
    Levels& levels = symbolic_levels_.try_emplace(k, symbolic.levels).first->second;
    while (!levels.empty() && !is_over(end, options_.stop)) {
        const InputAbstraction abstraction = abstract_inputs(loop_, instances_, levels, ablations_);
        const Network network =
            in_longest_unit(expand(observe_(abstraction.network)), abstraction.paced, {}, ablations_);
        if (timed::inexact_place(network)) return;
        const Proof proof = prove_({network, property.name, end, deadline_, options_.max_memory / 2, options_.stop});
        Verdict found;
        found.outcome = proof.outcome;
        if (proof.outcome == Outcome::Holds) {
            found.notes.emplace_back("proved by an inductive invariant of the abstraction");
            return conclude(k, found, levels);
        }
        if (proof.outcome == Outcome::Unknown) return;
        std::vector<Levels> raised;
        if (const auto path = proof.run ? path_of(network, *proof.run) : std::nullopt) {
            const AbstractRun abstract{network, instances_, levels, abstraction.choices, *path};
            found.run = real_run(k, abstract, symbolic, raised);
            if (found.run) return conclude(k, found, levels);
            if (stopped()) return;
        }
        const bool is_finer = !raised.empty() && raised.front() != levels;
        levels = is_finer ? std::move(raised.front()) : Levels();
    }
}

void InputAbstractionCheck::conclude(std::size_t k, const Verdict& found, const Levels& levels) {
    Verdict& verdict = result_.verdicts[k];
    verdict.outcome = found.outcome;
    verdict.obstacle = UnknownReason::None;
    verdict.reason.clear();
    verdict.vacuous = found.vacuous;
    verdict.notes.insert(verdict.notes.end(), found.notes.begin(), found.notes.end());
    verdict.run = found.run;
    verdict.states = found.states;
    verdict.transitions = found.transitions;
    verdict.abstraction = abstracted(levels);
}

/// Returns the property of verdict k. For `reachable all steps`, the result is the property for the step of this
/// verdict.
Property InputAbstractionCheck::single(std::size_t k) const {
    Property property = complete_.properties[result_.verdicts[k].about];
    if (property.pattern != Pattern::ReachableAllSteps) return property;
    std::size_t first = k;
    while (first > 0 && result_.verdicts[first - 1].about == result_.verdicts[k].about) --first;
    property.operands = {property.operands[k - first]};
    return property;
}

/// Converts a run of `complete_` or `stricter_` to the time unit of `observed_`. Returns nullopt if the converted run
/// is not a run of `observed_`.
std::optional<Run> InputAbstractionCheck::in_units(const Network& network, Run run) const {
    for (Move& move : run.moves)
        if (Delay* const delay = std::get_if<Delay>(&move))
            delay->units *= network.time_unit_ms / observed_.time_unit_ms;
    if (!replay(observed_, run)) return {};
    return run;
}

InputsAbstracted InputAbstractionCheck::abstracted(const Levels& levels) const {
    InputsAbstracted made;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const std::string& name = loop_.processes[instances_[i].process].name;
        if (levels[i] == InputLevel::Chosen) made.chosen.push_back(name);
        if (levels[i] == InputLevel::Untimed) made.untimed.push_back(name);
        if (levels[i] == InputLevel::Paced) made.paced.push_back(name);
    }
    return made;
}

InputSearch::InputSearch(const Network& loop, const Observe& observe, const TimedOptions& options, TimedResult& result,
                         const InputLimits& limits, const InputAblations& ablations, StateProver prove)
    : search_(std::make_unique<InputAbstractionCheck>(loop, observe, options, result, limits, ablations,
                                                      std::move(prove))) {}

InputSearch::~InputSearch() = default;

bool InputSearch::run(std::uint64_t states, const Deadline& deadline) { return search_->run(states, deadline); }

}  // namespace grafverif
