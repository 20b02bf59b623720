// SPDX-License-Identifier: MIT
#include "lsp/walk.hpp"

#include <algorithm>
#include <utility>

#include "support/overloaded.hpp"

namespace grafverif::lsp {

// -- declarations -----------------------------------------------------------------------------------------------------

class Declarer {
public:
    Declarer(const Parsed& file, Names& names) : file_(file), names_(names) {}

    void declare(const tree::Chart& chart) {
        const std::string key = top(DeclarationKind::Chart, "chart ", chart.name, chart.where);
        items(key, "", chart.items);
    }

    void declare(const tree::Component& component) {
        const std::string key = top(DeclarationKind::Component, "component ", component.name, component.where);
        for (const tree::Variables& group : component.parameters)
            variables(key, group,
                      group.kind == tree::VariableKind::Input    ? DeclarationKind::InputParameter
                      : group.kind == tree::VariableKind::Output ? DeclarationKind::OutputParameter
                                                                 : DeclarationKind::Constant);
        for (const tree::ComponentItem& item : component.items)
            std::visit(overloaded{
                           [&](const tree::Variables& group) { variables(key, group, DeclarationKind::Own); },
                           [&](const tree::Clocks& clocks) {
                               for (const tree::Name& name : clocks.names)
                                   part(DeclarationKind::Clock, key, "v ", name, name.where);
                           },
                           [&](const tree::Location& location) {
                               part(DeclarationKind::Location, key, "l ", location.name, location.where);
                           },
                           [](const tree::Constraint&) {},
                           [](const tree::Edge&) {},
                       },
                       item);
    }

    void declare(const tree::ClosedLoop& loop) {
        const std::string key = top(DeclarationKind::Loop, "loop ", loop.name, loop.where);
        for (const tree::LoopItem& item : loop.items)
            std::visit(overloaded{
                           [&](const tree::Controller& controller) {
                               names_.controllers_[key].push_back("chart " + text(controller.chart));
                           },
                           [&](const tree::Instance& instance) {
                               const std::string own =
                                   part(DeclarationKind::Instance, key, "i ", instance.name, instance.where);
                               names_.components_[own] = "component " + text(instance.component);
                           },
                           [&](const tree::Fault& fault) {
                               part(DeclarationKind::Fault, key, "f ", fault.behaviour.name, fault.where);
                           },
                           [&](const tree::Variables& group) { variables(key, group, DeclarationKind::Constant); },
                           [&](const tree::Property& property) {
                               part(DeclarationKind::Property, key, "q ", property.name, property.where);
                           },
                           [&](const tree::Observer& observer) {
                               const std::string own =
                                   part(DeclarationKind::Observer, key, "i ", observer.name, observer.where);
                               for (const tree::ObserverItem& each : observer.items)
                                   if (const auto* location = std::get_if<tree::Location>(&each))
                                       part(DeclarationKind::Location, own, "l ", location->name, location->where);
                           },
                           [](const auto&) {},
                       },
                       item);
    }

    void declare(const tree::Include&) {}

    void declare(const tree::PlcProgram& program) {
        top(DeclarationKind::Chart, "chart ", program.name, program.where);
    }

    /// Declares the plant variables of the loop: an output of an instance is bound to the variable, and no controller
    /// declares it.
    void declare_plant(const tree::ClosedLoop& loop) {
        const std::string key = "loop " + text(loop.name);
        const Declaration* const owner = names_.element(key);
        for (const tree::LoopItem& item : loop.items) {
            const auto* instance = std::get_if<tree::Instance>(&item);
            if (instance == nullptr || owner == nullptr) continue;
            for (const tree::Argument& argument : instance->arguments) {
                const Declaration* const parameter =
                    names_.element("component " + text(instance->component) + "/v " + text(argument.parameter));
                if (parameter == nullptr || parameter->kind != DeclarationKind::OutputParameter) continue;
                const tree::Expr& value = file_.tree.exprs[argument.value];
                if (value.op != tree::Op::Name || !term_key(names_, *owner, "", file_.tree.text(value.word)).empty())
                    continue;
                part(DeclarationKind::PlantVariable, key, "v ", {value.word, value.where}, argument.where);
            }
        }
    }

private:
    std::string text(const tree::Name& name) const { return std::string(file_.tree.text(name)); }

