// SPDX-License-Identifier: MIT
#include "check/localization/localization.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "check/localization/faults.hpp"
#include "check/shares.hpp"
#include "check/timed/property_queries.hpp"
#include "ir/patterns.hpp"
#include "support/element_of.hpp"

namespace grafverif {

namespace {

/// Name of a property that the first search of the complete network also decides: some reachable state is quiescent.
constexpr const char* settled_probe = "some state is quiescent";

using Cells = std::vector<std::uint32_t>;

bool wanted(const Property& property) { return property.pattern == Pattern::Reachable; }

/// True if the verdict was decided without a search of the complete network.
bool is_decided_separately(const Verdict& verdict) { return verdict.scope.cells || verdict.abstraction; }

/// True if `options` select a property that localization can decide, or that the caller of a CellSearch can decide
/// between the steps of the search. An undeclared `no timelock` is such a property.
bool has_local(const Network& network, const TimedOptions& options) {
    const auto is_local = [&](const Property& property) {
        const Pattern pattern = property.pattern;
        return timed::is_selected(options, property) &&
               (is_about_states(pattern) || is_liveness(pattern) || pattern == Pattern::NoDeadlock ||
                pattern == Pattern::NoTimelock || pattern == Pattern::AlwaysPossible);
    };
    return terms_have_values(network) && (options.timelock || std::ranges::any_of(network.properties, is_local));
}

}  // namespace

class LocalizationCheck {
public:
    LocalizationCheck(Network network, const TimedOptions& options, const LocalizationLimits& limits,
                      const LocalAblations& ablations, const WholeSearch& whole)
        : network_(std::move(network)),
          cells_(cells_of(network_)),
          options_(options),
          limits_(limits),
          ablations_(ablations),
          whole_(whole) {}

    void begin() {
        if (!has_local(network_, options_)) return search_complete();
        search_complete_model();
        // If the first search found a model error, or time passes in no explored state, localization is not used: a
        // property that holds in an abstraction may be unknown or vacuous in the complete network.
        if (limits_.local == 0 || !is_open() || !result_.errors.empty() || !result_.time_passes) return;
        collect_queries();
        if (tasks_.empty() && !race_) return;
        may_err_ = cells_that_may_err(network_, cells_);
        if (may_err_.contains(NetworkFragments::none)) {
            tasks_.clear();
            return race_.reset();
        }
        refine(search_rounds[0], share_of(options_.deadline, 3));
    }

    bool refine(std::uint64_t states, const Deadline& deadline);

    TimedResult& found() { return result_; }
    bool needs_whole();
    void search_complete();
    TimedResult result();

private:
    /// A set of fragments to search, with the indices of the verdicts that the search can decide.
    struct Task {
        Cells cells = {};
        std::vector<std::size_t> requested = {};
        /// True if the task has no query; its search only checks the fragments for model errors.
        bool concerns_errors() const { return requested.empty(); }
    };

    /// A task whose search did not decide all its queries. `borders` and `tied` are the omitted fragments that the
    /// fragments of the task read; `known` is the number of invariants that were known before the search.
    struct Open {
        Task task = {};
        Cells borders = {}, tied = {};
        std::size_t known = 0;
    };

    /// A term that localization has proved to be true in every state of the complete network.
    struct Invariant {
        std::string name = {};
        Id<Expr> term = {};
        Cells reads = {};
    };

    void search_complete_model();
    bool is_open() const;
    void collect_queries();
    void search_round();
    bool awaits_verdict() const;
    bool is_open(std::size_t k) const { return result_.verdicts[k].outcome == Outcome::Unknown; }
    void search(Task task);
    void go_on_with(Open open);
    void know(const Property& property);
    std::string assumed_behaviour(const LocalNetwork& local) const;
    SearchScope scope(const std::set<std::uint32_t>& searched, std::string because) const;
    void take_local();

