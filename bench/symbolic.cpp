// SPDX-License-Identifier: MIT
// bench_symbolic stations N: N assembly stations (DESDES06) side by side in one chart, with free inputs, checked by the
// symbolic engine: the growth with the number of steps and inputs.
#include <cstdlib>
#include <sstream>
#include <string>

#include <fmt/core.h>

#include "generate.hpp"
#include "grafverif/check/symbolic.hpp"
#include "grafverif/derive/derive.hpp"
#include "grafverif/read/text.hpp"
#include "grafverif/schedule/controller.hpp"

namespace {

using namespace grafverif;

/// The chart with a property of every kind on its last steps.
TransitionSystem stations(std::size_t count) {
    Sources sources;
    Diagnostics diagnostics;
    const Id<Source> file = sources.add({"stations.grafcet", bench::assembly_stations(count)});
    const auto model = read_text(file, sources, {}, diagnostics);
    const auto equations = model ? derive(*model->charts.begin(), diagnostics) : std::nullopt;
    if (!equations) {
        std::ostringstream text;
        render_text(diagnostics.all(), sources, Colour::Plain, text);
        fmt::print(stderr, "{}", text.str());
        std::exit(2);
    }
    TransitionSystem system = schedule_controller(*equations, ExecutionMode::EveryCycle);
    const TransitionSystem::Controller& controller = system.controllers.front();
    const auto step = [&](const std::string& name) {
        for (const TransitionSystem::Named& named : controller.steps)
            if (named.name == name) return system.exprs.leaf(Op::Variable, named.symbol.index);
        std::exit(2);
    };
    const std::string last = std::to_string(count);
    const auto ask = [&](const char* name, Pattern pattern, std::vector<Id<Expr>> operands) {
        system.properties.add({.name = name, .pattern = pattern, .operands = std::move(operands)});
    };
    ask("never", Pattern::Never, {system.exprs.conjunction(step("A" + last + "_5"), step("A" + last + "_13"))});
    ask("reachable", Pattern::Reachable, {system.exprs.conjunction(step("A1_14"), step("A" + last + "_14"))});
    ask("always_possible", Pattern::AlwaysPossible, {step("A" + last + "_14")});
    ask("leads_to", Pattern::LeadsTo, {step("A" + last + "_8"), step("A" + last + "_9")});
    ask("inevitable", Pattern::Inevitable, {step("A" + last + "_14")});
    return system;
}

}  // namespace

int main(int count, char** values) {
    if (count != 3 || std::string(values[1]) != "stations") {
        fmt::print(stderr, "usage: bench_symbolic stations N\n");
        return 2;
    }
    const auto progress = [](const SymbolicProgress& now) {
        fmt::print(stderr, "\r{} steps deep, {} MiB, {:.1f} s ", now.depth, now.bytes >> 20U, now.seconds);
    };
    const TransitionSystem system = stations(static_cast<std::size_t>(std::atoi(values[2])));
    const SymbolicResult result = check_symbolic(
        system, {.progress = std::getenv("ENGINE_PROGRESS") != nullptr ? progress : std::function<void(const SymbolicProgress&)>{}});
    fmt::print("{} steps, {} inputs: {} states, {} steps deep, {} MiB, {:.2f} s\n", system.controllers.front().steps.size(),
               system.controllers.front().inputs.size(), result.states, result.depth, result.bytes >> 20U, result.seconds);
    for (const Verdict& verdict : result.verdicts)
        fmt::print("  {}: {} {}\n", verdict.property, word(verdict.outcome), verdict.reason);
}