    std::string add(Declaration element) {
        std::string key = element.key;
        // If two elements have the same name, the first one is used.
        names_.elements_.try_emplace(key, std::move(element));
        return key;
    }
    std::string top(DeclarationKind kind, const char* word, const tree::Name& name, Span whole) {
        return add({kind, text(name), word + text(name), "", &file_, name.where, whole});
    }
    std::string part(DeclarationKind kind, const std::string& owner, const char* word, const tree::Name& name,
                     Span whole) {
        return add({kind, text(name), owner + "/" + word + text(name), owner, &file_, name.where, whole});
    }

    void variables(const std::string& owner, const tree::Variables& group, DeclarationKind kind) {
        for (const tree::Variable& variable : group.variables) part(kind, owner, "v ", variable.name, variable.where);
    }

    template <class Items>
    void items(const std::string& chart, const std::string& partial, const Items& all) {
        for (const tree::ChartItem& item : all)
            std::visit(overloaded{
                           [&](const tree::Variables& group) {
                               variables(chart, group,
                                         group.kind == tree::VariableKind::Input    ? DeclarationKind::Input
                                         : group.kind == tree::VariableKind::Output ? DeclarationKind::Output
                                                                                    : DeclarationKind::Internal);
                           },
                           [&](const tree::Step& step) {
                               const std::string key = add({DeclarationKind::Step, text(step.name),
                                                            chart + "/s " + partial + "/" + text(step.name), chart,
                                                            &file_, step.name.where, step.where});
                               names_.steps_[chart + "/" + text(step.name)].push_back(key);
                           },
                           [&](const tree::Transition& transition) {
                               if (transition.name.valid())
                                   part(DeclarationKind::Transition, chart, "t ", transition.name, transition.where);
                           },
                           [&](const tree::Partial& inner) {
                               part(DeclarationKind::Partial, chart, "p ", inner.name, inner.where);
                               items(chart, text(inner.name), inner.items);
                           },
                           [](const tree::Constraint&) {},
                           [](const tree::Accept&) {},
                       },
                       item);
    }

    const Parsed& file_;
    Names& names_;
};

void declare_all(const Parsed& file, Names& names) {
    Declarer declarer(file, names);
    for (const tree::Declaration& declaration : file.tree.declarations)
        std::visit([&](const auto& written) { declarer.declare(written); }, declaration);
}

void declare_plant(const Parsed& file, Names& names) {
    Declarer declarer(file, names);
    for (const tree::Declaration& declaration : file.tree.declarations)
        if (const auto* loop = std::get_if<tree::ClosedLoop>(&declaration)) declarer.declare_plant(*loop);
}

// -- uses of names ----------------------------------------------------------------------------------------------------

class Finder {
public:
    Finder(const Parsed& file, const Names& names) : file_(file), names_(names) {}

    std::vector<Use> all() {
        for (const tree::Declaration& declaration : file_.tree.declarations)
            std::visit([&](const auto& written) { find(written); }, declaration);
        std::ranges::stable_sort(found_, {}, [](const Use& use) { return use.where.begin; });
        return std::move(found_);
    }

    /// Returns the key of the step that `name` denotes in a partial chart. If the partial chart has no such step,
    /// returns the first step of the chart with this name.
    static std::string step_key(const Names& names, const std::string& chart, std::string_view partial,
                                std::string_view name) {
        const auto same = names.steps_.find(chart + "/" + std::string(name));
        if (same == names.steps_.end()) return {};
        const std::string here = chart + "/s " + std::string(partial) + "/" + std::string(name);
        return std::ranges::find(same->second, here) != same->second.end() ? here : same->second.front();
    }

private:
    std::string text(const tree::Name& name) const { return std::string(file_.tree.text(name)); }

    void use(std::string key, Span where, std::uint32_t skipped = 0) {
        if (!key.empty() && names_.element(key) != nullptr) found_.push_back({std::move(key), where, skipped});
    }
    void write(const std::string& key, Span where) {
        use(key, where);
        if (!found_.empty() && found_.back().key == key) found_.back().writes = true;
    }
    void declared(const std::string& key, Span where) {
        const Declaration* const element = names_.element(key);
        if (element == nullptr) return;
        const bool first = element->file == &file_ && element->where.begin == where.begin;
        found_.push_back({key, where, 0, first, false});
    }

    // Terms.

    std::uint32_t skipped(const std::string& key) const {
        const Declaration* const element = names_.element(key);
        return element != nullptr && element->kind == DeclarationKind::Step ? 1 : 0;
    }

