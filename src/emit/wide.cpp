// SPDX-License-Identifier: MIT
#include "emit/wide.hpp"

#include <string>
#include <vector>

#include "ir/flat_system.hpp"
#include "ir/interval.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

/// Tells of each place once.
class Places {
public:
    Places(std::string_view target, Diagnostics& diagnostics)
        : target_(target), diagnostics_(diagnostics), errors_(diagnostics.errors()) {}

    void add(Span where, const std::string& what) {
        if (where == last_ && diagnostics_.errors() != errors_) return;
        last_ = where;
        diagnostics_.add(messages::too_wide(where, what, target_));
    }
    bool none() const { return diagnostics_.errors() == errors_; }

private:
    std::string_view target_;
    Diagnostics& diagnostics_;
    std::size_t errors_ = 0;
    Span last_ = {};
};

std::string of_property(const Property& property) { return "property `" + property.name + '`'; }

class NetworkPlaces {
public:
    NetworkPlaces(const Network& network, Places& places)
        : network_(network), places_(places), wide_(wide_terms(network.exprs, [&](const Expr& leaf) {
              return leaf.op == Op::Variable ? network.variables[{static_cast<std::uint32_t>(leaf.value)}].type
                                             : Type{};
          })) {}

    void add_all() {
        for (const Network::Template& automaton : network_.templates) {
            for (const Network::Location& location : automaton.locations) add(location.invariant, location.origin);
            for (const Network::Procedure& procedure : automaton.procedures)
                add(procedure.assignments, automaton.origin);
            for (const Network::Edge& edge : automaton.edges) {
                if (wide_[edge.guard.index]) places_.add(edge.origin, "the guard of an edge");
                add(edge.constraint, edge.origin);
                add(edge.assignments, edge.origin);
            }
        }
        for (const Property& property : network_.properties)
            for (const Id<Expr> operand : property.operands)
                if (wide_[operand.index]) places_.add(property.origin, of_property(property));
    }

private:
    void add(const std::vector<Network::ClockConstraint>& constraints, Span where) {
        constexpr std::int64_t longest = (std::int64_t{1} << 30U) - 2;
        for (const Network::ClockConstraint& constraint : constraints) {
            const Expr& bound = network_.exprs[constraint.bound];
            if (wide_[constraint.bound.index] || bound.value > longest)
                places_.add(where, "what a clock is compared with");
        }
    }

    void add(const std::vector<Network::Assignment>& assignments, Span where) {
        for (const Network::Assignment& assignment : assignments) {
            if (!wide_[assignment.target.index] && !wide_[assignment.value.index]) continue;
            const Expr& target = network_.exprs[assignment.target];
            places_.add(where, '`' + network_.variables[{static_cast<std::uint32_t>(target.value)}].told_name() + '`');
        }
    }

    const Network& network_;
    Places& places_;
    std::vector<bool> wide_;
};

}  // namespace

bool fits(const Network& network, std::string_view target, Diagnostics& diagnostics) {
    Places places(target, diagnostics);
    NetworkPlaces(expand(network), places).add_all();
    return places.none();
}

bool fits(const TransitionSystem& system, std::string_view target, Diagnostics& diagnostics) {
    Places places(target, diagnostics);
    FlatSystem flat = flattened(system);
    std::vector<std::vector<Id<Expr>>> asked;  // per property
    for (const Property& property : system.properties) {
        std::vector<Id<Expr>>& operands = asked.emplace_back();
        for (const Id<Expr> operand : property.operands) operands.push_back(flattened(system, flat, operand));
    }
    const std::vector<bool> wide = wide_terms(
        flat.exprs, [&](const Expr& leaf) { return flat.variables[{static_cast<std::uint32_t>(leaf.value)}].type; });
    for (const FlatSystem::Variable& variable : flat.variables)
        for (const auto& term : {variable.initial, variable.next})
            if (term && wide[term->index]) places.add(variable.origin, '`' + variable.name + '`');
    for (const auto* terms : {&flat.invariants, &flat.transitions, &flat.justice})
        for (const Id<Expr> term : *terms)
            if (wide[term.index]) places.add({}, "what the steps of the model keep to");
    for (const Id<Property> id : system.properties.ids())
        for (const Id<Expr> operand : asked[id.index])
            if (wide[operand.index]) places.add(system.properties[id].origin, of_property(system.properties[id]));
    return places.none();
}

}  // namespace grafverif
