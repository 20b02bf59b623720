// SPDX-License-Identifier: MIT
// Resolves a closed loop. The controllers declare the shared variables, the instances bind these variables, and the
// properties read them.
#include "ir/program/program.hpp"
#include "support/messages.hpp"
#include "support/messages_program.hpp"
#include "support/overloaded.hpp"
#include "syntax/print/formula.hpp"
#include "syntax/resolve/expand.hpp"
#include "syntax/resolve/loop_scope.hpp"
#include "syntax/resolve/nearest.hpp"
#include "syntax/resolve/resolve.hpp"

namespace grafverif {

Id<ClosedLoop::Shared> shared_named(LoopScope& scope, std::string_view name, const Type& type, Span where) {
    const auto [known, fresh] = scope.shared.try_emplace(std::string(name));
    if (fresh) {
        known->second = scope.loop.shared.add({std::string(name), type, {}, {}, {}, where});
        scope.instance_writers.emplace_back();
    }
    return known->second;
}

namespace {

std::string_view described(const Type& type) { return type.boolean ? "Boolean" : "an integer"; }

/// Returns the value of the word `name`, which must occur in `choices`. Reports any other word, and
/// suggests an allowed word.
template <class Value>
std::optional<Value> choice(LoopScope& scope, tree::Name name, std::string_view kind,
                            std::initializer_list<std::pair<std::string_view, Value>> choices) {
    Nearest nearest(scope.text(name));
    for (const auto& [word, value] : choices) {
        if (scope.text(name) == word) return value;
        nearest.offer(word);
    }
    std::string hint = nearest.best();
    if (hint.empty()) hint = choices.begin()->first;
    scope.diagnostics.add(messages::unknown(name.where, kind, scope.text(name), hint));
    return {};
}

// -- controllers -----------------------------------------------------------------------------------------------------

Id<Chart> chart_named(LoopScope& scope, tree::Name name) {
    const auto found = scope.charts.find(scope.text(name));
    if (found != scope.charts.end())
        return scope.record.refer(name.where, scope.context.model.charts[found->second].origin), found->second;
    scope.incomplete = !scope.record.beyond_errors();
    if (scope.context.charts.in_error.contains(std::string(scope.text(name)))) return {};
    Nearest nearest(scope.text(name));
    for (const Chart& chart : scope.context.model.charts) nearest.offer(chart.name);
    scope.diagnostics.add(messages::unknown(name.where, "chart or program", scope.text(name), nearest.best()));
    return {};
}

void resolve_controller(LoopScope& scope, const tree::Controller& written) {
    const InCopy copy(scope.diagnostics, scope.file, written.name());
    ClosedLoop::Controller controller;
    controller.name = scope.text(written.name());
    controller.chart = written.instance.valid() ? instantiate(scope, written) : chart_named(scope, written.chart);
    controller.origin = written.name().where;
    for (const tree::Name& option : written.options) {
        const auto mode = choice<ExecutionMode>(
            scope, option, "option",
            {{"stability_search", ExecutionMode::StabilitySearch}, {"every_cycle", ExecutionMode::EveryCycle}});
        if (mode) controller.mode = *mode;
    }
    if (!controller.chart.valid()) return;
    if (const Chart& chart = scope.context.model.charts[controller.chart]; chart.program) {
        controller.mode = ExecutionMode::EveryCycle;
        for (const tree::Name& option : written.options)
            if (scope.text(option) == "stability_search")
                scope.diagnostics.add(messages::only_for_charts(option.where, controller.name,
                                                                "only charts have the mode `stability_search`",
                                                                "remove the option"));
    }
    const auto [known, fresh] = scope.controllers.try_emplace(scope.text(written.name()));
    if (!fresh) {
        scope.diagnostics.add(
            duplicate(written.name(), "controller", controller.name, scope.loop.controllers[known->second].origin));
        return;
    }
    known->second = scope.loop.controllers.add(std::move(controller));
}

/// For a program without `every`, sets the task cycle to the interval of its task, if the task has an interval.
void take_interval(LoopScope& scope, const tree::Controller& written) {
    const auto known = scope.controllers.find(scope.text(written.name()));
    if (known == scope.controllers.end() || !scope.chart(known->second).program) return;
    ClosedLoop::Controller& controller = scope.loop.controllers[known->second];
    if (const auto interval = (*scope.chart(known->second).program).interval_ms)
        controller.cycle = TaskCycle{*interval, *interval, controller.origin};
}

/// Resolves the task cycle `every LEAST..MOST` of a controller. If the declaration of the controller has an error, the
/// controller does not exist.
void resolve_cycle(LoopScope& scope, const tree::Controller& written) {
    if (!written.cycle.least.valid()) return take_interval(scope, written);
    const InCopy copy(scope.diagnostics, scope.file, written.name());
    constexpr std::string_view user = "a task cycle";
    const auto bound = [&](Id<tree::Expr> term) {
        return constant_terms(scope, user).constant(term, TermKind::Duration, user);
    };
    const auto least = bound(written.cycle.least);
    const auto most = written.cycle.most.valid() ? bound(written.cycle.most) : least;
    if (!least || !most) return;
    if (*least <= 0 || *most < *least)
        return scope.diagnostics.add(messages::bad_task_cycle(written.cycle.where, *least, *most));
    const auto controller = scope.controllers.find(scope.text(written.name()));
    if (controller != scope.controllers.end())
        scope.loop.controllers[controller->second].cycle = TaskCycle{*least, *most, written.cycle.where};
}

/// Records that a variable of a controller is a shared variable. If the controller is an instance of a chart, the
/// position of the variable is the position of the argument.
void record_shared(const LoopScope& scope, const Chart& chart, const Chart::Variable& variable,
                   const ClosedLoop::Shared& known) {
    if (chart.instance_of.empty()) return scope.record.share(variable.origin, known.origin);
    const bool writes = variable.kind == Chart::VariableKind::Output;
    if (known.origin.source == variable.origin.source && known.origin.begin == variable.origin.begin)
        scope.record.declare(DeclarationKind::PlantVariable, variable.name, variable.origin, variable.origin,
                             scope.loop.origin);
    scope.record.refer(variable.origin, known.origin, writes);
}

void share_input(LoopScope& scope, Id<ClosedLoop::Controller> controller, Id<Chart::Variable> id) {
    const Chart::Variable& variable = scope.chart(controller).variables[id];
    const Id<ClosedLoop::Shared> shared = shared_named(scope, variable.name, variable.type, variable.origin);
    ClosedLoop::Shared& known = scope.loop.shared[shared];
    record_shared(scope, scope.chart(controller), variable, known);
    const Span where =
        scope.chart(controller).instance_of.empty() ? scope.loop.controllers[controller].origin : variable.origin;
    if (known.type.boolean != variable.type.boolean) {
        scope.diagnostics.add(
            messages::argument_type(where, variable.name, described(variable.type), described(known.type)));
        return;
    }
    const bool covers = variable.type.low <= known.type.low && known.type.high <= variable.type.high;
    if (known.writer.valid() && !covers)
        scope.diagnostics.add(messages::range_mismatch(where, variable.name, known.type.low, known.type.high,
                                                       variable.type.low, variable.type.high));
    if (!known.writer.valid() && known.reader.valid() && known.type != variable.type)
        scope.diagnostics.add(messages::range_mismatch(where, variable.name, known.type.low, known.type.high,
                                                       variable.type.low, variable.type.high));
    if (!known.reader.valid()) known.reader = controller;
    if (!known.variable.valid()) known.variable = id;
}

void share_output(LoopScope& scope, Id<ClosedLoop::Controller> controller, Id<Chart::Variable> id) {
    const Chart::Variable& variable = scope.chart(controller).variables[id];
    const Id<ClosedLoop::Shared> shared = shared_named(scope, variable.name, variable.type, variable.origin);
    ClosedLoop::Shared& known = scope.loop.shared[shared];
    record_shared(scope, scope.chart(controller), variable, known);
    if (known.writer.valid()) {
        scope.diagnostics.add(messages::second_writer(scope.loop.controllers[controller].origin, variable.name,
                                                      scope.loop.controllers[known.writer].name,
                                                      scope.loop.controllers[controller].name));
        return;
    }
    known.writer = controller;
    known.variable = id;
}

/// Declares the shared variables of all controllers: first the outputs, because the writer of a variable determines its
/// range, then the inputs.
void share_variables(LoopScope& scope) {
    for (const Chart::VariableKind kind : {Chart::VariableKind::Output, Chart::VariableKind::Input}) {
        for (const Id<ClosedLoop::Controller> controller : scope.loop.controllers.ids()) {
            for (const Id<Chart::Variable> id : scope.chart(controller).variables.ids()) {
                if (scope.chart(controller).variables[id].kind != kind) continue;
                if (kind == Chart::VariableKind::Output) share_output(scope, controller, id);
                else share_input(scope, controller, id);
            }
        }
    }
}

void search_inside(LoopScope& scope) {
    for (const Id<ClosedLoop::Controller> controller : scope.loop.controllers.ids()) {
        const Chart& chart = scope.chart(controller);
        LoopScope::Inside& inside = scope.inside.emplace_back();
        for (const Id<Chart::Step> step : chart.steps.ids()) inside.steps[chart.steps[step].name].push_back(step);
        for (const Id<Chart::Variable> id : chart.variables.ids())
            if (chart.variables[id].kind == Chart::VariableKind::Internal)
                inside.internals.emplace(chart.variables[id].name, id);
        for (const Id<Chart::PartialChart> id : chart.partial_charts.ids())
            if (!chart.partial_charts[id].name.empty()) inside.partials.emplace(chart.partial_charts[id].name, id);
    }
}

// -- the other declarations -------------------------------------------------------------------------------------------

void resolve_time_unit(LoopScope& scope, const tree::TimeUnit& written) {
    if (scope.loop.time_unit_ms) scope.diagnostics.add(messages::declared_twice(written.where, "time unit"));
    const auto unit =
        constant_terms(scope, "a time unit").constant(written.duration, TermKind::Duration, "a time unit");
    if (!unit) return;
    if (*unit == 0) scope.diagnostics.add(messages::zero_duration(scope.file.exprs[written.duration].where));
    scope.loop.time_unit_ms = *unit;
    scope.loop.time_unit_origin = written.where;
}

void resolve_grain(LoopScope& scope, const tree::Grain& written, bool& seen) {
    if (seen) scope.diagnostics.add(messages::declared_twice(written.where, "grain"));
    seen = true;
    const auto grain =
        choice<Grain>(scope, written.name, "grain", {{"phased", Grain::Phased}, {"atomic", Grain::Atomic}});
    if (grain) scope.loop.grain = *grain;
}

void resolve_schedule(LoopScope& scope, const tree::Schedule& written) {
    if (scope.loop.schedule) scope.diagnostics.add(messages::declared_twice(written.where, "schedule"));
    scope.loop.schedule = choice<Schedule>(scope, written.name, "schedule",
                                           {{"interleaved", Schedule::Interleaved},
                                            {"synchronous", Schedule::Synchronous},
                                            {"sequenced", Schedule::Sequenced}});
}

/// Checks a formula in the language of an external tool, because the formula is copied unchanged
/// into models.
void check_formula(LoopScope& scope, const tree::Property& written) {
    const auto language = formula_language(written.pattern);
    if (!language) return;
    const Span where = written.raw_where;
    if (written.at_stable) scope.diagnostics.add(messages::formula_at_stable(where));
    const auto fault = formula_fault(*language, written.raw);
    if (!fault) return;
    const auto inner = static_cast<std::uint32_t>(where.begin + 1);  // position after the opening quote
    const Span there{where.source, inner + static_cast<std::uint32_t>(fault->begin),
                     inner + static_cast<std::uint32_t>(fault->end)};
    scope.diagnostics.add(messages::bad_formula(there, word(*language), fault->what));
}

std::int64_t duration_of(LoopScope& scope, Id<tree::Expr> written) {
    constexpr std::string_view user = "the duration of a property";
    const auto duration = constant_terms(scope, user).constant(written, TermKind::Duration, user);
    if (duration && *duration <= 0) scope.diagnostics.add(messages::zero_duration(scope.file.exprs[written].where));
    return duration.value_or(0);
}

std::int64_t count_of(LoopScope& scope, Id<tree::Expr> written) {
    constexpr std::string_view user = "the count of a property";
    const auto count = constant_terms(scope, user).constant(written, TermKind::Integer, user);
    if (count && (*count < 1 || *count > greatest_count))
        scope.diagnostics.add(messages::bad_count(scope.file.exprs[written].where, *count, greatest_count));
    return count.value_or(0);
}

void resolve_property(LoopScope& scope, const tree::Property& written,
                      std::unordered_map<std::string_view, Span>& names) {
    const InCopy copy(scope.diagnostics, scope.file, written.name);
    const auto [known, fresh] = names.try_emplace(scope.text(written.name), written.name.where);
    scope.record.declare(DeclarationKind::Property, scope.text(written.name), written.name.where, written.where,
                         scope.loop.origin);
    if (!fresh) scope.diagnostics.add(duplicate(written.name, "property", scope.text(written.name), known->second));
    Property property;
    property.name = scope.text(written.name);
    property.text = written.text;
    property.pattern = written.pattern;
    property.raw = written.raw;
    property.watch = written.watch;
    if (written.bound.valid()) {  // after an error, the count may be missing
        if (property.watch.kind == Sentence::Kind::Occurrences) property.watch.count = count_of(scope, written.bound);
        else property.watch.duration_ms = duration_of(scope, written.bound);
    }
    property.at_stable = written.at_stable;
    property.expected_violated = written.expected_violated;
    property.origin = written.name.where;
    check_formula(scope, written);
    Terms terms = property_terms(scope);
    for (const Id<tree::Expr> node : written.operands) {
        const Id<Expr> operand = terms.resolve(node, TermKind::Boolean, "a property");
        if (operand.valid()) property.operands.push_back(operand);
    }
    scope.loop.properties.add(std::move(property));
}

void resolve_queries(LoopScope& scope, const tree::ClosedLoop& written) {
    std::unordered_map<std::string_view, Span> names;
    bool grain = false;
    if (!scope.incomplete) declare_observers(scope, written);
    for (const tree::LoopItem& item : written.items) {
        std::visit(overloaded{
                       [&](const tree::Controller& controller) { resolve_cycle(scope, controller); },
                       [](const tree::Variables&) {},
                       [](const tree::Instance&) {},
                       [](const tree::Fault&) {},
                       [&](const tree::Grain& chosen) { resolve_grain(scope, chosen, grain); },
                       [&](const tree::TimeUnit& unit) { resolve_time_unit(scope, unit); },
                       [&](const tree::Property& property) {
                           if (!scope.incomplete) resolve_property(scope, property, names);
                       },
                       [](const tree::Constraint&) {},
                       [](const tree::Observer&) {},
                       [&](const tree::Schedule& chosen) { resolve_schedule(scope, chosen); },
                       [](const tree::ReplicatedLoopItems&) {},  // already expanded
                       [&](const tree::Accept& accept) {
                           scope.diagnostics.add(messages::not_yet(accept.where, "`accept` outside a chart"));
                       },
                   },
                   item);
    }
    if (scope.incomplete) return;
    resolve_observers(scope, written);
    resolve_constraints(scope, written);
}

/// Checks that every input of a controller is driven by another controller or an instance.
void check_driven(LoopScope& scope, Span loop) {
    for (const Id<ClosedLoop::Shared> id : scope.loop.shared.ids()) {
        const ClosedLoop::Shared& shared = scope.loop.shared[id];
        if (!shared.reader.valid() || shared.writer.valid() || !scope.instance_writers[id.index].empty()) continue;
        if (scope.excused.contains(shared.name)) continue;
        scope.diagnostics.add(messages::undriven_input(scope.loop.controllers[shared.reader].origin, shared.name,
                                                       scope.loop.controllers[shared.reader].name, shared.type.boolean,
                                                       loop));
    }
}

/// Reports a controller that is an instance of a chart and has the name of an instance of a component or of an
/// observer, because properties could not distinguish them.
void check_controller_names(LoopScope& scope) {
    for (const ClosedLoop::Controller& controller : scope.loop.controllers) {
        if (scope.context.model.charts[controller.chart].instance_of.empty()) continue;
        const auto instance = scope.written_instances.find(controller.name);
        const auto observer = scope.observers.find(controller.name);
        if (instance != scope.written_instances.end())
            scope.diagnostics.add(
                messages::duplicate_name(controller.origin, "instance", controller.name, instance->second->name.where));
        else if (observer != scope.observers.end())
            scope.diagnostics.add(messages::duplicate_name(controller.origin, "instance", controller.name,
                                                           scope.loop.observers[observer->second].origin));
    }
}

/// Resolves all declarations except constants, which have been resolved before.
void resolve_items(LoopScope& scope, const tree::ClosedLoop& written) {
    bool controlled = false;
    for (const tree::LoopItem& item : written.items)
        if (const auto* instance = std::get_if<tree::Instance>(&item))
            scope.written_instances.emplace(scope.text(instance->name), instance);
    for (const tree::LoopItem& item : written.items) {
        const auto* controller = std::get_if<tree::Controller>(&item);
        if (controller == nullptr) continue;
        controlled = true;
        resolve_controller(scope, *controller);
    }
    if (!controlled) scope.diagnostics.add(messages::no_controller(written.name.where, scope.loop.name));
    share_variables(scope);
    search_inside(scope);
    resolve_instances(scope, written);
    check_constant_names(scope);
    resolve_queries(scope, written);
    check_controller_names(scope);
    if (!scope.incomplete) check_driven(scope, written.where);
}

/// Returns the position of the declaration of a name that terms of the loop can contain; empty if the name is not
/// declared.
std::optional<Span> declared_name(const LoopScope& scope, std::string_view name) {
    if (const auto constant = scope.constants.find(name); constant != scope.constants.end())
        return constant->second.where;
    if (const auto instance = scope.instances.find(name); instance != scope.instances.end())
        return scope.loop.instances[instance->second].origin;
    if (const auto observer = scope.observers.find(name); observer != scope.observers.end())
        return scope.loop.observers[observer->second].origin;
    if (const auto controller = scope.controllers.find(name); controller != scope.controllers.end())
        return scope.loop.controllers[controller->second].origin;
    for (const Id<ClosedLoop::Controller> id : scope.loop.controllers.ids()) {
        if (id.index >= scope.inside.size()) break;  // occurs only after an error in the expansion
        const auto& partials = scope.inside[id.index].partials;
        if (const auto partial = partials.find(name); partial != partials.end())
            return scope.chart(id).partial_charts[partial->second].origin;
    }
    return variable_named(scope, name);
}

}  // namespace

std::optional<ClosedLoop> resolve_loop(const tree::File& file, const tree::ClosedLoop& written,
                                       const LoopContext& context, Diagnostics& diagnostics, Recorder record,
                                       std::uint64_t* copied) {
    const std::size_t errors = diagnostics.errors();
    tree::File copies;
    LoopScope scope{written.replicated ? copies : file, context, diagnostics, record};
    scope.copied = copied;
    scope.loop.name = file.text(written.name);
    scope.loop.origin = written.name.where;
    record.declare(DeclarationKind::Loop, scope.loop.name, written.name.where, written.where);
    for (const Id<Chart> id : context.model.charts.ids()) scope.charts.emplace(context.model.charts[id].name, id);
    for (const Id<Component> id : context.model.components.ids())
        scope.components.emplace(context.model.components[id].name, id);
    announce_constants(scope, file, written);
    if (!written.replicated)
        for (const tree::LoopItem& item : written.items)
            if (const auto* constants = std::get_if<tree::Variables>(&item)) resolve_constants(scope, *constants);
    Expansion expansion{file, copies, diagnostics, record, scope.loop.origin};
    expansion.copied = copied;
    expansion.constant_terms = [&](std::string_view user) { return constant_terms(scope, user); };
    expansion.constants = [&](const tree::Variables& constants) { resolve_constants(scope, constants); };
    resolve_expanded(expansion, written, [&](const tree::ClosedLoop& all) { resolve_items(scope, all); });
    check_indices(expansion, [&](std::string_view name) { return declared_name(scope, name); });
    if (scope.incomplete || diagnostics.errors() != errors) return {};
    return std::move(scope.loop);
}

}  // namespace grafverif
