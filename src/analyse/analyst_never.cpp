// SPDX-License-Identifier: MIT
// What never happens, in all points there are.
#include <algorithm>

#include "analyse/analyst.hpp"

namespace grafverif::analysis {

/// A step that is active at power-on is, even where no evolution follows.
bool Analyst::ever_active(Step step) const {
    return equations_.variables[equations_.steps[step.index].variable].initial != 0 || seen(machine_.active(step.index));
}

void Analyst::dead_steps() {
    for (const Step step : chart_.steps.ids()) {
        if (ever_active(step)) continue;
        keep(finding("step-never-active", step_name(step),
                     "`" + step_name(step) + "` is never active; no sequence of inputs leads to it",
                     chart_.steps[step].origin));
    }
}

void Analyst::dead_transitions() {
    for (const Transition id : chart_.transitions.ids()) {
        if (seen(machine_.fires(id.index))) continue;
        const Chart::Transition& transition = chart_.transitions[id];
        std::vector<Step> dead;
        for (const Step step : transition.from)
            if (!ever_active(step)) dead.push_back(step);
        const bool ready = seen(enabled(id));
        std::string why = "; its condition is never true then";
        if (!dead.empty()) why = "; " + steps_text(dead) + (dead.size() == 1 ? " is never active" : " are never active");
        else if (!ready) why = "; " + steps_text(transition.from) + " are never active together";
        Finding made =
            finding("transition-never-fired", name(id), "`" + name(id) + "` is never cleared" + why, transition.origin);
        if (ready) {
            made.message = "`" + name(id) + "` is never cleared; its condition is never true while it is enabled";
            show(made, enabled(id), {.ends = false}, "`" + name(id) + "` is enabled");
        }
        keep(std::move(made));
    }
}

void Analyst::immediate_transitions() {
    for (const Transition id : chart_.transitions.ids()) {
        const Bdd fires = machine_.fires(id.index);
        if (seen(enabled(id) & ~fires) || !seen(fires)) continue;
        Finding made = finding("transition-always-fired", name(id),
                               "`" + name(id) + "` is cleared as soon as it is enabled, whatever the inputs are",
                               chart_.transitions[id].origin);
        const Bdd good = fires & ~machine_.breaks();
        show(made, seen(good) ? good : fires, {.fired = {id}}, "`" + name(id) + "` is cleared in the last instant");
        keep(std::move(made));
    }
}

void Analyst::transient_steps() {
    if (!searching()) return;
    for (const Step step : chart_.steps.ids()) {
        const Bdd active = machine_.active(step.index);
        if (!seen(active) || seen(active & machine_.stable() & ~machine_.breaks())) continue;
        const bool acts = std::ranges::any_of(chart_.continuous,
                                              [&](const Chart::ContinuousAction& action) { return action.step == step; });
        Finding made = finding("step-never-stable", step_name(step),
                               "`" + step_name(step) + "` is left in the very instant it becomes active" +
                                   (acts ? "; its continuous actions never give an output" : ""),
                               chart_.steps[step].origin);
        if (acts) made.level = Finding::Level::Warning;
        show(made, active, {.ends = false}, "`" + step_name(step) + "` is active, and about to be left");
        keep(std::move(made));
    }
}

void Analyst::silent_outputs() {
    const Bdd written = searching() ? search_.reached() & machine_.stable()
                                   : machine_.without_ends(search_.landings());
    const auto silent = [&](Id<Equations::Variable> id) {
        const Equations::Variable& variable = equations_.variables[id];
        keep(finding("output-never-set", variable.name,
                     "`" + variable.name + "` always has its initial value; no action that is ever active gives it another",
                     variable.origin));
    };
    for (const Equations::Output& output : equations_.outputs) {
        const std::int64_t initial = equations_.variables[output.variable].initial;
        if ((written & machine_.differs(output.value, initial)).is_false()) silent(output.variable);
    }
    for (const Equations::Stored& stored : equations_.stored) {
        const Equations::Variable& variable = equations_.variables[stored.variable];
        if (variable.role != Equations::Role::Output) continue;
        const auto stores = [&](const Equations::Write& write) {
            return seen(machine_.holds(write.trigger) & machine_.differs(write.value, variable.initial));
        };
        const Bdd first = machine_.possible() & machine_.differs_at_first(stored.first, variable.initial);
        if (first.is_false() && std::ranges::none_of(stored.writes, stores)) silent(stored.variable);
    }
}

}  // namespace grafverif::analysis
