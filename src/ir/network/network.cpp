// SPDX-License-Identifier: MIT
// Invariants of a Network. Each check adds one message per fault. The sorts of terms are computed once per template.
#include "grafverif/ir/network.hpp"

#include <algorithm>
#include <cassert>
#include <string_view>
#include <unordered_set>

#include "ir/network_clocks.hpp"
#include "ir/sorts.hpp"

namespace grafverif {

namespace {

bool in_range(const Type& type, std::int64_t value) { return type.low <= value && value <= type.high; }

/// True if each clock value that the second constraint admits also satisfies the first constraint. Both constraints are
/// upper bounds on one clock.
bool implied(Op relation, std::int64_t bound, Op other_relation, std::int64_t other_bound) {
    if (other_bound != bound) return other_bound < bound;
    return relation == Op::LessEqual || other_relation == Op::Less;
}

/// Checks all terms of a network and reports faults.
class Verifier {
public:
    explicit Verifier(const Network& network) : network_(network) {}

    std::vector<std::string> faults() {
        check_variables();
        for (const Network::Template& automaton : network_.templates) check_template(automaton);
        for (const Network::Process& process : network_.processes) check_process(process);
        if (!faults_.empty()) return std::move(faults_);
        for (const Network::Process& process : network_.processes) check_urgency(process);
        for (const Network::Controller& controller : network_.controllers) check_controller(controller);
        check_properties();
        return std::move(faults_);
    }

private:
    void fault(std::string sentence) { faults_.push_back(std::move(sentence)); }

    void check_variables() {
        std::unordered_set<std::string_view> names;
        for (const Network::Variable& variable : network_.variables) {
            if (!names.insert(variable.name).second) fault("variable " + variable.name + ": its name is already used");
            if (variable.type.low > variable.type.high) fault("variable " + variable.name + ": its range is empty");
            if (!in_range(variable.type, variable.initial))
                fault("variable " + variable.name + ": its initial value is out of range");
        }
        if (network_.time_unit_ms <= 0) fault("the time unit is not positive");
    }

    void check_template(const Network::Template& automaton) {
        read_terms_of(&automaton);
        const std::string where = "template " + automaton.name;
        if (!automaton.locations.contains(automaton.initial)) fault(where + ": no initial location");
        for (const Network::Location& location : automaton.locations) {
            check_constraints(location.invariant, where + ", location " + location.name);
            for (const Network::ClockConstraint& bound : location.invariant)
                if (bound.relation != Op::Less && bound.relation != Op::LessEqual)
                    fault(where + ", location " + location.name + ": an invariant has a lower bound");
        }
        for (const Network::Procedure& procedure : automaton.procedures)
            check_assignments(procedure.assignments, where + ", procedure " + procedure.name);
        for (const Network::Edge& edge : automaton.edges) check_edge(edge, where);
    }

    void check_edge(const Network::Edge& edge, const std::string& where) {
        const Network::Template& automaton = *here_;
        if (!automaton.locations.contains(edge.from) || !automaton.locations.contains(edge.to))
            return fault(where + ": an edge leads to a location that does not exist");
        const std::string place =
            where + ", edge " + automaton.locations[edge.from].name + " -> " + automaton.locations[edge.to].name;
        check_term(edge.guard, Sort::Boolean, place + ": its guard");
        check_constraints(edge.constraint, place);
        if (edge.urgent && !edge.constraint.empty()) fault(place + ": an urgent edge has a clock constraint");
        check_assignments(edge.assignments, place);
        for (const Id<Network::Clock> clock : edge.resets)
            if (!automaton.clocks.contains(clock)) fault(place + ": the edge resets an unknown clock");
        for (const Id<Network::Procedure> call : edge.calls)
            if (!automaton.procedures.contains(call)) return fault(place + ": the edge calls an unknown procedure");
        check_scratch(edge, place);
    }

    void check_constraints(const std::vector<Network::ClockConstraint>& constraints, const std::string& where) {
        for (const Network::ClockConstraint& constraint : constraints) {
            if (!here_->clocks.contains(constraint.clock)) fault(where + ": a constraint bounds an unknown clock");
            const bool relation = is_comparison(constraint.relation) && constraint.relation != Op::NotEqual;
            if (!relation) fault(where + ": a clock is compared with an unknown relation");
            if (!check_term(constraint.bound, Sort::Integer, where + ": a clock bound")) continue;
            for (const Id<Expr> leaf : leaves(network_.exprs, constraint.bound)) {
                const Expr& node = network_.exprs[leaf];
                const Id<Network::Parameter> parameter{static_cast<std::uint32_t>(node.value)};
                const bool constant = node.op == Op::Parameter && here_->parameters.contains(parameter) &&
                                      here_->parameters[parameter].kind == Network::ParameterKind::Constant;
                if (!constant) fault(where + ": a clock bound reads a variable");
            }
        }
    }

