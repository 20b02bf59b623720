// SPDX-License-Identifier: MIT
#include "emit/wide.hpp"

#include <algorithm>
#include <string>

#include "ir/interval.hpp"
#include "ir/network/variables.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

/// Reports positions at which more than 32 bits may be necessary, each at most once.
class Places {
public:
    Places(std::string_view target, Diagnostics& diagnostics)
        : target_(target), diagnostics_(diagnostics), errors_(diagnostics.errors()) {}

    void add(Span where, const std::string& what) {
        if (where == last_ && !none()) return;
        last_ = where;
        diagnostics_.add(messages::beyond_32_bits(where, what, target_));
    }
    bool none() const { return diagnostics_.errors() == errors_; }

private:
    std::string_view target_;
    Diagnostics& diagnostics_;
    std::size_t errors_ = 0;
    Span last_ = {};
};

/// Checks the terms of one template. A constant of the template has the range of the arguments that processes pass.
class TemplatePlaces {
public:
    TemplatePlaces(const Network& network, Id<Network::Template> id, Places& places)
        : network_(network), automaton_(network.templates[id]), places_(places) {
        for (const Network::Parameter& parameter : automaton_.parameters) types_.push_back(parameter.type);
        fit_constants(id);
        wide_ = wide_terms(network.exprs, [&](const Expr& leaf) {
            if (leaf.op != Op::Parameter) return type_of(network, leaf);
            // The terms of all templates are visited: a parameter of another template may have an index beyond
            // `types_`.
            const auto index = static_cast<std::size_t>(leaf.value);
            return index < types_.size() ? types_[index] : Type{};
        });
    }

    void add_all() {
        for (std::size_t k = 0; k < types_.size(); ++k)
            if (!types_[k].boolean && is_wide(types_[k].low, types_[k].high))
                places_.add(automaton_.origin, '`' + automaton_.parameters[{static_cast<std::uint32_t>(k)}].name + '`');
        for (const Network::Location& location : automaton_.locations) add(location.invariant, location.origin);
        for (const Network::Procedure& procedure : automaton_.procedures) add(procedure.assignments, automaton_.origin);
        for (const Network::Edge& edge : automaton_.edges) {
            if (wide_[edge.guard.index]) places_.add(edge.origin, "the guard of an edge");
            add(edge.constraint, edge.origin);
            add(edge.assignments, edge.origin);
        }
    }

private:
    /// Restricts the range of each constant to the values of the arguments that processes pass.
    void fit_constants(Id<Network::Template> id) {
        std::vector<bool> given(types_.size());
        for (const Network::Process& process : network_.processes)
            for (std::size_t k = 0; process.automaton == id && k < process.arguments.size(); ++k) {
                const auto* const value = std::get_if<std::int64_t>(&process.arguments[k]);
                if (value == nullptr || types_[k].boolean) continue;
                types_[k].low = given[k] ? std::min(types_[k].low, *value) : *value;
                types_[k].high = given[k] ? std::max(types_[k].high, *value) : *value;
                given[k] = true;
            }
    }

    void add(const std::vector<Network::ClockConstraint>& constraints, Span where) {
        for (const Network::ClockConstraint& constraint : constraints)
            if (wide_[constraint.bound.index]) places_.add(where, "the bound of a clock");
    }

    void add(const std::vector<Network::Assignment>& assignments, Span where) {
        for (const Network::Assignment& assignment : assignments) {
            if (!wide_[assignment.target.index] && !wide_[assignment.value.index]) continue;
            const Expr& target = network_.exprs[assignment.target];
            const auto index = static_cast<std::uint32_t>(target.value);
            places_.add(where, '`' +
                                   (target.op == Op::Parameter ? automaton_.parameters[{index}].name
                                                               : network_.variables[{index}].display_name()) +
                                   '`');
        }
    }

    const Network& network_;
    const Network::Template& automaton_;
    Places& places_;
    std::vector<Type> types_ = {};  // type of each parameter
    std::vector<bool> wide_ = {};
};

}  // namespace

std::vector<bool> wide_terms(const Network& network) {
    return wide_terms(network.exprs, [&](const Expr& leaf) { return type_of(network, leaf); });
}

std::vector<bool> wide_terms(const FlatSystem& flat) {
    return wide_terms(flat.exprs,
                      [&](const Expr& leaf) { return flat.variables[{static_cast<std::uint32_t>(leaf.value)}].type; });
}

bool fits(const Network& network, std::string_view target, Diagnostics& diagnostics) {
    Places places(target, diagnostics);
    for (const Id<Network::Template> id : network.templates.ids()) TemplatePlaces(network, id, places).add_all();
    return places.none();
}

bool fits(const TransitionSystem& system, std::string_view target, Diagnostics& diagnostics) {
    Places places(target, diagnostics);
    const FlatSystem flat = flattened(system);
    const std::vector<bool> wide = wide_terms(flat);
    for (const FlatSystem::Variable& variable : flat.variables)
        for (const auto& term : {variable.initial, variable.next})
            if (term && wide[term->index]) places.add(variable.origin, '`' + variable.name + '`');
    for (const auto* terms : {&flat.invariants, &flat.transitions, &flat.justice})
        for (const Id<Expr> term : *terms)
            if (wide[term.index]) places.add({}, "a guard of the plant");
    return places.none();
}

}  // namespace grafverif
