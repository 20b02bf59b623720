// SPDX-License-Identifier: MIT
#include "pipeline/staged_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <memory>

#include "check/pdr/check.hpp"
#include "explain/moves.hpp"
#include "ir/probes.hpp"
#include "support/element_of.hpp"

namespace grafverif {

namespace {

/// Returns the number as text with thousands separators, such as `1,234,567`.
std::string grouped(std::uint64_t number) {
    std::string text = std::to_string(number);
    for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
    return text;
}

std::string progress_text(const TimedProgress& now) {
    const double rate = now.seconds > 0 ? static_cast<double>(now.states) / now.seconds / 1e6 : 0;
    return fmt::format("{} states, {:.2f} million/s, {} open, {} MiB, {:.0f} s", grouped(now.states), rate,
                       grouped(now.queue), now.bytes >> 20U, now.seconds);
}

bool is_limited(const Verdict& verdict) {
    return verdict.obstacle == UnknownReason::Bound || verdict.obstacle == UnknownReason::Stopped;
}

}  // namespace

TimedOptions timed_options(const LoopToCheck& loop, const CheckOptions& options) {
    TimedOptions timed;
    timed.finest = loop.finest;
    timed.properties = options.properties;
    timed.max_states = options.limits.states.value_or(timed.max_states);
    set_limits(timed, options.limits);
    if (options.limits.progress)
        timed.progress = [&options](const TimedProgress& now) {
            options.limits.progress({[&now] { return progress_text(now); }});
        };
    timed.jobs = options.jobs;
    timed.covering = !options.whole;
    timed.profile = options.profile ? ProfileFor::All : ProfileFor::IfLarge;
    timed.many = options.many;
    return timed;
}

StateProver prover_by_pdr(AbstractionTranslator system_of) {
    struct Known {
        bool no_fault = false;                                               // true if a proof excludes model errors
        std::chrono::steady_clock::duration time = std::chrono::seconds(4);  // limit of the next attempt
        std::vector<pdr::NamedCube> pairs = {};  // invariants found so far, for later abstractions
    };
    // Copies of the prover share the translator, because the translator stores equations.
    return [system_of = std::make_shared<AbstractionTranslator>(std::move(system_of)),
            known = std::make_shared<Known>()](const ProofTask& task) -> Proof {
        if (known->no_fault && excludes_fault(element_of(task.abstraction.properties, task.property, &Property::name)))
            return {Outcome::Holds};
        const std::optional<TransitionSystem> system = (*system_of)(task.abstraction);
        if (!system) return {};
        PdrOptions pdr;
        pdr.max_memory = task.memory;
        pdr.deadline = task.share;
        pdr.stop = task.stop;
        pdr.pairs = &known->pairs;
        pdr.shorten_for = std::chrono::milliseconds(100);
        const auto check = [&](std::vector<std::string> names) {
            pdr.properties = std::move(names);
            PdrResult found = check_pdr(*system, pdr);
            if (!found.failures.empty()) found.verdicts.clear();
            return found;
        };
        PdrResult first = check({task.property});
        std::vector<Verdict>& found = first.verdicts;
        if (found.size() != 1 || found.front().outcome == Outcome::Unknown) return {};
        if (found.front().outcome == Outcome::Violated) {
            std::optional<Moves> moves = moves_of(task.abstraction, *system, first.runs.front().value());
            return {Outcome::Violated, moves ? std::optional(std::move(moves->run)) : std::nullopt};
        }
        if (known->no_fault) return {Outcome::Holds};
        if (std::vector<std::string> names = unproven_faults(*system, found); !names.empty()) {
            const auto end = std::chrono::steady_clock::now() + std::exchange(known->time, known->time * 2);
            pdr.deadline = task.end ? std::min(end, *task.end) : end;
            std::ranges::move(check(std::move(names)).verdicts, std::back_inserter(found));
        }
        known->no_fault = unproven_faults(*system, found).empty();
        return {known->no_fault ? Outcome::Holds : Outcome::Unknown};
    };
}

StagedSearch::StagedSearch(const LoopToCheck& loop, const Observe& observe, const Network& network,
                           const CheckOptions& options, AdditionalResults additional)
    : is_watched_(&network != &loop.network),
      in_steps_(!options.whole),
      loop_(loop),
      observe_(observe),
      network_(network),
      options_(timed_options(loop, options)) {
    // The profile in a report is that of the loop without observers.
    options_.timelock = additional.timelock && !is_watched_;
    if (additional.profile && !is_watched_) return;
    options_.profile = ProfileFor::None;
    options_.many = {};
}

void StagedSearch::make_brief() {
    // If the limit of the user is not greater than the bound of the first search, input abstraction is not used.
    is_brief_ = options_.max_states > LocalizationLimits{}.whole;
    options_.max_states = std::min(options_.max_states, LocalizationLimits{}.whole);
}

void StagedSearch::begin(const Deadline& deadline, LocalizationLimits limits, const InputLimits& inputs) {
    if (options_.max_states <= LocalizationLimits{}.whole || loop_.disabled_corrections)
        in_steps_ = in_steps_ && !is_watched_;
    options_.deadline = deadline;
    if (!in_steps_) return void(result_ = check_timed(network_, options_));
    if (is_watched_) limits.local = 0;
    const WholeSearch search = is_watched_ ? WholeSearch(check_timed) : WholeSearch(check_timed_by_parts);
    complete_.emplace(expand(network_), options_, limits, LocalAblations{}, search);
    complete_->begin();
    const bool is_open = is_brief_ ? is_large() : options_.max_states > limits.whole && needs_whole();
    if (loop_.disabled_corrections || !is_open) return;
    expanded_ = expand(loop_.network);
    abstract_ = options_;
    abstract_.max_states = TimedOptions{}.max_states;
    inputs_.emplace(expanded_, observe_, abstract_, complete_->found(), inputs, InputAblations{}, loop_.prove);
    refines_inputs_ = true;
}

bool StagedSearch::refine(std::uint64_t states, const Deadline& deadline) {
    // While input abstraction continues, the searches of fragments by localization are limited, because large searches
    // would leave no time for input abstraction.
    const bool cells =
        complete_ && (refines_inputs_ ? complete_->refine(std::min(states, search_rounds[1]), share_of(deadline, 3))
                                      : complete_->refine(states, deadline));
    refines_inputs_ = inputs_ && inputs_->run(states, deadline);
    return (cells || refines_inputs_) && !is_brief_;
}

bool StagedSearch::decides_only_vacuity() {
    return complete_ && std::ranges::all_of(complete_->found().verdicts, [&](const Verdict& verdict) {
               return verdict.outcome != Outcome::Unknown ||
                      (verdict.about.valid() && is_probe(network_.properties[verdict.about]));
           });
}

bool StagedSearch::needs_whole() {
    return complete_ && complete_->needs_whole() &&
           std::ranges::any_of(complete_->found().verdicts, [&](const Verdict& verdict) {
               return is_limited(verdict) && !(verdict.about.valid() && is_probe(network_.properties[verdict.about]));
           });
}

void StagedSearch::search_complete(const Deadline& deadline) {
    options_.deadline = deadline;
    inputs_.reset();  // frees the memory of the input abstraction
    complete_->search_complete();
}

bool StagedSearch::is_large() { return complete_ && std::ranges::any_of(complete_->found().verdicts, is_limited); }

}  // namespace grafverif
