// SPDX-License-Identifier: MIT
#include "ir/sorts.hpp"

#include <algorithm>
#include <string_view>

#include "support/overloaded.hpp"

namespace grafverif {

namespace {

std::string_view described(Sort sort) {
    switch (sort) {
    case Sort::None: return "well typed";
    case Sort::Boolean: return "Boolean";
    case Sort::Integer: return "an integer";
    case Sort::Duration: return "a duration";
    }
    unreachable();
}

}  // namespace

Sort Sorts::operator()(Id<Expr> term) {
    if (!exprs_->contains(term)) return Sort::None;
    if (const auto found = known_.find(term.index); found != known_.end()) return found->second;
    const Sort sort = of(term);
    known_.emplace(term.index, sort);
    return sort;
}

bool Sorts::check(Id<Expr> term, Sort wanted, const std::string& what, std::vector<std::string>& faults) {
    if (!exprs_->contains(term)) faults.push_back(what + " is missing");
    else if (const Sort found = (*this)(term); found == Sort::None) faults.push_back(what + " contains a type error");
    else if (found != wanted) faults.push_back(what + " is not " + std::string(described(wanted)));
    else return true;
    return false;
}

bool Sorts::all(Id<Expr> term, Sort sort) {
    return std::ranges::all_of(exprs_->operands(term), [&](Id<Expr> operand) { return (*this)(operand) == sort; });
}

Sort Sorts::of(Id<Expr> term) {
    const Expr& node = (*exprs_)[term];
    const auto operand = [&](std::size_t i) { return (*this)(exprs_->operands(term)[i]); };
    switch (node.op) {
    case Op::False:
    case Op::True: return Sort::Boolean;
    case Op::Integer: return Sort::Integer;
    case Op::Duration:
    case Op::Variable:
    case Op::Step:
    case Op::Timed:
    case Op::Parameter:
    case Op::At: return leaf_(node);
    case Op::Rise:
    case Op::Fall: return all(term, Sort::Boolean) ? leaf_(node) : Sort::None;
    case Op::Not:
    case Op::And:
    case Op::Or: return all(term, Sort::Boolean) ? Sort::Boolean : Sort::None;
    case Op::Equal:
    case Op::NotEqual: return all(term, Sort::Boolean) || all(term, Sort::Integer) ? Sort::Boolean : Sort::None;
    case Op::Less:
    case Op::LessEqual:
    case Op::Greater:
    case Op::GreaterEqual: return all(term, Sort::Integer) ? Sort::Boolean : Sort::None;
    case Op::Plus:
        if (all(term, Sort::Duration)) return Sort::Duration;
        return all(term, Sort::Integer) ? Sort::Integer : Sort::None;
    case Op::Times:
        if (operand(0) == Sort::Integer && operand(1) == Sort::Duration) return Sort::Duration;
        if (operand(0) == Sort::Duration && operand(1) == Sort::Integer) return Sort::Duration;
        return all(term, Sort::Integer) ? Sort::Integer : Sort::None;
    case Op::Negate:
    case Op::Minus:
    case Op::Divide:
    case Op::Modulo: return all(term, Sort::Integer) ? Sort::Integer : Sort::None;
    case Op::Conditional: return operand(0) == Sort::Boolean && operand(1) == operand(2) ? operand(1) : Sort::None;
    }
    unreachable();
}

}  // namespace grafverif