    void term(const Declaration& owner, const std::string& partial, Id<tree::Expr> root) {
        std::vector<Id<tree::Expr>> waiting;
        if (root.valid()) waiting.push_back(root);
        while (!waiting.empty()) {
            const tree::Expr& expr = file_.tree.exprs[waiting.back()];
            waiting.pop_back();
            if (expr.op == tree::Op::Name) {
                const std::string key = term_key(names_, owner, partial, file_.tree.text(expr.word));
                use(key, expr.where, skipped(key));
            } else if (expr.op == tree::Op::Member || expr.op == tree::Op::In) {
                member(owner, expr);
            } else {
                for (Id<tree::Expr> each = expr.first; each.valid(); each = file_.tree.exprs[each].next)
                    waiting.push_back(each);
            }
        }
    }

    /// Handles `owner.name`. The name is the last token of the node.
    void member(const Declaration& owner, const tree::Expr& expr) {
        const std::string name(file_.tree.text(expr.word));
        const Span where = {expr.where.source, expr.where.end - static_cast<std::uint32_t>(name.size()),
                            expr.where.end};
        const tree::Expr& left = file_.tree.exprs[expr.first];
        std::string chart = owner.kind == DeclarationKind::Chart ? owner.key : std::string(), partial;
        tree::Name last{left.word, left.where};
        if (left.op == tree::Op::Member) {
            const tree::Expr& outer = file_.tree.exprs[left.first];
            chart = outer.word.valid() ? "chart " + std::string(file_.tree.text(outer.word)) : std::string();
            use(chart, outer.where);
            last.where.begin = last.where.end - static_cast<std::uint32_t>(file_.tree.text(left.word).size());
        } else if (left.op != tree::Op::Name) {
            return;
        }
        const std::string before = text(last);
        if (owner.kind == DeclarationKind::Loop && left.op == tree::Op::Name) {
            const std::string part = owner.key + "/i " + before;
            if (names_.element(part) != nullptr) {
                use(part, last.where);
                const std::string component = names_.component_of(part);
                const std::string owned = (component.empty() ? part : component) + '/';
                const bool variable = expr.op == tree::Op::Member && names_.element(owned + "l " + name) == nullptr;
                return use(owned + (variable ? "v " : "l ") + name, where);
            }
            const auto charts = names_.controllers(owner.key);
            if (std::ranges::find(charts, "chart " + before) != charts.end()) chart = "chart " + before;
            for (const std::string& each : charts)
                if (chart.empty() && names_.element(each + "/p " + before) != nullptr) chart = each;
        }
        if ("chart " + before == chart) use(chart, last.where);
        else partial = before, use(chart + "/p " + before, last.where);
        if (names_.element(chart + "/v " + name) != nullptr && partial.empty()) return use(chart + "/v " + name, where);
        if (name.starts_with('X')) use(step_key(names_, chart, partial, name.substr(1)), where, 1);
    }

    void assignments(const Declaration& owner, const std::string& partial, const std::vector<tree::Assignment>& all) {
        for (const tree::Assignment& each : all) assignment(owner, partial, each);
    }
    void assignment(const Declaration& owner, const std::string& partial, const tree::Assignment& written) {
        write(owner.key + "/v " + text(written.target), written.target.where);
        term(owner, partial, written.value);
    }

    void variables(const Declaration& owner, const tree::Variables& group) {
        for (const tree::Variable& variable : group.variables) {
            declared(owner.key + "/v " + text(variable.name), variable.name.where);
            if (variable.range) term(owner, "", variable.range->low), term(owner, "", variable.range->high);
            term(owner, "", variable.value);
        }
    }

    // Charts.

    void find(const tree::Include&) {}

    void find(const tree::PlcProgram& program) { declared("chart " + text(program.name), program.name.where); }

    void find(const tree::Chart& chart) {
        const std::string key = "chart " + text(chart.name);
        declared(key, chart.name.where);
        if (const Declaration* const owner = names_.element(key)) items(*owner, "", chart.items);
    }

