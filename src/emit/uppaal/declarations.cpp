// SPDX-License-Identifier: MIT
// Writes the three programs of a UPPAAL project: global declarations with the header of the model, the declarations of
// a template, and the system definition.
#include <algorithm>
#include <array>
#include <ostream>

#include "emit/uppaal/text.hpp"
#include "emit/uppaal/uppaal.hpp"
#include "ir/task_cycles.hpp"
#include "support/overloaded.hpp"
#include "syntax/print/constants.hpp"

namespace grafverif::uppaal {
namespace {

using Kind = Network::ParameterKind;
using Role = Network::Role;

constexpr std::array roles = {Role::Input,   Role::Output, Role::Internal, Role::Step,         Role::FiringCondition,
                              Role::Sample,  Role::Image,  Role::TimerEnd, Role::TimerPending, Role::Previous,
                              Role::Watched, Role::Flag,   Role::Plant};

std::string_view title(Role role) {
    switch (role) {
    case Role::Input: return "inputs of the controller";
    case Role::Output: return "outputs of the controller";
    case Role::Internal: return "internal variables";
    case Role::Step: return "step activities";
    case Role::FiringCondition: return "firing conditions";
    case Role::Sample: return "inputs as sampled in this cycle";
    case Role::Image: return "outputs not yet written";
    case Role::TimerEnd: return "outputs of timers";
    case Role::TimerPending: return "timers to start or stop";
    case Role::Previous: return "previous values, for edges";
    case Role::Watched: return "levels that timers observe";
    case Role::Flag: return "flags between controller, timers and plant";
    case Role::Plant: return "variables of the plant";
    }
    unreachable();
}

std::string_view title(Network::ProcessKind kind) {
    switch (kind) {
    case Network::ProcessKind::Plant: return "plant";
    case Network::ProcessKind::Environment: return "environment";
    case Network::ProcessKind::Controller: return "controller";
    case Network::ProcessKind::Timer: return "timers";
    case Network::ProcessKind::Observer: return "observers of properties";
    }
    unreachable();
}

std::string_view grain_text(Grain grain) {
    switch (grain) {
    case Grain::Phased: return "phased (the plant and the timers may move between the phases of a PLC cycle)";
    case Grain::Atomic: return "atomic (a PLC cycle is one edge: the plant does not move during the cycle)";
    }
    unreachable();
}

std::string_view mode_text(ExecutionMode mode) {
    switch (mode) {
    case ExecutionMode::StabilitySearch: return "with stability search (outputs are written in stable situations)";
    case ExecutionMode::EveryCycle: return "without stability search (outputs are written in every cycle)";
    }
    unreachable();
}

/// Returns `bool` or `int[lo,hi]`.
std::string type_text(const Type& type) {
    if (type.boolean) return "bool";
    return "int[" + std::to_string(type.low) + ',' + std::to_string(type.high) + ']';
}

std::string constant_type_text(const Type& type) {
    if (type == integer_type(least_integer, greatest_integer)) return "const int";
    return "const " + type_text(type);
}

std::string value_text(const Type& type, std::int64_t value) {
    if (type.boolean) return value != 0 ? "true" : "false";
    return std::to_string(value);
}

void write_header(std::ostream& out, const Network& network, const Names& names) {
    out << "// " << network.name << ": the closed loop of a GRAFCET controller (IEC 60848) and its plant.\n";
    for (const Network::Controller& controller : network.controllers) {
        const Id<Network::Template> automaton = network.processes[controller.process].automaton;
        out << "// Controller " << controller.words.name << " " << mode_text(controller.words.mode)
            << ".\n//   process " << names.processes[controller.process.index] << ", between two cycles in "
            << names.locals[automaton.index].locations[controller.waiting.index]
            << "; stable situation: " << names.variables[controller.stable.index] << "\n";
    }
    out << "// Grain: " << grain_text(network.grain) << ".\n"
        << "// Time unit: " << duration_text(network.time_unit_ms) << ".\n"
        << (network.constants.empty() ? "" : "// Constants: " + constants_text(network.constants) + ".\n")
        << "// Assumed: a PLC cycle takes no time"
        << (has_task_cycle(network)
                ? ", and the scans of a PLC with a task cycle start periodically, controlled by a clock"
                : "")
        << "; no time passes while the guard of an edge with `" << names.channel << "!` holds.\n";
    if (std::ranges::find(network.properties, Pattern::NoTimelock, &Property::pattern) == network.properties.end())
        out << "// Not part of this project: `no timelock`, which UPPAAL cannot express; `grafverif check` decides "
               "it.\n";
    for (const auto& [property, reason] : inexpressible(network))
        out << "// Property " << network.properties[property].name << " is omitted: " << reason << ".\n";
    if (!names.changed.empty()) out << "// Names that are not valid in UPPAAL:\n";
    for (const auto& [name, legal] : names.changed) out << "//   " << name << " is renamed to " << legal << "\n";
}

/// Returns the meaning of a variable that exists only for observers of properties: the location of a process, or the
/// turn of the observers. The result is empty for all other variables.
std::string observation_text(const Network& network, const Names& names, Id<Network::Variable> id) {
    const Network::Variable& variable = network.variables[id];
    if (variable.role != Role::Flag || variable.type.boolean) return {};
    for (const Id<Network::Process> process : network.processes.ids()) {
        const auto& arguments = network.processes[process].arguments;
        if (std::ranges::find(arguments, Network::Argument(id)) == arguments.end()) continue;
        std::string text = "location of " + names.processes[process.index] + ":";
        const auto& locations = names.locals[network.processes[process].automaton.index].locations;
        for (std::size_t k = 0; k < locations.size(); ++k)
            text += (k == 0 ? " " : ", ") + std::to_string(k) + " " + locations[k];
        return text;
    }
    return "0: edges of the loop can be taken; k: observer k reads the state";
}

void write_variable(std::ostream& out, const Network& network, const Names& names, Id<Network::Variable> id) {
    const Network::Variable& variable = network.variables[id];
    if (variable.scratch) out << "meta ";
    out << type_text(variable.type) << ' ' << names.variables[id.index];
    if (variable.initial != 0) out << " = " << value_text(variable.type, variable.initial);
    out << ';';
    if (const std::string text = observation_text(network, names, id); !text.empty()) out << "  // " << text;
    out << '\n';
}

/// Returns the controller whose PLC cycle the template represents; null if there is no such controller.
const Network::Controller* controller_of(const Network& network, Id<Network::Template> automaton) {
    for (const Network::Controller& controller : network.controllers)
        if (network.processes[controller.process].automaton == automaton) return &controller;
    return nullptr;
}

/// Returns the heading of the section to which an assignment in a procedure of the controller belongs; empty if the
/// target belongs to no section.
std::string_view heading_of(const Network& network, const Network::Controller* controller,
                            Id<Network::Procedure> procedure, const Network::Assignment& assignment) {
    const Expr& target = network.exprs[assignment.target];
    if (target.op != Op::Variable) return {};
    const Id<Network::Variable> variable{static_cast<std::uint32_t>(target.value)};
    const Role role = network.variables[variable].role;
    const bool is_temporary = role == Role::FiringCondition || role == Role::Sample;
    if (controller != nullptr && variable == controller->stable) return "true if another cycle would change nothing";
    if (controller != nullptr && procedure == controller->evolve && is_temporary)
        return "reset: not read before the next cycle";
    return title(role);
}

std::string_view purpose(const Network::Controller& controller, Id<Network::Procedure> procedure) {
    if (procedure == controller.start) return "the first evolution, after power-on";
    if (procedure == controller.fire) return "samples the inputs and stores the firing conditions";
    if (procedure == controller.evolve) return "one evolution: the new situation and stored values";
    return procedure == controller.write ? "the outputs of the new situation" : "";
}

/// Returns a description of the phase of the PLC cycle in the target location of `edge`; empty if the phase needs no
/// description.
std::string_view phase_after(const Network::Controller& controller, const Network::Edge& edge) {
    if (edge.to == controller.waiting) return {};
    if (has_call(edge, controller.fire)) return "the inputs are sampled";
    if (has_call(edge, controller.evolve)) return "the evolution is made";
    return edge.calls.empty() && edge.from == controller.waiting ? "a cycle has begun" : "";
}

void write_procedure(std::ostream& out, const Network& network, const Names& names, Id<Network::Template> automaton,
                     Id<Network::Procedure> id) {
    const Network::Controller* const controller = controller_of(network, automaton);
    const Network::Procedure& procedure = network.templates[automaton].procedures[id];
    const Terms terms(network, names, automaton);
    out << '\n';
    if (controller != nullptr)
        if (const std::string_view text = purpose(*controller, id); !text.empty()) out << "// " << text << '\n';
    out << "void " << names.locals[automaton.index].procedures[id.index] << "() {\n";
    std::string_view section;
    for (const Network::Assignment& assignment : procedure.assignments) {
        const std::string_view heading = heading_of(network, controller, id, assignment);
        if (!heading.empty() && heading != section) out << "    // " << heading << '\n';
        section = heading;
        out << "    ";
        terms.write_statement(out, assignment);
        out << '\n';
    }
    out << "}\n";
}

/// Returns text such as `reads G_IN, G_OUT`, or an empty string if there are no parameters of this kind.
std::string parameters_of_kind(const Network::Template& automaton, const LocalNames& names, Kind kind,
                               std::string_view verb) {
    std::string text;
    for (const Id<Network::Parameter> id : automaton.parameters.ids()) {
        if (automaton.parameters[id].kind != kind) continue;
        text += text.empty() ? std::string(verb) + ' ' : ", ";
        text += names.parameters[id.index];
    }
    return text;
}

/// Returns the meaning of the locations of a cycle with several phases, such as `W: between two cycles`.
std::string phases_text(const Network& network, const LocalNames& names, const Network::Controller& controller) {
    const Network::Template& automaton = network.templates[network.processes[controller.process].automaton];
    std::string text = names.locations[controller.waiting.index] + ": between two cycles";
    for (const Network::Edge& edge : automaton.edges)
        if (const std::string_view phase = phase_after(controller, edge); !phase.empty())
            text += "; " + names.locations[edge.to.index] + ": " + std::string(phase);
    return text;
}

/// Returns the arguments of a process that are durations, such as `TRAVEL = 2s`. An argument is a duration if its
/// parameter is a bound of a clock.
std::string durations_text(const Network& network, const LocalNames& names, const Network::Process& process) {
    const Network::Template& automaton = network.templates[process.automaton];
    std::vector<bool> is_duration(automaton.parameters.size());
    const auto note = [&](const std::vector<Network::ClockConstraint>& constraints) {
        for (const Network::ClockConstraint& constraint : constraints)
            if (const Expr& bound = network.exprs[constraint.bound]; bound.op == Op::Parameter)
                is_duration[static_cast<std::size_t>(bound.value)] = true;
    };
    for (const Network::Location& location : automaton.locations) note(location.invariant);
    for (const Network::Edge& edge : automaton.edges) note(edge.constraint);
    std::string text;
    for (const Id<Network::Parameter> id : automaton.parameters.ids())
        if (const auto* units = std::get_if<std::int64_t>(&process.arguments[id.index]); units && is_duration[id.index])
            text += (text.empty() ? "" : ", ") + names.parameters[id.index] + " = " +
                    duration_text(*units * network.time_unit_ms);
    return text;
}

std::string argument_text(const Names& names, const Type& type, const Network::Argument& argument) {
    return std::visit(overloaded{
                          [&](Id<Network::Variable> variable) { return names.variables[variable.index]; },
                          [&](std::int64_t value) { return value_text(type, value); },
                      },
                      argument);
}

/// Returns, for each process that is a timer, the name of its controller. The name is empty for all other processes. If
/// there is only one controller, all names are empty.
std::vector<std::string_view> timer_owners(const Network& network) {
    std::vector<std::string_view> owners(network.processes.size());
    if (network.controllers.size() < 2) return owners;
    for (const Network::Controller& controller : network.controllers)
        for (const Network::Timer& timer : controller.timers) owners[timer.process.index] = controller.words.name;
    return owners;
}

/// Prints `system A, B;` with lines of at most 100 columns.
void write_system_line(std::ostream& out, const std::vector<std::string>& processes) {
    std::string list = "system";
    for (std::size_t i = 0; i < processes.size(); ++i) list += (i == 0 ? " " : ", ") + processes[i];
    bool first = true;
    for (const std::string& line : lines_of(list + ';', 100)) {
        out << (first ? "" : "\n    ") << line;
        first = false;
    }
    out << '\n';
}

}  // namespace

void write_global_declarations(std::ostream& out, const Network& network, const Names& names) {
    write_header(out, network, names);
    out << "\n"
           "// urgent edges emit on this channel; no receiver is needed\n"
        << "urgent broadcast chan " << names.channel << ";\n";
    for (const Role role : roles) {
        bool any = false;
        for (const Id<Network::Variable> id : network.variables.ids()) {
            const Network::Variable& variable = network.variables[id];
            if (variable.role != role) continue;
            if (!any) out << "\n// " << title(role) << '\n';
            any = true;
            write_variable(out, network, names, id);
        }
    }
}

std::string parameter_list(const Network::Template& automaton, const LocalNames& names) {
    std::string list;
    for (const Id<Network::Parameter> id : automaton.parameters.ids()) {
        const auto& [name, kind, type] = automaton.parameters[id];
        if (!list.empty()) list += ", ";
        list += kind == Kind::Constant ? constant_type_text(type) + ' ' : type_text(type) + " &";
        list += names.parameters[id.index];
    }
    return list;
}

void write_template_declarations(std::ostream& out, const Network& network, const Names& names,
                                 Id<Network::Template> automaton, const std::vector<GuardFunction>& guards) {
    const Network::Template& entity = network.templates[automaton];
    const LocalNames& local = names.locals[automaton.index];
    std::string summary = parameters_of_kind(entity, local, Kind::Read, "reads");
    const std::string written = parameters_of_kind(entity, local, Kind::Written, "writes");
    if (!summary.empty() && !written.empty()) summary += "; ";
    summary += written;
    if (!summary.empty()) out << "// " << summary << '\n';
    const Network::Controller* const controller = controller_of(network, automaton);
    if (controller != nullptr && entity.locations.size() > 1)
        out << "// " << phases_text(network, local, *controller) << '\n';
    for (const std::string& clock : local.clocks) out << "clock " << clock << ";\n";
    for (const Id<Network::Procedure> id : entity.procedures.ids()) write_procedure(out, network, names, automaton, id);
    for (const auto& [name, body] : guards) {
        out << "\nbool " << name << "() {\n";
        std::string_view lead = "    return ";
        for (const std::string& line : lines_of(body + ';', 100)) {
            out << lead << line << '\n';
            lead = "           ";
        }
        out << "}\n";
    }
}

void write_system(std::ostream& out, const Network& network, const Names& names) {
    const std::vector<std::string_view> owners = timer_owners(network);
    std::string section;
    for (const Id<Network::Process> id : network.processes.ids()) {
        const Network::Process& process = network.processes[id];
        const Network::Template& automaton = network.templates[process.automaton];
        std::string heading(title(process.kind));
        if (!owners[id.index].empty()) ((heading += " of ") += owners[id.index]);
        if (heading != section) out << (section.empty() ? "" : "\n") << "// " << heading << '\n';
        section = std::move(heading);
        out << names.processes[id.index] << " = " << names.templates[process.automaton.index] << '(';
        for (const Id<Network::Parameter> parameter : automaton.parameters.ids()) {
            if (parameter.index != 0) out << ", ";
            out << argument_text(names, automaton.parameters[parameter].type, process.arguments[parameter.index]);
        }
        const std::string durations = durations_text(network, names.locals[process.automaton.index], process);
        out << ");" << (durations.empty() ? "" : "  // " + durations) << '\n';
    }
    out << '\n';
    write_system_line(out, names.processes);
}

}  // namespace grafverif::uppaal
