// SPDX-License-Identifier: MIT
// Writes the three programs of a UPPAAL project: global declarations with the header of the model, the declarations of
// a template, and the system definition.
#include <algorithm>
#include <array>
#include <ostream>

#include "emit/uppaal/text.hpp"
#include "emit/uppaal/uppaal.hpp"
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
        << (std::ranges::any_of(network.controllers, [](const auto& each) { return each.words.cycle.has_value(); })
                ? ", and a clock begins the scans of a task cycle"
                : "")
        << "; no time passes while the guard of an edge with `" << names.channel << "!` holds.\n";
    for (const auto& [property, reason] : inexpressible(network))
        out << "// Property " << network.properties[property].name << " is omitted: " << reason << ".\n";
    if (!names.changed.empty()) out << "// Names that are not valid in UPPAAL:\n";
    for (const auto& [name, legal] : names.changed) out << "//   " << name << " is renamed to " << legal << "\n";
}

void write_variable(std::ostream& out, const Network::Variable& variable, const std::string& name) {
    if (variable.scratch) out << "meta ";
    out << type_text(variable.type) << ' ' << name;
    if (variable.initial != 0) out << " = " << value_text(variable.type, variable.initial);
    out << ";\n";
}

std::optional<Role> role_of(const Network& network, const Network::Assignment& assignment) {
    const Expr& target = network.exprs[assignment.target];
    if (target.op != Op::Variable) return {};
    return network.variables[{static_cast<std::uint32_t>(target.value)}].role;
}

void write_procedure(std::ostream& out, const Network& network, const Terms& terms, const std::string& name,
                     const Network::Procedure& procedure) {
    out << "\nvoid " << name << "() {\n";
    std::optional<Role> section;
    for (const Network::Assignment& assignment : procedure.assignments) {
        const std::optional<Role> role = role_of(network, assignment);
        if (role && role != section) out << "    // " << title(*role) << '\n';
        section = role;
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

std::string argument_text(const Names& names, const Type& type, const Network::Argument& argument) {
    return std::visit(overloaded{
                          [&](Id<Network::Variable> variable) { return names.variables[variable.index]; },
                          [&](std::int64_t value) { return value_text(type, value); },
                      },
                      argument);
}

/// Returns, for each process that is a timer, the name of its controller. The name is empty for all other processes,
/// and for all processes if there is only one controller.
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
            write_variable(out, variable, names.variables[id.index]);
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
    for (const std::string& clock : local.clocks) out << "clock " << clock << ";\n";
    const Terms terms(network, names, automaton);
    for (const Id<Network::Procedure> id : entity.procedures.ids())
        write_procedure(out, network, terms, local.procedures[id.index], entity.procedures[id]);
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
        out << ");\n";
    }
    out << '\n';
    write_system_line(out, names.processes);
}

}  // namespace grafverif::uppaal
