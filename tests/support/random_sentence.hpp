// SPDX-License-Identifier: MIT
// Generates random properties of docs/reference/properties.md, named `S`, of every kind and in every scope, over the
// names of a network.
#pragma once

#include <cstdint>

#include "grafverif/ir/network.hpp"
#include "support/random_chart.hpp"

namespace grafverif {

struct RandomSentence {
    Property property = {};
    std::int64_t duration = 0;  ///< in time units
};

inline RandomSentence random_sentence(Network& network, Random& random) {
    using Kind = Sentence::Kind;
    Exprs& exprs = network.exprs;
    const auto atom = [&]() -> Id<Expr> {
        for (;;) {
            const auto at = static_cast<std::uint32_t>(
                random_number(random, 0, static_cast<std::int64_t>(network.variables.size()) - 1));
            const Network::Variable& variable = network.variables[{at}];
            if (random_number(random, 0, 3) == 0) {
                const auto process = static_cast<std::uint32_t>(
                    random_number(random, 0, static_cast<std::int64_t>(network.processes.size()) - 1));
                const auto size = network.templates[network.processes[{process}].automaton].locations.size();
                return exprs.at(
                    process, static_cast<std::uint32_t>(random_number(random, 0, static_cast<std::int64_t>(size) - 1)));
            }
            if (variable.scratch) continue;
            const Id<Expr> leaf = exprs.leaf(Op::Variable, at);
            if (variable.type.boolean) return leaf;
            return exprs.apply(Op::Equal, leaf,
                               exprs.integer(random_number(random, variable.type.low, variable.type.high)));
        }
    };
    const auto term = [&] {
        const Id<Expr> one = random_number(random, 0, 1) == 0 ? atom() : exprs.negation(atom());
        return random_number(random, 0, 1) == 0 ? one : exprs.conjunction(one, atom());
    };
    RandomSentence made;
    Property& property = made.property;
    property = {.name = "S", .pattern = Pattern::Watched, .at_stable = random_number(random, 0, 3) == 0};
    property.watch.kind = static_cast<Kind>(random_number(random, 0, static_cast<std::int64_t>(Kind::Occurrences)));
    const bool counted = property.watch.kind == Kind::Occurrences;
    const bool timed = (property.watch.kind >= Kind::HoldsFor && !counted) ||
                       (property.watch.kind == Kind::Response && random_number(random, 0, 1) == 0);
    const bool global = (property.watch.kind == Kind::Precedence || counted) && random_number(random, 0, 4) == 0;
    const bool scoped = property.watch.kind != Kind::HoldsFor && property.watch.kind != Kind::Since;
    if (counted) property.watch.count = random_number(random, 1, 3);
    if (timed) made.duration = random_number(random, 1, 4);
    property.watch.duration_ms = made.duration * network.time_unit_ms;
    if (timed ? scoped && random_number(random, 0, 1) == 0 : !global)
        property.watch.scope = static_cast<Sentence::Scope>(random_number(random, 1, 4));
    const bool pair = property.watch.kind == Kind::Response || property.watch.kind == Kind::Precedence ||
                      property.watch.kind == Kind::Since;
    std::size_t operands = pair ? 2 : 1;
    if (property.watch.scope != Sentence::Scope::Globally)
        operands += property.watch.scope >= Sentence::Scope::Between ? 2 : 1;
    for (std::size_t i = 0; i < operands; ++i) property.operands.push_back(term());
    return made;
}

}  // namespace grafverif
