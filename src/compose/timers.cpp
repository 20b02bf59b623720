// SPDX-License-Identifier: MIT
// Adds the timers: one process per distinct time condition t1/v/t2. Timers for t1/v share the template of CEP13 Fig.
// 33b, with two corrections. A timer as published follows the level of its step and sets EVOL_TI only when it expires.
// Such a timer does not detect that its step is deactivated and activated again within one instant. As a result, the
// pulse chart `1 -> 2 when 5s/X1; 2 -> 1 when true` clears transitions forever after the first 5 s. In this
// implementation, the update of the step sets a request (P) whenever it changes the level, and the timer accepts the
// request immediately and restarts. No PLC cycle starts before the request is accepted, and every change of the timer
// output Q sets EVOL_TI. If the step is inactive at the end of the update, the request only stops the timer.
//
// With a task cycle, EVOL_TI does not exist, because time starts the scans. In a scan that searches for stability, no
// delay elapses before `stable` is true: for all evolutions of the scan, only those delays have elapsed that had
// elapsed at its start.
//
// With t2, Q remains true for t2 after the level falls. The delay t1 ends before the delay t2 begins. If the level
// rises again during t2, the new t1 (rise, clock t) elapses concurrently with the rest of the previous t2 (fall, clock
// u).
//
// Main edges of the three templates:
//   `t1/v`:    idle -> run -> done -> idle
//   `v/t2`:    off -> on -> fall -> off; fall -> on
//   `t1/v/t2`: idle -> run -> done -> fall -> idle; fall -> both (the level rises again); both -> done, run or fall
#include <algorithm>
#include <cassert>
#include <tuple>
#include <utility>

#include "compose/controller.hpp"
#include "ir/words_of.hpp"

namespace grafverif {

namespace {

constexpr Id<Network::Location> done{2};  ///< location after t1 has elapsed, in every template with t1

enum class Delays { Rise, Fall, Both };

Delays delays(const Equations::Timer& timer) {
    if (timer.fall_ms == 0) return Delays::Rise;
    return timer.rise_ms == 0 ? Delays::Fall : Delays::Both;
}

const char* template_name(Delays delays) {
    switch (delays) {
    case Delays::Rise: return "timer";
    case Delays::Fall: return "timer_off";
    case Delays::Both: return "timer_on_off";
    }
    return "";
}

/// The connection of a timer to its controller.
struct Coupling {
    /// True if the timer waits for requests; false if it follows the level of its step, as with
    /// Ablations::timers_as_published.
    bool requests = true;
    bool flags = true;   ///< true if each change of the output Q sets EVOL_TI
    bool waits = false;  ///< true if delays elapse only while `stable` is true
};

class TimerBuilder {
public:
    TimerBuilder(Exprs& exprs, Delays delays, Coupling coupling)
        : exprs_(exprs), delays_(delays), coupling_(coupling) {}

    Network::Template build(std::string name) {
        automaton_.name = std::move(name);
        const Type durations = integer_type(least_integer, greatest_integer);
        if (delays_ != Delays::Fall) rise_ = {parameter("D", Network::ParameterKind::Constant, durations)};
        if (delays_ != Delays::Rise) fall_ = {parameter("F", Network::ParameterKind::Constant, durations)};
        level_ = parameter("X", Network::ParameterKind::Read, {});
        if (coupling_.requests) pending_ = parameter("P", Network::ParameterKind::Written, {});
        end_ = parameter("Q", Network::ParameterKind::Written, {});
        if (coupling_.flags) flag_ = parameter("EVOL_TI", Network::ParameterKind::Written, {});
        if (coupling_.waits) stable_ = parameter("stable", Network::ParameterKind::Read, {});
        if (delays_ != Delays::Fall) rise_.clock = automaton_.clocks.add({"t"});
        if (delays_ != Delays::Rise) fall_.clock = automaton_.clocks.add({"u"});
        const Id<Expr> requested = coupling_.requests ? pending_ : exprs_.constant(true);
        up_ = exprs_.conjunction(requested, level_);
        down_ = exprs_.conjunction(requested, exprs_.negation(level_));
        switch (delays_) {
        case Delays::Rise: coupling_.requests ? add_rise() : add_published(); break;
        case Delays::Fall: add_fall(); break;
        case Delays::Both: add_both(); break;
        }
        automaton_.initial = {0};
        return std::move(automaton_);
    }

private:
    using Location = Id<Network::Location>;

    struct Delay {
        Id<Expr> duration = {};
        Id<Network::Clock> clock = {};
    };

    Id<Expr> parameter(const char* name, Network::ParameterKind kind, Type type) {
        return exprs_.leaf(Op::Parameter, automaton_.parameters.add({name, kind, type}).index);
    }

    Location location(const char* name, std::vector<Delay> running = {}) {
        Network::Location location{name, {}, {}};
        for (const Delay& delay : running) location.invariant.push_back({delay.clock, Op::LessEqual, delay.duration});
        return automaton_.locations.add(std::move(location));
    }

    void add_done() {
        [[maybe_unused]] const Location added = location("done");
        assert(added == done);
    }

    /// Returns assignments that set the output Q to `value` and, unless the controller has a task cycle, request a PLC
    /// cycle.
    std::vector<Network::Assignment> change(bool value) {
        std::vector<Network::Assignment> list{{end_, exprs_.constant(value)}};
        if (coupling_.flags) list.push_back({flag_, exprs_.constant(true)});
        return list;
    }

