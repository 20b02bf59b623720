// SPDX-License-Identifier: MIT
// InputAbstractionCheck: proofs of `no timelock`, `no deadlock`, `always possible`, `inevitable` and `leads to`.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "check/inputs/evolutions.hpp"
#include "check/inputs/input_check.hpp"
#include "check/inputs/response.hpp"
#include "check/inputs/resting.hpp"
#include "check/timed/property_queries.hpp"
#include "ir/network_subsystems.hpp"

namespace grafverif {

/// True for verdicts on `no deadlock` and on `no timelock`, even if the model does not declare `no timelock`.
bool InputAbstractionCheck::is_about_passing(const Verdict& verdict) const {
    if (!verdict.about.valid()) return true;
    const Property& property = observed_.properties[verdict.about];
    return property.pattern == Pattern::NoDeadlock || timed::about_time(property);
}

/// Returns the coarsest levels for a proof by instants (ChoiceLifetime::Instant): the levels abstract only autonomous
/// instances that need not move.
InputAbstractionCheck::Levels InputAbstractionCheck::levels_of_resting() const {
    Levels levels;
    for (const AbstractableProcess& process : instances_) {
        const bool abstracted = process.autonomous && process.can_rest;
        const bool chosen = abstracted && !process.valuations.empty();
        levels.push_back(chosen ? InputLevel::Chosen : abstracted ? InputLevel::Untimed : InputLevel::Complete);
    }
    if (!ablations_.ignore_readers) store_what_is_read(instances_, levels);
    limit_choices(levels);
    return levels;
}

/// True if each independent subsystem has an instance that can always make a further move after some time.
bool InputAbstractionCheck::each_part_is_lively() const {
    const NetworkSubsystems parts = parts_of(loop_);
    std::vector<bool> lively(parts.count, false);
    for (const AbstractableProcess& instance : instances_)
        if (instance.lively) lively[parts.of_process[instance.process.index]] = true;
    return std::ranges::find(lively, false) == lively.end();
}

/// Returns the task for `no timelock`. A proof by evolutions of the PLCs (ChoiceLifetime::Evolution) requires
/// lets_time_pass(loop) and that integer time is exact. If a requirement is not satisfied, the task is a proof by
/// instants (ChoiceLifetime::Instant).
InputAbstractionCheck::Task InputAbstractionCheck::passing_task() const {
    if (timed::inexact_place(loop_) || !lets_time_pass(loop_, ablations_))
        return {levels_of_resting(), {}, 0, false, Kind::Passing};
    return {first_levels({}, true), {}, 0, false, Kind::Evolution};
}

/// True if the evolutions of the PLCs end, and no edge of a PLC has a model error. The proof considers each group of
/// variables separately, and may not exclude a model error that depends on a step and a counter. In this case, a search
/// excludes model errors, and the proof is repeated.
bool InputAbstractionCheck::proves_evolutions() {
    const auto end = [&](bool errors_are_excluded) {
        return evolutions_end(
            loop_, instances_,
            {.memory = options_.max_memory, .deadline = share_of(deadline_, 8), .stop = options_.stop},
            errors_are_excluded);
    };
    if (!evolutions_end_) evolutions_end_ = end(false);
    if (evolutions_end_ == false && !errors_were_ignored_ && excludes_errors()) {
        errors_were_ignored_ = true;
        evolutions_end_ = end(true);
    }
    return evolutions_end_.value_or(false);
}

/// True if no edge of a PLC has a model error: a complete search of an abstraction, which has all runs of the loop, has
/// found no model error.
bool InputAbstractionCheck::excludes_errors() {
    if (errors_are_excluded_ || ablations_.ignore_errors) return true;
    const Task task{.levels = first_levels({}, true), .coarse = true};
    const InputAbstraction abstraction = abstract_inputs(loop_, instances_, task.levels, ablations_);
    Network network = in_longest_unit(expand(abstraction.network), abstraction.paced);
    network.properties = {};
    network.properties.add({.name = "none", .pattern = Pattern::Never, .operands = {network.exprs.constant(false)}});
    TimedOptions options = options_;
    options.properties = {"none"};
    options.timelock = false;
    searched(network, abstraction, options, task);
    return errors_are_excluded_;
}

void InputAbstractionCheck::search_passing(const Task& task) {
    const bool by_evolutions = task.kind == Kind::Evolution;
    if (by_evolutions && !ablations_.search_evolutions && proves_evolutions()) {
        Verdict proof;
        proof.outcome = Outcome::Holds;
        proof.notes = {"proved separately for the processes and for the evolutions of the charts"};
        return conclude_passing(
            proof, Task{.levels = Levels(instances_.size(), InputLevel::Complete), .verdicts = task.verdicts});
    }
    const InputAbstraction abstraction =
        abstract_inputs(loop_, instances_, task.levels, ablations_,
                        by_evolutions ? ChoiceLifetime::Evolution : ChoiceLifetime::Instant);
    TimedOptions options = options_;
    options.properties = {timed::undeclared_timelock(loop_).name};
    options.timelock = true;
    options.abstracted = true;
    const TimedResult found = searched(in_longest_unit(expand(abstraction.network)), abstraction, options, task);
    const auto passes = std::ranges::find_if(found.verdicts, [&](const Verdict& verdict) {
        return !verdict.about.valid() || timed::about_time(abstraction.network.properties[verdict.about]);
    });
    const bool open = passes == found.verdicts.end() || passes->outcome == Outcome::Unknown;
    if (ends_with_round(task, found) || (open && stopped())) return postponed_.push_back(task);
    const bool holds = passes != found.verdicts.end() && passes->outcome == Outcome::Holds && found.complete;
    if (!holds && !(by_evolutions && ablations_.ignore_evolutions)) {
        if (by_evolutions) tasks_.push_front({levels_of_resting(), task.verdicts, 0, false, Kind::Passing});
        else if (passes != found.verdicts.end() && passes->reason == timed::endless_instants) note_no_proof(task);
        return;
    }
    Verdict proof;
    proof.outcome = Outcome::Holds;
    proof.states = std::to_string(found.states);
    proof.transitions = found.transitions;
    conclude_passing(proof, task);
}

/// Applies the proof that time diverges to the verdicts of the task.
void InputAbstractionCheck::conclude_passing(const Verdict& proof, const Task& task) {
    time_diverges_ = true;
    const bool lively = each_part_is_lively();
    for (const std::size_t k : task.verdicts) {
        const Verdict& verdict = result_.verdicts[k];
        const bool about_deadlock =
            verdict.about.valid() && observed_.properties[verdict.about].pattern == Pattern::NoDeadlock;
        if (!about_deadlock || lively) conclude(k, proof, task.levels);
    }
}

/// Adds a note to the verdicts of the task after a failed proof. A frequent cause is a chart that is unstable for some
/// inputs.
void InputAbstractionCheck::note_no_proof(const Task& task) {
    const auto searches_stability = [](const Network::Controller& controller) {
        return controller.words.mode == ExecutionMode::StabilitySearch;
    };
    if (!std::ranges::all_of(loop_.controllers, searches_stability)) return;
    for (const std::size_t k : task.verdicts)
        if (is_open(k))
            result_.verdicts[k].notes.emplace_back(
                "no proof by input abstraction: with freely chosen inputs, time may stop while the situation changes; "
                "`grafverif analyse` reports whether the chart is unstable for some inputs");
}

/// Proves `always possible` (possible.hpp), or `inevitable` and `leads to` (response.hpp). The proofs require that an
/// earlier search has proved that time diverges. If that earlier search is postponed, this task is also postponed.
void InputAbstractionCheck::search_progress(const Task& task) {
    if (!time_diverges_ && !ablations_.need_not_diverge) {
        if (std::ranges::any_of(postponed_, [](const Task& other) {
                return other.kind == Kind::Evolution || other.kind == Kind::Passing;
            }))
            postponed_.push_back(task);
        return;
    }
    if (timed::inexact_place(loop_)) return;
    const FollowLimits limits{.states = std::min(round_, limits_.states),
                              .bytes = options_.max_memory / 4,
                              .deadline = deadline_,
                              .stop = options_.stop};
    std::vector<std::size_t> open;
    for (const std::size_t k : task.verdicts) {
        if (!is_open(k)) continue;
        const auto proved = task.kind == Kind::Possible ? prove_possible(k, limits) : prove_response(k, limits);
        if (!proved) open.push_back(k);
    }
    // In the last round, the proof ended at its own limit and not at the bound of the round, so another round would not
    // help.
    if (open.empty() || (!stopped() && round_ >= limits_.states)) return;
    postpone(task, std::move(open));
}

/// Returns the property of `loop_` that has the same name as the property of verdict k. The property of `observed_`
/// cannot be used for `loop_`, because its terms belong to `observed_`.
const Property& InputAbstractionCheck::property_of_loop(std::size_t k) const {
    const std::string& name = observed_.properties[result_.verdicts[k].about].name;
    return *std::ranges::find(loop_.properties, name, &Property::name);
}

std::optional<bool> InputAbstractionCheck::prove_possible(std::size_t k, const FollowLimits& limits) {
    if (!possible_) possible_.emplace(loop_, instances_, ablations_);
    const std::size_t before = possible_->states();
    const std::optional<bool> proved = possible_->proves(property_of_loop(k), limits);
    result_.states += possible_->states() - before;
    if (!proved || !*proved) return proved;
    Verdict found;
    found.outcome = Outcome::Holds;
    found.states = std::to_string(possible_->states());
    found.notes = {"the proof uses only edges that can be taken for all values of the clocks"};
    if (const std::vector<std::string>& moves = possible_->sequence(); !moves.empty())
        found.notes.push_back(fmt::format("from every state, few states are possible after these moves: {}",
                                          fmt::join(moves, ", then ")));
    conclude(k, found, possible_->levels());
    return true;
}

std::optional<bool> InputAbstractionCheck::prove_response(std::size_t k, const FollowLimits& limits) {
    if (!takes_time_) takes_time_ = takes_time(loop_);
    if (!*takes_time_ && !ablations_.need_not_take_time) return false;
    const ResponseResult result = grafverif::prove_response(loop_, instances_, property_of_loop(k), limits, ablations_);
    result_.states += result.states;
    if (!result.holds || !*result.holds) return result.holds;
    Verdict found;
    found.outcome = Outcome::Holds;
    found.vacuous = result.vacuous;
    found.states = std::to_string(result.states);
    if (result.vacuous) found.notes = {"the premise is never true"};
    else if (property_of_loop(k).pattern == Pattern::LeadsTo)
        found.notes = {"vacuity is unknown: the abstraction does not show that the premise is ever true"};
    conclude(k, found, result.levels);
    return true;
}

}  // namespace grafverif
