// SPDX-License-Identifier: MIT
// `uppaal` and `nusmv`: one model, to a file or to standard output.
#include "app/verbs.hpp"

namespace grafverif::app {

ExitCode uppaal(Job& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    const auto loop = model ? chosen_loop(*model, job) : std::nullopt;
    const auto network = loop ? network_of(*model, *loop, job) : std::nullopt;
    if (!network) return ExitCode::Input;
    const UppaalProject project = uppaal_project(*network, job.diagnostics);
    if (!job.diagnostics.has_errors()) deliver(project.project, job, streams);
    return ExitCode::Done;
}

ExitCode nusmv(Job& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    if (!model) return ExitCode::Input;
    std::optional<TransitionSystem> system;
    if (is_of_a_chart(*model, job.options)) {
        if (const auto chart = chosen_chart(*model, job))
            system = grafverif::transition_system_of(*model, *chart, model_options(job.options), job.diagnostics);
    } else if (const auto loop = chosen_loop(*model, job)) {
        system = transition_system_of(*model, *loop, job);
    }
    if (!system) return ExitCode::Input;
    const std::string text = nusmv_model(*system, job.diagnostics);
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
        {Accepts::Output, Accepts::Loop, Accepts::Mode, Accepts::Grain}};
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
        {Accepts::Output, Accepts::Loop, Accepts::Chart, Accepts::Mode, Accepts::Grain, Accepts::Untimed}};
}

}  // namespace grafverif::app