    void check_assignments(const std::vector<Network::Assignment>& assignments, const std::string& where) {
        for (const Network::Assignment& assignment : assignments) {
            const Sort sort = sorts_(assignment.target);
            if (sort == Sort::None) {
                fault(where + ": the target of an assignment does not exist or has no type");
                continue;
            }
            const Expr& node = network_.exprs[assignment.target];
            const Id<Network::Parameter> parameter{static_cast<std::uint32_t>(node.value)};
            const bool written = node.op == Op::Parameter && here_->parameters.contains(parameter) &&
                                 here_->parameters[parameter].kind == Network::ParameterKind::Written;
            if (!written && node.op != Op::Variable)
                fault(where + ": an assignment has a target that cannot be written");
            check_term(assignment.value, sort, where + ": an assigned value");
        }
    }

    /// Checks that scratch variables are written before they are read, within the edge.
    void check_scratch(const Network::Edge& edge, const std::string& where) {
        std::unordered_set<std::uint32_t> written;
        const auto run = [&](const std::vector<Network::Assignment>& assignments) {
            for (const Network::Assignment& assignment : assignments) {
                if (!network_.exprs.contains(assignment.target) || !network_.exprs.contains(assignment.value)) continue;
                for (const Id<Expr> leaf : leaves(network_.exprs, assignment.value))
                    if (const auto variable = scratch(leaf); variable && !written.contains(*variable))
                        fault(where + ": the procedure reads " + network_.variables[{*variable}].name +
                              " before it is written");
                if (const auto variable = scratch(assignment.target)) written.insert(*variable);
            }
        };
        run(edge.assignments);
        for (const Id<Network::Procedure> call : edge.calls) run(here_->procedures[call].assignments);
    }

    std::optional<std::uint32_t> scratch(Id<Expr> leaf) const {
        const Expr& node = network_.exprs[leaf];
        const Id<Network::Variable> variable{static_cast<std::uint32_t>(node.value)};
        if (node.op != Op::Variable || !network_.variables.contains(variable)) return {};
        return network_.variables[variable].scratch ? std::optional(variable.index) : std::nullopt;
    }

    void check_process(const Network::Process& process) {
        const std::string where = "process " + process.name;
        if (!network_.templates.contains(process.automaton)) return fault(where + ": no template");
        const Network::Template& automaton = network_.templates[process.automaton];
        if (!automaton.locations.contains(process.initial)) fault(where + ": no initial location");
        if (process.arguments.size() != automaton.parameters.size())
            return fault(where + ": the number of arguments differs from the number of parameters");
        for (const Id<Network::Parameter> id : automaton.parameters.ids())
            check_argument(automaton.parameters[id], process.arguments[id.index], where);
    }

    void check_argument(const Network::Parameter& parameter, const Network::Argument& argument,
                        const std::string& where) {
        const bool constant = parameter.kind == Network::ParameterKind::Constant;
        if (const auto* variable = std::get_if<Id<Network::Variable>>(&argument)) {
            if (constant) return fault(where + ": a variable is passed for the constant " + parameter.name);
            if (!network_.variables.contains(*variable)) return fault(where + ": no variable for " + parameter.name);
            if (network_.variables[*variable].type != parameter.type)
                fault(where + ": " + parameter.name + " has a type that differs from the one of its argument");
            return;
        }
        if (!constant) return fault(where + ": a number is passed for the variable " + parameter.name);
        if (!in_range(parameter.type, std::get<std::int64_t>(argument)))
            fault(where + ": the argument for " + parameter.name + " is out of range");
    }

    void check_urgency(const Network::Process& process) {
        for (const Network::Edge& edge : network_.templates[process.automaton].edges)
            if (edge.urgent && !keeps_target_invariant(network_, process, edge))
                fault("process " + process.name + ": an urgent edge may violate the invariant of its target location");
    }

    void check_controller(const Network::Controller& controller) {
        const std::string where = "controller " + controller.words.name;
        if (!network_.processes.contains(controller.process)) return fault(where + ": no process");
        const Network::Template& automaton = network_.templates[network_.processes[controller.process].automaton];
        if (!automaton.locations.contains(controller.waiting)) fault(where + ": no waiting location");
        if (!network_.variables.contains(controller.stable))
            fault(where + ": no variable indicates that its situation is stable");
        for (const Network::Timer& timer : controller.timers)
            if (!network_.processes.contains(timer.process)) fault(where + ": a timer refers to an unknown process");
        check_text(controller.words, where);
    }

