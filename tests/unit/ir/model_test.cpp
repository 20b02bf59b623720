// SPDX-License-Identifier: MIT
// Tests that verify detects malformed charts, components and closed loops.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "read/text.hpp"

namespace grafverif {
namespace {

Model sound() {
    Sources sources;
    Diagnostics diagnostics;
    const Id<Source> source = sources.add(
        {"sound.grafcet",
         "grafcet lamp {\n    input BUTTON;\n    output LAMP;\n    internal N: int 0..3 = 0;\n    initial step 0;\n"
         "    step 1 { LAMP; N := N + 1 on activation; }\n    transition t0: 0 -> 1 when BUTTON;\n"
         "    transition t1: 1 -> 0 when 3s/X1;\n    partial G2 { initial step 2; }\n}\n"
         "component button(output OUT; GAP = 1s) {\n    clock t;\n    initial location idle invariant t <= GAP;\n"
         "    timed idle -> idle when t == GAP && !OUT do OUT := !OUT, t := 0;\n    urgent idle -> idle when OUT;\n}\n"
         "closed_loop room {\n    controller lamp;\n    environment Button = button(OUT = BUTTON);\n"
         "    property P: never LAMP && X0;\n}\n"});
    auto model = read_text(source, sources, {}, diagnostics);
    EXPECT_TRUE(model);
    return model ? *model : Model{};
}

struct Damage {
    const char* what;
    std::function<void(Model&)> done;
};

TEST(Verify, AcceptsASoundModel) { EXPECT_EQ(verify(sound()), std::vector<std::string>{}); }

TEST(Verify, FindsEachDamage) {
    const std::vector<Damage> damages = {
        {"two variables of one name", [](Model& m) { m.charts[{0}].variables[{0}].name = "LAMP"; }},
        {"a value at power-on out of range", [](Model& m) { m.charts[{0}].variables[{2}].initial = 7; }},
        {"an empty range", [](Model& m) { m.charts[{0}].variables[{2}].type.low = 9; }},
        {"two steps of one name", [](Model& m) { m.charts[{0}].steps[{1}].name = "0"; }},
        {"two transitions of one name", [](Model& m) { m.charts[{0}].transitions[{1}].name = "t0"; }},
        {"a transition to nowhere", [](Model& m) { m.charts[{0}].transitions[{0}].to = {Id<Chart::Step>{9}}; }},
        {"a transition between partial charts",
         [](Model& m) { m.charts[{0}].transitions[{0}].to = {Id<Chart::Step>{2}}; }},
        {"a condition that is an integer",
         [](Model& m) { m.charts[{0}].transitions[{0}].condition = m.charts[{0}].exprs.integer(1); }},
        {"a condition that compares a Boolean as a number, deep inside",
         [](Model& m) {
             Exprs& exprs = m.charts[{0}].exprs;
             const auto nested = exprs.apply(Op::Less, exprs.leaf(Op::Variable, 0), exprs.integer(1));
             m.charts[{0}].transitions[{0}].condition = exprs.negation(nested);
         }},
        {"a stored value that adds a step to a number",
         [](Model& m) {
             Exprs& exprs = m.charts[{0}].exprs;
             m.charts[{0}].stored[{0}].value = exprs.apply(Op::Plus, exprs.leaf(Op::Step, 0), exprs.integer(1));
         }},
        {"a guard that counts a Boolean",
         [](Model& m) {
             Exprs& exprs = m.components[{0}].exprs;
             const auto sum = exprs.apply(Op::Plus, exprs.leaf(Op::Parameter, 0), exprs.integer(1));
             m.components[{0}].edges[{0}].guard = exprs.apply(Op::Equal, sum, exprs.integer(1));
         }},
        {"a bound that multiplies two durations",
         [](Model& m) {
             Exprs& exprs = m.components[{0}].exprs;
             m.components[{0}].edges[{0}].constraint[0].bound =
                 exprs.apply(Op::Times, exprs.duration(2), exprs.leaf(Op::Parameter, 1));
         }},
        {"a condition that is missing", [](Model& m) { m.charts[{0}].transitions[{0}].condition = {}; }},
        {"a leaf in no table", [](Model& m) { m.charts[{0}].exprs.leaf(Op::Step, 99); }},
        {"an action on an integer", [](Model& m) { m.charts[{0}].continuous[{0}].output = {2}; }},
        {"a stored value of another type", [](Model& m) { m.charts[{0}].stored[{0}].target = {1}; }},
        {"an expansion without entry",
         [](Model& m) { m.charts[{0}].partial_charts[{1}].kind = Chart::PartialKind::Expansion; }},
        {"a time condition of no time", [](Model& m) { m.charts[{0}].time_conditions[{0}].rise_ms = 0; }},
        {"an urgent edge with a clock", [](Model& m) { m.components[{0}].edges[{0}].urgent = true; }},
        {"an invariant from below",
         [](Model& m) { m.components[{0}].locations[{0}].invariant[0].relation = Op::GreaterEqual; }},
        {"a bound that is no duration",
         [](Model& m) { m.components[{0}].edges[{0}].constraint[0].bound = m.components[{0}].exprs.integer(3); }},
        {"an assigned constant",
         [](Model& m) {
             m.components[{0}].edges[{0}].assignments[0].target = m.components[{0}].exprs.leaf(Op::Parameter, 1);
         }},
        {"an edge to nowhere", [](Model& m) { m.components[{0}].edges[{0}].to = {7}; }},
        {"a controller without chart", [](Model& m) { m.loops[{0}].controllers[{0}].chart = {}; }},
        {"an input that nothing drives", [](Model& m) { m.loops[{0}].instances = {}; }},
        {"a second writer", [](Model& m) { m.loops[{0}].instances.add(m.loops[{0}].instances[{0}]); }},
        {"an argument of another kind", [](Model& m) { m.loops[{0}].instances[{0}].arguments[0] = std::int64_t{1}; }},
        {"an argument too few", [](Model& m) { m.loops[{0}].instances[{0}].arguments.pop_back(); }},
        {"a shared variable of another type", [](Model& m) { m.loops[{0}].shared[{0}].type = integer_type(0, 3); }},
        {"a symbol of nothing",
         [](Model& m) {
             m.loops[{0}].symbols.add(ClosedLoop::StepSymbol{{0}, {42}});
         }},
    };
    for (const Damage& damage : damages) {
        SCOPED_TRACE(damage.what);
        Model model = sound();
        damage.done(model);
        EXPECT_NE(verify(model), std::vector<std::string>{});
    }
}

TEST(StepVariable, NamesThePartialChart) {
    const Model model = sound();
    EXPECT_EQ(step_variable(model.charts[{0}], {1}), "X1");
    EXPECT_EQ(step_variable(model.charts[{0}], {2}), "G2.X2");
}

}  // namespace
}  // namespace grafverif
