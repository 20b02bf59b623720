// SPDX-License-Identifier: MIT
#include "pipeline/variants/fault_model.hpp"

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

#include "support/unique_names.hpp"

namespace grafverif {

namespace {

using Assignments = std::vector<Component::Assignment>;

/// Builds the union of the component of an instance and the component of its fault (fault_model.hpp).
class UnionBuilder {
public:
    UnionBuilder(const Model& model, const ClosedLoop::Instance& instance, const ClosedLoop::Fault& fault)
        : faulty_(model.components[fault.behaviour.component]),
          behaviour_(fault.behaviour),
          made_(model.components[instance.component]),
          instance_(instance),
          clocks_(made_.clocks.size()),
          locations_(made_.locations.size()),
          copy_(faulty_.exprs, made_.exprs, [this](const Expr& leaf) { return copied_leaf(leaf); }) {
        for (const auto& each : made_.parameters) names_.take(each.name);
        for (const auto& each : made_.variables) names_.take(each.name);
        for (const auto& each : made_.clocks) names_.take(each.name);
        for (const auto& each : made_.locations) location_names_.take(each.name);
    }

    /// Adds the union to the components of `model`. Returns the faulty instance with the union as its component.
    ClosedLoop::Instance build(Model& model, const ActiveFault& active) {
        made_.name += "_or_" + behaviour_.name;
        const Id<Component::Variable> first_own{static_cast<std::uint32_t>(made_.variables.size())};
        add_parameters();
        for (const Component::Variable& own : faulty_.variables)
            made_.variables.add({fresh(own.name), own.value, {}, {}, {}, own.origin});
        declare_own(first_own);
        for (const Component::Clock& clock : faulty_.clocks) made_.clocks.add({fresh(clock.name), clock.origin});
        for (const Component::Location& location : faulty_.locations)
            made_.locations.add({location_name(location), constraints(location.invariant), {}, location.origin});
        add_change(active.announced);
        for (const Component::Edge& edge : faulty_.edges) add_edge(edge);
        if (active.from_power_on) instance_.initial = start();
        instance_.component = model.components.add(std::move(made_));
        return std::move(instance_);
    }

private:
    std::string fresh(const std::string& name) { return names_.fresh(behaviour_.name + "_" + name); }

    /// Returns the name in the union for a location of the fault. If the fault has only one location, this location has
    /// the name of the fault.
    std::string location_name(const Component::Location& location) {
        const bool single = faulty_.locations.size() == 1;
        return location_names_.fresh(single ? behaviour_.name : behaviour_.name + "_" + location.name);
    }

    Id<Component::Location> start() const { return place(behaviour_.initial); }
    Id<Component::Location> place(Id<Component::Location> id) const {
        return {static_cast<std::uint32_t>(id.index + locations_)};
    }
    Id<Component::Clock> clock(Id<Component::Clock> id) const {
        return {static_cast<std::uint32_t>(id.index + clocks_)};
    }

    Id<Expr> copied_leaf(const Expr& leaf) {
        if (leaf.op == Op::Duration) return made_.exprs.duration(leaf.value);
        const auto index = static_cast<std::size_t>(leaf.value);
        return leaf.op == Op::Parameter ? parameters_[index] : own_[index];
    }

    /// Maps each output of the fault to the output of the instance that is bound to the same variable. Adds all other
    /// parameters of the fault to the union.
    void add_parameters() {
        const std::size_t normal = made_.parameters.size();
        for (const Id<Component::Parameter> id : faulty_.parameters.ids()) {
            const Component::Parameter& parameter = faulty_.parameters[id];
            const ClosedLoop::Argument& argument = behaviour_.arguments[id.index];
            std::size_t index = made_.parameters.size();
            if (parameter.kind == Component::ParameterKind::Output) {
                for (index = 0; index < normal; ++index)
                    if (made_.parameters[Id<Component::Parameter>{static_cast<std::uint32_t>(index)}].kind ==
                            parameter.kind &&
                        instance_.arguments[index] == argument)
                        break;
                assert(index < normal);
            } else {
                made_.parameters.add(
                    {fresh(parameter.name), parameter.kind, parameter.value, {}, {}, {}, parameter.origin});
                instance_.arguments.push_back(argument);
            }
            parameters_.push_back(made_.exprs.leaf(Op::Parameter, static_cast<std::uint32_t>(index)));
        }
        for (std::size_t k = 0; k < faulty_.variables.size(); ++k)
            own_.push_back(made_.exprs.leaf(Op::Variable, static_cast<std::uint32_t>(made_.variables.size() + k)));
    }

