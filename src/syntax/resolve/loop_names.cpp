// SPDX-License-Identifier: MIT
// Resolves names in the properties of a closed loop: shared variables, internal variables and steps of its controllers,
// locations of its instances.
#include <algorithm>
#include <optional>

#include "ir/program/interface.hpp"
#include "support/messages.hpp"
#include "support/messages_notation.hpp"
#include "support/messages_program.hpp"
#include "support/overloaded.hpp"
#include "syntax/resolve/loop_scope.hpp"
#include "syntax/resolve/nearest.hpp"
#include "syntax/st/st_tree.hpp"

namespace grafverif {

namespace {

using Controller = ClosedLoop::Controller;

Term symbol_term(LoopScope& scope, const ClosedLoop::Symbol& symbol, bool boolean = true) {
    const auto key = std::visit(
        overloaded{
            [](const ClosedLoop::SharedSymbol& of) { return "v" + std::to_string(of.shared.index); },
            [](const ClosedLoop::InternalSymbol& of) {
                return "i" + std::to_string(of.controller.index) + '.' + std::to_string(of.variable.index);
            },
            [](const ClosedLoop::StepSymbol& of) {
                return "s" + std::to_string(of.controller.index) + '.' + std::to_string(of.step.index);
            },
            [](const ClosedLoop::OwnSymbol& of) {
                return "w" + std::to_string(of.instance.index) + '.' + std::to_string(of.variable.index);
            },
            [](const ClosedLoop::TimeSymbol& of) {
                const bool action = !of.condition.valid();
                return (action ? "a" : "t") + std::to_string(of.controller.index) + '.' +
                       std::to_string(action ? of.step.index : of.condition.index) + '.' + std::to_string(of.rise_ms);
            },
            [](const ClosedLoop::LocationSymbol& of) {
                return "l" + std::to_string(of.instance.index) + '.' + std::to_string(of.location.index);
            },
            [](const ClosedLoop::ObserverSymbol& of) {
                return "o" + std::to_string(of.observer.index) + '.' + std::to_string(of.location.index);
            },
        },
        symbol);
    const auto [known, fresh] = scope.symbols.try_emplace(key);
    if (fresh) known->second = scope.loop.symbols.add(symbol);
    return {scope.loop.exprs.leaf(Op::Variable, known->second.index), boolean ? TermKind::Boolean : TermKind::Integer};
}

Term internal_term(LoopScope& scope, Id<Controller> controller, Id<Chart::Variable> variable) {
    return symbol_term(scope, ClosedLoop::InternalSymbol{controller, variable},
                       scope.chart(controller).variables[variable].type.boolean);
}

/// Returns the name qualified by the name of its controller. The qualified name is unambiguous in properties.
std::string qualified(const LoopScope& scope, Id<Controller> controller, std::string_view name) {
    return scope.loop.controllers[controller].name + '.' + std::string(name);
}

Term unknown_name(LoopScope& scope, Span where, std::string_view name) {
    const bool step_like = name.size() > 1 && name[0] == 'X' && name[1] >= '0' && name[1] <= '9';
    if (scope.diagnostics.full())
        return scope.diagnostics.add(messages::unknown(where, step_like ? "step" : "variable", name, "")), Term{};
    Nearest nearest(name);
    for (const ClosedLoop::Shared& shared : scope.loop.shared) nearest.offer(shared.name);
    for (const NamedConstant& constant : scope.loop.constants) nearest.offer(constant.name);
    for (const Id<Controller> controller : scope.loop.controllers.ids()) {
        const Chart& chart = scope.chart(controller);
        for (const Chart::Variable& variable : chart.variables)
            if (variable.kind == Chart::VariableKind::Internal) nearest.offer(variable.name);
        if (name[0] == 'X' || name[0] == 'x')
            for (const Chart::Step& step : chart.steps) nearest.offer('X', step.name);
    }
    scope.diagnostics.add(messages::unknown(where, step_like ? "step" : "variable", name, nearest.best()));
    return {};
}

/// Returns the internal variable `name` of a controller; empty if the controller has no such variable. Variable names
/// of programs are compared case-insensitively.
std::optional<Id<Chart::Variable>> internal_named(const LoopScope& scope, Id<Controller> controller,
                                                  std::string_view name) {
    const auto& internals = scope.inside[controller.index].internals;
    if (const auto known = internals.find(name); known != internals.end()) return known->second;
    if (!scope.chart(controller).program) return {};
    for (const auto& [known, variable] : internals)
        if (known.size() == name.size() && st::capitals(known) == st::capitals(name)) return variable;
    return {};
}

/// Reports a name such as `XFill` or `Tank.XFill` that denotes both a variable and a step of a program.
bool report_step_or_variable(LoopScope& scope, Id<Controller> controller, std::string_view name, Span where) {
    const Chart& chart = scope.chart(controller);
    const std::size_t dot = name.rfind('.');
    const std::string_view owner = name.substr(0, dot == std::string_view::npos ? 0 : dot);
    const std::string_view last = name.substr(dot == std::string_view::npos ? 0 : dot + 1);
    if (!chart.program || last.size() < 2 || last[0] != 'X') return false;
    const auto& known = scope.inside[controller.index].steps;
    const auto steps = known.find(last.substr(1));
    if (steps == known.end()) return false;
    for (const Id<Chart::Step> step : steps->second) {
        const std::string& partial = chart.partial_charts[chart.steps[step].chart].name;
        if (!owner.empty() && partial != owner) continue;
        const std::string path = (partial.empty() ? "" : partial + '.') + chart.steps[step].name;
        return scope.diagnostics.add(messages::step_or_variable(where, name, path)), true;
    }
    return false;
}

/// Resolves a step variable such as `X2`, or an internal variable, of one controller; if `partial` is set, only in this
/// partial chart.
std::optional<Term> inside(LoopScope& scope, Id<Controller> controller, std::string_view name,
                           std::optional<Id<Chart::PartialChart>> partial, Span where) {
    const LoopScope::Inside& known = scope.inside[controller.index];
    const Chart& chart = scope.chart(controller);
    // The names of internal variables are qualified: for example, `N` of the partial chart `Head[1]` (an instance of a
    // chart) has the name `Head[1].N`.
    const std::string owner = partial ? chart.partial_charts[*partial].name : "";
    const auto internal =
        internal_named(scope, controller, owner.empty() ? std::string(name) : owner + '.' + std::string(name));
    if (internal) {
        if (report_step_or_variable(scope, controller, name, where)) return Term{};
        scope.record.refer(last_name(where, name), chart.variables[*internal].origin);
        return internal_term(scope, controller, *internal);
    }
    const auto steps = name.size() > 1 && name[0] == 'X' ? known.steps.find(name.substr(1)) : known.steps.end();
    if (steps == known.steps.end()) return {};
    std::vector<Id<Chart::Step>> meant;
    for (const Id<Chart::Step> step : steps->second)
        if (!partial || chart.steps[step].chart == *partial) meant.push_back(step);
    if (meant.empty()) return {};
    if (meant.size() == 1) {
        scope.record.refer(last_name(where, name), chart.steps[meant.front()].origin);
        return symbol_term(scope, ClosedLoop::StepSymbol{controller, meant.front()});
    }
    scope.diagnostics.add(messages::ambiguous(where, name, qualified(scope, controller, step_variable(chart, meant[0])),
                                              qualified(scope, controller, step_variable(chart, meant[1]))));
    return Term{};
}

Term own_term(LoopScope& scope, Id<ClosedLoop::Instance> instance, Id<Component::Variable> variable) {
    const Component& component = scope.context.model.components[scope.loop.instances[instance].component];
    return symbol_term(scope, ClosedLoop::OwnSymbol{instance, variable},
                       component.variables[variable].value == Component::ValueKind::Boolean);
}

/// Resolves a name such as `Gate_X`, by which traces and models denote the variable `X` of the instance `Gate`.
std::optional<Term> display_name(LoopScope& scope, Span where, std::string_view name) {
    for (const Id<ClosedLoop::Instance> id : scope.loop.instances.ids()) {
        const ClosedLoop::Instance& instance = scope.loop.instances[id];
        if (!instance.component.valid() || !name.starts_with(instance.name + '_')) continue;
        const Component& component = scope.context.model.components[instance.component];
        for (const Id<Component::Variable> variable : component.variables.ids()) {
            const Component::Variable& own = component.variables[variable];
            if (own.name != name.substr(instance.name.size() + 1)) continue;
            const auto middle = static_cast<std::uint32_t>(where.begin + instance.name.size());
            scope.record.refer({where.source, where.begin, middle}, instance.origin);
            scope.record.refer({where.source, middle + 1, where.end}, own.origin);
            return own_term(scope, id, variable);
        }
    }
    return {};
}

Term simple_name(LoopScope& scope, Span where, std::string_view name) {
    if (const auto constant = constant_named(scope, name, where)) return *constant;
    const auto shared = scope.shared.find(std::string(name));
    if (shared != scope.shared.end()) {
        scope.record.refer(where, scope.loop.shared[shared->second].origin);
        for (const Id<Controller> controller : scope.loop.controllers.ids())
            if (report_step_or_variable(scope, controller, name, where)) return {};
        return symbol_term(scope, ClosedLoop::SharedSymbol{shared->second},
                           scope.loop.shared[shared->second].type.boolean);
    }
    std::optional<Term> found;
    Id<Controller> owner;
    for (const Id<Controller> controller : scope.loop.controllers.ids()) {
        const auto term = inside(scope, controller, name, {}, where);
        if (!term) continue;
        if (term->kind == TermKind::Wrong) return {};
        if (found) {
            scope.diagnostics.add(
                messages::ambiguous(where, name, qualified(scope, owner, name), qualified(scope, controller, name)));
            return {};
        }
        found = term;
        owner = controller;
    }
    if (found) return *found;
    if (const auto own = display_name(scope, where, name)) return *own;
    if (scope.excused.contains(name)) return {};  // an instance that contains an error may declare the name
    return unknown_name(scope, where, name);
}

// -- `owner.name` -----------------------------------------------------------------------------------------------------

/// Resolves `name` to an internal variable of the instance, or to the variable or term that is bound to the output or
/// input `name` of the instance.
std::optional<Term> variable_of(LoopScope& scope, Id<ClosedLoop::Instance> instance, const Component& component,
                                std::string_view name, Span where) {
    for (const Id<Component::Variable> variable : component.variables.ids()) {
        if (component.variables[variable].name != name) continue;
        scope.record.refer(where, component.variables[variable].origin);
        return own_term(scope, instance, variable);
    }
    for (const Id<Component::Parameter> id : component.parameters.ids()) {
        if (component.parameters[id].name != name) continue;
        scope.record.refer(where, component.parameters[id].origin);
        const auto& argument = scope.loop.instances[instance].arguments[id.index];
        if (const auto* shared = std::get_if<Id<ClosedLoop::Shared>>(&argument))
            return symbol_term(scope, ClosedLoop::SharedSymbol{*shared}, scope.loop.shared[*shared].type.boolean);
        const bool boolean = component.parameters[id].value == Component::ValueKind::Boolean;
        if (const auto* term = std::get_if<Id<Expr>>(&argument))
            return Term{*term, boolean ? TermKind::Boolean : TermKind::Integer};
    }
    return {};
}

/// Resolves a name of an instance. `Gate in open` denotes a location. `Gate.open` denotes a location or, if no location
/// has this name, a variable.
Term state_of(LoopScope& scope, Id<ClosedLoop::Instance> instance, std::string_view name, const tree::Expr& node) {
    const Span where = node.where, last = last_name(where, name);
    const Id<Component> id = scope.loop.instances[instance].component;
    if (!id.valid()) return {};
    const Component& component = scope.context.model.components[id];
    Nearest nearest(name);
    for (const Id<Component::Location> location : component.locations.ids()) {
        if (component.locations[location].name == name) {
            scope.record.refer(last, component.locations[location].origin);
            return symbol_term(scope, ClosedLoop::LocationSymbol{instance, location});
        }
        nearest.offer(component.locations[location].name);
    }
    const bool place = node.op == tree::Op::In;
    if (!place) {
        if (const auto variable = variable_of(scope, instance, component, name, last)) return *variable;
        for (const Component::Variable& variable : component.variables) nearest.offer(variable.name);
    }
    for (const Component::Clock& clock : component.clocks) {
        if (clock.name != name) continue;
        scope.record.refer(last, clock.origin);
        scope.diagnostics.add(messages::clock_in_property(where, name));
        return {};
    }
    scope.diagnostics.add(
        messages::unknown_location(where, name, nearest.best(), component.name, location_list(component)));
    return {};
}

Term observed(LoopScope& scope, Id<ClosedLoop::Observer> observer, std::string_view name, Span where) {
    Nearest nearest(name);
    const Table<ClosedLoop::ObserverLocation>& locations = scope.loop.observers[observer].locations;
    for (const Id<ClosedLoop::ObserverLocation> location : locations.ids()) {
        if (locations[location].name == name) {
            scope.record.refer(last_name(where, name), locations[location].origin);
            return symbol_term(scope, ClosedLoop::ObserverSymbol{observer, location});
        }
        nearest.offer(locations[location].name);
    }
    scope.diagnostics.add(messages::unknown(where, "location", name, nearest.best()));
    return {};
}

Term inside_or_unknown(LoopScope& scope, Id<Controller> controller, std::string_view name,
                       std::optional<Id<Chart::PartialChart>> partial, Span where) {
    if (const auto term = inside(scope, controller, name, partial, where)) return *term;
    return unknown_name(scope, where, name);
}

/// Reports terms of IEC 61131-3 such as `X2.T`, `Fill.T` and `Fill.X` if a controller has the steps `2` and `Fill`.
bool report_step_member(LoopScope& scope, std::string_view owner, std::string_view member, Span where) {
    if (!is_step_member(member)) return false;
    for (const LoopScope::Inside& inside : scope.inside) {
        const bool is_variable = owner.starts_with('X') && inside.steps.contains(owner.substr(1));
        if (!is_variable && !inside.steps.contains(owner)) continue;
        const std::string variable = is_variable ? std::string(owner) : 'X' + std::string(owner);
        return scope.diagnostics.add(messages::step_member(where, variable, member)), true;
    }
    return false;
}

/// Returns the name of a memory cell of a program, such as `T1.Q`. If `node` does not consist only of names, returns an
/// empty string.
std::string cell_path(const LoopScope& scope, const tree::Expr& node) {
    if (node.op == tree::Op::Name) return std::string(scope.file.text(node.word));
    if (node.op != tree::Op::Member) return {};
    const std::string owner = cell_path(scope, scope.file.exprs[node.first]);
    return owner.empty() ? "" : owner + '.' + std::string(scope.file.text(node.word));
}

/// Records the qualifiers in the path `node`, which denotes the memory cell `cell` of a program: instances, structures
/// and, if the path begins with its name, the controller.
void record_owners(const LoopScope& scope, const Chart& chart, const tree::Expr& node, std::string_view cell) {
    std::vector<const tree::Expr*> owners;
    for (const tree::Expr* each = &node; each->op == tree::Op::Member; owners.push_back(each))
        each = &scope.file.exprs[each->first];
    std::vector<Span> declarations = declarations_in(*chart.program, cell);
    const std::size_t inside = static_cast<std::size_t>(std::ranges::count(cell, '.'));
    if (owners.size() > inside) declarations.insert(declarations.begin(), chart.origin);
    for (std::size_t k = 0; k < owners.size() && k < declarations.size(); ++k) {
        const tree::Expr& owner = *owners[owners.size() - 1 - k];
        scope.record.refer(last_name(owner.where, scope.file.text(owner.word)), declarations[k]);
    }
}

/// Resolves a member of a function block or a structure of a program, such as `T1.Q` or `drive.T1.Q`; empty if no
/// program has this member.
std::optional<Term> cell_term(LoopScope& scope, const tree::Expr& node) {
    const std::string path = cell_path(scope, node);
    std::optional<Term> found;
    Id<Controller> owner;
    for (const Id<Controller> controller : scope.loop.controllers.ids()) {
        if (!scope.chart(controller).program) continue;
        const std::string prefix = scope.loop.controllers[controller].name + '.';
        std::optional<Term> term;
        for (const std::string& name : {path, path.starts_with(prefix) ? path.substr(prefix.size()) : path}) {
            const auto cell = internal_named(scope, controller, name);
            if (!cell) continue;
            if (report_step_or_variable(scope, controller, name, node.where)) return Term{};
            const std::string_view member = scope.file.text(node.word);
            scope.record.refer(last_name(node.where, member), scope.chart(controller).variables[*cell].origin);
            record_owners(scope, scope.chart(controller), node, name);
            term = internal_term(scope, controller, *cell);
            break;
        }
        if (!term) continue;
        if (found) {
            scope.diagnostics.add(messages::ambiguous(node.where, path, qualified(scope, owner, path),
                                                      qualified(scope, controller, path)));
            return Term{};
        }
        found = term;
        owner = controller;
    }
    return found;
}

/// Resolves a name such as `G2.X2` if exactly one controller has a partial chart `G2`.
Term in_partial_chart(LoopScope& scope, const tree::Expr& owner, std::string_view name, Span where) {
    const std::string_view partial = scope.file.text(owner.word);
    std::optional<Id<Controller>> found;
    for (const Id<Controller> controller : scope.loop.controllers.ids()) {
        if (!scope.inside[controller.index].partials.contains(partial)) continue;
        if (found) {
            scope.diagnostics.add(messages::ambiguous(where, partial, qualified(scope, *found, partial),
                                                      qualified(scope, controller, partial)));
            return {};
        }
        found = controller;
    }
    if (found) {
        const Id<Chart::PartialChart> id = scope.inside[found->index].partials.at(partial);
        scope.record.refer(owner.where, scope.chart(*found).partial_charts[id].origin);
        return inside_or_unknown(scope, *found, name, id, where);
    }
    if (report_step_member(scope, partial, name, where)) return {};
    Nearest nearest(partial);
    if (!scope.diagnostics.full()) {
        for (const auto& instance : scope.loop.instances) nearest.offer(instance.name);
        for (const auto& observer : scope.loop.observers) nearest.offer(observer.name);
        for (const auto& controller : scope.loop.controllers) nearest.offer(controller.name);
    }
    scope.diagnostics.add(messages::unknown(owner.where, "instance", partial, nearest.best()));
    return {};
}

Term no_such_instance(LoopScope& scope, const tree::Expr& owner) {
    const std::string_view name = scope.file.text(owner.word);
    Nearest nearest(name);
    if (!scope.diagnostics.full()) {
        for (const auto& instance : scope.loop.instances) nearest.offer(instance.name);
        for (const auto& observer : scope.loop.observers) nearest.offer(observer.name);
    }
    scope.diagnostics.add(messages::unknown(owner.where, "instance", name, nearest.best()));
    return {};
}

Term member_name(LoopScope& scope, const tree::Expr& node) {
    const tree::Expr& owner = scope.file.exprs[node.first];
    const std::string_view name = scope.file.text(node.word);
    if (owner.op == tree::Op::Name) {
        const auto instance = scope.instances.find(scope.file.text(owner.word));
        if (instance != scope.instances.end())
            return scope.record.refer(owner.where, scope.loop.instances[instance->second].origin),
                   state_of(scope, instance->second, name, node);
        const auto observer = scope.observers.find(scope.file.text(owner.word));
        if (observer != scope.observers.end())
            return scope.record.refer(owner.where, scope.loop.observers[observer->second].origin),
                   observed(scope, observer->second, name, node.where);
        if (node.op == tree::Op::In) return no_such_instance(scope, owner);
        const auto controller = scope.controllers.find(scope.file.text(owner.word));
        if (controller != scope.controllers.end()) {
            const Chart& chart = scope.chart(controller->second);
            scope.record.refer(owner.where, chart.origin);
            // If several steps have the same name, `chart.X2` denotes the step that is declared directly in the chart.
            const auto& steps = scope.inside[controller->second.index].steps;
            const auto same = name.size() > 1 ? steps.find(name.substr(1)) : steps.end();
            const bool repeated = name[0] == 'X' && same != steps.end() && same->second.size() > 1;
            if (repeated && chart.partial_charts[Id<Chart::PartialChart>{0}].name.empty())
                return inside_or_unknown(scope, controller->second, name, Id<Chart::PartialChart>{0}, node.where);
            return inside_or_unknown(scope, controller->second, name, {}, node.where);
        }
        if (const auto cell = cell_term(scope, node)) return *cell;
        return in_partial_chart(scope, owner, name, node.where);
    }
    if (const auto cell = node.op == tree::Op::Member ? cell_term(scope, node) : std::nullopt) return *cell;
    if (node.op == tree::Op::In) return no_such_instance(scope, owner);
    const tree::Expr& outer = scope.file.exprs[owner.first];
    const auto controller =
        outer.op == tree::Op::Name ? scope.controllers.find(scope.file.text(outer.word)) : scope.controllers.end();
    if (controller == scope.controllers.end()) {
        scope.diagnostics.add(messages::unknown(outer.where, "controller",
                                                scope.file.text(outer.word.valid() ? outer.word : owner.word), ""));
        return {};
    }
    scope.record.refer(outer.where, scope.chart(controller->second).origin);
    const auto& partials = scope.inside[controller->second.index].partials;
    const auto partial = partials.find(scope.file.text(owner.word));
    if (partial == partials.end()) {
        if (report_step_member(scope, scope.file.text(owner.word), name, node.where)) return {};
        Nearest nearest(scope.file.text(owner.word));
        for (const Chart::PartialChart& known : scope.chart(controller->second).partial_charts)
            if (!known.name.empty()) nearest.offer(known.name);
        scope.diagnostics.add(
            messages::unknown(owner.where, "partial chart", scope.file.text(owner.word), nearest.best()));
        return {};
    }
    scope.record.refer(last_name(owner.where, partial->first),
                       scope.chart(controller->second).partial_charts[partial->second].origin);
    return inside_or_unknown(scope, controller->second, name, partial->second, node.where);
}

/// Reports an invalid name in a term that is bound to an input: the name is unknown, or it is internal to a controller
/// or an instance.
Term no_signal(LoopScope& scope, const tree::Expr& node, std::string_view name) {
    if (node.op != tree::Op::Name) {
        const std::string_view owner = scope.file.text(scope.file.exprs[node.first].word);
        const bool instance = scope.instances.contains(owner);
        scope.diagnostics.add(
            messages::no_signal(node.where, name, instance ? "part of an instance" : "part of a chart"));
        return {};
    }
    for (const LoopScope::Inside& inside : scope.inside) {
        const bool step = name.size() > 1 && name[0] == 'X' && inside.steps.contains(name.substr(1));
        if (!step && !inside.internals.contains(name)) continue;
        scope.diagnostics.add(messages::no_signal(node.where, name, step ? "a step" : "an internal variable"));
        return {};
    }
    if (scope.incomplete || scope.excused.contains(name)) return {};
    Nearest nearest(name);
    if (!scope.diagnostics.full()) {
        for (const ClosedLoop::Shared& shared : scope.loop.shared) nearest.offer(shared.name);
        for (const NamedConstant& constant : scope.loop.constants) nearest.offer(constant.name);
    }
    scope.diagnostics.add(messages::undriven_variable(node.where, name, nearest.best()));
    return {};
}

}  // namespace

Terms port_terms(LoopScope& scope) {
    Terms terms(scope.file, scope.loop.exprs, scope.diagnostics);
    terms.name = [&scope](const tree::Expr& node) {
        const std::string_view name = scope.file.text(node.word);
        if (node.op == tree::Op::Name) {
            if (const auto constant = constant_named(scope, name, node.where)) return *constant;
            if (const auto known = scope.shared.find(std::string(name)); known != scope.shared.end()) {
                const ClosedLoop::Shared& shared = scope.loop.shared[known->second];
                scope.record.refer(node.where, shared.origin);
                return symbol_term(scope, ClosedLoop::SharedSymbol{known->second}, shared.type.boolean);
            }
        }
        return no_signal(scope, node, name);
    };
    return terms;
}

Terms property_terms(LoopScope& scope) {
    Terms terms(scope.file, scope.loop.exprs, scope.diagnostics);
    terms.places_allowed = true;
    terms.special = [&scope](const tree::Expr& node) { return time_term(scope, node); };
    terms.name = [&scope](const tree::Expr& node) {
        return node.op == tree::Op::Name ? simple_name(scope, node.where, scope.file.text(node.word))
                                         : member_name(scope, node);
    };
    return terms;
}

Id<Expr> symbol_leaf(LoopScope& scope, const ClosedLoop::Symbol& symbol) { return symbol_term(scope, symbol).expr; }

std::string location_list(const Component& component) {
    std::string list;
    for (const Component::Location& location : component.locations)
        list += (list.empty() ? "`" : ", `") + location.name + '`';
    return list;
}

}  // namespace grafverif
