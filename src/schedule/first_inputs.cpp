// SPDX-License-Identifier: MIT
#include "schedule/first_inputs.hpp"

namespace grafverif::schedule {

std::vector<bool> read_at_first(const Equations& equations, ExecutionMode mode) {
    Exprs scratch;
    std::vector<Id<Expr>> values(equations.variables.size()), terms;
    const auto inserted = [&](Id<Expr> term) {
        return translate(equations.exprs, term, scratch, [&](const Expr& leaf) {
            const auto index = static_cast<std::size_t>(leaf.value);
            return values[index].valid() ? values[index]
                                         : scratch.leaf(Op::Variable, static_cast<std::uint32_t>(index));
        });
    };
    for (const Id<Equations::Variable> id : equations.variables.ids()) {
        const Equations::Variable& variable = equations.variables[id];
        if (variable.role == Equations::Role::Input) continue;
        values[id.index] =
            variable.type.boolean ? scratch.constant(variable.initial != 0) : scratch.integer(variable.initial);
    }
    std::vector<Id<Expr>> first;
    for (const Equations::Stored& stored : equations.stored) {
        first.push_back(inserted(stored.first));
        terms.push_back(inserted(stored.first_race));
    }
    for (const Equations::Previous& previous : equations.previous) terms.push_back(inserted(previous.value));
    terms.insert(terms.end(), first.begin(), first.end());
    for (std::size_t k = 0; k < first.size(); ++k) values[equations.stored[k].variable.index] = first[k];
    if (mode == ExecutionMode::EveryCycle)
        for (const Equations::Output& output : equations.outputs) terms.push_back(inserted(output.value));
    std::vector<bool> read(equations.variables.size());
    for (const Id<Expr> term : terms)
        for (const Id<Expr> leaf : leaves(scratch, term)) read[static_cast<std::size_t>(scratch[leaf].value)] = true;
    return read;
}

}  // namespace grafverif::schedule
