// SPDX-License-Identifier: MIT
#include "check/decomposition/subsystem_runs.hpp"

#include <algorithm>
#include <map>

namespace grafverif {

namespace {

using StepKind = SubsystemStep::Kind;

constexpr std::size_t most_steps = 20'000;

/// Iterates over the steps of a run. After the last step of a run with a loop, the first step of the loop follows.
class RunCursor {
public:
    explicit RunCursor(const SubsystemRun& run) : run_(run) {}

    bool over() const { return at_ == run_.steps.size(); }
    bool moves() const { return !over() && run_.steps[at_].kind == StepKind::Moves; }
    const SubsystemStep& now() const { return run_.steps[at_]; }
    void go_on() {
        if (++at_ == run_.steps.size() && run_.loop) at_ = *run_.loop;
    }
    void move_on(SubsystemRun& made) {
        for (; moves(); go_on()) made.steps.push_back(now());
    }
    std::size_t place() const { return at_; }

private:
    const SubsystemRun& run_;
    std::size_t at_ = 0;
};

}  // namespace

bool SubsystemRun::never_waits_again() const {
    return std::none_of(steps.begin() + static_cast<std::ptrdiff_t>(loop.value_or(steps.size())), steps.end(),
                        [](const SubsystemStep& step) { return step.kind == StepKind::Waits; });
}

SubsystemRun concatenated(SubsystemRun first, const SubsystemRun& second) {
    if (second.loop) first.loop = first.steps.size() + *second.loop;
    first.steps.insert(first.steps.end(), second.steps.begin(), second.steps.end());
    return first;
}

SubsystemRun without_waits(const SubsystemRun& run) {
    SubsystemRun made;
    for (std::size_t i = 0; i < run.steps.size(); ++i) {
        if (run.loop == i) made.loop = made.steps.size();
        if (run.steps[i].kind != StepKind::Waits) made.steps.push_back(run.steps[i]);
    }
    return made;
}

std::optional<SubsystemRun> side_by_side(const SubsystemRun& shown, const std::vector<SubsystemRun>& others,
                                         bool settling) {
    std::vector<RunCursor> cursors;
    for (const SubsystemRun& other : others) cursors.emplace_back(other);
    SubsystemRun made;
    // For each arrival of `shown` at the start of its loop: maps the positions in all other runs at this time to the
    // index of the next step of `made`. If the same positions recur, the loop of `made` is closed.
    std::map<std::vector<std::size_t>, std::size_t> seen;
    const bool alone = shown.loop && shown.never_waits_again();
    for (RunCursor here(shown); !here.over() && made.steps.size() <= most_steps; here.go_on()) {
        if (shown.loop && here.place() == *shown.loop) {
            std::vector<std::size_t> places;
            for (const RunCursor& other : cursors) places.push_back(alone ? 0 : other.place());
            const auto [known, fresh] = seen.emplace(std::move(places), made.steps.size());
            if (!fresh) {
                made.loop = known->second;
                return made;
            }
        }
        if (here.now().kind == StepKind::Waits)
            for (RunCursor& other : cursors) {
                other.move_on(made);
                other.go_on();
            }
        made.steps.push_back(here.now());
    }
    if (shown.loop || made.steps.size() > most_steps) return {};
    if (settling)
        for (RunCursor& other : cursors) other.move_on(made);
    return made;
}

FlatRun replayed(const FlatSystem& whole, const SubsystemRun& run) {
    std::vector<std::int64_t> state(whole.variables.size(), 0);
    const auto valued = [&] {
        return evaluate_all(whole.exprs, [&](const Expr& leaf) { return state[static_cast<std::size_t>(leaf.value)]; });
    };
    const auto first = valued();
    for (const Id<FlatSystem::Variable> id : whole.variables.ids())
        if (const auto& initial = whole.variables[id].initial) state[id.index] = first[initial->index].value_or(0);
    FlatRun made{{}, run.loop};
    for (const SubsystemStep& step : run.steps) {
        for (const auto& [choice, value] : step.choices) state[choice] = value;
        const auto values = valued();
        made.states.push_back(state);
        for (const Id<FlatSystem::Variable> id : whole.variables.ids()) {
            const FlatSystem::Variable& variable = whole.variables[id];
            state[id.index] = variable.choice ? 0 : values[variable.next->index].value_or(0);
        }
    }
    if (!run.loop) made.states.push_back(std::move(state));
    return made;
}

}  // namespace grafverif
