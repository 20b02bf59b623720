// SPDX-License-Identifier: MIT
// InputAbstractionCheck: the searches of an InputSearch (inputs.hpp).
#pragma once

#include <algorithm>
#include <chrono>
#include <deque>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "check/inputs/alternatives.hpp"
#include "check/inputs/follow.hpp"
#include "check/inputs/impossible.hpp"
#include "check/inputs/inputs.hpp"
#include "check/inputs/novelty.hpp"
#include "check/inputs/possible.hpp"
#include "ir/slots.hpp"

namespace grafverif {

class InputAbstractionCheck {
    using Levels = std::vector<InputLevel>;
    using TimePoint = std::chrono::steady_clock::time_point;

public:
    InputAbstractionCheck(const Network& loop, const Observe& observe, const TimedOptions& options, TimedResult& result,
                          const InputLimits& limits, const InputAblations& ablations, StateProver prove)
        : loop_(loop),
          observe_(observe),
          options_(options),
          result_(result),
          limits_(limits),
          ablations_(ablations),
          prove_(std::move(prove)),
          instances_(abstractable_processes(loop, ablations)),
          observed_(expand(observe(loop))),
          complete_(in_longest_unit(observed_)),
          stricter_(in_longer_unit(observed_, instances_)),
          writers_(observed_.variables.size()) {
        // If the loop has a model error or time cannot pass in it, a property that holds in an abstraction may hold
        // only vacuously.
        if (!instances_.empty() && result_.errors.empty() && result_.time_passes) collect();
    }

    bool run(std::uint64_t states, const Deadline& deadline) {
        round_begin_ = std::chrono::steady_clock::now();
        round_ = states;
        deadline_ = deadline;
        for (Task& task : tasks_) task.searches = 0;
        for (auto& [k, alternatives] : alternatives_) alternatives.begin_round();
        // The searches of the last round may use all of the time. In a search with an observer, alternatives delay no
        // other property.
        if (has_observer() || round_ >= limits_.states) search_alternatives();
        limited_.clear();
        const bool explores = explore();
        while (!tasks_.empty() && !stopped()) {
            const Task task = std::move(tasks_.front());
            tasks_.pop_front();
            switch (task.kind) {
            case Kind::SingleStates:
                if (has_open(task) && task.searches >= limits_.searches_per_round && round_ < bound_of(task))
                    postpone(task, task.verdicts);
                else search(task);
                break;
            case Kind::Evolution:
            case Kind::Passing: search_passing(task); break;
            case Kind::Possible:
            case Kind::Response: search_progress(task); break;
            }
        }
        if (prove_ && round_ >= limits_.symbolic_from) decide_symbolically();
        search_alternatives();
        seconds_ += since(round_begin_);
        std::ranges::move(std::exchange(postponed_, {}), std::back_inserter(tasks_));
        return !tasks_.empty() || explores || (round_ < limits_.states && has_alternatives());
    }

private:
    /// Properties that a task decides. SingleStates: properties about single states. Evolution, Passing: `no timelock`
    /// and `no deadlock`, with ChoiceLifetime::Evolution and ChoiceLifetime::Instant, respectively. Possible: `always
    /// possible`. Response: `leads to` and `inevitable`.
    enum class Kind : std::uint8_t { SingleStates, Evolution, Passing, Possible, Response };

    /// A task: properties to decide on one abstraction. A property is identified by the index of its verdict.
    struct Task {
        Levels levels = {};
        std::vector<std::size_t> verdicts = {};
        std::size_t rounds = 0;
        bool coarse = false;  // true if timers and instances that are not autonomous are also abstracted
        Kind kind = Kind::SingleStates;
        bool rounded = false;      // true if clock bounds of observers are rounded to the unit of all other processes
        std::size_t searches = 0;  // number of earlier searches for these properties in the current round
        // Set if the levels are an alternative for the only property of the task: the cost of this alternative.
        std::optional<std::size_t> alternative = {};
    };
    /// Maximum number of states of the search of an alternative.
    static constexpr std::uint64_t most_states_of_alternative = std::uint64_t{1} << 20U;

