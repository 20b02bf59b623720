// SPDX-License-Identifier: MIT
// Evaluates the queries whose findings are impossible events, that is, events that occur at no reachable point.
#include <algorithm>
#include <ostream>

#include "analyse/chart_analyzer.hpp"
#include "ir/words_of.hpp"
#include "syntax/print/chart.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif::analysis {

void ChartAnalyzer::watch(std::string_view code, std::size_t index, PointSet among, const Bdd& goal) {
    if (Query* const question = questions_.open(code, index)) signs_.push_back({question, among, goal});
}

void ChartAnalyzer::watch_signs() {
    for (const Step step : chart_.steps.ids()) {
        if (!machine_.covers_step(step.index)) continue;
        // An initial step counts as active in some run, even if no evolution follows.
        const bool initial = equations_.variables[equations_.steps[step.index].variable].initial != 0;
        if (initial) questions_.decide("step-never-active", step.index);
        watch("step-never-active", step.index, PointSet::Points, machine_.active(step.index));
        watch("step-never-stable", step.index, PointSet::Stable, machine_.active(step.index));
    }
    for (const Transition id : chart_.transitions.ids()) {
        if (!machine_.covers_firing(id.index) || !covers(chart_.transitions[id].from)) continue;
        watch("transition-never-fired", id.index, PointSet::Points, machine_.fires(id.index));
        watch("transition-always-fired", id.index, PointSet::Points, enabled(id) & ~machine_.fires(id.index));
    }
    watch_outputs();
}

void ChartAnalyzer::watch_outputs() {
    for (const Equations::Output& output : equations_.outputs) {
        if (!machine_.covers(output.value)) continue;
        const std::int64_t initial = equations_.variables[output.variable].initial;
        watch("output-never-set", output.variable.index, searching() ? PointSet::Stable : PointSet::Landings,
              machine_.differs(output.value, initial));
    }
    for (const Equations::Stored& stored : equations_.stored) {
        const Equations::Variable& variable = equations_.variables[stored.variable];
        if (variable.role != Equations::Role::Output || !machine_.covers(stored.variable)) continue;
        if (!(machine_.possible() & machine_.differs_at_first(stored.first, variable.initial)).is_false())
            questions_.decide("output-never-set", stored.variable.index);
        Bdd stores;
        for (const Equations::Write& write : stored.writes)
            stores |= machine_.holds(write.trigger) & machine_.differs(write.value, variable.initial);
        watch("output-never-set", stored.variable.index, PointSet::Points, stores);
    }
}

// -- during the search ------------------------------------------------------------------------------------------------

void ChartAnalyzer::find_signs() {
    stable_ = searching() ? machine_.stable(machine_.unbroken(search_.fresh())) : Bdd();
    if (!searching()) landings_seen_ = machine_.without_ends(search_.landings());
    for (Sign& sign : signs_) {
        if (sign.question->decided || sign.seen || !sign_seen(sign)) continue;
        sign.seen = true;
        if (certain() || (sign.among != PointSet::Landings &&
                          confirmed((sign.among == PointSet::Stable ? stable_ : search_.fresh()) & sign.goal)))
            sign.question->decided = true;
        else sign.question->seen_in_part = true;
    }
}

bool ChartAnalyzer::sign_seen(const Sign& sign) {
    switch (sign.among) {
    case PointSet::Points: return !(search_.fresh() & sign.goal).is_false();
    case PointSet::Stable: return !(stable_ & sign.goal).is_false();
    case PointSet::Landings: return !(landings_seen_ & sign.goal).is_false();
    }
    return false;
}

/// True if the interpreter confirms that the complete chart, and not only the cone of this machine, has a run to a
/// point of `points`. The result is also false if no event times were found for the run.
bool ChartAnalyzer::confirmed(const Bdd& points) {
    const std::optional<Path> path = search_.path_to(points);
    if (!path) return false;
    const WitnessTrace tried = evidence(chart_, equations_, machine_, options_.mode, *path, {.ends = false});
    if (!tried.failure.empty() || tried.timing == Finding::Timing::Unconfirmed) return false;
    confirm_others(*path);
    return true;
}

/// Decides every open query whose event occurs on `path`, because the run that demonstrates one event may also show
/// other events.
void ChartAnalyzer::confirm_others(const Path& path) {
    for (const Sign& sign : signs_) {
        if (sign.question->decided || sign.among != PointSet::Points) continue;
        for (const std::vector<Point>& instant : path.instants)
            for (const Point& point : instant)
                if (evaluate(sign.goal, point)) sign.question->decided = true;
    }
}

// -- after the search -------------------------------------------------------------------------------------------------

void ChartAnalyzer::gather_unseen() {
    for (const Sign& sign : signs_)
        if (!sign.seen) unseen_.insert(sign.question);
}

bool ChartAnalyzer::unseen(std::string_view code, std::size_t index) {
    return unseen_.contains(questions_.open(code, index));
}

bool ChartAnalyzer::ever_active(Step step) const {
    return equations_.variables[equations_.steps[step.index].variable].initial != 0 ||
           seen(machine_.active(step.index));
}