    void items(const Declaration& chart, const std::string& partial, const std::vector<tree::ChartItem>& all) {
        for (const tree::ChartItem& item : all)
            std::visit(overloaded{
                           [&](const tree::Variables& group) { variables(chart, group); },
                           [&](const tree::Constraint& constraint) { term(chart, partial, constraint.condition); },
                           [&](const tree::Accept& accept) { subject(chart, accept); },
                           [&](const tree::Step& step) { this->step(chart, partial, step); },
                           [&](const tree::Transition& transition) { this->transition(chart, partial, transition); },
                           [&](const tree::Partial& inner) {
                               declared(chart.key + "/p " + text(inner.name), inner.name.where);
                               items(chart, text(inner.name), inner.items);
                           },
                       },
                       item);
    }

    void steps(const Declaration& chart, const std::string& partial, const std::vector<tree::Name>& labels) {
        for (const tree::Name& label : labels) use(step_key(names_, chart.key, partial, text(label)), label.where);
    }

    void step(const Declaration& chart, const std::string& partial, const tree::Step& step) {
        declared(chart.key + "/s " + partial + "/" + text(step.name), step.name.where);
        for (const tree::Name& inner : step.contents) use(chart.key + "/p " + text(inner), inner.where);
        for (const tree::Action& action : step.actions)
            std::visit(overloaded{
                           [&](const tree::ContinuousAction& continuous) {
                               write(chart.key + "/v " + text(continuous.output), continuous.output.where);
                               term(chart, partial, continuous.condition);
                           },
                           [&](const tree::StoredAction& stored) {
                               assignment(chart, partial, stored.assignment);
                               term(chart, partial, stored.event);
                           },
                           [&](const tree::ForcingOrder& order) {
                               use(chart.key + "/p " + text(order.chart), order.chart.where);
                               steps(chart, text(order.chart), order.steps);
                           },
                       },
                       action);
    }

    void transition(const Declaration& chart, const std::string& partial, const tree::Transition& transition) {
        if (transition.name.valid()) declared(chart.key + "/t " + text(transition.name), transition.name.where);
        steps(chart, partial, transition.from);
        steps(chart, partial, transition.to);
        term(chart, partial, transition.condition);
        assignments(chart, partial, transition.assignments);
    }

    /// Handles `accept CODE X4 "...";`. The tree does not contain the position of the subject, which is the last token
    /// before the reason.
    void subject(const Declaration& chart, const tree::Accept& accept) {
        if (accept.subject.empty()) return;
        const std::string_view all = file_.bytes(accept.where);
        const std::size_t at = all.substr(0, all.find('"')).rfind(accept.subject);
        if (at == std::string_view::npos) return;
        // If there is no dot, npos + 1 is 0, and the complete text is used.
        const std::size_t dot = accept.subject.rfind('.') + 1;
        const std::string name = accept.subject.substr(dot);
        const auto begin = static_cast<std::uint32_t>(accept.where.begin + at + dot);
        const Span where = {accept.where.source, begin, begin + static_cast<std::uint32_t>(name.size())};
        const std::string partial = dot == 0 ? "" : accept.subject.substr(0, dot - 1);
        if (names_.element(chart.key + "/t " + name) != nullptr) return use(chart.key + "/t " + name, where);
        const std::string key = term_key(names_, chart, partial, name);
        use(key, where, skipped(key));
    }

    // Components.

    void find(const tree::Component& component) {
        const std::string key = "component " + text(component.name);
        declared(key, component.name.where);
        const Declaration* const owner = names_.element(key);
        if (owner == nullptr) return;
        for (const tree::Variables& group : component.parameters) variables(*owner, group);
        for (const tree::ComponentItem& item : component.items)
            std::visit(overloaded{
                           [&](const tree::Variables& group) { variables(*owner, group); },
                           [&](const tree::Constraint& constraint) { term(*owner, "", constraint.condition); },
                           [&](const tree::Clocks& clocks) {
                               for (const tree::Name& name : clocks.names)
                                   declared(key + "/v " + text(name), name.where);
                           },
                           [&](const tree::Location& location) {
                               declared(key + "/l " + text(location.name), location.name.where);
                               term(*owner, "", location.invariant);
                               assignments(*owner, "", location.values);
                           },
                           [&](const tree::Edge& edge) {
                               for (const tree::Name& end : {edge.from, edge.to})
                                   use(key + "/l " + text(end), end.where);
                               term(*owner, "", edge.condition);
                               assignments(*owner, "", edge.assignments);
                           },
                       },
                       item);
    }

    // Closed loops.