    void check_text(const ControllerWords<Network::Variable>& words, const std::string& where) {
        for (const auto& [name, variable] : words.steps)
            if (!network_.variables.contains(variable))
                fault(where + ": `" + name.text() + "` does not refer to a variable");
        for (const auto* list : {&words.transitions, &words.inputs, &words.outputs, &words.internals})
            for (const auto& [name, variable] : *list)
                if (!network_.variables.contains(variable))
                    fault(where + ": `" + name + "` does not refer to a variable");
        for (const Id<Network::Variable> held : words.held)
            if (!network_.variables.contains(held)) fault(where + ": an input is held in an unknown variable");
        if (!words.held.empty() && words.held.size() != words.inputs.size())
            fault(where + ": some inputs are held, and others are not");
        for (const auto& timer : words.timers) {
            if (!network_.variables.contains(timer.end)) fault(where + ": a timer refers to an unknown output");
            if (timer.step && *timer.step >= words.steps.size()) fault(where + ": a timer refers to an unknown step");
        }
    }

    void check_properties() {
        read_terms_of(nullptr);
        std::unordered_set<std::string_view> names;
        for (const Property& property : network_.properties) {
            if (!names.insert(property.name).second) fault("property " + property.name + ": its name is already used");
            for (const Id<Expr> operand : property.operands)
                check_term(operand, Sort::Boolean, "property " + property.name + ": an operand");
        }
        if (network_.settled.valid()) check_term(network_.settled, Sort::Boolean, "settled");
    }

    bool check_term(Id<Expr> term, Sort sort, const std::string& what) {
        return sorts_.check(term, sort, what, faults_);
    }

    /// Sets the template to which the following terms belong; null for terms of properties.
    void read_terms_of(const Network::Template* automaton) {
        here_ = automaton;
        sorts_ = Sorts(network_.exprs, [this](const Expr& leaf) { return leaf_sort(leaf); });
    }

    Sort leaf_sort(const Expr& leaf) const {
        const auto index = static_cast<std::uint32_t>(leaf.value);
        if (leaf.op == Op::Variable && network_.variables.contains({index}))
            return sort_of(network_.variables[{index}].type);
        if (leaf.op == Op::Parameter && here_ && here_->parameters.contains({index}))
            return sort_of(here_->parameters[{index}].type);
        if (leaf.op == Op::At && !here_ && network_.processes.contains({at_process(leaf)}) &&
            at_location(leaf) < network_.templates[network_.processes[{at_process(leaf)}].automaton].locations.size())
            return Sort::Boolean;
        return Sort::None;
    }

    const Network& network_;
    const Network::Template* here_ = nullptr;  // template of the parameters that the current terms read
    Sorts sorts_{network_.exprs, [this](const Expr& leaf) { return leaf_sort(leaf); }};
    std::vector<std::string> faults_ = {};
};

}  // namespace

std::vector<std::string> verify(const Network& network) { return Verifier(network).faults(); }

bool has_call(const Network::Edge& edge, Id<Network::Procedure> procedure) {
    return procedure.valid() && std::ranges::find(edge.calls, procedure) != edge.calls.end();
}

std::int64_t bound_value(const Network& network, const Network::Process& process, Id<Expr> bound) {
    const auto value = evaluate(network.exprs, bound, [&](const Expr& leaf) {
        assert(leaf.op == Op::Parameter);
        return std::get<std::int64_t>(process.arguments[static_cast<std::size_t>(leaf.value)]);
    });
    return value.value_or(0);
}

bool keeps_target_invariant(const Network& network, const Network::Process& process, const Network::Edge& edge) {
    const Network::Template& automaton = network.templates[process.automaton];
    return std::ranges::all_of(automaton.locations[edge.to].invariant, [&](const Network::ClockConstraint& wanted) {
        const std::int64_t bound = bound_value(network, process, wanted.bound);
        if (resets(edge, wanted.clock)) return wanted.relation == Op::Less ? bound > 0 : bound >= 0;
        return std::ranges::any_of(
            automaton.locations[edge.from].invariant, [&](const Network::ClockConstraint& given) {
                return given.clock == wanted.clock &&
                       implied(wanted.relation, bound, given.relation, bound_value(network, process, given.bound));
            });
    });
}

}  // namespace grafverif