void ChartAnalyzer::dead_steps() {
    for (const Step step : chart_.steps.ids()) {
        if (!unseen("step-never-active", step.index)) continue;
        keep(finding("step-never-active", step_name(step),
                     "`" + step_name(step) + "` is never active: no input sequence activates it",
                     chart_.steps[step].origin));
        questions_.decide("step-never-active", step.index);
    }
}

void ChartAnalyzer::dead_transitions() {
    for (const Transition id : chart_.transitions.ids()) dead_transition(id);
}

/// Returns, as text, the first conjunct of the transition condition that is false whenever the transition is enabled.
/// Conjuncts with variables that have no name in the chart are ignored. The text is empty if no conjunct is always
/// false.
std::string ChartAnalyzer::false_part(Transition id) {
    const Exprs& exprs = equations_.exprs;
    const Id<Expr> condition = equations_.firings[id.index].condition;
    bool named = true;
    const auto leaf = [&](std::ostream& out, const Expr& of) {
        const Id<Equations::Variable> variable{static_cast<std::uint32_t>(of.value)};
        const auto step = std::ranges::find(equations_.steps, variable, &Equations::StepActivity::variable);
        const auto timer = std::ranges::find(equations_.timers, variable, &Equations::Timer::end);
        const Equations::Role role = equations_.variables[variable].role;
        std::string text = step != equations_.steps.end() ? step->step.variable() : "";
        if (timer != equations_.timers.end() && !watched_name(equations_, *timer).empty())
            text = time_text(timer->rise_ms, watched_name(equations_, *timer), timer->fall_ms);
        if (role == Equations::Role::Input || role == Equations::Role::Internal)
            text = equations_.variables[variable].name;
        named = named && !text.empty();
        out << text;
    };
    std::vector<Id<Expr>> parts = {condition};
    if (exprs[condition].op == Op::And)
        parts.assign(exprs.operands(condition).begin(), exprs.operands(condition).end());
    for (const Id<Expr> part : parts) {
        named = true;
        const std::string text = expr_text(exprs, part, chart_spelling, leaf);
        if (named && !seen(enabled(id) & machine_.holds(part))) return text;
    }
    return {};
}

void ChartAnalyzer::dead_transition(Transition id) {
    if (!unseen("transition-never-fired", id.index)) return;
    const Chart::Transition& transition = chart_.transitions[id];
    std::vector<Step> dead;
    for (const Step step : transition.from)
        if (!ever_active(step)) dead.push_back(step);
    const bool ready = seen(enabled(id));
    std::string why = "; its condition is never true while it is enabled";
    if (!dead.empty()) why = "; " + steps_text(dead) + (dead.size() == 1 ? " is never active" : " are never active");
    else if (!ready) why = "; " + steps_text(transition.from) + " are never active together";
    Finding made =
        finding("transition-never-fired", name(id), "`" + name(id) + "` is never cleared" + why, transition.origin);
    if (ready) {
        made.message = "`" + name(id) + "` is never cleared; its condition is never true while it is enabled";
        if (const std::string part = false_part(id); !part.empty()) made.message += ", since `" + part + "` is false";
        show(made, enabled(id), {.ends = false}, "`" + name(id) + "` is enabled");
    }
    keep(std::move(made));
    questions_.decide("transition-never-fired", id.index);
}

/// Reports transitions that are always cleared as soon as they are enabled, provided that some run clears them.
void ChartAnalyzer::immediate_transitions() {
    for (const Transition id : chart_.transitions.ids()) {
        if (!unseen("transition-always-fired", id.index)) continue;
        const Bdd& fires = machine_.fires(id.index);
        if (seen(fires)) {
            Finding made = finding(
                "transition-always-fired", name(id),
                "`" + name(id) + "` is always cleared in the evolution after it becomes enabled, for all inputs",
                chart_.transitions[id].origin);
            if (!show(made, prefer_unbroken(fires), {.fired = {id}},
                      "`" + name(id) + "` is cleared in the last instant"))
                continue;
            keep(std::move(made));
        }
        questions_.decide("transition-always-fired", id.index);
    }
}

void ChartAnalyzer::transient_steps() {
    for (const Step step : chart_.steps.ids()) {
        if (!unseen("step-never-stable", step.index)) continue;
        const Bdd& active = machine_.active(step.index);
        if (seen(active)) {
            const bool acts = std::ranges::any_of(
                chart_.continuous, [&](const Chart::ContinuousAction& action) { return action.step == step; });
            Finding made = finding("step-never-stable", step_name(step),
                                   "`" + step_name(step) + "` is always deactivated in the instant of its activation" +
                                       (acts ? "; its continuous actions never set an output" : ""),
                                   chart_.steps[step].origin);
            if (acts) made.level = Finding::Level::Warning;
            if (!show(made, active, {.ends = false}, "`" + step_name(step) + "` is active and will be deactivated"))
                continue;
            keep(std::move(made));
        }
        questions_.decide("step-never-stable", step.index);
    }
}

void ChartAnalyzer::silent_outputs() {
    for (const Id<Equations::Variable> id : equations_.variables.ids()) {
        const Equations::Variable& variable = equations_.variables[id];
        if (!unseen("output-never-set", id.index)) continue;
        keep(finding("output-never-set", variable.name,
                     "`" + variable.name + "` always has its initial value: no reachable action changes it",
                     variable.origin));
        questions_.decide("output-never-set", id.index);
    }
}

}  // namespace grafverif::analysis
