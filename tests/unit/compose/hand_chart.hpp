// SPDX-License-Identifier: MIT
// Builds charts in C++ for tests that vary the number of steps, and composes the loop of one controller.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "compose/compose.hpp"
#include "derive/derive.hpp"
#include "plant/plant.hpp"
#include "support/derived.hpp"
#include "support/random_loop.hpp"

namespace grafverif {

struct HandChart {
    Chart chart = {};
    Id<Chart::PartialChart> main = chart.partial_charts.add({});

    explicit HandChart(std::string name) { chart.name = std::move(name); }

    Id<Chart::Step> step(std::string name, bool initial = false) {
        return chart.steps.add({.name = std::move(name), .initial = initial, .chart = main});
    }
    Id<Chart::Variable> variable(std::string name, Chart::VariableKind kind, Type type = {}, std::int64_t initial = 0) {
        return chart.variables.add({std::move(name), kind, type, initial, {}});
    }
    Id<Chart::Variable> input(std::string name) { return variable(std::move(name), Chart::VariableKind::Input); }
    Id<Chart::Variable> output(std::string name) { return variable(std::move(name), Chart::VariableKind::Output); }
    Id<Expr> leaf(Id<Chart::Variable> variable) { return chart.exprs.leaf(Op::Variable, variable.index); }
    Id<Expr> always() { return chart.exprs.constant(true); }
    Id<Expr> never() { return chart.exprs.constant(false); }
    Id<Expr> after(std::int64_t milliseconds, Id<Chart::Step> step) {
        const Id<Expr> watched = chart.exprs.leaf(Op::Step, step.index);
        return chart.exprs.leaf(Op::Timed, chart.time_conditions.add({milliseconds, watched, 0, {}}).index);
    }
    void transition(Id<Chart::Step> from, Id<Chart::Step> to, Id<Expr> when) {
        const std::string name = "t" + std::to_string(chart.transitions.size());
        chart.transitions.add({name, {from}, {to}, when, main, {}});
    }
    void while_active(Id<Chart::Step> step, Id<Chart::Variable> output) {
        chart.continuous.add({step, output, always(), 0, 0, {}});
    }
    void while_active(Id<Chart::Step> step, Id<Chart::Variable> output, Id<Expr> condition) {
        chart.continuous.add({step, output, condition, 0, 0, {}});
    }
    void on_activation(Id<Chart::Step> step, Id<Chart::Variable> target, Id<Expr> value) {
        chart.stored.add({Chart::StoredOn::Activation, step, {}, target, value, {}, {}});
    }
};

/// Returns the network of the first loop of `model`.
inline Network composed(const Model& model, const ComposeOptions& options = {}) {
    Diagnostics diagnostics;
    const ClosedLoop& loop = model.loops[{0}];
    const std::vector<Equations> equations = derived(model, diagnostics).value();
    const Network alone = plant(model, loop, diagnostics).value();
    Network network = compose(alone, loop, equations, options, diagnostics).value();
    EXPECT_EQ(verify(network), std::vector<std::string>{});
    return network;
}

inline const Network::Template& automaton(const Network& network, const std::string& process) {
    for (const Network::Process& candidate : network.processes)
        if (candidate.name == process) return network.templates[candidate.automaton];
    throw std::out_of_range("unknown process " + process);
}

}  // namespace grafverif
