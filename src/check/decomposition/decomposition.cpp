// SPDX-License-Identifier: MIT
#include "check/decomposition/decomposition.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "check/decomposition/join.hpp"
#include "check/decomposition/preservation.hpp"
#include "check/decomposition/subsystem_queries.hpp"
#include "check/shares.hpp"
#include "check/timed/property_queries.hpp"
#include "ir/network_subsystems.hpp"
#include "ir/patterns.hpp"
#include "support/element_of.hpp"

namespace grafverif {

namespace {

const char* const timelock_probe = "no timelock";
const char* const deadlock_probe = "no deadlock";

/// The subnetwork of some parts (independent subsystems), and the result of the search of this subnetwork.
struct SubsystemSearch {
    SubNetwork of = {};
    TimedResult result = {};

    const Verdict& verdict(const std::string& name) const {
        return element_of(result.verdicts, name, &Verdict::property);
    }
};

class DecomposedCheck {
public:
    DecomposedCheck(const Network& network, const NetworkSubsystems& parts, const TimedOptions& options)
        : network_(network), parts_(parts), options_(options) {}

    TimedResult result() {
        questions_ = subsystem_queries(network_, parts_, options_);
        search_each();
        if (errors_may_be_out_of_reach()) return check_timed(network_, options_);
        for (SubsystemQuery& question : questions_) answer(question);
        search_complete();
        for (SubsystemQuery& question : questions_) result_.verdicts.push_back(std::move(question.verdict));
        for (Verdict& verdict : result_.verdicts) verdict.seconds = result_.seconds;
        return std::move(result_);
    }

private:
    void search_each();
    SubsystemSearch search(const PartNumbers& chosen, bool premises, const Deadline& deadline);
    const SubsystemSearch& search_of(const PartNumbers& chosen);
    OmittedSubsystem omitted(std::uint32_t part) const;
    bool errors_may_be_out_of_reach() const;

    void answer(SubsystemQuery& question);
    void result_of_each(SubsystemQuery& question);
    void take(SubsystemQuery& question, Verdict verdict) const;
    bool carries(const SubsystemQuery& question, const Verdict& verdict, const PartNumbers& chosen,
                 std::string& why) const;
    void show(Verdict& verdict, const SubNetwork& of, const PartNumbers& chosen, bool at_stable) const;
    void needs_complete(const SubsystemQuery& question, std::string why) {
        whole_.emplace_back(static_cast<std::size_t>(&question - questions_.data()), std::move(why));
    }
    void search_complete();

    void count(const TimedResult& found);
    PartNumbers others(const PartNumbers& chosen) const;
    std::vector<const OmittedSubsystem*> left_out(const PartNumbers& chosen) const;
    std::vector<Run> other_runs(const PartNumbers& chosen) const;
    std::vector<std::string> names(const PartNumbers& chosen) const;

