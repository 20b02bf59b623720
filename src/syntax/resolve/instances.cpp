// SPDX-License-Identifier: MIT
// Resolves the instances of a closed loop. An instance binds the parameters of a component. Constants and outputs are
// resolved first, because outputs declare the variables of the plant. Inputs are resolved afterwards, because they read
// these variables. Faults are resolved last, because a fault inherits the arguments of its instance.
#include <algorithm>
#include <string>

#include "support/messages.hpp"
#include "support/messages_fault.hpp"
#include "support/overloaded.hpp"
#include "syntax/resolve/expand.hpp"
#include "syntax/resolve/loop_scope.hpp"
#include "syntax/resolve/nearest.hpp"

namespace grafverif {

namespace {

using Parameter = Component::Parameter;

std::string_view described(bool boolean) { return boolean ? "Boolean" : "an integer"; }

/// An instance whose arguments are being bound.
struct Binding {
    const tree::Instance* written = nullptr;
    const Component* component = nullptr;
    ClosedLoop::Instance instance = {};
    std::vector<const tree::Argument*> given = {};  ///< for each parameter: its argument, or null
    std::vector<bool> bound = {};                   ///< for each parameter: true if given or inherited

    /// For a fault: the instance whose arguments it inherits.
    const Binding* of = nullptr;
    bool wrong = false;
};

void fail(LoopScope& scope, Binding& binding, Diagnostic diagnostic) {
    scope.diagnostics.add(std::move(diagnostic));
    binding.wrong = true;
}

// -- assignment of arguments to parameters ----------------------------------------------------------------------------

Id<Component> component_named(LoopScope& scope, tree::Name name) {
    const auto found = scope.components.find(scope.text(name));
    if (found != scope.components.end())
        return scope.record.refer(name.where, scope.context.model.components[found->second].origin), found->second;
    scope.incomplete = !scope.record.beyond_errors();
    if (scope.context.components_in_error.contains(std::string(scope.text(name)))) return {};
    Nearest nearest(scope.text(name));
    std::string known;
    for (const std::string& component : scope.context.component_names) {
        nearest.offer(component);
        known += (known.empty() ? "`" : ", `") + component + '`';
    }
    scope.diagnostics.add(messages::unknown_component(name.where, scope.text(name), nearest.best(), known));
    return {};
}

std::string example(const Parameter& parameter) {
    if (parameter.kind != Component::ParameterKind::Constant) return "NAME";
    switch (parameter.value) {
    case Component::ValueKind::Boolean: return "true";
    case Component::ValueKind::Integer: return "1";
    case Component::ValueKind::Duration: return "1s";
    }
    unreachable();
}

/// Binds a parameter of a fault that has no argument: it inherits the argument of the instance's parameter with the
/// same name and type. Returns false if the instance has no such parameter.
bool inherit(const LoopScope& scope, Binding& binding, Id<Parameter> id) {
    if (binding.of == nullptr) return false;
    const Parameter& parameter = binding.component->parameters[id];
    const auto& known = binding.of->component->parameters;
    const auto same = std::ranges::find_if(known, [&](const Parameter& each) {
        return each.name == parameter.name && each.kind == parameter.kind && each.value == parameter.value;
    });
    if (same == known.end()) return false;
    scope.record.share(parameter.origin, same->origin);
    binding.instance.arguments[id.index] =
        binding.of->instance.arguments[static_cast<std::size_t>(same - known.begin())];
    return true;
}

void match_arguments(LoopScope& scope, Binding& binding) {
    const Component& component = *binding.component;
    std::unordered_map<std::string_view, Id<Parameter>> parameters;
    for (const Id<Parameter> id : component.parameters.ids()) parameters.emplace(component.parameters[id].name, id);
    binding.given.resize(component.parameters.size());
    for (const tree::Argument& argument : binding.written->arguments) {
        const std::string_view name = scope.text(argument.parameter);
        const auto found = parameters.find(name);
        if (found != parameters.end())
            scope.record.refer(argument.parameter.where, component.parameters[found->second].origin);
        if (found == parameters.end()) {
            Nearest nearest(name);
            for (const Parameter& parameter : component.parameters) nearest.offer(parameter.name);
            fail(scope, binding, messages::unknown(argument.parameter.where, "parameter", name, nearest.best()));
        } else if (const tree::Argument*& given = binding.given[found->second.index]; given != nullptr) {
            fail(scope, binding,
                 messages::duplicate_name(argument.parameter.where, "argument", name, given->parameter.where));
        } else {
            given = &argument;
        }
    }
    if (binding.wrong && !scope.record.beyond_errors()) return;
    for (const Id<Parameter> id : component.parameters.ids()) {
        const Parameter& parameter = component.parameters[id];
        const bool optional = parameter.kind == Component::ParameterKind::Constant && parameter.initial.has_value();
        binding.bound.push_back(binding.given[id.index] != nullptr || inherit(scope, binding, id));
        if (!binding.bound.back() && !optional)
            fail(scope, binding,
                 messages::missing_argument(binding.written->component.where, component.name, parameter.name,
                                            example(parameter)));
    }
}

// -- constants --------------------------------------------------------------------------------------------------------

std::int64_t argument_value(const Binding& binding, const Expr& leaf) {
    const auto* value = std::get_if<std::int64_t>(&binding.instance.arguments[static_cast<std::size_t>(leaf.value)]);
    return value == nullptr ? 0 : *value;
}

std::optional<std::int64_t> value_of(LoopScope& scope, Binding& binding, Id<Expr> term) {
    const auto value =
        evaluate(binding.component->exprs, term, [&](const Expr& leaf) { return argument_value(binding, leaf); });
    if (!value) fail(scope, binding, messages::no_value(binding.written->name.where, binding.instance.name));
    return value;
}

void bind_given_constant(LoopScope& scope, Binding& binding, Id<Parameter> id) {
    const Parameter& parameter = binding.component->parameters[id];
    Terms terms = constant_terms(scope, '`' + parameter.name + '`');
    const TermKind kind = parameter.value == Component::ValueKind::Boolean   ? TermKind::Boolean
                          : parameter.value == Component::ValueKind::Integer ? TermKind::Integer
                                                                             : TermKind::Duration;
    const auto value = terms.constant(binding.given[id.index]->value, kind, '`' + parameter.name + '`');
    if (!value) binding.wrong = true;
    binding.instance.arguments[id.index] = value.value_or(0);
}

/// Binds the defaults of constants in the order of dependency: a default is bound after the constants that it reads.
/// The resolution of the component has already rejected cycles.
void bind_defaults(LoopScope& scope, Binding& binding) {
    const Component& component = *binding.component;
    std::vector<bool> bound = binding.bound;
    std::vector<std::uint32_t> work;
    for (const Id<Parameter> id : component.parameters.ids()) {
        if (component.parameters[id].kind != Component::ParameterKind::Constant) continue;
        work.push_back(id.index);
        while (!work.empty()) {
            const std::uint32_t index = work.back();
            const auto& initial = component.parameters[Id<Parameter>{index}].initial;
            const std::size_t pending = work.size();
            if (!bound[index] && initial)
                for (const Id<Expr> leaf : leaves(component.exprs, *initial)) {
                    const auto needed = static_cast<std::uint32_t>(component.exprs[leaf].value);
                    if (!bound[needed]) work.push_back(needed);
                }
            if (work.size() != pending) continue;
            work.pop_back();
            if (!bound[index] && initial)
                binding.instance.arguments[index] = value_of(scope, binding, *initial).value_or(0);
            bound[index] = true;
        }
    }
}

// -- variables --------------------------------------------------------------------------------------------------------

/// Returns the name of the variable to which an output is bound. Reports an error if the argument is another
/// expression.
std::optional<std::string_view> bound_name(LoopScope& scope, Binding& binding, Id<Parameter> id) {
    const tree::Expr& value = scope.file.exprs[binding.given[id.index]->value];
    if (value.op == tree::Op::Name) return scope.file.text(value.word);
    fail(scope, binding, messages::output_not_a_name(value.where, binding.component->parameters[id].name));
    return {};
}

std::optional<Type> output_type(LoopScope& scope, Binding& binding, const Parameter& parameter) {
    if (parameter.value == Component::ValueKind::Boolean) return Type{};
    if (!parameter.low || !parameter.high) return {};  // a bound is missing only after an error
    const auto low = value_of(scope, binding, *parameter.low);
    const auto high = low ? value_of(scope, binding, *parameter.high) : std::nullopt;
    if (!low || !high) return {};
    if (*low > *high || *low < least_integer || *high > greatest_integer) {
        fail(scope, binding, messages::bad_range(binding.written->name.where, parameter.name, *low, *high));
        return {};
    }
    return integer_type(*low, *high);
}

void bind_output(LoopScope& scope, Binding& binding, Id<Parameter> id) {
    const auto name = bound_name(scope, binding, id);
    if (!name) return;
    auto type = output_type(scope, binding, binding.component->parameters[id]);
    if (!type && scope.record.beyond_errors()) type = Type{};
    if (!type) return;
    const tree::Argument& given = *binding.given[id.index];
    const Span where = scope.file.exprs[given.value].where;
    const Id<ClosedLoop::Shared> shared = shared_named(scope, *name, *type, where);
    const ClosedLoop::Shared& known = scope.loop.shared[shared];
    if (known.origin.begin == where.begin && known.origin.source == where.source)
        scope.record.declare(DeclarationKind::PlantVariable, *name, where, given.where, scope.loop.origin);
    scope.record.refer(where, known.origin, true);
    std::string& writer = scope.instance_writers[shared.index];
    if (known.writer.valid() || !writer.empty()) {
        const std::string& first = known.writer.valid() ? scope.loop.controllers[known.writer].name : writer;
        return fail(scope, binding, messages::second_writer(where, known.name, first, binding.instance.name));
    }
    writer = binding.instance.name;
    if (known.type.boolean != type->boolean)
        return fail(
            scope, binding,
            messages::argument_type(where, known.name, described(known.type.boolean), described(type->boolean)));
    if (type->low < known.type.low || type->high > known.type.high)
        return fail(
            scope, binding,
            messages::range_mismatch(where, known.name, type->low, type->high, known.type.low, known.type.high));
    binding.instance.arguments[id.index] = shared;
}

/// Binds an input to a variable or to a term over variables.
void bind_input(LoopScope& scope, Binding& binding, Id<Parameter> id) {
    const Id<tree::Expr> written = binding.given[id.index]->value;
    const tree::Expr& value = scope.file.exprs[written];
    const Parameter& parameter = binding.component->parameters[id];
    const bool boolean = parameter.value == Component::ValueKind::Boolean;
    const auto named =
        value.op == tree::Op::Name ? scope.shared.find(std::string(scope.file.text(value.word))) : scope.shared.end();
    if (named == scope.shared.end()) {
        const TermKind kind = boolean ? TermKind::Boolean : TermKind::Integer;
        const Id<Expr> term = port_terms(scope).resolve(written, kind, "the input `" + parameter.name + '`');
        binding.wrong = binding.wrong || !term.valid();
        if (term.valid()) binding.instance.arguments[id.index] = term;
        return;
    }
    const ClosedLoop::Shared& shared = scope.loop.shared[named->second];
    scope.record.refer(value.where, shared.origin);
    if (shared.type.boolean != boolean)
        return fail(
            scope, binding,
            messages::argument_type(value.where, shared.name, described(shared.type.boolean), described(boolean)));
    binding.instance.arguments[id.index] = named->second;
}

/// If the resolution continues after errors, records the names in all arguments, because arguments with errors are not
/// bound.
void record_arguments(LoopScope& scope, const tree::Instance& written) {
    if (!scope.record.beyond_errors()) return;
    for (const tree::Argument& argument : written.arguments) port_terms(scope).resolve(argument.value);
}

void bind_inputs(LoopScope& scope, Binding& binding) {
    for (const Id<Parameter> id : binding.component->parameters.ids())
        if (binding.component->parameters[id].kind == Component::ParameterKind::Input) bind_input(scope, binding, id);
}

void choose_location(LoopScope& scope, Binding& binding) {
    const tree::Name name = binding.written->initial;
    binding.instance.initial = binding.component->initial;
    if (!name.valid()) {
        if (binding.instance.initial.valid()) return;
        return fail(scope, binding,
                    messages::missing_initially(binding.written->component.where, binding.component->name,
                                                location_list(*binding.component)));
    }
    Nearest nearest(scope.text(name));
    for (const Id<Component::Location> id : binding.component->locations.ids()) {
        const std::string& location = binding.component->locations[id].name;
        if (location == scope.text(name)) {
            scope.record.refer(name.where, binding.component->locations[id].origin);
            binding.instance.initial = id;
            return;
        }
        nearest.offer(location);
    }
    fail(scope, binding,
         messages::unknown_location(name.where, scope.text(name), nearest.best(), binding.component->name,
                                    location_list(*binding.component)));
}

void excuse(LoopScope& scope, const tree::Instance& written) {
    for (const tree::Argument& argument : written.arguments) {
        const tree::Expr& value = scope.file.exprs[argument.value];
        if (value.op == tree::Op::Name) scope.excused.emplace(scope.file.text(value.word));
    }
}

Binding begin(LoopScope& scope, const tree::Instance& written, DeclarationKind kind, Span whole) {
    scope.record.declare(kind, scope.text(written.name), written.name.where, whole, scope.loop.origin);
    Binding binding;
    binding.written = &written;
    binding.instance.name = scope.text(written.name);
    binding.instance.environment = written.environment;
    binding.instance.origin = written.name.where;
    binding.instance.component = component_named(scope, written.component);
    return binding;
}

/// Assigns the arguments to parameters, and binds the constants. Returns false after an error.
bool bind_constants(LoopScope& scope, Binding& binding) {
    binding.component = &scope.context.model.components[binding.instance.component];
    binding.instance.arguments.resize(binding.component->parameters.size(), std::int64_t{0});
    match_arguments(scope, binding);
    if (binding.wrong && !scope.record.beyond_errors()) return false;
    for (const Id<Parameter> id : binding.component->parameters.ids())
        if (binding.given[id.index] != nullptr &&
            binding.component->parameters[id].kind == Component::ParameterKind::Constant)
            bind_given_constant(scope, binding, id);
    if (binding.wrong && !scope.record.beyond_errors()) return false;
    bind_defaults(scope, binding);
    return true;
}

Binding bind_instance(LoopScope& scope, const tree::Instance& written) {
    const InCopy copy(scope.diagnostics, scope.file, written.name);
    Binding binding = begin(scope, written, DeclarationKind::Instance, written.where);
    const auto [known, fresh] = scope.instances.try_emplace(scope.text(written.name));
    if (!fresh && known->second.valid())
        fail(scope, binding,
             duplicate(written.name, "instance", binding.instance.name, scope.loop.instances[known->second].origin));
    if (!binding.instance.component.valid()) {
        binding.wrong = true;
        return binding;
    }
    if (!bind_constants(scope, binding)) return binding;
    for (const Id<Parameter> id : binding.component->parameters.ids())
        if (binding.component->parameters[id].kind == Component::ParameterKind::Output &&
            binding.given[id.index] != nullptr)
            bind_output(scope, binding, id);
    choose_location(scope, binding);
    return binding;
}

// -- faults ----------------------------------------------------------------------------------------------------------

std::string type_text(const Type& type) {
    return type.boolean ? "bool" : "int " + std::to_string(type.low) + ".." + std::to_string(type.high);
}

/// Returns the output of an instance that is bound to `variable`; invalid if no output is bound to it.
Id<Parameter> writer_of(const Binding& binding, Id<ClosedLoop::Shared> variable) {
    for (const Id<Parameter> id : binding.component->parameters.ids()) {
        const auto* shared = std::get_if<Id<ClosedLoop::Shared>>(&binding.instance.arguments[id.index]);
        if (binding.component->parameters[id].kind == Component::ParameterKind::Output && shared != nullptr &&
            *shared == variable)
            return id;
    }
    return {};
}

/// Binds an output of a fault to a variable. Reports an error if the instance of the fault does not write this
/// variable, or writes it with another range.
void bind_output_of_fault(LoopScope& scope, Binding& binding, Id<Parameter> id) {
    const Parameter& parameter = binding.component->parameters[id];
    const Span where = binding.given[id.index] == nullptr ? binding.written->component.where
                                                          : scope.file.exprs[binding.given[id.index]->value].where;
    if (binding.given[id.index] != nullptr) {
        const auto name = bound_name(scope, binding, id);
        if (!name) return;
        const auto known = scope.shared.find(std::string(*name));
        if (known != scope.shared.end()) {
            binding.instance.arguments[id.index] = known->second;
            scope.record.refer(where, scope.loop.shared[known->second].origin, true);
        }
    }
    const auto* shared = std::get_if<Id<ClosedLoop::Shared>>(&binding.instance.arguments[id.index]);
    const Id<Parameter> normal = shared == nullptr ? Id<Parameter>{} : writer_of(*binding.of, *shared);
    if (!normal.valid())
        return fail(
            scope, binding,
            messages::fault_writes_other(where, binding.instance.name, parameter.name, binding.of->instance.name));
    Binding of = *binding.of;
    const auto type = output_type(scope, binding, parameter);
    const auto wanted = output_type(scope, of, of.component->parameters[normal]);
    if (type && wanted && *type != *wanted)
        fail(scope, binding,
             messages::fault_type(where, binding.instance.name, scope.loop.shared[*shared].name, type_text(*type),
                                  type_text(*wanted)));
}

/// Checks that the fault has exactly one output for each variable that its instance writes.
void check_outputs_of_fault(LoopScope& scope, Binding& binding) {
    std::vector<int> writers(scope.loop.shared.size());
    const auto count = [&](const Binding& each, int change) {
        for (const Id<Parameter> id : each.component->parameters.ids())
            if (each.component->parameters[id].kind == Component::ParameterKind::Output)
                writers[std::get<Id<ClosedLoop::Shared>>(each.instance.arguments[id.index]).index] += change;
    };
    count(binding, 1);
    count(*binding.of, -1);
    for (const Id<ClosedLoop::Shared> id : scope.loop.shared.ids()) {
        const std::string& variable = scope.loop.shared[id].name;
        if (writers[id.index] < 0)
            fail(scope, binding,
                 messages::fault_lacks_output(binding.written->component.where, binding.instance.name,
                                              binding.component->name, variable, binding.of->instance.name));
        if (writers[id.index] > 0)
            fail(scope, binding,
                 messages::second_writer(binding.written->component.where, variable, binding.instance.name,
                                         binding.instance.name));
    }
}

/// Checks that the invariant of the fault's initial location is true when all clocks are 0.
void check_start(LoopScope& scope, Binding& binding) {
    const Component::Location& location = binding.component->locations[binding.instance.initial];
    for (const Component::ClockConstraint& bound : location.invariant) {
        const auto value = value_of(scope, binding, bound.bound);
        if (value && (*value < 0 || (*value == 0 && bound.relation == Op::Less)))
            return fail(
                scope, binding,
                messages::fault_cannot_start(binding.written->component.where, binding.instance.name, location.name));
    }
}

void bind_fault(LoopScope& scope, Binding& binding) {
    if (!bind_constants(scope, binding)) return;
    for (const Id<Parameter> id : binding.component->parameters.ids()) {
        const Component::ParameterKind kind = binding.component->parameters[id].kind;
        if (kind == Component::ParameterKind::Output) bind_output_of_fault(scope, binding, id);
        if (kind == Component::ParameterKind::Input && binding.given[id.index] != nullptr)
            bind_input(scope, binding, id);
    }
    choose_location(scope, binding);
    if (!binding.wrong) check_outputs_of_fault(scope, binding);
    if (!binding.wrong) check_start(scope, binding);
}

/// If the resolution continues after errors, records the names of the parameters and of the initial location in a fault
/// whose instance has errors.
void record_parameters(LoopScope& scope, Binding& binding) {
    if (!scope.record.beyond_errors() || !binding.instance.component.valid()) return;
    bind_constants(scope, binding);
    choose_location(scope, binding);
}

/// Resolves a fault. `bindings` are the instances, in the order of the table of instances of the loop.
void resolve_fault(LoopScope& scope, const tree::Fault& written, const std::vector<Binding>& bindings) {
    const InCopy copy(scope.diagnostics, scope.file, written.behaviour.name);
    Binding binding = begin(scope, written.behaviour, DeclarationKind::Fault, written.where);
    record_arguments(scope, written.behaviour);
    const auto [first, fresh] = scope.faults.try_emplace(scope.text(written.behaviour.name), binding.instance.origin);
    if (!fresh) fail(scope, binding, duplicate(written.behaviour.name, "fault", binding.instance.name, first->second));
    const auto of = scope.instances.find(scope.text(written.of));
    if (of == scope.instances.end() || !of->second.valid()) {
        Nearest nearest(scope.text(written.of));
        if (!scope.diagnostics.full())
            for (const Binding& each : bindings) nearest.offer(each.instance.name);
        scope.diagnostics.add(messages::unknown(written.of.where, "instance", scope.text(written.of), nearest.best()));
        return record_parameters(scope, binding);
    }
    Binding instance = bindings[of->second.index];
    scope.record.refer(written.of.where, instance.instance.origin);
    if (instance.wrong || !binding.instance.component.valid()) return record_parameters(scope, binding);
    instance.instance = scope.loop.instances[of->second];
    binding.of = &instance;
    binding.instance.environment = instance.instance.environment;
    bind_fault(scope, binding);
    if (!binding.wrong) scope.loop.faults.add({of->second, std::move(binding.instance)});
}

}  // namespace

void resolve_instances(LoopScope& scope, const tree::ClosedLoop& written) {
    std::vector<Binding> bindings;
    for (const tree::LoopItem& item : written.items) {
        const auto* instance = std::get_if<tree::Instance>(&item);
        if (instance == nullptr) continue;
        bindings.push_back(bind_instance(scope, *instance));
        if (bindings.back().wrong) excuse(scope, *instance);
        const Id<ClosedLoop::Instance> id = scope.loop.instances.add(bindings.back().instance);
        Id<ClosedLoop::Instance>& known = scope.instances[bindings.back().instance.name];
        if (!known.valid()) known = id;
    }
    for (std::uint32_t index = 0; index < bindings.size(); ++index) {
        Binding& binding = bindings[index];
        const InCopy copy(scope.diagnostics, scope.file, binding.written->name);
        record_arguments(scope, *binding.written);
        if (binding.wrong) continue;
        bind_inputs(scope, binding);
        scope.loop.instances[Id<ClosedLoop::Instance>{index}] = binding.instance;
    }
    for (const tree::LoopItem& item : written.items)
        if (const auto* fault = std::get_if<tree::Fault>(&item)) resolve_fault(scope, *fault, bindings);
}

}  // namespace grafverif
