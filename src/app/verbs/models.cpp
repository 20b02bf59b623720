// SPDX-License-Identifier: MIT
// `uppaal`, `pins`, `nusmv`, `aiger` and `btor2`: writes one model to a file or to standard output.
#include "pipeline/models.hpp"

#include <utility>

#include "app/outputs.hpp"
#include "app/verbs.hpp"
#include "pipeline/check.hpp"

namespace grafverif::app {

namespace {

/// The timed model of the selected loop.
std::optional<Network> timed_model(Job& job) {
    auto model = read_model(job.options.operands[0], job);
    const auto loop = model ? chosen_loop(*model, job) : std::nullopt;
    return loop && keep_asked(model->loops[*loop], job) ? network_of(*model, *loop, job) : std::nullopt;
}

}  // namespace

ExitCode uppaal(Job& job, const Streams& streams) {
    const auto network = timed_model(job);
    if (!network) return ExitCode::Input;
    const UppaalProject project = uppaal_project(*network, job.diagnostics);
    if (!job.diagnostics.has_errors()) deliver(project.project, job, streams);
    return ExitCode::Done;
}

ExitCode pins(Job& job, const Streams& streams) {
    const auto network = timed_model(job);
    if (!network) return ExitCode::Input;
    const std::string text = pins_model(*network);
    if (!job.diagnostics.has_errors()) deliver(text, job, streams);
    return ExitCode::Done;
}

namespace {

/// The untimed model of the selected loop or chart.
std::optional<TransitionSystem> untimed_model(Job& job) {
    auto model = read_model(job.options.operands[0], job);
    if (!model) return {};
    if (is_of_a_chart(*model, job.options)) {
        const auto chart = chosen_chart(*model, job);
        ClosedLoop none;  // a chart alone has no properties
        if (!chart || !keep_asked(none, job)) return {};
        return grafverif::transition_system_of(*model, *chart, model_options(job.options), job.diagnostics);
    }
    const auto loop = chosen_loop(*model, job);
    return loop && keep_asked(model->loops[*loop], job) ? transition_system_of(*model, *loop, job) : std::nullopt;
}

}  // namespace

ExitCode nusmv(Job& job, const Streams& streams) {
    const auto system = untimed_model(job);
    if (!system) return ExitCode::Input;
    const std::string text = nusmv_model(*system, job.diagnostics);
    if (!job.diagnostics.has_errors()) deliver(text, job, streams);
    return ExitCode::Done;
}

ExitCode aiger(Job& job, const Streams& streams) {
    auto system = untimed_model(job);
    if (!system) return ExitCode::Input;
    if (job.options.chart || system->properties.empty()) ask_for_steps(*system);
    const std::string output = job.options.output.value_or("-");
    const bool binary = job.options.binary.value_or(output.ends_with(".aig"));
    AigerModel model = aiger_model(*system, binary ? aiger::Form::Binary : aiger::Form::Ascii, job.diagnostics);
    if (job.diagnostics.has_errors()) return ExitCode::Done;
    std::vector<OutputFile> files = {{output, std::move(model.text)}};
    if (output != "-") files.push_back({output + ".json", std::move(model.map)});
    return write_outputs(files, job, streams) ? ExitCode::Done : ExitCode::Input;
}

ExitCode btor2(Job& job, const Streams& streams) {
    auto system = untimed_model(job);
    if (!system) return ExitCode::Input;
    if (job.options.chart || system->properties.empty()) ask_for_steps(*system);
    const std::string text = btor2_model(*system, job.diagnostics);
    if (!job.diagnostics.has_errors()) deliver(text, job, streams);
    return ExitCode::Done;
}

Verb uppaal_usage() {
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
        {Accepts::Output, Accepts::Loop, Accepts::Constants, Accepts::Questions, Accepts::Mode, Accepts::Grain}};
}

Verb pins_usage() {
    return {
        "pins",
        "FILE",
        1,
        1,
        "write the timed closed loop as a C file, for LTSmin",
        "Writes the timed closed loop of FILE, in integer time, with the partitioned next-state interface (PINS) of\n"
        "LTSmin, whose multi-core, symbolic and distributed engines take what fits into no single memory. It has the\n"
        "states that `check` looks at; a label per property about states is 1 where it is violated (of `reachable`:\n"
        "shown). How to build and search it stands in the file.",
        {"grafverif pins samples/oven_door/oven_door.grafcet -o oven_door.c",
         "grafverif pins station.grafcet --grain atomic"},
        {Accepts::Output, Accepts::Loop, Accepts::Constants, Accepts::Questions, Accepts::Mode, Accepts::Grain}};
}

Verb nusmv_usage() {
    return {
        "nusmv",
        "FILE",
        1,
        1,
        "write the NuSMV model of a controller, alone or with its plant",
        "Writes the NuSMV model of the controller of FILE's closed loop, or of a chart alone: one step of the model is "
        "one\n"
        "PLC cycle; inputs and timer ends are free. With --plant automata, the model of the closed loop without time,\n"
        "or with clocks that count (--time discrete). What a verdict says of the real plant stands in the model's\n"
        "header.",
        {"grafverif nusmv samples/tanks/tanks.grafcet -o tanks.smv",
         "grafverif nusmv samples/oven_door/oven_door.grafcet --plant automata --grain atomic",
         "grafverif nusmv station.grafcet --chart testing_station --mode every-cycle"},
        {Accepts::Output, Accepts::Loop, Accepts::Constants, Accepts::Questions, Accepts::Chart, Accepts::Mode,
         Accepts::Grain, Accepts::Untimed}};
}

Verb aiger_usage() {
    return {
        "aiger",
        "FILE",
        1,
        1,
        "write the untimed model as a circuit, for hardware model checkers",
        "Writes the model that `nusmv` writes bit by bit, in the format AIGER 1.9: a bad state per property about "
        "states\n"
        "(of `reachable`: the state that shows it), a justice list per property about runs. `always possible` and\n"
        "formulas are left out, with a warning. Beside the file OUT stands OUT.json, which tells what its bits are to\n"
        "the charts. A name that ends in .aig asks for the binary form, as `--format aig` does.",
        {"grafverif aiger samples/tanks/tanks.grafcet -o tanks.aig",
         "grafverif aiger samples/oven_door/oven_door.grafcet --plant automata --grain atomic"},
        {Accepts::Output, Accepts::Loop, Accepts::Constants, Accepts::Questions, Accepts::Chart, Accepts::Mode,
         Accepts::Grain, Accepts::Untimed, Accepts::FormatAiger}};
}

Verb btor2_usage() {
    return {
        "btor2",
        "FILE",
        1,
        1,
        "write the untimed model in words of bits, for model checkers of hardware",
        "Writes the model that `nusmv` writes in the format BTOR2: a state per variable, named as there, and a bad "
        "state\n"
        "per property about states (of `reachable`: the state that shows it). What is about runs is left out, with a\n"
        "warning; `aiger` says it.",
        {"grafverif btor2 samples/tanks/tanks.grafcet -o tanks.btor2",
         "grafverif btor2 samples/oven_door/oven_door.grafcet --plant automata --grain atomic"},
        {Accepts::Output, Accepts::Loop, Accepts::Constants, Accepts::Questions, Accepts::Chart, Accepts::Mode,
         Accepts::Grain, Accepts::Untimed}};
}

}  // namespace grafverif::app