    const Network& network_;
    const NetworkSubsystems& parts_;
    const TimedOptions& options_;
    std::vector<SubsystemQuery> questions_ = {};
    std::vector<SubsystemSearch> each_ = {};  // each_[i]: the search of part i alone
    std::vector<OmittedSubsystem> neighbours_ = {};
    std::map<PartNumbers, SubsystemSearch> together_ = {};
    // Indices of the queries that require a search of the complete network, with the reasons.
    std::vector<std::pair<std::size_t, std::string>> whole_ = {};
    TimedResult result_ = {};
};

/// Adds the numbers of states and transitions and the time of a search to the result, and keeps the profile of the
/// search with the most states.
void DecomposedCheck::count(const TimedResult& found) {
    result_.states += found.states;
    result_.transitions += found.transitions;
    result_.bytes = std::max(result_.bytes, found.bytes);
    result_.state_bytes = std::max(result_.state_bytes, found.state_bytes);
    result_.seconds += found.seconds;
    result_.complete = result_.complete && found.complete;
    if (!found.profile || (result_.profile && found.profile->states < result_.profile->states)) return;
    result_.profile = found.profile;
}

/// Searches the subnetwork of the parts `chosen`. The search decides all queries about exactly
/// these parts, and the queries that are decided for each part separately.
SubsystemSearch DecomposedCheck::search(const PartNumbers& chosen, bool premises, const Deadline& deadline) {
    SubNetworkBuilder builder(network_, parts_, chosen);
    bool deadlock_requested = false;
    for (const SubsystemQuery& question : questions_) {
        const Property& property = question.property;
        deadlock_requested = deadlock_requested || (question.each && property.pattern == Pattern::NoDeadlock);
        if (question.race) builder.add_property(property);
        if (question.each || question.reads != chosen) continue;
        if (!property.at_stable || settled_separately(property.pattern)) builder.add_property(property);
    }
    builder.add_property({.name = timelock_probe, .pattern = Pattern::NoTimelock});
    if (premises && deadlock_requested) builder.add_property({.name = deadlock_probe, .pattern = Pattern::NoDeadlock});
    SubsystemSearch made{std::move(builder).build(), {}};
    TimedOptions options = options_;
    options.properties = {};
    options.premises = premises;
    options.deadline = deadline;
    made.result = check_timed(made.of.network, options);
    return made;
}

void DecomposedCheck::search_each() {
    for (SubsystemQuery& question : questions_)
        if (!question.each && question.reads.empty()) question.reads = {0};
    result_.time_passes = true;
    for (std::uint32_t part = 0; part < parts_.count; ++part)
        each_.push_back(search({part}, true, share_of(options_.deadline, parts_.count - part)));
    for (std::uint32_t part = 0; part < parts_.count; ++part) {
        const bool stopped = each_[part].verdict(timelock_probe).obstacle == UnknownReason::Stopped;
        // The search of this part used up its share of the time limit, but the deadline of the check has not passed.
        // Repeats the search with all the remaining time.
        if (stopped && options_.deadline && !is_over(options_.deadline))
            each_[part] = search({part}, true, options_.deadline);
        count(each_[part].result);
        neighbours_.push_back(omitted(part));
        result_.time_passes = result_.time_passes && each_[part].result.time_passes;
    }
    for (std::uint32_t part = 0; part < parts_.count; ++part)
        for (ModelError error : each_[part].result.errors) {
            const SubNetwork& of = each_[part].of;
            if (error.variable.valid()) error.variable = of.variables[error.variable.index];
            if (error.process.valid()) error.process = of.processes[error.process.index];
            error.run = joined(in_complete(of, error.run), other_runs({part}), Ending::Anywhere).value_or(Run{});
            result_.errors.push_back(std::move(error));
        }
}

OmittedSubsystem DecomposedCheck::omitted(std::uint32_t part) const {
    const TimedResult& found = each_[part].result;
    OmittedSubsystem is{.name = name_of_part(network_, parts_, part)};
    is.searched = found.complete && found.premises;
    is.faulty = !found.errors.empty();
    is.time_passes = found.time_passes;
    is.never_locks = each_[part].verdict(timelock_probe).outcome == Outcome::Holds;
    if (!found.premises) return is;
    is.diverges = found.premises->diverges.has_value();
    is.rests = found.premises->rests;
    is.settles = found.premises->settles;
    return is;
}

/// True if a model error of a part may be unreachable in the complete network. A model error of a part is reachable in
/// the complete network if, in each other part, time can pass until the error occurs.
bool DecomposedCheck::errors_may_be_out_of_reach() const {
    for (std::uint32_t part = 0; part < parts_.count; ++part)
        for (std::uint32_t other = 0; other < parts_.count; ++other)
            if (part != other && neighbours_[part].faulty && !neighbours_[other].diverges) return true;
    return false;
}

const SubsystemSearch& DecomposedCheck::search_of(const PartNumbers& chosen) {
    if (chosen.size() == 1) return each_[chosen.front()];
    const auto found = together_.find(chosen);
    if (found != together_.end()) return found->second;
    const SubsystemSearch& made = together_.emplace(chosen, search(chosen, false, options_.deadline)).first->second;
    count(made.result);
    return made;
}

PartNumbers DecomposedCheck::others(const PartNumbers& chosen) const {
    PartNumbers rest;
    for (std::uint32_t part = 0; part < parts_.count; ++part)
        if (!std::ranges::binary_search(chosen, part)) rest.push_back(part);
    return rest;
}

std::vector<const OmittedSubsystem*> DecomposedCheck::left_out(const PartNumbers& chosen) const {
    std::vector<const OmittedSubsystem*> rest;
    for (const std::uint32_t part : others(chosen)) rest.push_back(&neighbours_[part]);
    return rest;
}

/// Returns a run for each part that is not in `chosen` and has a run in which time diverges. The caller combines these
/// runs with a run of the chosen parts.
std::vector<Run> DecomposedCheck::other_runs(const PartNumbers& chosen) const {
    std::vector<Run> runs;
    for (const std::uint32_t part : others(chosen)) {
        const std::optional<Premises>& premises = each_[part].result.premises;
        if (premises && premises->diverges) runs.push_back(in_complete(each_[part].of, *premises->diverges));
    }
    return runs;
}

std::vector<std::string> DecomposedCheck::names(const PartNumbers& chosen) const {
    std::vector<std::string> all;
    for (const std::uint32_t part : chosen) all.push_back(neighbours_[part].name);
    return all;
}

/// Copies outcome, reason, notes, counts and run of `verdict` to the verdict of the query. The name and the property of
/// the query are unchanged.
void DecomposedCheck::take(SubsystemQuery& question, Verdict verdict) const {
    Verdict& given = question.verdict;
    given.outcome = verdict.outcome;
    given.obstacle = verdict.obstacle;
    given.reason = std::move(verdict.reason);
    given.vacuous = verdict.vacuous;
    given.notes = std::move(verdict.notes);
    given.states = std::move(verdict.states);
    given.transitions = verdict.transitions;
    given.scope = std::move(verdict.scope);
    given.run = std::move(verdict.run);
}

/// Returns the outcome whose preservation must be checked. If the verdict is unknown only because of a model error or
/// inexact time, the result is the outcome that the property would have without this obstacle. If a
/// limit ended the search, the result is an outcome that is preserved if time can pass forever in
/// the other parts. After a limit, a search of the complete network would also reach the limit,
/// because the complete network then has at least as many states as the searched parts.
Outcome supposed(const Verdict& verdict) {
    const bool wanted = verdict.pattern == Pattern::Reachable;
    switch (verdict.obstacle) {
    case UnknownReason::Faulty:
    case UnknownReason::Inexact: return wanted ? Outcome::Violated : Outcome::Holds;
    case UnknownReason::Bound:
    case UnknownReason::Memory: return wanted ? Outcome::Holds : Outcome::Violated;
    default: return verdict.outcome;
    }
}

/// True if the verdict on the parts `chosen` is also the verdict on the complete network, or if the verdict on the
/// complete network would also be unknown. Otherwise, stores the reason in `why`.
bool DecomposedCheck::carries(const SubsystemQuery& question, const Verdict& verdict, const PartNumbers& chosen,
                              std::string& why) const {
    if (verdict.obstacle == UnknownReason::Stopped || verdict.obstacle == UnknownReason::Unsupported) return true;
    Verdict carried = verdict;
    carried.outcome = supposed(verdict);
    why = preservation_obstacle(carried, question.property.at_stable, left_out(chosen));
    return why.empty();
}

/// Converts the run of the verdict to a run of the complete network. If the converted run would be too long, removes
/// the run and adds a note to the verdict.
void DecomposedCheck::show(Verdict& verdict, const SubNetwork& of, const PartNumbers& chosen, bool at_stable) const {
    if (!verdict.run) return;
    verdict.run =
        joined(in_complete(of, *verdict.run), other_runs(chosen), at_stable ? Ending::Waiting : Ending::Anywhere);
    if (!verdict.run) {
        verdict.notes.emplace_back(
            "no trace is given: with the moves of the other sub-loops, the trace would repeat only after very many "
            "steps");
        return;
    }
    const bool maximal = is_liveness(verdict.pattern) || verdict.pattern == Pattern::NoTimelock;
    if (maximal && !verdict.run->loop) verdict.run = continued(network_, std::move(*verdict.run));
    if (verdict.run->moves.size() <= most_moves) return;
    verdict.run.reset();
    verdict.notes.emplace_back(
        "no trace is given: with the moves of the other sub-loops, the trace would have more than 100,000 moves");
}

void DecomposedCheck::answer(SubsystemQuery& question) {
    if (question.each) return result_of_each(question);
    const Property& property = question.property;
    if (question.reads.size() == parts_.count) return needs_complete(question, "");
    if (property.at_stable && !settled_separately(property.pattern))
        return needs_complete(question,
                              "whether a run ends in a quiescent state (`at stable`) depends on all sub-loops");
    if (property.at_stable && network_.settled.valid() && parts_.settled.empty())
        return needs_complete(question, "quiescence cannot be decomposed into sub-loops");
    const SubsystemSearch& search = search_of(question.reads);
    Verdict verdict = search.verdict(property.name);
    std::string why;
    if (!carries(question, verdict, question.reads, why)) return needs_complete(question, why);
    show(verdict, search.of, question.reads, property.at_stable);
    mark_vacuous(verdict, left_out(question.reads));
    verdict.scope = {names(question.reads), names(others(question.reads)), {}};
    if (verdict.outcome != Outcome::Unknown) verdict.scope.because = because(verdict, property.at_stable);
    take(question, std::move(verdict));
}

/// Decides `no deadlock`, `no timelock` or `no_race`, each of which holds for the complete network
/// if it holds for each part.
void DecomposedCheck::result_of_each(SubsystemQuery& question) {
    const Pattern pattern = question.property.pattern;
    const std::string name = pattern == Pattern::NoTimelock   ? timelock_probe
                             : pattern == Pattern::NoDeadlock ? deadlock_probe
                                                              : question.property.name;
    Verdict all{.outcome = Outcome::Holds, .transitions = 0};
    std::uint64_t states = 0;
    std::string why;
    std::optional<Verdict> unknown;
    for (std::uint32_t part = 0; part < parts_.count; ++part) {
        Verdict verdict = each_[part].verdict(name);
        states += each_[part].result.states;
        all.transitions = *all.transitions + each_[part].result.transitions;
        for (const std::string& note : verdict.notes)
            if (std::ranges::find(all.notes, note) == all.notes.end()) all.notes.push_back(note);
        all.vacuous = all.vacuous || verdict.vacuous;
        if (verdict.outcome == Outcome::Violated && carries(question, verdict, {part}, why)) {
            show(verdict, each_[part].of, {part}, false);
            verdict.scope = {names({part}), names(others({part})), because(verdict, false)};
            return take(question, std::move(verdict));
        }
        if (verdict.outcome == Outcome::Violated) return needs_complete(question, why);
        if (verdict.outcome == Outcome::Holds) continue;
        const bool is_final = verdict.obstacle == UnknownReason::Faulty || verdict.obstacle == UnknownReason::Inexact;
        if (!is_final && !carries(question, verdict, {part}, why)) return needs_complete(question, why);
        if (!unknown) unknown = verdict;
    }
    if (unknown) return take(question, std::move(*unknown));
    all.states = std::to_string(states);
    all.scope.searched = names(others({}));
    take(question, std::move(all));
}

void DecomposedCheck::search_complete() {
    if (whole_.empty()) return;
    TimedOptions options = options_;
    options.properties = {};
    for (const auto& [index, why] : whole_)
        if (const Id<Property> about = questions_[index].verdict.about; about.valid())
            options.properties.push_back(network_.properties[about].name);
    if (options.properties.empty()) options.properties.push_back(timed::undeclared_timelock(network_).name);
    const std::uint64_t earlier = result_.states;
    const TimedResult whole = check_timed(network_, options);
    count(whole);
    for (const auto& [index, why] : whole_) {
        SubsystemQuery& question = questions_[index];
        Verdict verdict = element_of(whole.verdicts, question.verdict.property, &Verdict::property);
        if (!why.empty()) verdict.notes.push_back("the complete loop was explored: " + why);
        report_earlier(verdict, "searches of independent subsystems", earlier);
        take(question, std::move(verdict));
    }
}

/// Makes all steps of all charts the operands of `property`. Requires that `property` has no operands.
void name_steps(Network& network, Property& property) {
    for (const Id<Network::Variable> id : network.variables.ids())
        if (network.variables[id].role == Network::Role::Step)
            property.operands.push_back(network.exprs.leaf(Op::Variable, id.index));
}

}  // namespace

TimedResult check_timed_by_parts(const Network& network, const TimedOptions& options) {
    Network flat = expand(network);
    const NetworkSubsystems parts = parts_of(flat);
    if (parts.count < 2) return check_timed(network, options);
    for (Property& property : flat.properties)
        if (property.pattern == Pattern::ReachableAllSteps && property.operands.empty()) name_steps(flat, property);
    return DecomposedCheck(flat, parts, options).result();
}

}  // namespace grafverif
