// SPDX-License-Identifier: MIT
#include "analyse/evidence.hpp"

#include <algorithm>
#include <utility>

#include "analyse/event_times.hpp"
#include "run/interpreter.hpp"
#include "run/project.hpp"

namespace grafverif::analysis {

namespace {

using Kind = Chart::VariableKind;

/// The maximum number of evolutions of an endless loop that a witness trace contains.
constexpr std::size_t reported_of_loop = 60;

std::string fault_text(RunFault::Kind kind) {
    switch (kind) {
    case RunFault::Kind::NoValue: return "undefined value";
    case RunFault::Kind::OutOfRange: return "value out of range";
    case RunFault::Kind::ForcedApart: return "contradictory forcing orders";
    }
    return {};
}

class WitnessTraceBuilder {
public:
    WitnessTraceBuilder(const Chart& chart, const Equations& equations, const Machine& machine, ExecutionMode mode,
                        const Path& path)
        : chart_(chart), equations_(equations), machine_(machine), mode_(mode), path_(path), state_(power_on(chart)) {}

    WitnessTrace build(const EvolutionRequirement& demand) {
        const auto moments = analysis::moments(machine_, path_);
        if (!moments) {
            result_.timing = Finding::Timing::Unconfirmed;
            return std::move(result_);
        }
        if (!machine_.clocks().empty()) result_.timing = Finding::Timing::Confirmed;
        moments_ = *moments;
        result_.trace = project(chart_, mode_);
        const std::size_t last = path_.instants.size() - 1;
        begin(0);
        add_row("power-on", {});
        for (std::size_t instant = 0; instant < last && result_.failure.empty(); ++instant) complete_instant(instant);
        if (result_.failure.empty()) last_instant(last, demand);
        return std::move(result_);
    }

private:
    using Fired = std::vector<std::vector<Id<Chart::Transition>>>;

    /// Advances the time and sets the inputs of `instant`.
    void begin(std::size_t instant) {
        if (instant > 0) state_ = pass_time(std::move(state_), moments_[instant] - moments_[instant - 1]);
        time_ = moments_[instant];
        const Point& point = path_.instants[instant].front();
        inputs_.assign(chart_.variables.size(), 0);
        for (const Id<Chart::Variable> id : chart_.variables.ids())
            if (chart_.variables[id].kind == Kind::Input) inputs_[id.index] = machine_.value(point, {id.index});
    }

    std::string problem(const Cycle& cycle) const {
        if (cycle.race) return "two actions race";
        if (cycle.fault) return "a value is undefined or out of range";
        return cycle.endless.empty() && !cycle.gave_up ? "" : "the instant never ends";
    }

    void complete_instant(std::size_t instant) {
        begin(instant);
        Cycle done = cycle(chart_, state_, inputs_, mode_);
        if (const std::string found = problem(done); !found.empty()) return fail(instant, found);
        state_ = std::move(done.state);
        add_row("", done.fired);
    }

    void last_instant(std::size_t instant, const EvolutionRequirement& demand) {
        begin(instant);
        const State at_start = state_;
        const std::vector<Point>& points = path_.instants[instant];
        const std::size_t before = path_.at_first ? 0 : points.size() - 1 + (instant == 0 ? 1 : 0);
        Fired fired;
        for (std::size_t k = 0; k < before; ++k) {
            Evolution made = evolve();
            if (made.race || made.fault) return fail(instant, "an earlier evolution has a model error");
            fired.push_back(std::move(made.fired));
            state_ = std::move(made.state);
        }
        if (!path_.at_first && !is_at(points.back())) return fail(instant, "the situation differs");
        if (!demand.ends && !demand.endless) {
            add_row("in this instant", fired);
            return;
        }
        const Evolution shown = evolve();
        if (!shows(shown, demand)) return fail(instant, "the last evolution does not confirm the finding");
        if (demand.endless) return report_loop(instant, fired);
        if (demand.settles && (shown.race || shown.fault)) return fail(instant, "the last evolution has a model error");
        if (shown.race && shown.race->variable == demand.race) result_.racing = {shown.race->first, shown.race->second};
        if (shown.fault) result_.fault = shown.fault->where;
        if (shown.race || shown.fault) {
            fired.push_back(shown.fired);
            state_.situation = shown.state.situation;
            add_row(shown.race ? "race" : fault_text(shown.fault->kind), fired);
            return;
        }
        fired.push_back(shown.fired);
        report_rest(at_start, shown, fired);
        if (demand.settles && !settles_) fail(instant, "the instant never ends or has a model error");
    }

    /// Appends the last instant to the trace up to its end. If the instant never ends, or aborts after the end of the
    /// path, appends only its evolutions up to the end of the path.
    void report_rest(const State& at_start, const Evolution& shown, const Fired& fired) {
        Cycle done = cycle(chart_, at_start, inputs_, mode_);
        const bool ends = problem(done).empty();
        settles_ = ends;
        state_ = ends ? std::move(done.state) : shown.state;
        ends ? add_row("", done.fired) : add_row("in this instant", fired);
    }

    /// Appends the endless loop of evolutions at the end of the path to the trace.
    void report_loop(std::size_t instant, const Fired& fired) {
        result_.endless = cycle(chart_, state_, inputs_, mode_).endless;
        if (result_.endless.empty()) return fail(instant, "the instant ends");
        if (!fired.empty()) add_row("", fired);
        ChartRun& run = result_.trace;
        if (result_.endless.size() <= reported_of_loop) run.loop = run.loop_from = run.rows.size();
        for (std::size_t k = 0; k < std::min(result_.endless.size(), reported_of_loop); ++k) {
            Evolution made = evolve();
            state_ = std::move(made.state);
            add_row("immediately", {made.fired});
        }
    }

    Evolution evolve() const { return grafverif::evolve(chart_, state_, inputs_, time_conditions(chart_, state_)); }

    bool is_at(const Point& point) const {
        for (const Id<Chart::Step> id : chart_.steps.ids())
            if (machine_.covers_step(id.index) &&
                state_.situation[id.index] != (machine_.value(point, equations_.steps[id.index].variable) != 0))
                return false;
        return true;
    }

    static bool shows(const Evolution& made, const EvolutionRequirement& demand) {
        const bool fired = std::ranges::all_of(demand.fired, [&](Id<Chart::Transition> wanted) {
            return std::ranges::find(made.fired, wanted) != made.fired.end();
        });
        const bool race = !demand.race.valid() || made.race.has_value();
        return fired && race && (!demand.fault || made.fault.has_value());
    }

    void fail(std::size_t instant, const std::string& what) {
        result_.failure = "instant " + std::to_string(instant + 1) + ": under the rules of IEC 60848, " + what;
    }

    void add_row(std::string what, const Fired& fired) {
        append_instant(result_.trace, std::move(what), fired, project(chart_, state_, inputs_, time_));
    }

    const Chart& chart_;
    const Equations& equations_;
    const Machine& machine_;
    ExecutionMode mode_;
    const Path& path_;
    State state_;
    std::vector<std::int64_t> moments_ = {};
    std::int64_t time_ = 0;
    std::vector<std::int64_t> inputs_ = {};
    WitnessTrace result_ = {};
    bool settles_ = false;
};

}  // namespace

WitnessTrace evidence(const Chart& chart, const Equations& equations, const Machine& machine, ExecutionMode mode,
                      const Path& path, const EvolutionRequirement& demand) {
    return WitnessTraceBuilder(chart, equations, machine, mode, path).build(demand);
}

}  // namespace grafverif::analysis