    void declare_own(Id<Component::Variable> first) {
        const auto copied = [&](const std::optional<Id<Expr>>& term) {
            return term ? std::optional(copy_(*term)) : std::nullopt;
        };
        for (const Component::Variable& own : faulty_.variables) {
            Component::Variable& made = made_.variables[first];
            made.low = copied(own.low);
            made.high = copied(own.high);
            made.initial = copied(own.initial);
            ++first.index;
        }
    }

    Assignments copied(const Assignments& from) {
        Assignments list;
        for (const Component::Assignment& each : from)
            list.push_back({copy_(each.target), copy_(each.value), each.origin});
        return list;
    }

    std::vector<Component::ClockConstraint> constraints(const std::vector<Component::ClockConstraint>& from) {
        std::vector<Component::ClockConstraint> list;
        for (const Component::ClockConstraint& each : from)
            list.push_back({clock(each.clock), each.relation, copy_(each.bound), each.origin});
        return list;
    }

    void add_edge(const Component::Edge& from) {
        Component::Edge edge{.from = place(from.from), .to = place(from.to), .urgent = from.urgent};
        edge.guard = copy_(from.guard);
        edge.constraint = constraints(from.constraint);
        edge.assignments = copied(from.assignments);
        for (const Id<Component::Clock> each : from.resets) edge.resets.push_back(clock(each));
        edge.origin = from.origin;
        made_.edges.add(std::move(edge));
    }

    /// Adds the edges by which the fault occurs, and the initial values for an instance whose fault is present from
    /// power-on. If the fault assigns no value to an output, this output has the same initial value as without the
    /// fault.
    void add_change(bool announced) {
        const Assignments declared = copied(faulty_.locations[behaviour_.initial].initially);
        std::vector<Id<Component::Clock>> resets;
        for (const Id<Component::Clock> each : faulty_.clocks.ids()) resets.push_back(clock(each));
        Id<Component::Location> target = start();
        if (announced) {
            target =
                made_.locations.add({location_names_.fresh(behaviour_.name + "_occurs"), {}, {}, behaviour_.origin});
            made_.edges.add({target, start(), true, made_.exprs.constant(true), {}, {}, resets, behaviour_.origin});
        }
        for (std::uint32_t from = 0; from < locations_; ++from)
            made_.edges.add(
                {{from}, target, false, made_.exprs.constant(true), {}, declared, resets, behaviour_.origin});
        Assignments initially = made_.locations[instance_.initial].initially;
        initially.insert(initially.end(), declared.begin(), declared.end());
        made_.locations[start()].initially = std::move(initially);
    }

    const Component& faulty_;
    const ClosedLoop::Instance& behaviour_;
    Component made_;
    ClosedLoop::Instance instance_;
    std::size_t clocks_, locations_;  ///< number of clocks, and number of locations, of the normal behaviour
    UniqueNames names_ = {}, location_names_ = {};
    std::vector<Id<Expr>> parameters_ = {}, own_ = {};  ///< terms for the parameters and variables of the fault
    TermCopier copy_;
};

}  // namespace

Model with_faults(const Model& model, Id<ClosedLoop> loop, const std::vector<ActiveFault>& faults) {
    Model made = model;
    for (const ActiveFault& active : faults) {
        const ClosedLoop::Fault& fault = model.loops[loop].faults[active.fault];
        made.loops[loop].instances[fault.of] =
            UnionBuilder(model, model.loops[loop].instances[fault.of], fault).build(made, active);
    }
    made.loops[loop].faults = {};
    assert(verify(made.loops[loop], made).empty());
    return made;
}

}  // namespace grafverif
