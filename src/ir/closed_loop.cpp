// SPDX-License-Identifier: MIT
#include "grafverif/ir/closed_loop.hpp"

#include <algorithm>
#include <string_view>
#include <unordered_set>

#include "support/overloaded.hpp"

namespace grafverif {

namespace {

struct ClosedLoopChecker {
    const ClosedLoop& loop;
    const Model& model;
    std::vector<std::string> faults = {};

    void check(bool holds, std::string fault) {
        if (!holds) faults.push_back(std::move(fault));
    }
    const Chart& chart(Id<ClosedLoop::Controller> controller) const {
        return model.charts[loop.controllers[controller].chart];
    }
};

void check_controllers(ClosedLoopChecker& checker) {
    for (const auto& controller : checker.loop.controllers)
        checker.check(checker.model.charts.contains(controller.chart),
                      "controller " + controller.name + " has no chart");
}

void check_shared(ClosedLoopChecker& checker) {
    std::unordered_set<std::string_view> names;
    for (const auto& shared : checker.loop.shared) {
        checker.check(names.insert(shared.name).second, "two shared variables are named " + shared.name);
        const auto owner = shared.writer.valid() ? shared.writer : shared.reader;
        if (!owner.valid()) continue;
        const bool known =
            checker.loop.controllers.contains(owner) && checker.chart(owner).variables.contains(shared.variable);
        checker.check(known, "shared variable " + shared.name + " does not belong to a chart");
        if (known)
            checker.check(checker.chart(owner).variables[shared.variable].type == shared.type,
                          "shared variable " + shared.name + " has a type that differs from the one in its chart");
    }
}

void check_term(ClosedLoopChecker& checker, const ClosedLoop::Instance& instance, Id<Expr> term,
                std::vector<bool>& read) {
    const ClosedLoop& loop = checker.loop;
    checker.check(loop.exprs.contains(term), "an argument of " + instance.name + " does not exist");
    if (!loop.exprs.contains(term)) return;
    for (const Id<Expr> leaf : leaves(loop.exprs, term)) {
        const Id<ClosedLoop::Symbol> symbol{static_cast<std::uint32_t>(loop.exprs[leaf].value)};
        const auto* of =
            loop.symbols.contains(symbol) ? std::get_if<ClosedLoop::SharedSymbol>(&loop.symbols[symbol]) : nullptr;
        const bool known = of != nullptr && loop.shared.contains(of->shared);
        checker.check(known, "an argument of " + instance.name + " reads something other than a shared variable");
        if (known) read[of->shared.index] = true;
    }
}

void check_argument(ClosedLoopChecker& checker, const ClosedLoop::Instance& instance,
                    const Component::Parameter& parameter, const ClosedLoop::Argument& argument,
                    std::vector<int>& writers, std::vector<bool>& read) {
    const auto* shared = std::get_if<Id<ClosedLoop::Shared>>(&argument);
    const auto* term = std::get_if<Id<Expr>>(&argument);
    const bool variable = parameter.kind != Component::ParameterKind::Constant;
    const bool input = parameter.kind == Component::ParameterKind::Input;
    checker.check(term != nullptr ? input : (shared != nullptr) == variable,
                  "an argument of " + instance.name + " does not match parameter " + parameter.name);
    if (term != nullptr) return check_term(checker, instance, *term, read);
    if (shared == nullptr) return;
    checker.check(checker.loop.shared.contains(*shared),
                  "an argument of " + instance.name + " is not a shared variable");
    if (!checker.loop.shared.contains(*shared)) return;
    const bool boolean = parameter.value == Component::ValueKind::Boolean;
    checker.check(checker.loop.shared[*shared].type.boolean == boolean,
                  "an argument of " + instance.name + " has a type that differs from the one of " + parameter.name);
    if (parameter.kind == Component::ParameterKind::Output) ++writers[shared->index];
    if (input) read[shared->index] = true;
}

/// Checks `instance`, counts the instance in `writers` for each of its outputs, and marks its inputs in `read`.
void check_instance(ClosedLoopChecker& checker, const ClosedLoop::Instance& instance, std::vector<int>& writers,
                    std::vector<bool>& read) {
    checker.check(checker.model.components.contains(instance.component),
                  "instance " + instance.name + " has no component");
    if (!checker.model.components.contains(instance.component)) return;
    const Component& component = checker.model.components[instance.component];
    checker.check(component.locations.contains(instance.initial),
                  "instance " + instance.name + " has no initial location");
    checker.check(instance.arguments.size() == component.parameters.size(),
                  "instance " + instance.name + " has the wrong number of arguments");
    if (instance.arguments.size() != component.parameters.size()) return;
    for (const auto id : component.parameters.ids())
        check_argument(checker, instance, component.parameters[id], instance.arguments[id.index], writers, read);
}

/// Checks that each fault writes exactly the variables that its instance writes.
void check_faults(ClosedLoopChecker& checker, std::vector<bool>& read) {
    const ClosedLoop& loop = checker.loop;
    for (const ClosedLoop::Fault& fault : loop.faults) {
        checker.check(loop.instances.contains(fault.of), "fault " + fault.behaviour.name + " has no instance");
        if (!loop.instances.contains(fault.of)) continue;
        std::vector<int> writers(loop.shared.size()), of_instance(loop.shared.size());
        check_instance(checker, fault.behaviour, writers, read);
        check_instance(checker, loop.instances[fault.of], of_instance, read);
        checker.check(writers == of_instance, "fault " + fault.behaviour.name + " writes other variables");
    }
}

void check_instances(ClosedLoopChecker& checker) {
    const ClosedLoop& loop = checker.loop;
    std::vector<int> writers(loop.shared.size());
    std::vector<bool> read(loop.shared.size());
    for (const auto& instance : loop.instances) check_instance(checker, instance, writers, read);
    check_faults(checker, read);
    for (const auto id : loop.shared.ids()) {
        const auto& shared = loop.shared[id];
        const int drivers = writers[id.index] + (shared.writer.valid() ? 1 : 0);
        const bool needs = shared.reader.valid() || read[id.index];
        checker.check(drivers <= 1 && (drivers == 1 || !needs),
                      "shared variable " + shared.name + " does not have exactly one driver");
    }
}

bool is_known(const ClosedLoopChecker& checker, const ClosedLoop::Symbol& symbol) {
    const ClosedLoop& loop = checker.loop;
    return std::visit(
        overloaded{
            [&](const ClosedLoop::SharedSymbol& of) { return loop.shared.contains(of.shared); },
            [&](const ClosedLoop::InternalSymbol& of) {
                return loop.controllers.contains(of.controller) &&
                       checker.chart(of.controller).variables.contains(of.variable);
            },
            [&](const ClosedLoop::StepSymbol& of) {
                return loop.controllers.contains(of.controller) && checker.chart(of.controller).steps.contains(of.step);
            },
            [&](const ClosedLoop::LocationSymbol& of) {
                return loop.instances.contains(of.instance) &&
                       checker.model.components[loop.instances[of.instance].component].locations.contains(of.location);
            },
            [&](const ClosedLoop::OwnSymbol& of) {
                return loop.instances.contains(of.instance) &&
                       checker.model.components[loop.instances[of.instance].component].variables.contains(of.variable);
            },
            [&](const ClosedLoop::TimeSymbol& of) {
                if (!loop.controllers.contains(of.controller)) return false;
                return is_waited_for(checker.chart(of.controller), of);
            },
            [&](const ClosedLoop::ObserverSymbol& of) {
                return loop.observers.contains(of.observer) &&
                       loop.observers[of.observer].locations.contains(of.location);
            },
        },
        symbol);
}

void check_properties(ClosedLoopChecker& checker) {
    const ClosedLoop& loop = checker.loop;
    for (const auto& symbol : loop.symbols)
        checker.check(is_known(checker, symbol), "a symbol refers to an element that does not exist");
    for (std::uint32_t index = 0; index < loop.exprs.size(); ++index) {
        const Expr& node = loop.exprs[Id<Expr>{index}];
        if (is_leaf(node.op))
            checker.check(node.op == Op::Variable && loop.symbols.contains({static_cast<std::uint32_t>(node.value)}),
                          "a leaf of a property is not a symbol");
    }
    std::unordered_set<std::string_view> names;
    for (const auto& property : loop.properties) {
        checker.check(names.insert(property.name).second, "two properties are named " + property.name);
        for (const auto operand : property.operands)
            checker.check(loop.exprs.contains(operand), "an operand of " + property.name + " does not exist");
    }
}

void check_observers(ClosedLoopChecker& checker) {
    const ClosedLoop& loop = checker.loop;
    for (const ClosedLoop::Observer& observer : loop.observers) {
        checker.check(observer.locations.contains(observer.initial), observer.name + " has no initial location");
        for (const ClosedLoop::ObserverEdge& edge : observer.edges)
            checker.check(observer.locations.contains(edge.from) && observer.locations.contains(edge.to) &&
                              loop.exprs.contains(edge.guard),
                          "an edge of " + observer.name + " has an invalid location or guard");
    }
    for (const ClosedLoop::Constraint& constraint : loop.constraints)
        checker.check(loop.exprs.contains(constraint.condition), constraint.name + " does not exist");
}

}  // namespace

std::vector<std::string> verify(const ClosedLoop& loop, const Model& model) {
    ClosedLoopChecker checker{loop, model};
    check_controllers(checker);
    if (!checker.faults.empty()) return checker.faults;
    check_shared(checker);
    check_instances(checker);
    if (checker.faults.empty()) check_properties(checker);
    check_observers(checker);
    return checker.faults;
}

std::vector<Id<ClosedLoop::Shared>> shared_in(const ClosedLoop& loop, const ClosedLoop::Argument& argument) {
    if (const auto* shared = std::get_if<Id<ClosedLoop::Shared>>(&argument)) return {*shared};
    std::vector<Id<ClosedLoop::Shared>> found;
    if (const auto* term = std::get_if<Id<Expr>>(&argument))
        for (const Id<Expr> leaf : leaves(loop.exprs, *term)) {
            const Id<ClosedLoop::Symbol> symbol{static_cast<std::uint32_t>(loop.exprs[leaf].value)};
            found.push_back(std::get<ClosedLoop::SharedSymbol>(loop.symbols[symbol]).shared);
        }
    return found;
}

bool is_waited_for(const Chart& chart, const ClosedLoop::TimeSymbol& symbol) {
    if (symbol.condition.valid())
        return chart.time_conditions.contains(symbol.condition) &&
               read_terms(chart).time_conditions[symbol.condition.index];
    return std::ranges::any_of(chart.continuous, [&](const Chart::ContinuousAction& action) {
        const bool delayed = action.delay_ms > 0 && action.delay_ms == symbol.rise_ms;
        const bool limited = action.limit_ms > 0 && action.delay_ms + action.limit_ms == symbol.rise_ms;
        return action.step == symbol.step && (delayed || limited);
    });
}

bool has_its_timers(const ClosedLoop& loop, const Property& property, const Model& model) {
    const auto is_there = [&](Id<Expr> leaf) {
        const Id<ClosedLoop::Symbol> symbol{static_cast<std::uint32_t>(loop.exprs[leaf].value)};
        const auto* time = std::get_if<ClosedLoop::TimeSymbol>(&loop.symbols[symbol]);
        return time == nullptr || is_waited_for(model.charts[loop.controllers[time->controller].chart], *time);
    };
    return std::ranges::all_of(property.operands, [&](Id<Expr> operand) {
        return std::ranges::all_of(leaves(loop.exprs, operand), is_there);
    });
}

Id<Equations::Variable> end_of(const Equations& equations, const ClosedLoop::TimeSymbol& symbol) {
    if (symbol.condition.valid()) return equations.timers[equations.conditions[symbol.condition.index].index].end;
    const Id<Equations::Variable> step = equations.steps[symbol.step.index].variable;
    const auto found = std::ranges::find_if(equations.timers, [&](const Equations::Timer& timer) {
        return timer.watched == step && timer.rise_ms == symbol.rise_ms && timer.fall_ms == 0;
    });
    if (found == equations.timers.end()) unreachable();
    return found->end;
}

std::size_t own_argument(const ClosedLoop& loop, const ClosedLoop::OwnSymbol& symbol) {
    const std::vector<ClosedLoop::Argument>& arguments = loop.instances[symbol.instance].arguments;
    const auto is_term = [](const ClosedLoop::Argument& each) { return std::holds_alternative<Id<Expr>>(each); };
    const auto terms = std::ranges::count_if(arguments, is_term);
    return arguments.size() - static_cast<std::size_t>(terms) + symbol.variable.index;
}

bool reads_observer(const ClosedLoop& loop, const Property& property) {
    return std::ranges::any_of(property.operands, [&](Id<Expr> operand) {
        return std::ranges::any_of(leaves(loop.exprs, operand), [&](Id<Expr> leaf) {
            const Id<ClosedLoop::Symbol> symbol{static_cast<std::uint32_t>(loop.exprs[leaf].value)};
            return std::holds_alternative<ClosedLoop::ObserverSymbol>(loop.symbols[symbol]);
        });
    });
}

std::vector<std::string> verify(const Model& model) {
    std::vector<std::string> faults;
    const auto take = [&faults](const std::string& owner, std::vector<std::string> found) {
        for (std::string& fault : found) faults.push_back(owner + ": " + fault);
    };
    for (const Chart& chart : model.charts) take(chart.name, verify(chart));
    for (const Component& component : model.components) take(component.name, verify(component));
    for (const ClosedLoop& loop : model.loops) take(loop.name, verify(loop, model));
    return faults;
}

}  // namespace grafverif
