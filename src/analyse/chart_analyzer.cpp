// SPDX-License-Identifier: MIT
// Evaluates the queries during the search, and computes a run that demonstrates each finding.
#include "analyse/chart_analyzer.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace grafverif::analysis {

ChartAnalyzer::ChartAnalyzer(const Chart& chart, const Equations& equations, const AnalyseOptions& options,
                             Machine& machine, PathSearch& search, Queries& questions, Analysis& result)
    : chart_(chart),
      equations_(equations),
      options_(options),
      machine_(machine),
      search_(search),
      questions_(questions),
      result_(result) {
    expect_breaks();
    expect_forcing();
    expect_branches();
    expect_reactivated_steps();
    watch_signs();
}

void ChartAnalyzer::look() {
    instability();
    for (Event& event : events_) {
        if (event.question->decided || !event.record) continue;
        const Bdd seen = search_.fresh() & event.goal;
        if (seen.is_false()) continue;
        if (event.record(seen)) event.question->decided = true;
        else uncertain_.push_back(event.question);
        event.record = {};
    }
    dead_values();
    find_signs();
    explored_instants_ = search_.instants().size();
    search_.forget_fresh();
}

void ChartAnalyzer::conclude() {
    gather_unseen();
    dead_steps();
    dead_transitions();
    immediate_transitions();
    transient_steps();
    silent_outputs();
    for (const Event& event : events_) {
        const bool occurs_elsewhere = event.question->index == no_variable && !machine_.whole();
        if (!occurs_elsewhere && !is_uncertain(event.question)) event.question->decided = true;
    }
    for (const Equations::Stored& stored : equations_.stored) {
        if (!machine_.covers(stored.variable)) continue;
        for (const std::size_t value : {0U, 1U}) {
            Query* const question = questions_.open("action-conflict", 2 * stored.variable.index + value);
            if (question != nullptr && !is_uncertain(question)) question->decided = true;
        }
    }
}

void ChartAnalyzer::search_loosely() {
    for (Event& event : events_) event.seen = event.seen || !(search_.fresh() & event.goal).is_false();
    const Bdd stable = machine_.stable(machine_.unbroken(search_.fresh()));
    for (Sign& sign : signs_)
        sign.seen = sign.seen || !((sign.among == PointSet::Stable ? stable : search_.fresh()) & sign.goal).is_false();
    search_.forget_fresh();
}

void ChartAnalyzer::conclude_loosely() {
    gather_unseen();
    dead_steps();
    silent_outputs();
    for (const Transition id : chart_.transitions.ids())
        if (unseen("transition-never-fired", id.index) && !seen(enabled(id))) dead_transition(id);
    std::set<const Query*> met;  // a set, because several events may belong to one query
    for (const Event& event : events_)
        if (event.seen || (event.question->index == no_variable && !machine_.whole())) met.insert(event.question);
    for (const Event& event : events_)
        if (!met.contains(event.question)) event.question->decided = true;
}

bool ChartAnalyzer::is_uncertain(const Query* question) const {
    return std::ranges::find(uncertain_, question) != uncertain_.end();
}

bool ChartAnalyzer::doubtful() const {
    return std::ranges::find(uncertain_, std::string_view("total-instability"), &Query::code) != uncertain_.end();
}

void ChartAnalyzer::leave() noexcept {
    const auto note = [this](Query* question) {
        if (question == nullptr || question->decided) return;
        if (!is_uncertain(question)) question->instants = std::max(question->instants, explored_instants_);
    };
    for (const Event& event : events_)
        if (event.question->index != no_variable || machine_.whole()) note(event.question);
    for (const Sign& sign : signs_)
        if (!sign.seen) note(sign.question);
    if (machine_.whole()) note(questions_.open("total-instability", 0));
    for (const Equations::Stored& stored : equations_.stored)
        if (machine_.covers(stored.variable))
            for (const std::size_t value : {0U, 1U})
                note(questions_.open("action-conflict", 2 * stored.variable.index + value));
}

Bdd ChartAnalyzer::all_active(const std::vector<Step>& steps) const {
    Bdd all = Bdd::constant(true);
    for (const Step step : steps) all &= machine_.active(step.index);
    return all;
}

bool ChartAnalyzer::covers(const std::vector<Step>& steps) const {
    return std::ranges::all_of(steps, [this](Step step) { return machine_.covers_step(step.index); });
}

Bdd ChartAnalyzer::enabled(Transition transition) const { return all_active(chart_.transitions[transition].from); }

std::string ChartAnalyzer::steps_text(const std::vector<Step>& steps) const {
    std::string text;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        if (k > 0) text += k + 1 == steps.size() ? " and " : ", ";
        text += "`" + step_name(steps[k]) + "`";
    }
    return text;
}

Finding ChartAnalyzer::finding(std::string_view code, std::string subject, std::string message, Span origin) const {
    Finding made;
    made.code = code;
    made.level = std::ranges::find(finding_kinds(), code, &FindingKind::code)->level;
    made.subject = std::move(subject);
    made.message = std::move(message);
    made.origin = origin;
    return made;
}

bool ChartAnalyzer::show(Finding& finding, const std::optional<Path>& path, const EvolutionRequirement& demand,
                         std::string shows, bool certain) {
    last_ = {};
    if (!path) return certain;
    last_ = evidence(chart_, equations_, machine_, options_.mode, *path, demand);
    finding.timing = last_.timing;
    if (!last_.failure.empty()) {
        if (certain)
            result_.failures.push_back("the trace of `" + finding.code + "` on `" + finding.subject +
                                       "` cannot be replayed: " + last_.failure);
        return certain;
    }
    finding.evidence_shows = std::move(shows);
    if (last_.timing != Finding::Timing::Unconfirmed) finding.evidence = last_.trace;
    return true;
}

Bdd ChartAnalyzer::prefer_unbroken(const Bdd& points) const {
    const Bdd good = machine_.unbroken(points);
    return seen(good) ? good : points;
}

bool ChartAnalyzer::keep(Finding finding) {
    result_.findings.push_back(std::move(finding));
    if (options_.found) options_.found(result_.findings.back());
    return true;
}

std::optional<Path> ChartAnalyzer::path_along(const std::vector<Point>& points) const {
    std::optional<Path> path = search_.path_to(machine_.only(points.front()));
    if (path) path->instants.back().insert(path->instants.back().end(), points.begin() + 1, points.end());
    return path;
}

}  // namespace grafverif::analysis
