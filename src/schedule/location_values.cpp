// SPDX-License-Identifier: MIT
#include "schedule/location_values.hpp"

namespace grafverif::schedule {

namespace {

/// What an edge leaves in a variable that held `before`; empty: no constant.
std::optional<std::int64_t> value_after(const Slots& slots, const Network::Edge& edge, Id<Network::Variable> variable,
                                        std::int64_t before) {
    const Exprs& exprs = slots.network.exprs;
    std::optional<std::int64_t> value = before;
    for (const auto& [target, term] : slots.assignments(edge)) {
        if (slots.variable(exprs[target]) != variable) continue;
        bool constant = true;
        for (const Id<Expr> leaf : leaves(exprs, term))
            constant = constant && !slots.variable(exprs[leaf]).valid();
        if (!constant) return {};
        value = evaluate(exprs, term, [&](const Expr& leaf) { return slots.constant(leaf); });
        if (!value) return {};
    }
    return value;
}

}  // namespace

std::optional<std::vector<std::int64_t>> location_values(const Slots& slots, Id<Network::Variable> variable) {
    const std::int64_t initial = slots.network.variables[variable].initial;
    const Type type = slots.network.variables[variable].type;
    std::vector<std::optional<std::int64_t>> known(slots.automaton.locations.size());
    known[slots.process.initial.index] = initial;
    for (bool grew = true; grew;) {
        grew = false;
        for (const Network::Edge& edge : slots.automaton.edges) {
            if (!known[edge.from.index]) continue;
            const auto value = value_after(slots, edge, variable, *known[edge.from.index]);
            if (!value || *value < type.low || *value > type.high) return {};
            std::optional<std::int64_t>& there = known[edge.to.index];
            if (there && *there != *value) return {};
            grew = grew || !there;
            there = value;
        }
    }
    std::vector<std::int64_t> values;
    for (const std::optional<std::int64_t>& value : known) values.push_back(value.value_or(initial));
    return values;
}

}  // namespace grafverif::schedule
