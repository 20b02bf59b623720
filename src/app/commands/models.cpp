// SPDX-License-Identifier: MIT
// `uppaal`, `pins`, `nusmv`, `aiger` and `btor2`: write one model to a file or to standard output.
#include "pipeline/models.hpp"

#include <utility>

#include "app/commands.hpp"
#include "app/outputs.hpp"
#include "pipeline/check.hpp"

namespace grafverif::app {

namespace {

/// Returns the timed model of the selected loop.
std::optional<Network> timed_model(CommandContext& job) {
    auto model = read_model(job.options.operands[0], job);
    const auto loop = model ? chosen_loop(*model, job) : std::nullopt;
    return loop && keep_requested(model->loops[*loop], job) ? network_of(*model, *loop, job) : std::nullopt;
}

}  // namespace

ExitCode uppaal(CommandContext& job, const Streams& streams) {
    const auto network = timed_model(job);
    if (!network) return ExitCode::Input;
    const UppaalProject project = uppaal_project(*network, job.diagnostics);
    if (!job.diagnostics.has_errors()) deliver(project.project, job, streams);
    return ExitCode::Done;
}

ExitCode pins(CommandContext& job, const Streams& streams) {
    const auto network = timed_model(job);
    if (!network) return ExitCode::Input;
    const std::string text = pins_model(*network);
    if (!job.diagnostics.has_errors()) deliver(text, job, streams);
    return ExitCode::Done;
}

namespace {

/// Returns the untimed model of the selected loop or chart.
std::optional<TransitionSystem> untimed_model(CommandContext& job) {
    auto model = read_model(job.options.operands[0], job);
    if (!model) return {};
    if (is_of_a_chart(*model, job.options)) {
        const auto chart = chosen_chart(*model, job);
        ClosedLoop none;  // a chart without a loop has no properties
        if (!chart || !keep_requested(none, job)) return {};
        return grafverif::transition_system_of(*model, *chart, model_options(job.options), job.diagnostics);
    }
    const auto loop = chosen_loop(*model, job);
    return loop && keep_requested(model->loops[*loop], job) ? transition_system_of(*model, *loop, job) : std::nullopt;
}

/// Returns the untimed model for AIGER or BTOR2. The model contains a query for each step if `--chart` is given, or if
/// the model has neither properties nor omitted properties.
std::optional<TransitionSystem> queried_model(CommandContext& job) {
    auto system = untimed_model(job);
    if (system && (job.options.chart || (system->properties.empty() && system->omitted.empty()))) query_steps(*system);
    return system;
}

}  // namespace

ExitCode nusmv(CommandContext& job, const Streams& streams) {
    const auto system = untimed_model(job);
    if (!system) return ExitCode::Input;
    const std::string text = nusmv_model(*system, job.diagnostics);
    if (!job.diagnostics.has_errors()) deliver(text, job, streams);
    return ExitCode::Done;
}

ExitCode aiger(CommandContext& job, const Streams& streams) {
    const auto system = queried_model(job);
    if (!system) return ExitCode::Input;
    const std::string output = job.options.output.value_or("-");
    const bool binary = job.options.binary.value_or(output.ends_with(".aig"));
    AigerModel model = aiger_model(*system, binary ? aiger::Form::Binary : aiger::Form::Ascii, job.diagnostics);
    if (job.diagnostics.has_errors()) return ExitCode::Done;
    std::vector<OutputFile> files = {{output, std::move(model.text)}};
    if (output != "-") files.push_back({output + ".json", std::move(model.map)});
    return write_outputs(files, job, streams) ? ExitCode::Done : ExitCode::Input;
}

ExitCode btor2(CommandContext& job, const Streams& streams) {
    const auto system = queried_model(job);
    if (!system) return ExitCode::Input;
    const std::string text = btor2_model(*system, job.diagnostics);
    if (!job.diagnostics.has_errors()) deliver(text, job, streams);
    return ExitCode::Done;
}

CliCommand uppaal_usage() {
    return {
        "uppaal",
        "FILE",
        1,
        1,
        "write the UPPAAL project of a closed loop",
        "Writes the UPPAAL project of the timed closed loop of FILE: one template per component, the PLC cycle with\n"
        "its timers, and the properties as queries.",
        {"grafverif uppaal samples/oven_door/oven_door.grafcet -o oven_door.xml",
         "grafverif uppaal station.grafcet --mode every-cycle --grain atomic"},
        {OptionGroup::Output, OptionGroup::Loop, OptionGroup::Constants, OptionGroup::Questions, OptionGroup::Mode,
         OptionGroup::Grain, OptionGroup::Cycle}};
}

CliCommand pins_usage() {
    return {
        "pins",
        "FILE",
        1,
        1,
        "write the timed closed loop as a C file for LTSmin",
        "Writes the timed closed loop of FILE, in integer time, as a C file with the partitioned next-state\n"
        "interface (PINS) of LTSmin. LTSmin has multi-core, symbolic and distributed engines for very large state\n"
        "spaces. The model has the states that `check` explores. Each state property has a label with value 1 in\n"
        "states that violate the property (for `reachable`: that satisfy it). Comments in the file describe how to\n"
        "compile it and how to run LTSmin.",
        {"grafverif pins samples/oven_door/oven_door.grafcet -o oven_door.c",
         "grafverif pins station.grafcet --grain atomic"},
        {OptionGroup::Output, OptionGroup::Loop, OptionGroup::Constants, OptionGroup::Questions, OptionGroup::Mode,
         OptionGroup::Grain, OptionGroup::Cycle}};
}

CliCommand nusmv_usage() {
    return {
        "nusmv",
        "FILE",
        1,
        1,
        "write the NuSMV model of a controller, alone or with its plant",
        "Writes the NuSMV model of the controller of a closed loop in FILE, or of a single chart. One step of the "
        "model\n"
        "is one PLC cycle, with free inputs and timers. With --plant automata, the model is the closed loop without\n"
        "time, or with bounded clock counters (--time discrete). The header of the model states the implication of a\n"
        "verdict for the real plant.",
        {"grafverif nusmv samples/tanks/tanks.grafcet -o tanks.smv",
         "grafverif nusmv samples/oven_door/oven_door.grafcet --plant automata --grain atomic",
         "grafverif nusmv station.grafcet --chart testing_station --mode every-cycle"},
        {OptionGroup::Output, OptionGroup::Loop, OptionGroup::Constants, OptionGroup::Questions, OptionGroup::Chart,
         OptionGroup::Mode, OptionGroup::Grain, OptionGroup::Cycle, OptionGroup::Untimed}};
}

CliCommand aiger_usage() {
    return {
        "aiger",
        "FILE",
        1,
        1,
        "write the untimed model as a circuit for hardware model checkers",
        "Writes the model of `nusmv` at bit level in the format AIGER 1.9, with one bad-state property per state\n"
        "property (for `reachable`: the state to reach) and one justice property per property of runs. `always\n"
        "possible` and formulas are omitted, with a warning. An additional file OUT.json maps the bits to the charts.\n"
        "The suffix .aig or `--format aig` selects the binary format.",
        {"grafverif aiger samples/tanks/tanks.grafcet -o tanks.aig",
         "grafverif aiger samples/oven_door/oven_door.grafcet --plant automata --grain atomic"},
        {OptionGroup::Output, OptionGroup::Loop, OptionGroup::Constants, OptionGroup::Questions, OptionGroup::Chart,
         OptionGroup::Mode, OptionGroup::Grain, OptionGroup::Cycle, OptionGroup::Untimed, OptionGroup::FormatAiger}};
}

CliCommand btor2_usage() {
    return {
        "btor2",
        "FILE",
        1,
        1,
        "write the untimed model at word level for hardware model checkers",
        "Writes the model of `nusmv` in the format BTOR2, with one state of the same name per variable and one\n"
        "bad-state property per state property (for `reachable`: the state to reach). Properties of runs are omitted,\n"
        "with a warning; `aiger` supports them.",
        {"grafverif btor2 samples/tanks/tanks.grafcet -o tanks.btor2",
         "grafverif btor2 samples/oven_door/oven_door.grafcet --plant automata --grain atomic"},
        {OptionGroup::Output, OptionGroup::Loop, OptionGroup::Constants, OptionGroup::Questions, OptionGroup::Chart,
         OptionGroup::Mode, OptionGroup::Grain, OptionGroup::Cycle, OptionGroup::Untimed}};
}

}  // namespace grafverif::app
