// SPDX-License-Identifier: MIT
#include "support/print_network.hpp"

#include <ostream>
#include <sstream>
#include <string_view>

#include "support/overloaded.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

namespace {

std::string_view word(Network::Role role) {
    switch (role) {
    case Network::Role::Input: return "input";
    case Network::Role::Output: return "output";
    case Network::Role::Internal: return "internal";
    case Network::Role::Step: return "step";
    case Network::Role::FiringCondition: return "firing condition";
    case Network::Role::Sample: return "sample";
    case Network::Role::Image: return "image";
    case Network::Role::TimerEnd: return "timer end";
    case Network::Role::TimerPending: return "timer pending";
    case Network::Role::Previous: return "previous value";
    case Network::Role::Watched: return "watched level";
    case Network::Role::Flag: return "flag";
    case Network::Role::Plant: return "plant";
    }
    unreachable();
}

std::string_view word(Network::ParameterKind kind) {
    switch (kind) {
    case Network::ParameterKind::Read: return "read";
    case Network::ParameterKind::Written: return "written";
    case Network::ParameterKind::Constant: return "constant";
    }
    unreachable();
}

std::string_view word(Network::ProcessKind kind) {
    switch (kind) {
    case Network::ProcessKind::Plant: return "plant";
    case Network::ProcessKind::Environment: return "environment";
    case Network::ProcessKind::Controller: return "controller";
    case Network::ProcessKind::Timer: return "timer";
    case Network::ProcessKind::Observer: return "observer";
    }
    unreachable();
}

std::string_view word(Pattern pattern) {
    switch (pattern) {
    case Pattern::Always: return "always";
    case Pattern::Never: return "never";
    case Pattern::Reachable: return "reachable";
    case Pattern::Inevitable: return "inevitable";
    case Pattern::LeadsTo: return "leads to";
    case Pattern::NoDeadlock: return "no deadlock";
    case Pattern::NoTimelock: return "no timelock";
    case Pattern::ReachableAllSteps: return "reachable all steps";
    case Pattern::ExactlyOneOf: return "exactly one of";
    case Pattern::AlwaysPossible: return "always possible";
    case Pattern::Watched: return "watched";
    case Pattern::RawUppaal: return "uppaal";
    case Pattern::RawCtl: return "ctl";
    case Pattern::RawLtl: return "ltl";
    }
    unreachable();
}

class Printer {
public:
    Printer(std::ostream& out, const Network& network) : out_(out), network_(network) {}

    void print() {
        out_ << "network " << network_.name << '\n';
        out_ << "grain " << (network_.grain == Grain::Phased ? "phased" : "atomic") << '\n';
        out_ << "time unit " << duration_text(network_.time_unit_ms) << "\n\n";
        for (const Network::Variable& variable : network_.variables) print(variable);
        for (const Network::Template& automaton : network_.templates) print(automaton);
        here_ = nullptr;
        if (!network_.processes.empty()) out_ << '\n';
        for (const Network::Process& process : network_.processes) print(process);
        for (const Network::Controller& controller : network_.controllers) print(controller);
        if (network_.settled.valid()) out_ << "\nsettled " << text(network_.settled) << '\n';
        if (!network_.properties.empty()) out_ << '\n';
        for (const Property& property : network_.properties) print(property);
    }

private:
    std::string text(Id<Expr> root) const {
        return expr_text(network_.exprs, root, chart_spelling, [this](std::ostream& out, const Expr& node) {
            const auto index = static_cast<std::uint32_t>(node.value);
            if (node.op == Op::Variable) out << network_.variables[{index}].name;
            else if (node.op == Op::Parameter) out << here_->parameters[{index}].name;
            else print_at(out, node);
        });
    }

    void print_at(std::ostream& out, const Expr& node) const {
        const Network::Process& process = network_.processes[{at_process(node)}];
        out << process.name << '.' << network_.templates[process.automaton].locations[{at_location(node)}].name;
    }

    void print(const Type& type) {
        if (type.boolean) out_ << "bool";
        else out_ << "int " << type.low << ".." << type.high;
    }

    void print_value(const Type& type, std::int64_t value) {
        if (type.boolean) out_ << (value != 0 ? "true" : "false");
        else out_ << value;
    }

    void print(const Network::Variable& variable) {
        out_ << word(variable.role) << ' ' << variable.name << ": ";
        print(variable.type);
        if (variable.scratch) out_ << ", scratch\n";
        else {
            out_ << " = ";
            print_value(variable.type, variable.initial);
            out_ << '\n';
        }
    }

