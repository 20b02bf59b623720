// SPDX-License-Identifier: MIT
#include "plant/variables.hpp"

#include <algorithm>
#include <numeric>

#include "ir/display_name.hpp"
#include "support/messages.hpp"
#include "support/overloaded.hpp"
#include "support/unique_names.hpp"

namespace grafverif {

namespace {

using Variable = Network::Variable;

/// Evaluates expressions of one instance at power-on. The value of a constant is the argument of the instance
/// for this constant; the value of a variable is the initial value that was last assigned to the variable.
class PowerOn {
public:
    PowerOn(const Component& component, const ClosedLoop::Instance& instance, PlantVariables& plant,
            const std::vector<Id<Variable>>& own, Diagnostics& diagnostics)
        : component_(component), instance_(instance), plant_(plant), own_(own), diagnostics_(diagnostics) {}

    std::optional<std::int64_t> value(Id<Expr> root, Span where) const {
        const auto result = evaluate(component_.exprs, root, [&](const Expr& leaf) {
            const auto index = static_cast<std::uint32_t>(leaf.value);
            if (leaf.op == Op::Variable) return plant_.variables[own_[index]].initial;
            return std::visit(
                overloaded{
                    [&](Id<ClosedLoop::Shared> shared) { return plant_.variables[{shared.index}].initial; },
                    [](std::int64_t constant) { return constant; },
                    // Declarations do not read inputs, so that this case is impossible.
                    [](Id<Expr>) -> std::int64_t { unreachable(); },
                },
                instance_.arguments[index]);
        });
        if (!result) diagnostics_.add(messages::no_value(where, instance_.name));
        return result;
    }

    /// Sets the range `low..high` and the initial value. The default of the initial value is 0 if 0 is in the range,
    /// otherwise `low`.
    void declare(Variable& variable, std::optional<Id<Expr>> low, std::optional<Id<Expr>> high,
                 std::optional<Id<Expr>> initial, Span where) const {
        if (low && high) {
            const auto least = value(*low, where);
            const auto greatest = value(*high, where);
            if (!least || !greatest) return;
            if (*least > *greatest || *least < least_integer || *greatest > greatest_integer)
                diagnostics_.add(messages::bad_range(instance_.origin, variable.name, *least, *greatest));
            variable.type = integer_type(*least, *greatest);
        }
        const Type type = variable.type;
        variable.initial = type.low <= 0 && 0 <= type.high ? 0 : type.low;
        if (initial)
            if (const auto start = value(*initial, where)) variable.initial = *start;
    }

    /// Assigns the values that the initial location declares with the keyword `with`.
    void enter_initial_location() const {
        for (const Component::Assignment& assignment : component_.locations[instance_.initial].initially) {
            const Expr& target = component_.exprs[assignment.target];
            const auto index = static_cast<std::uint32_t>(target.value);
            const auto start = value(assignment.value, assignment.origin);
            if (!start) continue;
            if (target.op == Op::Variable) plant_.variables[own_[index]].initial = *start;
            else if (const auto* shared = std::get_if<Id<ClosedLoop::Shared>>(&instance_.arguments[index]))
                plant_.variables[{shared->index}].initial = *start;
        }
    }