    void find(const tree::ClosedLoop& loop) {
        const std::string key = "loop " + text(loop.name);
        declared(key, loop.name.where);
        const Declaration* const owner = names_.element(key);
        if (owner == nullptr) return;
        for (const tree::LoopItem& item : loop.items)
            std::visit(overloaded{
                           [&](const tree::Controller& controller) {
                               use("chart " + text(controller.chart), controller.chart.where);
                               term(*owner, "", controller.cycle.least);
                               term(*owner, "", controller.cycle.most);
                           },
                           [&](const tree::Instance& instance) { this->instance(*owner, "/i ", instance); },
                           [&](const tree::Fault& fault) {
                               use(key + "/i " + text(fault.of), fault.of.where);
                               this->instance(*owner, "/f ", fault.behaviour);
                           },
                           [&](const tree::Property& property) {
                               declared(key + "/q " + text(property.name), property.name.where);
                               for (const Id<tree::Expr> operand : property.operands) term(*owner, "", operand);
                               term(*owner, "", property.bound);
                           },
                           [&](const tree::Variables& group) { variables(*owner, group); },
                           [&](const tree::TimeUnit& unit) { term(*owner, "", unit.duration); },
                           [&](const tree::Constraint& constraint) { term(*owner, "", constraint.condition); },
                           [&](const tree::Observer& observer) { this->observer(*owner, observer); },
                           [](const auto&) {},
                       },
                       item);
    }

    /// Finds the names of an instance or of the behaviour of a fault; `kind` is part of the key of its declaration.
    void instance(const Declaration& loop, const char* kind, const tree::Instance& instance) {
        declared(loop.key + kind + text(instance.name), instance.name.where);
        const std::string component = "component " + text(instance.component);
        use(component, instance.component.where);
        for (const tree::Argument& argument : instance.arguments) {
            const std::string parameter = component + "/v " + text(argument.parameter);
            use(parameter, argument.parameter.where);
            const tree::Expr& value = file_.tree.exprs[argument.value];
            const std::size_t before = found_.size();
            term(loop, "", argument.value);
            const Declaration* const bound = names_.element(parameter);
            if (found_.size() != before + 1 || bound == nullptr || bound->kind != DeclarationKind::OutputParameter)
                continue;
            found_.back().writes = true;
            const Declaration* const plant = names_.element(found_.back().key);
            found_.back().declares = plant->kind == DeclarationKind::PlantVariable && plant->file == &file_ &&
                                     plant->where.begin == value.where.begin;
        }
        if (instance.initial.valid()) use(component + "/l " + text(instance.initial), instance.initial.where);
    }

    void observer(const Declaration& loop, const tree::Observer& observer) {
        const std::string key = loop.key + "/i " + text(observer.name);
        declared(key, observer.name.where);
        for (const tree::ObserverItem& item : observer.items)
            std::visit(overloaded{
                           [&](const tree::Location& location) {
                               declared(key + "/l " + text(location.name), location.name.where);
                           },
                           [&](const tree::ObserverEdge& edge) {
                               for (const tree::Name& end : {edge.from, edge.to})
                                   use(key + "/l " + text(end), end.where);
                               term(loop, "", edge.condition);
                           },
                       },
                       item);
    }

    const Parsed& file_;
    const Names& names_;
    std::vector<Use> found_ = {};
};

std::vector<Use> uses_in(const Parsed& file, const Names& names) { return Finder(file, names).all(); }

std::string term_key(const Names& names, const Declaration& owner, std::string_view partial, std::string_view name) {
    const std::string wanted(name);
    const auto step = [&](const std::string& chart) {
        return name.size() > 1 && name[0] == 'X' ? Finder::step_key(names, chart, partial, name.substr(1))
                                                 : std::string();
    };
    const std::string own = owner.key + "/v " + wanted;
    if (owner.kind != DeclarationKind::Loop) {
        if (names.element(own) != nullptr) return own;
        return owner.kind == DeclarationKind::Chart ? step(owner.key) : std::string();
    }
    const std::vector<std::string> charts = names.controllers(owner.key);
    for (const bool internal : {false, true}) {
        for (const std::string& chart : charts) {
            const Declaration* const found = names.element(chart + "/v " + wanted);
            if (found != nullptr && (found->kind == DeclarationKind::Internal) == internal) return found->key;
        }
        if (!internal && names.element(own) != nullptr) return own;
    }
    for (const std::string& chart : charts)
        if (std::string key = step(chart); !key.empty()) return key;
    return {};
}

}  // namespace grafverif::lsp