    Network network_;  // copy of the network, to whose term table localization adds terms
    const NetworkFragments cells_;
    const TimedOptions& options_;
    const LocalizationLimits limits_;
    const LocalAblations ablations_;
    const WholeSearch whole_;
    TimedResult result_ = {};
    // The property of each verdict; nullopt if localization cannot decide the property.
    std::vector<std::optional<Property>> questions_ = {};
    std::deque<Task> tasks_ = {};
    std::vector<Task> postponed_ = {};  // tasks whose searches ended at the state limit or the deadline of the round
    std::vector<Open> open_ = {};
    std::vector<Invariant> known_ = {};
    std::map<std::size_t, Verdict> found_ = {};  // verdicts found by localization
    std::optional<std::size_t> race_ = {};       // index of the verdict on action races
    std::set<std::uint32_t> may_err_ = {}, faultless_ = {};
    std::set<std::uint32_t> tried_ = {};  // fragments that may have a model error and have been searched
    std::uint64_t round_ = 0;             // maximum number of states of a search in the current round
    bool searched_whole_ = false;
    Deadline local_deadline_ = {};                                    // deadline of the searches of fragments
    std::uint64_t local_states_ = 0;                                  // number of states of all searches of fragments
    std::uint64_t faultless_states_ = 0, faultless_transitions_ = 0;  // totals of all searches that found no model
                                                                      // error
};

/// Explores at most `limits_.whole` states of the complete network. For a small model, this search is complete. In
/// larger models, states near the initial state often suffice to decide a property.
void LocalizationCheck::search_complete_model() {
    TimedOptions first = options_;
    first.max_states = std::min(options_.max_states, limits_.whole);
    const bool at_stable = std::ranges::any_of(network_.properties, [&](const Property& property) {
        return property.at_stable && is_about_single_states(property.pattern) && timed::is_selected(options_, property);
    });
    if (!at_stable) return void(result_ = whole_(network_, first));
    Network probed = network_;
    Property probe{.name = settled_probe, .pattern = Pattern::Reachable, .at_stable = true};
    probe.operands.push_back(probed.exprs.constant(true));
    probed.properties.add(std::move(probe));
    if (!first.properties.empty()) first.properties.emplace_back(settled_probe);
    result_ = whole_(probed, first);
    result_.settles = element_of(result_.verdicts, settled_probe, &Verdict::property).outcome == Outcome::Holds;
    std::erase_if(result_.verdicts, [](const Verdict& verdict) { return verdict.property == settled_probe; });
}

/// True if the verdict of some property is unknown because a search reached its state limit or was stopped.
bool LocalizationCheck::is_open() const {
    return std::ranges::any_of(result_.verdicts, [](const Verdict& verdict) {
        return verdict.obstacle == UnknownReason::Bound || verdict.obstacle == UnknownReason::Stopped;
    });
}

void LocalizationCheck::collect_queries() {
    std::map<Cells, std::vector<std::size_t>> groups;
    for (std::size_t k = 0; k < result_.verdicts.size(); ++k) {
        const Verdict& verdict = result_.verdicts[k];
        questions_.emplace_back();
        if (verdict.obstacle != UnknownReason::Bound || !verdict.about.valid()) continue;
        Property property = network_.properties[verdict.about];
        if (!is_about_single_states(property.pattern)) continue;
        if (property.at_stable && !result_.settles) continue;
        const Cells read = cells_read(network_, cells_, property);
        if (timed::about_race(network_, property)) race_ = k;
        if (read.empty() || read.size() == cells_.count) continue;
        questions_[k] = std::move(property);
        groups[read].push_back(k);
    }
    for (auto& [read, requested] : groups) tasks_.push_back({read, std::move(requested)});
    if (ablations_.unproven)
        for (const std::optional<Property>& question : questions_)
            if (question) know(*question);
}

/// A search that reaches the state limit of a round is repeated in the next round, with a greater limit. Therefore a
/// search with few states does not wait for a search with many states.
bool LocalizationCheck::refine(std::uint64_t states, const Deadline& deadline) {
    if (tasks_.empty() && !race_) return false;
    if (const std::uint64_t bound = std::min(states, limits_.local); bound > round_) {
        round_ = bound;
        local_deadline_ = deadline;
        std::ranges::stable_partition(tasks_, &Task::concerns_errors);
        search_round();
        std::ranges::move(std::exchange(postponed_, {}), std::back_inserter(tasks_));
        const auto is_faultless = [&](std::uint32_t cell) { return faultless_.contains(cell); };
        if (ablations_.break_off || std::ranges::all_of(may_err_, is_faultless)) take_local();
    }
    return !tasks_.empty() && round_ < limits_.local;
}

/// Performs the searches of one round. The verdicts of localization are valid only if no model error is possible in the
/// complete network. The searches for model errors are performed first, because the searches that add fragments for a
/// query may use all of the time.
void LocalizationCheck::search_round() {
    const auto search_tasks = [&] {
        while (!tasks_.empty()) {
            Task task = std::move(tasks_.front());
            tasks_.pop_front();
            search(std::move(task));
        }
    };
    // Adds fragments to the open tasks for which `selects` is true, until each of these tasks has a result or no
    // fragment can be added.
    const auto search_wider = [&](const auto& selects) {
        search_tasks();
        for (;;) {
            std::vector<Open> now;
            std::ranges::partition_copy(std::exchange(open_, {}), std::back_inserter(now), std::back_inserter(open_),
                                        selects);
            if (now.empty()) return;
            for (Open& open : now) go_on_with(std::move(open));
            search_tasks();
        }
    };
    const auto concerns_errors = [](const Open& open) { return open.task.concerns_errors(); };
    const auto search_each = [](const Open&) { return true; };
    const auto search_cells_that_may_err = [&](const auto& run) {
        for (const std::uint32_t cell : may_err_) {
            if (!awaits_verdict()) return;
            if (faultless_.contains(cell) || !tried_.insert(cell).second) continue;
            tasks_.push_back({{cell}, {}});
            run();
        }
    };
    search_tasks();
    search_cells_that_may_err(search_tasks);
    search_wider(concerns_errors);
    search_wider(search_each);
    search_cells_that_may_err([&] { search_wider(search_each); });
}

/// True if some open verdict depends only on the proof that no model error is possible.
bool LocalizationCheck::awaits_verdict() const {
    return (race_ && is_open(*race_)) ||
           std::ranges::any_of(found_, [&](const auto& entry) { return is_open(entry.first); });
}

void LocalizationCheck::search(Task task) {
    if (is_over(local_deadline_)) return postponed_.push_back(std::move(task));
    const bool concerns_errors = task.concerns_errors();
    std::erase_if(task.requested, [&](std::size_t k) { return !is_open(k); });
    if (task.requested.empty() && !concerns_errors) return;
    if (concerns_errors && !awaits_verdict()) return postponed_.push_back(std::move(task));
    std::vector<Property> properties;
    for (const std::size_t k : task.requested) properties.push_back(*questions_[k]);
    std::vector<Id<Expr>> invariants;
    for (const Invariant& invariant : known_) invariants.push_back(invariant.term);
    const LocalNetwork local = localized(network_, cells_, task.cells, properties, invariants, ablations_);
    const auto open = [&](Task left) { open_.push_back({std::move(left), local.borders, local.tied, known_.size()}); };
    if (!local.made) return open(task);
    TimedOptions options = options_;
    options.properties = {};
    options.timelock = false;
    options.profile = ProfileFor::None;
    options.many = {};
    options.deadline = local_deadline_;
    options.max_states = std::min(options_.max_states, round_);
    if (round_ < limits_.local) options.max_transitions = round_ * limits_.transitions;
    const TimedResult found = check_timed(local.network, options);
    result_.states += found.states;
    local_states_ += found.states;
    result_.transitions += found.transitions;
    result_.bytes = std::max(result_.bytes, found.bytes);
    result_.seconds += found.seconds;
    if (!found.complete) {
        const bool is_bounded = found.states >= round_ || found.transitions >= options.max_transitions;
        if (is_bounded || is_over(local_deadline_)) postponed_.push_back(std::move(task));
        return;
    }
    if (!found.errors.empty() && !ablations_.break_off) return open(task);
    faultless_.insert(task.cells.begin(), task.cells.end());
    faultless_states_ += found.states;
    faultless_transitions_ += found.transitions;
    Task left{task.cells, {}};
    for (std::size_t i = 0; i < task.requested.size(); ++i) {
        const std::size_t k = task.requested[i];
        const Verdict& verdict = found.verdicts[i];
        const Outcome carries = wanted(*questions_[k]) ? Outcome::Violated : Outcome::Holds;
        if (verdict.outcome == carries) {
            (found_[k] = verdict).scope =
                scope(std::set(task.cells.begin(), task.cells.end()), assumed_behaviour(local));
            know(*questions_[k]);
        } else {
            left.requested.push_back(k);
        }
    }
    if (!left.requested.empty()) open(std::move(left));
}

/// Adds a property that localization has proved to the invariants. The invariant is true in each state of a run before
/// the first model error, so results that are derived with the invariant are valid in these states. If a model error is
/// possible, no result of localization is reported.
void LocalizationCheck::know(const Property& property) {
    if (property.at_stable || timed::about_race(network_, property)) return;
    const Id<Expr> term = property.operands[0];
    const bool is_true = property.pattern == Pattern::Always;
    if (!is_true && property.pattern != Pattern::Never) return;
    for (const Id<Expr> leaf : leaves(network_.exprs, term))
        if (network_.exprs[leaf].op == Op::At) return;  // guards cannot read locations
    known_.push_back(
        {property.name, is_true ? term : network_.exprs.negation(term), cells_read(network_, cells_, property)});
}

std::string LocalizationCheck::assumed_behaviour(const LocalNetwork& local) const {
    std::vector<std::string> names;
    for (const std::size_t i : local.known) names.push_back(known_[i].name);
    if (names.empty()) return "may do anything at any time, which is an over-approximation";
    return fmt::format("may have any behaviour that satisfies the proved {1} {0}; this is an over-approximation",
                       fmt::join(names, ", "), names.size() == 1 ? "property" : "properties");
}

SearchScope LocalizationCheck::scope(const std::set<std::uint32_t>& searched, std::string because) const {
    SearchScope made{.because = std::move(because), .cells = true};
    for (std::uint32_t cell = 0; cell < cells_.count; ++cell)
        (searched.contains(cell) ? made.searched : made.left_out).push_back(cells_.names[cell]);
    return made;
}

/// Continues an open task. If new invariants about omitted fragments that the task reads are known, the search of the
/// task is repeated. Otherwise the function adds fragments to the task: first the fragments in `borders`; if the task
/// contains all of them, all other fragments that the task reads, for example those that cycles of PLCs read (`tied`).
void LocalizationCheck::go_on_with(Open open) {
    Task& task = open.task;
    const auto tells = [&](const Invariant& invariant) {
        return std::ranges::any_of(
            open.tied, [&](std::uint32_t cell) { return std::ranges::binary_search(invariant.reads, cell); });
    };
    if (std::any_of(known_.begin() + static_cast<std::ptrdiff_t>(open.known), known_.end(), tells))
        return tasks_.push_back(std::move(task));
    const auto with = [&](const Cells& more) {
        Cells all;
        std::ranges::set_union(task.cells, more, std::back_inserter(all));
        return all;
    };
    Cells wider = with(open.borders);
    if (wider == task.cells) wider = with(open.tied);
    if (wider == task.cells || wider.size() == cells_.count) return;
    task.cells = std::move(wider);
    tasks_.push_back(std::move(task));
}

void LocalizationCheck::take_local() {
    if (race_) {  // all fragments in which a race might occur have been searched
        Verdict& none = found_[*race_] = {.outcome = Outcome::Holds};
        none.scope = scope(faultless_, "cannot have a model error");
        if (!faultless_.empty()) {
            none.states = std::to_string(faultless_states_);
            none.transitions = faultless_transitions_;
        }
    }
    for (auto& [k, found] : found_) {
        Verdict& verdict = result_.verdicts[k];
        if (!is_open(k)) continue;
        verdict.outcome = found.outcome;
        verdict.obstacle = UnknownReason::None;
        verdict.reason.clear();
        verdict.states = std::move(found.states);
        verdict.transitions = found.transitions;
        verdict.scope = std::move(found.scope);
    }
}

/// Returns true if an unknown verdict requires a search of the complete network. An unknown verdict on `no timelock`
/// does not require this search if `no timelock` is neither declared nor selected. If another property requires the
/// search, the search also decides `no timelock`.
bool LocalizationCheck::needs_whole() {
    if (searched_whole_ || !is_open()) return false;
    if (std::ranges::none_of(result_.verdicts, is_decided_separately)) return true;
    bool needed = false;
    for (Verdict& verdict : result_.verdicts) {
        if (verdict.outcome != Outcome::Unknown) continue;
        const bool named = std::ranges::find(options_.properties, verdict.property) != options_.properties.end();
        verdict.declared = named || (verdict.declared && options_.properties.empty());
        needed = needed || verdict.declared;
        if (!verdict.declared)
            verdict.reason = "no selected property requires the complete loop; only " + verdict.states +
                             " of its states were explored";
    }
    return needed;
}

void LocalizationCheck::search_complete() {
    searched_whole_ = true;
    if (result_.verdicts.empty()) return void(result_ = whole_(network_, options_));
    if (options_.max_states <= limits_.whole) return;
    TimedOptions options = options_;
    if (std::ranges::any_of(result_.verdicts, is_decided_separately)) {
        options.properties.clear();
        for (const Verdict& verdict : result_.verdicts)
            if (!is_decided_separately(verdict) && verdict.about.valid())
                options.properties.push_back(network_.properties[verdict.about].name);
        if (options.properties.empty()) options.properties.push_back(timed::undeclared_timelock(network_).name);
    }
    TimedResult whole = whole_(network_, options);
    for (Verdict& verdict : result_.verdicts) {
        if (is_decided_separately(verdict)) continue;
        const Verdict& found = element_of(whole.verdicts, verdict.property, &Verdict::property);
        const bool ended_before = found.outcome == Outcome::Unknown && verdict.outcome != Outcome::Unknown;
        const bool first_was_greater =
            found.obstacle == UnknownReason::Stopped && std::stoull(found.states) < std::stoull(verdict.states);
        if (!ended_before && first_was_greater) {
            verdict.obstacle = UnknownReason::Stopped;
            verdict.reason = "stopped after " + verdict.states + " states";
        } else if (!ended_before) {
            std::vector<std::string> notes = std::move(verdict.notes);
            verdict = found;
            // Keeps the notes of an input abstraction, which state why the abstraction did not decide the property.
            for (std::string& note : notes)
                if (verdict.outcome == Outcome::Unknown &&
                    std::ranges::find(verdict.notes, note) == verdict.notes.end())
                    verdict.notes.push_back(std::move(note));
        }
        report_earlier(verdict, "localization", local_states_);
    }
    if (whole.errors.empty()) whole.errors = std::move(result_.errors);
    if (result_.profile && (!whole.profile || whole.profile->states < result_.profile->states))
        whole.profile = std::move(result_.profile);
    whole.verdicts = std::move(result_.verdicts);
    result_ = std::move(whole);
}

namespace {

/// If the search for timelocks ended at a limit, adds a note with the number of states that were searched for
/// timelocks. The note is added to each property that holds (for `reachable`: that is violated), because the property
/// may hold only because a timelock makes a state unreachable.
TimedResult with_time_reported(TimedResult result) {
    const auto time = std::ranges::find(result.verdicts, Pattern::NoTimelock, &Verdict::pattern);
    if (time == result.verdicts.end()) return result;
    const bool cut_off = time->obstacle == UnknownReason::Bound || time->obstacle == UnknownReason::Memory ||
                         time->obstacle == UnknownReason::Stopped;
    if (time->outcome != Outcome::Unknown || !cut_off) return result;
    const std::string note = "timelocks were searched only in the first " + time->states + " states" +
                             (time->declared ? "" : "; declare `no timelock` to search all states");
    for (Verdict& verdict : result.verdicts)
        if (verdict.outcome == (verdict.pattern == Pattern::Reachable ? Outcome::Violated : Outcome::Holds))
            verdict.notes.push_back(note);
    return result;
}

}  // namespace

TimedResult LocalizationCheck::result() {
    if (options_.profile != ProfileFor::All && !searched_whole_ &&
        std::ranges::any_of(result_.verdicts, is_decided_separately))
        result_.profile.reset();
    return with_time_reported(std::move(result_));
}

CellSearch::CellSearch(Network network, const TimedOptions& options, const LocalizationLimits& limits,
                       const LocalAblations& ablations, const WholeSearch& whole)
    : search_(std::make_unique<LocalizationCheck>(std::move(network), options, limits, ablations, whole)) {}

CellSearch::~CellSearch() = default;

void CellSearch::begin() { search_->begin(); }

bool CellSearch::refine(std::uint64_t states, const Deadline& deadline) { return search_->refine(states, deadline); }

TimedResult& CellSearch::found() { return search_->found(); }

bool CellSearch::needs_whole() { return search_->needs_whole(); }

void CellSearch::search_complete() { search_->search_complete(); }

TimedResult CellSearch::result() { return search_->result(); }

TimedResult check_timed_by_cells(const Network& network, const TimedOptions& options, const LocalizationLimits& limits,
                                 const LocalAblations& ablations, const WholeSearch& whole) {
    CellSearch search(expand(network), options, limits, ablations, whole);
    search.begin();
    const Deadline localization = share_of(options.deadline, 3);
    for (const std::uint64_t states : search_rounds) search.refine(states, localization);
    if (search.needs_whole()) search.search_complete();
    return search.result();
}

}  // namespace grafverif