    void print(const Network::Template& automaton) {
        here_ = &automaton;
        out_ << "\ntemplate " << automaton.name << '\n';
        for (const Network::Parameter& parameter : automaton.parameters) {
            out_ << "    " << word(parameter.kind) << ' ' << parameter.name << ": ";
            print(parameter.type);
            out_ << '\n';
        }
        for (const Network::Clock& clock : automaton.clocks) out_ << "    clock " << clock.name << '\n';
        for (const Id<Network::Location> id : automaton.locations.ids()) {
            const Network::Location& location = automaton.locations[id];
            out_ << "    " << (id == automaton.initial ? "initial " : "") << "location " << location.name;
            print_constraints(location.invariant, " invariant ");
            out_ << '\n';
        }
        for (const Network::Procedure& procedure : automaton.procedures) {
            out_ << "    procedure " << procedure.name << '\n';
            for (const Network::Assignment& assignment : procedure.assignments)
                out_ << "        " << text(assignment.target) << " := " << text(assignment.value) << '\n';
        }
        for (const Network::Edge& edge : automaton.edges) print(edge);
    }

    void print_constraints(const std::vector<Network::ClockConstraint>& constraints, std::string_view before) {
        for (const Network::ClockConstraint& constraint : constraints) {
            out_ << before << here_->clocks[constraint.clock].name << ' ' << chart_spelling(constraint.relation).token
                 << ' ' << text(constraint.bound);
            before = " && ";
        }
    }

    void print(const Network::Edge& edge) {
        out_ << "    " << (edge.urgent ? "urgent " : "timed ") << here_->locations[edge.from].name << " -> "
             << here_->locations[edge.to].name;
        const bool guarded = !is_true(network_.exprs, edge.guard);
        if (guarded) out_ << " when " << text(edge.guard);
        print_constraints(edge.constraint, guarded ? " && " : " when ");
        std::string_view before = " do ";
        for (const Network::Assignment& assignment : edge.assignments) {
            out_ << before << text(assignment.target) << " := " << text(assignment.value);
            before = ", ";
        }
        for (const Id<Network::Procedure> call : edge.calls) {
            out_ << before << here_->procedures[call].name << "()";
            before = ", ";
        }
        for (const Id<Network::Clock> clock : edge.resets) {
            out_ << before << here_->clocks[clock].name << " := 0";
            before = ", ";
        }
        out_ << '\n';
    }

    void print(const Network::Process& process) {
        const Network::Template& automaton = network_.templates[process.automaton];
        out_ << word(process.kind) << ' ' << process.name << " = " << automaton.name << '(';
        std::string_view before;
        for (const Id<Network::Parameter> id : automaton.parameters.ids()) {
            const Network::Parameter& parameter = automaton.parameters[id];
            out_ << before << parameter.name << " = ";
            std::visit(overloaded{
                           [&](Id<Network::Variable> variable) { out_ << network_.variables[variable].name; },
                           [&](std::int64_t value) { print_value(parameter.type, value); },
                       },
                       process.arguments[id.index]);
            before = ", ";
        }
        out_ << ") initially " << automaton.locations[process.initial].name << '\n';
    }

    void print(const Network::Controller& controller) {
        const Network::Process& process = network_.processes[controller.process];
        out_ << "\ncontroller " << controller.words.name << " with "
             << (controller.words.mode == ExecutionMode::EveryCycle ? "every_cycle" : "stability_search") << ": "
             << process.name << " waits in " << network_.templates[process.automaton].locations[controller.waiting].name
             << ", stable is " << network_.variables[controller.stable].name;
        std::string_view before = ", timers ";
        for (const Network::Timer& timer : controller.timers) {
            out_ << before << network_.processes[timer.process].name;
            before = ", ";
        }
        out_ << '\n';
    }

    void print(const Property& property) {
        out_ << "property " << property.name;
        if (!property.text.empty()) out_ << " \"" << property.text << '"';
        if (property.expected_violated) out_ << " expected violated";
        out_ << ": " << word(property.pattern);
        if (!property.raw.empty()) out_ << " \"" << property.raw << '"';
        std::string_view before = " ";
        for (const Id<Expr> operand : property.operands) {
            out_ << before << text(operand);
            before = ", ";
        }
        out_ << (property.at_stable ? " at stable\n" : "\n");
    }

    std::ostream& out_;
    const Network& network_;
    const Network::Template* here_ = nullptr;  // the template whose parameters are being printed
};

}  // namespace

void print_network(std::ostream& out, const Network& network) { Printer(out, network).print(); }

std::string network_text(const Network& network) {
    std::ostringstream out;
    print_network(out, network);
    return out.str();
}

}  // namespace grafverif
