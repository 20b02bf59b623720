// SPDX-License-Identifier: MIT
#include "report/trace_rows.hpp"

#include <algorithm>
#include <utility>

#include "report/trace_text.hpp"

namespace grafverif {

namespace {

using Kind = ChartRun::Kind;
using Act = ChartRun::Act;

const char* phase_word(const Act& act) {
    if (act.starts) return "first evolution";
    if (act.samples && act.evolves) return "cycle";
    if (act.samples) return "inputs sampled";
    if (act.evolves) return "evolution";
    if (act.writes != Act::Writes::No) return "outputs written";
    return act.begins ? "cycle begins" : "cycle ends";
}

}  // namespace

void TraceRowBuilder::add(ChartRun::Row row, std::size_t moment) {
    close_delay();
    row.moment = moment;
    run_.rows.push_back(std::move(row));
}

void TraceRowBuilder::close_delay() {
    if (!delay_) return;
    const std::size_t moment = *std::exchange(delay_, {});
    const std::int64_t ms = std::exchange(delay_ms_, 0);
    add({.kind = Kind::Delay,
         .what = !run_.searches ? "time passes" : seconds_text(ms) + (ms == 1000 ? " passes" : " pass")},
        moment);
}

void TraceRowBuilder::close(std::size_t controller, std::size_t moment) {
    const OpenRow open = std::exchange(open_[controller], {});
    if (open.fired.empty() && !open.changed) return;
    ChartRun::Row row{.kind = Kind::Controller,
                      .component = run_.controllers[{static_cast<std::uint32_t>(controller)}].name,
                      .fired = open.fired};
    if (open.first) row.what = "first evolution";
    else if (!open.written && run_.searches) row.what = "outputs not yet written";
    add(std::move(row), moment);
}

void TraceRowBuilder::close_all(std::size_t moment) {
    for (std::size_t controller = 0; controller < open_.size(); ++controller) close(controller, moment);
}

void TraceRowBuilder::begin_loop() {
    close_delay();
    close_all(next_ - 1);
    run_.loop_from = run_.rows.size();
}

void TraceRowBuilder::catch_up() {
    for (; next_ < run_.moments.size(); ++next_) {
        if (run_.loop == next_) begin_loop();
        add_event(next_);
    }
}

void TraceRowBuilder::flush() {
    catch_up();
    close_delay();
    close_all(next_ - 1);
}

void TraceRowBuilder::finish() {
    flush();
    if (run_.loop == run_.moments.size()) begin_loop();
    if (!run_.loop_from) return;
    const auto loop = run_.rows.begin() + static_cast<std::ptrdiff_t>(*run_.loop_from);
    if (loop == run_.rows.end()) {
        ChartRun::Row row{.kind = Kind::Environment, .what = "nothing changes, forever"};
        if (run_.searches) row = {Kind::Controller, "", "cycles repeat forever, no time passes, nothing changes"};
        return add(std::move(row), next_ - 1);
    }
    const bool waits = std::all_of(loop, run_.rows.end(), [](const auto& row) { return row.kind == Kind::Delay; });
    if (waits && run_.searches) loop->what = "time passes, forever";
}

void TraceRowBuilder::add_event(std::size_t moment) {
    const ChartRun::Event& event = run_.moments[moment];
    if (moment == 0) {
        const bool alone = run_.controllers.size() == 1;
        return add({Kind::Controller, alone ? run_.controllers.begin()->name : run_.name, "power on"}, moment);
    }
    if (event.kind == Kind::Delay) {
        close_all(moment - 1);
        delay_ = moment;
        delay_ms_ += event.after.time_ms - run_.moments[moment - 1].after.time_ms;
        return;
    }
    // A delay is printed as one row, even if scans of a task cycle occur during the delay, provided that these scans
    // change nothing.
    const bool scans = std::ranges::any_of(
        event.acts, [&](const Act& act) { return run_.controllers[act.controller].cycle.has_value(); });
    if (run_.searches && !scans) close_delay();
    for (const Act& act : event.acts) add_act_rows(moment, act);
    if (event.timer.valid()) return add_timer_row(moment);
    if (event.kind != Kind::Controller && !event.internal) return add_instance_row(moment);
    if (event.internal && event.instance.valid() && detail_ == Detail::Everything)
        add({.kind = event.kind,
             .component = run_.instances[event.instance].name,
             .what = instance_text(run_, moment),
             .internal = true},
            moment);
}

/// Adds a row for each controller that has sampled an input whose value changes in this event, before the evolution
/// that reads the sample. The row states that the controller has sampled its inputs.
void TraceRowBuilder::add_sampling_row(std::size_t moment) {
    const std::vector<std::int64_t>& before = run_.moments[moment - 1].after.values;
    const std::vector<std::int64_t>& after = run_.moments[moment].after.values;
    for (const Id<ChartRun::Controller> id : run_.controllers.ids()) {
        const ChartRun::Controller& controller = run_.controllers[id];
        const bool changes = std::ranges::any_of(
            controller.inputs, [&](Id<ChartRun::Signal> input) { return before[input.index] != after[input.index]; });
        if (!sampled_[id.index] || !changes || detail_ == Detail::Everything) continue;
        add({Kind::Controller, controller.name, "inputs sampled"}, moment - 1);
        sampled_[id.index] = false;
    }
}

void TraceRowBuilder::add_instance_row(std::size_t moment) {
    close_all(moment - 1);
    add_sampling_row(moment);
    const ChartRun::Event& event = run_.moments[moment];
    ChartRun::Row row{.kind = event.kind, .what = "inputs change"};
    if (event.instance.valid()) {
        row.component = run_.instances[event.instance].name;
        row.what = instance_text(run_, moment);
    }
    add(std::move(row), moment);
}

void TraceRowBuilder::add_timer_row(std::size_t moment) {
    close_all(moment - 1);
    const ChartRun::Event& event = run_.moments[moment];
    const ChartRun::Timer& timer = run_.timers[event.timer];
    add({Kind::Timer, timer.name, timer_text(timer, event.timer_holds)}, moment);
}

void TraceRowBuilder::add_act_rows(std::size_t moment, const Act& act) {
    const ChartRun::State &before = run_.moments[moment - 1].after, &after = run_.moments[moment].after;
    const std::size_t index = act.controller.index;
    for (std::size_t other = 0; other < open_.size(); ++other)
        if (other != index) close(other, moment - 1);
    OpenRow& open = open_[index];
    if (act.samples || act.evolves) sampled_[index] = run_.searches && !act.evolves && !act.fired.empty();
    if (act.evolves) {
        if (!act.fired.empty()) open.fired.push_back(act.fired);
        open.written = false;
    }
    open.changed =
        open.changed || before.values != after.values || (!run_.searches && before.situation != after.situation);
    open.first = open.first || (open.changed && act.starts);
    open.written = open.written || act.writes == Act::Writes::Yes;
    if (detail_ == Detail::Everything) return report_phase(moment, act);
    if (act.writes == Act::Writes::Yes || !run_.searches) close(index, moment);
}

/// Adds a row for the collected actions of a PLC cycle. If each evolution has a row (`searches` is false), actions that
/// include no evolution and change nothing have no row.
void TraceRowBuilder::report_phase(std::size_t moment, const Act& act) {
    const OpenRow open = std::exchange(open_[act.controller.index], {});
    const bool internal = open.fired.empty() && !open.changed;
    if (!run_.searches && internal && !act.evolves) return;
    add({.kind = Kind::Controller,
         .component = run_.controllers[act.controller].name,
         .what = run_.searches || act.starts ? phase_word(act) : "",
         .fired = open.fired,
         .internal = internal},
        moment);
}

ChartRun with_rows(ChartRun run, Detail detail) {
    TraceRowBuilder(run, detail).finish();
    return run;
}

}  // namespace grafverif