    void check(const Variable& variable) const {
        const auto [boolean, low, high] = variable.type;
        if (low > high || (low <= variable.initial && variable.initial <= high)) return;
        diagnostics_.add(messages::initial_out_of_range(instance_.origin, variable.name, variable.initial, low, high));
    }

private:
    const Component& component_;
    const ClosedLoop::Instance& instance_;
    PlantVariables& plant_;
    const std::vector<Id<Variable>>& own_;
    Diagnostics& diagnostics_;
};

Network::Role role_of(const ClosedLoop::Shared& shared) {
    if (shared.writer.valid()) return Network::Role::Output;
    return shared.reader.valid() ? Network::Role::Input : Network::Role::Plant;
}

PlantVariables shared_variables(const Model& model, const ClosedLoop& loop) {
    PlantVariables plant;
    for (const ClosedLoop::Shared& shared : loop.shared) {
        Variable variable{.name = shared.name, .role = role_of(shared), .type = shared.type, .origin = shared.origin};
        variable.initial = shared.type.low <= 0 && 0 <= shared.type.high ? 0 : shared.type.low;
        if (shared.writer.valid() && shared.variable.valid() && !shared.reader.valid())
            variable.initial = model.charts[loop.controllers[shared.writer].chart].variables[shared.variable].initial;
        plant.variables.add(std::move(variable));
    }
    return plant;
}

/// Checks that each shared variable has at most one writer, which is an instance or a controller (CEP13 4.2).
void check_writers(const Model& model, const ClosedLoop& loop, Diagnostics& diagnostics) {
    std::vector<const std::string*> writers(loop.shared.size(), nullptr);
    for (const Id<ClosedLoop::Shared> shared : loop.shared.ids())
        if (loop.shared[shared].writer.valid())
            writers[shared.index] = &loop.controllers[loop.shared[shared].writer].name;
    for (const ClosedLoop::Instance& instance : loop.instances) {
        const Component& component = model.components[instance.component];
        for (const Id<Component::Parameter> parameter : component.parameters.ids()) {
            const auto* shared = std::get_if<Id<ClosedLoop::Shared>>(&instance.arguments[parameter.index]);
            if (!shared || component.parameters[parameter].kind != Component::ParameterKind::Output) continue;
            const std::string*& writer = writers[shared->index];
            if (writer)
                diagnostics.add(
                    messages::second_writer(instance.origin, loop.shared[*shared].name, *writer, instance.name));
            writer = &instance.name;
        }
    }
}

void power_on(const Component& component, const ClosedLoop::Instance& instance, PlantVariables& plant,
              UniqueNames& names, Diagnostics& diagnostics) {
    std::vector<Id<Variable>>& own = plant.own.emplace_back();
    const PowerOn here(component, instance, plant, own, diagnostics);
    std::vector<Id<Variable>> written;
    for (const Id<Component::Parameter> id : component.parameters.ids()) {
        const Component::Parameter& parameter = component.parameters[id];
        const auto* shared = std::get_if<Id<ClosedLoop::Shared>>(&instance.arguments[id.index]);
        if (!shared || parameter.kind != Component::ParameterKind::Output) continue;
        const Id<Variable> variable{shared->index};
        const Type bound = plant.variables[variable].type;
        here.declare(plant.variables[variable], parameter.low, parameter.high, parameter.initial, parameter.origin);
        // Restores the type from the loop, because a controller may declare a wider range than the component.
        plant.variables[variable].type = bound;
        written.push_back(variable);
    }
    for (const Component::Variable& declared : component.variables) {
        Variable variable{.name = names.fresh(instance.name + "_" + declared.name), .origin = declared.origin};
        variable.shown_name = display_name(instance.name, component, declared.name);
        here.declare(variable, declared.low, declared.high, declared.initial, declared.origin);
        own.push_back(plant.variables.add(std::move(variable)));
        written.push_back(own.back());
    }
    here.enter_initial_location();
    for (const Id<Variable> variable : written) here.check(plant.variables[variable]);
}

}  // namespace

std::optional<PlantVariables> plant_variables(const Model& model, const ClosedLoop& loop, Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.errors();
    check_writers(model, loop, diagnostics);
    PlantVariables plant = shared_variables(model, loop);
    UniqueNames names;
    for (const Variable& variable : plant.variables) names.fresh(variable.name);
    plant.own.reserve(loop.instances.size());
    for (const ClosedLoop::Instance& instance : loop.instances)
        power_on(model.components[instance.component], instance, plant, names, diagnostics);
    if (diagnostics.errors() != errors) return {};
    return plant;
}

}  // namespace grafverif
