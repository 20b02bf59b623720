// SPDX-License-Identifier: MIT
#include "conform/location_terms.hpp"

#include <algorithm>

namespace grafverif::conform {

LocationTerms::LocationTerms(const Equations& equations, const InputOf& inputs, const InputSpace& space)
    : equations_(equations), inputs_(inputs), space_(space), of_inputs_(equations.exprs, [this](const Expr& leaf) {
          return space_.term(*inputs_[static_cast<std::size_t>(leaf.value)]);
      }) {
    const Exprs& exprs = equations.exprs;
    for (std::uint32_t index = 0; index < exprs.size(); ++index) {
        const Id<Expr> id{index};
        if (exprs[id].op == Op::Variable) {
            kinds_.push_back(is_input(exprs[id]) ? Kind::OfInputs : Kind::Fixed);
            continue;
        }
        bool reads_inputs = false, reads_location = false;
        for (const Id<Expr> operand : exprs.operands(id)) {
            reads_inputs = reads_inputs || kinds_[operand.index] != Kind::Fixed;
            reads_location =
                reads_location || (kinds_[operand.index] != Kind::OfInputs && !is_constant(exprs[operand].op));
        }
        kinds_.push_back(!reads_inputs ? Kind::Fixed : reads_location ? Kind::Mixed : Kind::OfInputs);
    }
}

LocationValue LocationTerms::value(Id<Expr> term, const Values& at) {
    switch (kinds_[term.index]) {
    case Kind::Fixed: return fixed(term, at);
    case Kind::OfInputs: return {0, false, of_inputs_(term)};
    case Kind::Mixed: break;
    }
    const Op op = equations_.exprs[term].op;
    if ((op == Op::And || op == Op::Or) && split(term) != nullptr) return joined(term, at);
    if (op != Op::Not) return anyhow(term, at);
    LocationValue result = value(equations_.exprs.operands(term)[0], at);
    if (result.function) result.function->bits.front() = ~result.function->bits.front();
    else result.number = result.number == 0;
    return result;
}

LocationCondition LocationTerms::condition(Id<Expr> term, const Values& at) {
    if (std::optional<Bdd> found = plain_condition(term, at)) return {std::move(*found), {}};
    LocationValue found = value(term, at);
    if (!found.function) return {Bdd::constant(found.number != 0), Bdd::constant(found.none)};
    return {std::move(found.function->bits.front()), std::move(found.function->undefined)};
}

/// Evaluates a term in the most frequent case: a conjunction or disjunction in which each operand reads either only
/// inputs or no inputs. An operand that reads no inputs has a constant value in the location.
std::optional<Bdd> LocationTerms::plain_condition(Id<Expr> term, const Values& at) {
    const Op op = equations_.exprs[term].op;
    if (kinds_[term.index] != Kind::Mixed || (op != Op::And && op != Op::Or)) return {};
    const Split* const parts = split(term);
    if (parts == nullptr) return {};
    const bool decides = op == Op::Or;
    for (const Id<Expr> operand : parts->others) {
        if (kinds_[operand.index] != Kind::Fixed) return {};
        const LocationValue value = fixed(operand, at);
        if (value.none) return {};
        if ((value.number != 0) == decides) return Bdd::constant(decides);
    }
    return parts->inputs;
}

/// Evaluates a term without inputs. The function is recursive; `derive` limits the depth.
LocationValue LocationTerms::fixed(Id<Expr> term, const Values& at) const {
    const Expr& node = equations_.exprs[term];
    switch (node.op) {
    case Op::Variable: return {at[static_cast<std::size_t>(node.value)], false, {}};
    case Op::Not: {
        LocationValue result = fixed(equations_.exprs.operands(term)[0], at);
        result.number = result.number == 0;
        return result;
    }
    case Op::And:
    case Op::Or: {
        const bool decides = node.op == Op::Or;
        for (const Id<Expr> operand : equations_.exprs.operands(term)) {
            LocationValue result = fixed(operand, at);
            if (result.none || (result.number != 0) == decides) return result;
        }
        return {decides ? 0 : 1, false, {}};
    }
    default: break;
    }
    const std::optional<std::int64_t> number =
        evaluate(equations_.exprs, term, [&at](const Expr& leaf) { return at[static_cast<std::size_t>(leaf.value)]; });
    return {number.value_or(0), !number, {}};
}

/// Returns the value of an And or Or of the kind Mixed, which reads both inputs and variables. The operands that are
/// combined in `Split::inputs` are always defined; therefore, their position among the other operands is irrelevant.
LocationValue LocationTerms::joined(Id<Expr> term, const Values& at) {
    const bool decides = equations_.exprs[term].op == Op::Or;
    const Split& parts = *split(term);
    std::optional<BddTerm> result;
    for (const Id<Expr> operand : parts.others) {
        LocationValue other = value(operand, at);
        if (other.none) return anyhow(term, at);  // whether this undefined operand is evaluated depends on the inputs
        if (!other.function) {
            if ((other.number != 0) == decides) return other;
            continue;
        }
        if (!other.function->undefined.is_false()) return anyhow(term, at);
        if (!result) result = std::move(other.function);
        else if (decides) result->bits.front() |= other.function->bits.front();
        else result->bits.front() &= other.function->bits.front();
    }
    if (!result) return {0, false, bdd_boolean(parts.inputs)};
    if (decides) result->bits.front() |= parts.inputs;
    else result->bits.front() &= parts.inputs;
    return {0, false, std::move(result)};
}

LocationValue LocationTerms::anyhow(Id<Expr> term, const Values& at) const {
    BddTerms terms(equations_.exprs, [this, &at](const Expr& leaf) {
        const auto variable = static_cast<std::size_t>(leaf.value);
        if (inputs_[variable]) return space_.term(*inputs_[variable]);
        if (equations_.variables[{static_cast<std::uint32_t>(variable)}].type.boolean)
            return bdd_boolean(Bdd::constant(at[variable] != 0));
        return bdd_integer(at[variable]);
    });
    return {0, false, terms(term)};
}

const LocationTerms::Split* LocationTerms::split(Id<Expr> term) {
    const auto [place, added] = splits_.try_emplace(term.index);
    if (!added) return place->second ? &*place->second : nullptr;
    const bool conjunction = equations_.exprs[term].op == Op::And;
    Split result{Bdd::constant(conjunction), {}};
    for (const Id<Expr> operand : equations_.exprs.operands(term)) {
        if (kinds_[operand.index] != Kind::OfInputs) {
            result.others.push_back(operand);
            continue;
        }
        const BddTerm& part = of_inputs_(operand);
        if (!part.undefined.is_false()) return nullptr;
        if (conjunction) result.inputs &= part.bits.front();
        else result.inputs |= part.bits.front();
    }
    place->second = std::move(result);
    return &*place->second;
}

}  // namespace grafverif::conform