    bool has_observer() const { return observed_.processes.size() != loop_.processes.size(); }
    bool stopped() const { return is_over(deadline_, options_.stop); }
    static double since(TimePoint begin) {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
    /// Returns the maximum number of states of a search for the task, without the bound of the current round.
    std::uint64_t bound_of(const Task& task) const {
        const std::uint64_t states = task.alternative ? most_states_of_alternative
                                     : task.coarse    ? limits_.coarse_states
                                                      : limits_.states;
        return std::min(options_.max_states, states);
    }
    /// Returns the maximum number of transitions of the search of the task in the current round, if it is limited.
    std::optional<std::uint64_t> most_transitions(const Task& task) const {
        if (task.alternative) return transitions_left_;
        if (task.kind != Kind::SingleStates || round_ >= bound_of(task)) return {};
        return round_ * limits_.transitions;
    }
    /// True if the search of the task ended because it reached the bound of the current round.
    bool ends_with_round(const Task& task, const TimedResult& found) const {
        if (found.complete) return false;
        const std::optional<std::uint64_t> transitions = most_transitions(task);
        return (round_ < bound_of(task) && found.states >= round_) ||
               (transitions && found.transitions >= *transitions);
    }

    bool has_open(const Task& task) const {
        return std::ranges::any_of(task.verdicts, [&](std::size_t k) { return is_open(k); });
    }
    bool has_alternatives() const {
        return std::ranges::any_of(alternatives_,
                                   [&](const auto& each) { return is_open(each.first) && each.second.has_any(); });
    }
    /// Postpones the verdicts `open` of the task to the next round. If the search of an alternative has reached its
    /// greatest bound, the alternative is dropped.
    void postpone(Task task, std::vector<std::size_t> open) {
        if (task.alternative) {
            if (round_ < most_states_of_alternative)
                alternatives_[open.front()].postpone({std::move(task.levels), task.rounded, *task.alternative + 2});
            return;
        }
        task.verdicts = std::move(open);
        task.searches = 0;
        postponed_.push_back(std::move(task));
    }
    bool is_open(std::size_t verdict) const { return result_.verdicts[verdict].outcome == Outcome::Unknown; }

    void collect();
    bool explore();
    bool search_for_runs(std::uint64_t states);
    Levels first_levels(const Property& property, bool coarse) const;
    void begin_with_known(const Property& property, Levels& levels) const;
    /// Reason why the search of a task ended without a verdict. Limit: a limit was reached. SpuriousRun: the complete
    /// network may not have the run that the search found. RoundedRun: as SpuriousRun, in a network with rounded clock
    /// bounds.
    enum class End : std::uint8_t { Limit, SpuriousRun, RoundedRun };
    void refine(std::size_t verdict, const Task& task, End end, const Levels& levels, std::vector<Task>& tasks);
    void search(const Task& task);
    void search_passing(const Task& task);
    bool proves_evolutions();
    bool excludes_errors();
    void conclude_passing(const Verdict& proof, const Task& task);
    void note_no_proof(const Task& task);
    void search_progress(const Task& task);
    std::optional<bool> prove_possible(std::size_t verdict, const FollowLimits& limits);
    std::optional<bool> prove_response(std::size_t verdict, const FollowLimits& limits);
    Task passing_task() const;
    Levels levels_of_resting() const;
    void limit_choices(Levels& levels) const;
    bool each_part_is_lively() const;
    TimedResult searched(const Network& network, const InputAbstraction& abstraction, TimedOptions options,
                         const Task& task);
    void decide_symbolically();
    void decide_symbolically(std::size_t verdict, const Task& task, const Deadline& end);
    void conclude(std::size_t verdict, const Verdict& found, const Levels& levels);
    std::optional<Run> real_run(std::size_t verdict, const AbstractRun& abstract, const Task& task,
                                std::vector<Levels>& raised);
    std::optional<Run> in_units(const Network& network, Run run) const;
    ConcreteRun followed(std::size_t verdict, const AbstractRun& abstract, const Task& task) const;
    std::vector<Levels> raised_if_impossible(const AbstractRun& abstract, bool waits) const;
    void add_alternatives(std::size_t verdict, const Task& task, const std::vector<Levels>& raised);
    Levels completed(Levels levels) const;
    bool may_search_alternatives() const;
    void search_alternatives();
    InputsAbstracted abstracted(const Levels& levels) const;
    Property single(std::size_t verdict) const;
    const Property& property_of_loop(std::size_t verdict) const;
    bool is_about_passing(const Verdict& verdict) const;

    const Network& loop_;
    const Observe& observe_;
    const TimedOptions& options_;
    TimedResult& result_;
    const InputLimits limits_;
    const InputAblations ablations_;
    const StateProver prove_;
    const std::vector<AbstractableProcess> instances_;
    const Network observed_;
    // Complete network in its longest time unit.
    const Network complete_;
    // Complete network in a longer time unit (in_longer_unit). Searches for runs use `stricter_` before `complete_`,
    // because `stricter_` has fewer states.
    const Network stricter_;
    std::vector<std::set<std::uint32_t>> writers_;  // processes that write each variable of observed_
    std::deque<Task> tasks_ = {}, postponed_ = {};
    std::vector<std::size_t> explored_ = {};  // verdicts for which `novelty_` searches, in the order of its properties
    std::optional<NoveltySearch> novelty_ = {};
    std::map<std::size_t, Alternatives> alternatives_ = {};  // per verdict
    std::set<std::size_t> limited_ = {};  // verdicts whose preferred search has reached the bound of the current round
    double seconds_ = 0, alternative_seconds_ = 0;  // time of all earlier rounds, and of all alternatives
    std::uint64_t transitions_left_ = 0;  // number of transitions that alternatives for a property may still explore
    std::optional<PossibleProof> possible_ = {};
    // True if it is proved that time diverges in all runs in which the instances that need not move
    // (AbstractableProcess::can_rest) stay in their locations.
    bool time_diverges_ = false;
    // Per verdict: the abstraction levels with which the symbolic engine continues the search; empty if it cannot
    // continue.
    std::map<std::size_t, Levels> symbolic_levels_ = {};
    std::map<std::size_t, int> symbolic_calls_ = {};
    double symbolic_seconds_ = 0;
    const TimePoint begin_ = std::chrono::steady_clock::now();
    TimePoint round_begin_ = begin_;
    std::optional<bool> evolutions_end_ = {};  // result of the function evolutions_end; empty if not computed yet
    bool errors_are_excluded_ = false;         // true if a complete search of an abstraction found no model error
    bool errors_were_ignored_ = false;         // true if evolutions_end_ was computed with `errors_are_excluded`
    std::optional<bool> takes_time_ = {};      // result of the function takes_time; empty if not computed yet
    std::uint64_t round_ = 0;                  // bound of the searches of the current round
    Deadline deadline_ = {};
};

}  // namespace grafverif