    /// Adds an edge that accepts the request `request`. The edge resets the clock `starts`, if it is valid.
    void take(Location from, Location to, Id<Expr> request, std::vector<Network::Assignment> assignments,
              Id<Network::Clock> starts = {}) {
        if (coupling_.requests) assignments.push_back({pending_, exprs_.constant(false)});
        Network::Edge edge{
            .from = from, .to = to, .urgent = true, .guard = request, .assignments = std::move(assignments)};
        if (starts.valid()) edge.resets.push_back(starts);
        automaton_.edges.add(std::move(edge));
    }

    /// Adds an edge at the end of a delay. The edge is disabled while a request is pending.
    void elapse(Location from, Location to, const Delay& delay, std::vector<Network::Assignment> assignments) {
        std::vector<Id<Expr>> guard;
        if (coupling_.requests) guard.push_back(exprs_.negation(pending_));
        if (coupling_.waits) guard.push_back(stable_);
        automaton_.edges.add({.from = from,
                              .to = to,
                              .guard = exprs_.conjunction(guard),
                              .constraint = {{delay.clock, Op::Equal, delay.duration}},
                              .assignments = std::move(assignments)});
    }

    void add_rise() {
        const Location idle = location("idle"), run = location("run", {rise_});
        add_done();
        take(idle, run, up_, {}, rise_.clock);
        take(idle, idle, down_, {});
        elapse(run, done, rise_, change(true));
        take(run, run, up_, {}, rise_.clock);
        take(run, idle, down_, {});
        take(done, run, up_, change(false), rise_.clock);
        take(done, idle, down_, change(false));
    }

    void add_published() {
        const Location idle = location("idle"), run = location("run", {rise_});
        add_done();
        take(idle, run, up_, {}, rise_.clock);
        elapse(run, done, rise_, change(true));
        take(run, idle, down_, {});
        take(done, idle, down_, {{end_, exprs_.constant(false)}});
    }

    void add_fall() {
        const Location off = location("off"), on = location("on"), fall = location("fall", {fall_});
        take(off, on, up_, change(true));
        take(on, fall, down_, {}, fall_.clock);
        take(fall, on, up_, {});
        elapse(fall, off, fall_, change(false));
    }

    void add_both() {
        const Location idle = location("idle"), run = location("run", {rise_});
        add_done();
        const Location fall = location("fall", {fall_}), both = location("both", {rise_, fall_});
        take(idle, run, up_, {}, rise_.clock);
        elapse(run, done, rise_, change(true));
        take(run, idle, down_, {});
        take(done, fall, down_, {}, fall_.clock);
        elapse(fall, idle, fall_, change(false));
        take(fall, both, up_, {}, rise_.clock);
        elapse(both, done, rise_, {});
        elapse(both, run, fall_, change(false));
        take(both, fall, down_, {});
    }

    Exprs& exprs_;
    Delays delays_;
    Coupling coupling_;
    Network::Template automaton_ = {};
    Id<Expr> level_ = {}, pending_ = {}, end_ = {}, flag_ = {}, stable_ = {};
    Delay rise_ = {}, fall_ = {};
    Id<Expr> up_ = {}, down_ = {};  ///< guards of edges that accept a request to start or to stop
};

/// Returns the template for `timer`, whose parameters are the durations. The template is added for the first timer of
/// its type.
Id<Network::Template> template_for(Composition& composition, const Equations::Timer& timer, Coupling coupling,
                                   const std::vector<std::int64_t>& durations) {
    Network& network = composition.network;
    const std::tuple type{static_cast<int>(delays(timer)), coupling.flags, coupling.waits};
    Id<Network::Template>& automaton = composition.timers[type];
    if (!automaton.valid()) {
        TimerBuilder builder(network.exprs, delays(timer), coupling);
        automaton = network.templates.add(builder.build(composition.names.fresh(template_name(delays(timer)))));
    }
    for (std::uint32_t k = 0; k < durations.size(); ++k) {
        Type& bound = network.templates[automaton].parameters[{k}].type;
        bound.high = std::max(bound.high, durations[k]);
    }
    return automaton;
}

}  // namespace

void add_timers(Composition& composition, const ControllerParts& parts, Id<Network::Controller> controller) {
    Network& network = composition.network;
    const Coupling coupling{!parts.pending.empty(), !parts.cycle, parts.holds_inputs()};
    for (std::size_t i = 0; i < parts.equations->timers.size(); ++i) {
        const Equations::Timer& timer = parts.equations->timers[i];
        std::vector<std::int64_t> durations;
        for (const std::int64_t duration : {timer.rise_ms, timer.fall_ms})
            if (duration > 0) durations.push_back(duration / network.time_unit_ms);
        Network::Process process{.name = composition.names.fresh(parts.prefix + timer.name),
                                 .automaton = template_for(composition, timer, coupling, durations),
                                 .kind = Network::ProcessKind::Timer,
                                 .origin = timer.origin};
        process.arguments.assign(durations.begin(), durations.end());
        process.arguments.push_back(parts.variable[timer.watched.index]);
        if (!parts.pending.empty()) process.arguments.push_back(parts.pending[i]);
        process.arguments.push_back(parts.variable[timer.end.index]);
        if (coupling.flags) process.arguments.push_back(parts.evol_ti);
        if (coupling.waits) process.arguments.push_back(parts.stable);
        process.initial = network.templates[process.automaton].initial;
        network.controllers[controller].timers.push_back({network.processes.add(std::move(process)),
                                                          timer.rise_ms > 0 ? done : Id<Network::Location>{},
                                                          !parts.pending.empty()});
    }
}

}  // namespace grafverif
