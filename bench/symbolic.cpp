// SPDX-License-Identifier: MIT
// Measures the symbolic engine.
//
// bench_symbolic stations N: N independent assembly stations (DESDES06) in one chart with free
// inputs. The printed time shows how the cost grows with the number of steps and inputs.
//
// bench_symbolic PATH|cylinders N|line N|two APPROACH [SCHEDULE] [discrete] [atomic]: a closed loop with all
// properties. The loop is samples/PATH, a loop with N cylinders, a transfer line of N cells, or two testing stations
// that share only time (with the properties of one station). APPROACH: none, constraints or automata. SCHEDULE:
// interleaved, synchronous or sequenced. `discrete` models time by counting clocks; `atomic` selects the grain atomic.
// If the last argument is `whole`, independent subsystems are explored together; if it is `nusmv`, the model is printed
// and not checked.
#include "check/symbolic/symbolic.hpp"

#include <fmt/core.h>

#include <cstdlib>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "check/decomposition/interleaved.hpp"
#include "compose/compose.hpp"
#include "derive/derive.hpp"
#include "emit/nusmv/nusmv.hpp"
#include "engine_loops.hpp"
#include "generate.hpp"
#include "read/text.hpp"
#include "schedule/controller.hpp"
#include "schedule/network.hpp"
#include "schedule/together.hpp"

namespace {

using namespace grafverif;

[[noreturn]] void give_up(const Diagnostics& diagnostics, const Sources& sources) {
    std::ostringstream text;
    render_text(diagnostics.all(), sources, Colour::Plain, text);
    throw std::invalid_argument(text.str());
}

/// Returns a system of `count` stations in one chart, with five properties of different types, mostly
/// about the steps of the last station.
TransitionSystem stations(std::size_t count) {
    Sources sources;
    Diagnostics diagnostics;
    const Id<Source> file = sources.add({"stations.grafcet", bench::assembly_stations(count)});
    const auto model = read_text(file, sources, {}, diagnostics);
    const auto equations = model ? derive(*model->charts.begin(), diagnostics) : std::nullopt;
    if (!equations) give_up(diagnostics, sources);
    TransitionSystem system = schedule_controller(*equations, ExecutionMode::EveryCycle);
    const TransitionSystem::Controller& controller = system.controllers.front();
    const auto step = [&](const std::string& name) {
        for (const auto& named : controller.words.steps)
            if (named.name.text() == name) return system.exprs.leaf(Op::Variable, named.variable.index);
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

TransitionSystem closed_loop(const bench::LoopParts& parts, const std::optional<Network>& composed,
                             const ScheduleOptions& options, std::optional<Grain> grain) {
    const ClosedLoop& loop = parts.model.loops[{0}];
    if (options.plant != PlantApproach::Automata)
        return schedule_controllers(parts.model, loop, parts.equations, options);
    Diagnostics diagnostics;
    const bool interleaved =
        options.schedule.value_or(loop.schedule.value_or(Schedule::Interleaved)) == Schedule::Interleaved;
    std::optional<TransitionSystem> made;
    if (!interleaved) made = schedule_together(parts.model, loop, parts.equations, parts.plant, options, diagnostics);
    else if (const auto network = composed ? composed
                                           : compose(parts.plant, loop, parts.equations,
                                                     {.grain = grain.value_or(loop.grain)}, diagnostics))
        made = schedule_network(parts.model, loop, parts.equations, *network, options, diagnostics);
    if (!made) give_up(diagnostics, {});
    return std::move(*made);
}

/// Returns the value of `word` in `table`.
template <class Value>
Value meant(const std::map<std::string, Value>& table, const std::string& word) {
    const auto found = table.find(word);
    if (found == table.end())
        throw std::invalid_argument(
            "usage: bench_symbolic stations N | PATH|cylinders N|line N|two APPROACH [SCHEDULE] [discrete] "
            "[atomic] [whole|nusmv]");
    return found->second;
}

TransitionSystem system_of(const std::vector<std::string>& words) {
    if (words.size() == 2 && words[0] == "stations")
        return stations(static_cast<std::size_t>(std::atoi(words[1].c_str())));
    using enum PlantApproach;
    using enum Schedule;
    const bool grows = words.size() > 1 && (words[0] == "cylinders" || words[0] == "line"),
               two = words.size() > 1 && words[0] == "two";
    ScheduleOptions options;
    std::optional<Grain> grain;
    for (std::size_t i = grows ? 2 : 1; i < words.size(); ++i)
        if (words[i] == "discrete") options.time = TimeModel::Discrete;
        else if (words[i] == "atomic") grain = Grain::Atomic;
        else if (words[i] == "none" || words[i] == "constraints" || words[i] == "automata")
            options.plant =
                meant<PlantApproach>({{"none", None}, {"constraints", Constraints}, {"automata", Automata}}, words[i]);
        else
            options.schedule = meant<Schedule>(
                {{"interleaved", Interleaved}, {"synchronous", Synchronous}, {"sequenced", Sequenced}}, words[i]);
    if (words.empty()) meant<Grain>({}, "");
    bench::LoopParts parts =
        bench::parts(grows ? (words[0] == "line" ? bench::transfer_line : bench::cylinders)(std::atoi(words[1].c_str()))
                           : bench::sample(two ? "testing_station/testing_station.grafcet" : words[0]));
    if (!two) return closed_loop(parts, {}, options, grain);
    parts.equations.push_back(parts.equations.front());
    return closed_loop(parts, bench::two_stations(grain.value_or(Grain::Phased)), options, grain);
}

void measure(const TransitionSystem& system, bool whole) {
    const auto progress = [](const SymbolicProgress& now) {
        fmt::print(stderr, "\r{} steps deep, {} MiB, {:.1f} s ", now.depth, now.bytes >> 20U, now.seconds);
    };
    SymbolicOptions options;
    options.witnesses = false;  // the command `check` also omits witnesses by default
    if (std::getenv("ENGINE_PROGRESS") != nullptr) options.progress = progress;
    const SymbolicResult result = whole ? check_symbolic(system, options) : check_symbolic_by_parts(system, options);
    fmt::print("{} steps, {} inputs: {} states, {} steps deep, {} MiB, {:.2f} s\n",
               system.controllers.front().words.steps.size(), system.controllers.front().words.inputs.size(),
               result.states, result.depth, result.bytes >> 20U, result.seconds);
    for (const Verdict& verdict : result.verdicts)
        fmt::print("  {}: {} {}\n", verdict.property, word(verdict.outcome), verdict.reason);
}

}  // namespace

int main(int count, char** values) {
    try {
        std::vector<std::string> words{values + 1, values + count};
        const bool write = !words.empty() && words.back() == "nusmv";
        const bool whole = !words.empty() && words.back() == "whole";
        if (write || whole) words.pop_back();
        const TransitionSystem system = system_of(words);
        if (write) nusmv::emit(system, std::cout);
        else measure(system, whole);
    } catch (const std::invalid_argument& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 2;
    }
}
