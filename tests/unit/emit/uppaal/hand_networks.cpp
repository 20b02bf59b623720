// SPDX-License-Identifier: MIT
#include "unit/emit/uppaal/hand_networks.hpp"

namespace grafverif::test {
namespace {

using Kind = Network::ParameterKind;
using Location = Id<Network::Location>;
using Parameter = Id<Network::Parameter>;
using Role = Network::Role;
using Template = Network::Template;
using Variable = Id<Network::Variable>;

struct EdgeOf {
    std::uint32_t from = 0, to = 0;
    bool urgent = false;
    Id<Expr> guard = {};
    std::vector<Network::ClockConstraint> constraint = {};
    std::vector<Network::Assignment> assignments = {};
    std::vector<Id<Network::Clock>> resets = {};
    std::vector<Id<Network::Procedure>> calls = {};
};

void add_edge(Template& automaton, EdgeOf edge) {
    automaton.edges.add({{edge.from},
                         {edge.to},
                         edge.urgent,
                         edge.guard,
                         std::move(edge.constraint),
                         std::move(edge.resets),
                         std::move(edge.assignments),
                         std::move(edge.calls),
                         {}});
}

/// Returns the cylinder of CEP13 Fig. 8 and 13a.
Template cylinder(Hand& h, Type position) {
    Template automaton{.name = "cylinder_5_3"};
    const Parameter in = automaton.parameters.add({"G_IN", Kind::Read, {}});
    const Parameter out = automaton.parameters.add({"G_OUT", Kind::Read, {}});
    const Parameter x = automaton.parameters.add({"X", Kind::Written, position});
    const Parameter low = automaton.parameters.add({"X_min", Kind::Constant, integer_type(-32768, 32767)});
    const Parameter high = automaton.parameters.add({"X_max", Kind::Constant, integer_type(-32768, 32767)});
    const Parameter step = automaton.parameters.add({"D_X", Kind::Constant, integer_type(-32768, 32767)});
    const Parameter duration = automaton.parameters.add({"STEP", Kind::Constant, integer_type(-32768, 32767)});
    const Id<Network::Clock> t = automaton.clocks.add({"t"});
    const std::vector<Network::ClockConstraint> moving = {{t, Op::LessEqual, h.p(duration)}};
    const std::vector<Network::ClockConstraint> due = {{t, Op::Equal, h.p(duration)}};
    automaton.initial = automaton.locations.add({"still", {}, {}});
    automaton.locations.add({"going_out", moving, {}});
    automaton.locations.add({"going_in", moving, {}});
    const auto direction = [&](std::uint32_t there, Parameter order, Op move, Op before, Op beyond, Parameter end) {
        const Id<Expr> moved = h.op(move, h.p(x), h.p(step));
        const Id<Expr> going = h.all({h.p(order), h.op(before, moved, h.p(end))});
        const Id<Expr> arriving = h.all({h.p(order), h.op(beyond, moved, h.p(end))});
        add_edge(automaton, {.from = 0,
                             .to = there,
                             .urgent = true,
                             .guard = h.all({h.p(order), h.op(before, h.p(x), h.p(end))}),
                             .resets = {t}});
        add_edge(automaton, {.from = there,
                             .to = there,
                             .guard = going,
                             .constraint = due,
                             .assignments = {{h.p(x), moved}},
                             .resets = {t}});
        add_edge(automaton,
                 {.from = there, .to = 0, .guard = arriving, .constraint = due, .assignments = {{h.p(x), h.p(end)}}});
        add_edge(automaton, {.from = there, .to = 0, .urgent = true, .guard = h.neither(h.p(order))});
    };
    direction(1, out, Op::Plus, Op::Less, Op::GreaterEqual, high);
    direction(2, in, Op::Minus, Op::Greater, Op::LessEqual, low);
    return automaton;
}

/// Returns the sensor of CEP13 Fig. 13b. `END` is true while `X` is in the range from `FROM` to `TO`.
Template sensor(Hand& h, Type position) {
    Template automaton{.name = "end_sensor"};
    const Parameter x = automaton.parameters.add({"X", Kind::Read, position});
    const Parameter end = automaton.parameters.add({"END", Kind::Written, {}});
    const Parameter low = automaton.parameters.add({"FROM", Kind::Constant, integer_type(-32768, 32767)});
    const Parameter high = automaton.parameters.add({"TO", Kind::Constant, integer_type(-32768, 32767)});
    const Parameter evol = automaton.parameters.add({"EVOL_PL", Kind::Written, {}});
    automaton.initial = automaton.locations.add({"away", {}, {}});
    automaton.locations.add({"there", {}, {}});
    const Id<Expr> inside = h.all({h.op(Op::GreaterEqual, h.p(x), h.p(low)), h.op(Op::LessEqual, h.p(x), h.p(high))});
    const Id<Expr> outside = h.any({h.op(Op::Less, h.p(x), h.p(low)), h.op(Op::Greater, h.p(x), h.p(high))});
    add_edge(automaton, {.from = 0,
                         .to = 1,
                         .urgent = true,
                         .guard = inside,
                         .assignments = {{h.p(end), h.yes()}, {h.p(evol), h.yes()}}});
    add_edge(automaton, {.from = 1,
                         .to = 0,
                         .urgent = true,
                         .guard = outside,
                         .assignments = {{h.p(end), h.no()}, {h.p(evol), h.yes()}}});
    return automaton;
}

/// Returns the button of CEP13 Fig. 34.
Template button(Hand& h) {
    Template automaton{.name = "push_button"};
    const Parameter out = automaton.parameters.add({"OUT", Kind::Written, {}});
    const Parameter evol = automaton.parameters.add({"EVOL_PL", Kind::Written, {}});
    const Id<Network::Clock> t = automaton.clocks.add({"t"});
    automaton.initial = automaton.locations.add({"1", {}, {}});
    add_edge(automaton, {.from = 0,
                         .to = 0,
                         .guard = h.yes(),
                         .constraint = {{t, Op::GreaterEqual, h.number(1)}},
                         .assignments = {{h.p(out), h.neither(h.p(out))}, {h.p(evol), h.yes()}},
                         .resets = {t}});
    return automaton;
}

/// Returns the timer of CEP13 Fig. 33b, which restarts if its step is activated again.
Template timer(Hand& h) {
    Template automaton{.name = "timer"};
    const Parameter duration = automaton.parameters.add({"D", Kind::Constant, integer_type(-32768, 32767)});
    const Parameter step = automaton.parameters.add({"X", Kind::Read, {}});
    const Parameter pending = automaton.parameters.add({"P", Kind::Written, {}});
    const Parameter end = automaton.parameters.add({"Q", Kind::Written, {}});
    const Parameter evol = automaton.parameters.add({"EVOL_TI", Kind::Written, {}});
    const Id<Network::Clock> t = automaton.clocks.add({"t"});
    automaton.initial = automaton.locations.add({"idle", {}, {}});
    automaton.locations.add({"run", {{t, Op::LessEqual, h.p(duration)}}, {}});
    automaton.locations.add({"done", {}, {}});
    const Id<Expr> start = h.all({h.p(pending), h.p(step)}), stop = h.all({h.p(pending), h.neither(h.p(step))});
    const Network::Assignment taken{h.p(pending), h.no()}, over{h.p(end), h.yes()}, reset{h.p(end), h.no()},
        announce{h.p(evol), h.yes()};
    add_edge(automaton, {.from = 0, .to = 1, .urgent = true, .guard = start, .assignments = {taken}, .resets = {t}});
    add_edge(automaton, {.from = 0, .to = 0, .urgent = true, .guard = stop, .assignments = {taken}});
    add_edge(automaton, {.from = 1,
                         .to = 2,
                         .guard = h.neither(h.p(pending)),
                         .constraint = {{t, Op::Equal, h.p(duration)}},
                         .assignments = {over, announce}});
    add_edge(automaton, {.from = 1, .to = 1, .urgent = true, .guard = start, .assignments = {taken}, .resets = {t}});
    add_edge(automaton, {.from = 1, .to = 0, .urgent = true, .guard = stop, .assignments = {taken}});
    add_edge(
        automaton,
        {.from = 2, .to = 1, .urgent = true, .guard = start, .assignments = {taken, reset, announce}, .resets = {t}});
    add_edge(automaton, {.from = 2, .to = 0, .urgent = true, .guard = stop, .assignments = {taken, reset, announce}});
    return automaton;
}

/// The variables that the chart of `station` and its plant share.
struct Wires {
    Variable start = {}, is_in = {}, is_out = {}, go_in = {}, go_out = {}, lock = {}, count = {}, x0 = {}, x1 = {},
             cf0 = {}, cf1 = {}, sample = {}, image = {}, old = {}, end = {}, pending = {}, evol_pl = {}, evol_ti = {},
             stable = {}, race = {};
};

/// Returns the cycle of CEP13 Fig. 33a for `0 -> 1 when START; 1 -> 0 when 3s/X1 && IS_OUT`.
Template cycle(Hand& h, const Wires& w) {
    Template automaton{.name = "plc_cycle"};
    const auto fire = automaton.procedures.add({"fire",
                                                {
                                                    {h.v(w.cf0), h.all({h.v(w.x0), h.v(w.start)})},
                                                    {h.v(w.cf1), h.all({h.v(w.x1), h.v(w.end), h.v(w.is_out)})},
                                                    {h.v(w.sample), h.v(w.is_in)},
                                                }});
    const auto evolve = automaton.procedures.add(
        {"evolve",
         {
             {h.v(w.old), h.v(w.count)},
             {h.v(w.pending), h.any({h.v(w.pending), h.v(w.cf0), h.v(w.cf1)})},
             {h.v(w.stable), h.all({h.neither(h.v(w.cf0)), h.neither(h.v(w.cf1))})},
             {h.v(w.race), h.all({h.v(w.cf0), h.v(w.cf1)})},
             {h.v(w.count),
              h.network.exprs.conditional(
                  h.v(w.cf0), h.op(Op::Plus, h.v(w.count), h.number(1)),
                  h.network.exprs.conditional(h.all({h.v(w.cf1), h.op(Op::Equal, h.v(w.old), h.number(9))}),
                                              h.number(-3), h.v(w.count)))},
             {h.v(w.image), h.network.exprs.conditional(h.v(w.cf0), h.v(w.sample), h.v(w.image))},
             {h.v(w.x0), h.any({h.v(w.cf1), h.all({h.v(w.x0), h.neither(h.v(w.cf0))})})},
             {h.v(w.x1), h.any({h.v(w.cf0), h.all({h.v(w.x1), h.neither(h.v(w.cf1))})})},
             {h.v(w.cf0), h.no()},
             {h.v(w.cf1), h.no()},
         }});
    const auto write = automaton.procedures.add({"write",
                                                 {
                                                     {h.v(w.go_out), h.v(w.x1)},
                                                     {h.v(w.go_in), h.all({h.v(w.x0), h.neither(h.v(w.sample))})},
                                                     {h.v(w.lock), h.v(w.image)},
                                                     {h.v(w.sample), h.no()},
                                                 }});
    for (const char* name : {"W", "P0", "P1", "P2"}) automaton.locations.add({name, {}, {}});
    automaton.initial = {0};
    const Id<Expr> begins =
        h.all({h.any({h.neither(h.v(w.stable)), h.v(w.evol_pl), h.v(w.evol_ti)}), h.neither(h.v(w.pending))});
    add_edge(automaton, {.from = 0,
                         .to = 1,
                         .urgent = true,
                         .guard = begins,
                         .assignments = {{h.v(w.evol_pl), h.no()}, {h.v(w.evol_ti), h.no()}}});
    add_edge(automaton, {.from = 1, .to = 2, .urgent = true, .guard = h.yes(), .calls = {fire}});
    add_edge(automaton, {.from = 2, .to = 3, .urgent = true, .guard = h.yes(), .calls = {evolve}});
    add_edge(automaton, {.from = 3, .to = 0, .urgent = true, .guard = h.v(w.stable), .calls = {write}});
    add_edge(automaton, {.from = 3, .to = 0, .urgent = true, .guard = h.neither(h.v(w.stable))});
    return automaton;
}

Wires wires(Hand& h) {
    Wires w;
    w.start = h.boolean("START", Role::Input);
    w.is_in = h.boolean("IS_IN", Role::Input, true);
    w.is_out = h.boolean("IS_OUT", Role::Input);
    w.go_in = h.boolean("GO_IN", Role::Output);
    w.go_out = h.boolean("GO_OUT", Role::Output);
    w.lock = h.boolean("LOCK", Role::Output);
    w.count = h.integer("COUNT", Role::Internal, -3, 10);
    w.x0 = h.boolean("X_0", Role::Step, true);
    w.x1 = h.boolean("X_1", Role::Step);
    w.cf0 = h.boolean("CF_T0", Role::FiringCondition);
    w.cf1 = h.boolean("CF_T1", Role::FiringCondition);
    w.sample = h.boolean("IS_IN_sample", Role::Sample);
    w.image = h.boolean("LOCK_image", Role::Image);
    w.old = h.integer("COUNT_old", Role::Internal, -3, 10);
    h.network.variables[w.old].scratch = true;
    w.end = h.boolean("T_X1_3s_Q", Role::TimerEnd);
    w.pending = h.boolean("T_X1_3s_P", Role::TimerPending);
    w.evol_pl = h.boolean("EVOL_PL", Role::Flag);
    w.evol_ti = h.boolean("EVOL_TI", Role::Flag);
    w.stable = h.boolean("stable", Role::Flag);
    w.race = h.boolean("race", Role::Flag);
    return w;
}

void add_properties(Hand& h, const Wires& w, Id<Network::Process> cylinder) {
    const Id<Expr> moving = h.any({h.at(cylinder, 1), h.at(cylinder, 2)}), both = h.all({h.v(w.go_in), h.v(w.go_out)});
    h.property("P1", "never both orders", Pattern::Never, {both});
    h.property("P2", "", Pattern::Always, {h.any({h.neither(both), moving})});
    h.property("P3", "it moves <at all> & \"well\"", Pattern::Reachable, {h.at(cylinder, 1)});
    h.property("P4", "", Pattern::Inevitable, {h.v(w.is_out)});
    h.property("P5", "it comes back", Pattern::LeadsTo,
               {h.neither(h.all({h.v(w.x0), h.v(w.is_in)})), h.all({h.v(w.x0), h.v(w.is_in)})});
    h.property("D", "", Pattern::NoDeadlock);
    h.property("T", "time -- goes on", Pattern::NoTimelock);
    h.property("S", "", Pattern::ReachableAllSteps, {h.v(w.x0), h.v(w.x1)});
    h.property("E", "", Pattern::ExactlyOneOf, {h.v(w.x0), h.v(w.x1)});
    h.network.properties.add({.name = "U", .pattern = Pattern::RawUppaal, .raw = "A[] COUNT <= 10"});
    h.network.properties.add({.name = "R",
                              .text = "this one fails",
                              .pattern = Pattern::Reachable,
                              .operands = {both},
                              .expected_violated = true});
    for (const Pattern pattern : {Pattern::Always, Pattern::Never, Pattern::Reachable, Pattern::Inevitable})
        h.network.properties.add({.name = "Q" + std::to_string(static_cast<int>(pattern)),
                                  .pattern = pattern,
                                  .operands = {h.any({both, h.v(w.x0)})},
                                  .at_stable = true});
    h.network.properties.add(
        {.name = "Q4", .pattern = Pattern::LeadsTo, .operands = {moving, h.v(w.is_out)}, .at_stable = true});
    h.network.properties.add({.name = "Q8",
                              .pattern = Pattern::ExactlyOneOf,
                              .operands = {h.v(w.x0), h.neither(h.v(w.x1))},
                              .at_stable = true});
    h.property("A", "", Pattern::AlwaysPossible, {h.v(w.x0)});
    h.network.properties.add({.name = "C", .pattern = Pattern::RawCtl, .raw = "AG EF x"});
    h.network.properties.add({.name = "L", .pattern = Pattern::RawLtl, .raw = "G F x"});
}

}  // namespace

Network station() {
    Hand h;
    h.network.name = "station";
    const Wires w = wires(h);
    const Variable position = h.integer("H", Role::Plant, 0, 20);
    const Type range = h.network.variables[position].type;
    const auto cylinder_template = h.network.templates.add(cylinder(h, range));
    const auto sensor_template = h.network.templates.add(sensor(h, range));
    const auto button_template = h.network.templates.add(button(h));
    const auto cycle_template = h.network.templates.add(cycle(h, w));
    const auto timer_template = h.network.templates.add(timer(h));

    using PK = Network::ProcessKind;
    const auto actuator = h.process("H_Act", cylinder_template, {w.go_in, w.go_out, position, 0, 20, 2, 1}, PK::Plant);
    h.process("H_In", sensor_template, {position, w.is_in, 0, 1, w.evol_pl}, PK::Plant, 1);
    h.process("H_Out", sensor_template, {position, w.is_out, 18, 20, w.evol_pl}, PK::Plant, 0);
    h.process("Start", button_template, {w.start, w.evol_pl}, PK::Environment);
    const auto plc = h.process("handling", cycle_template, {}, PK::Controller);
    const auto t = h.process("T_X1_3s", timer_template, {60000, w.x1, w.pending, w.end, w.evol_ti}, PK::Timer);
    for (const auto p : h.network.templates[timer_template].parameters.ids())
        if (p.index == 0) h.network.templates[timer_template].parameters[p].type = integer_type(0, 60000);

    h.network.controllers.add({.words = {.name = "handling", .steps = {{{"", "0"}, w.x0}, {{"G2", "1"}, w.x1}}},
                               .process = plc,
                               .waiting = {0},
                               .stable = w.stable,
                               .timers = {{t}}});
    h.network.settled = h.all(
        {h.at(plc, 0), h.v(w.stable), h.neither(h.v(w.evol_pl)), h.neither(h.v(w.evol_ti)), h.neither(h.v(w.pending))});
    add_properties(h, w, actuator);
    return h.network;
}

Network awkward_names() {
    Hand h;
    h.network.name = "awkward";
    const Variable x = h.boolean("X", Role::Input), kept = h.boolean("X_", Role::Input),
                   hurry = h.boolean("hurry", Role::Output);
    const Variable waiting = h.boolean("W", Role::Step, true), stable = h.boolean("sat", Role::Flag);
    Template first{.name = "free"};
    const Parameter out = first.parameters.add({"true", Kind::Written, {}});
    first.initial = first.locations.add({"2", {}, {}});
    first.locations.add({"init", {}, {}});
    add_edge(first, {.from = 0, .to = 1, .guard = h.yes(), .assignments = {{h.p(out), h.v(hurry)}}});
    Template second{.name = "process"};
    second.procedures.add({"abs", {{h.v(hurry), h.any({h.v(waiting), h.v(x), h.v(kept)})}}});
    second.initial = second.locations.add({"W", {}, {}});
    second.locations.add({"hurry", {}, {}});
    add_edge(second, {.from = 0, .to = 1, .urgent = true, .guard = h.v(waiting), .calls = {{0}}});
    const auto a = h.network.templates.add(std::move(first));
    const auto b = h.network.templates.add(std::move(second));
    h.process("free", a, {x}, Network::ProcessKind::Environment);
    h.process("Pr", a, {kept}, Network::ProcessKind::Environment);
    const auto plc = h.process("sqrt", b, {}, Network::ProcessKind::Controller);
    h.network.controllers.add({{.name = "sqrt", .mode = ExecutionMode::EveryCycle}, plc, {0}, stable});
    h.network.settled = h.v(stable);
    h.property("under", "names", Pattern::Always,
               {h.any({h.at(plc, 0), h.at(plc, 1), h.v(x), h.v(kept), h.at({0}, 0), h.at({1}, 1)})});
    return h.network;
}

Network crowded() {
    Hand h;
    h.network.name = "crowded";
    std::vector<Variable> variables;
    for (int i = 0; i < 12; ++i) variables.push_back(h.boolean("a_rather_long_name_" + std::to_string(i), Role::Plant));
    const auto v = [&](std::size_t i) { return h.v(variables[i % variables.size()]); };
    Template loops{.name = "loops"};
    loops.initial = loops.locations.add({"the_only_one", {}, {}});
    for (std::size_t i = 0; i < 9; ++i)
        add_edge(loops, {.from = 0,
                         .to = 0,
                         .guard = h.all({v(i), h.neither(v(i + 1))}),
                         .assignments = {{v(i), h.no()}, {v(i + 1), h.yes()}}});
    Template complete{.name = "complete"};
    for (std::uint32_t i = 0; i < 5; ++i) complete.locations.add({"location_" + std::to_string(i), {}, {}});
    complete.initial = {0};
    for (std::uint32_t i = 0; i < 5; ++i)
        for (std::uint32_t j = 0; j < 5; ++j)
            add_edge(complete, {.from = i,
                                .to = j,
                                .urgent = i < j,
                                .guard = h.all({v(i), v(j + 5), h.neither(v(j + 6))}),
                                .assignments = {{v(j), v(i + 3)}}});
    Template guarded{.name = "guarded"};
    guarded.initial = guarded.locations.add({"here", {}, {}});
    std::vector<Id<Expr>> terms;
    for (std::size_t i = 0; i < 12; ++i) terms.push_back(h.any({v(i), h.neither(v(i + 5))}));
    add_edge(guarded, {.from = 0, .to = 0, .guard = h.network.exprs.conjunction(terms), .assignments = {{v(0), v(1)}}});
    for (Template* automaton : {&loops, &complete, &guarded}) {
        const std::string name = "the_" + automaton->name;
        h.process(name, h.network.templates.add(std::move(*automaton)), {}, Network::ProcessKind::Plant);
    }
    return h.network;
}

}  // namespace grafverif::test
