// SPDX-License-Identifier: MIT
#include "analyse/counters.hpp"

#include <algorithm>
#include <limits>

#include "bdd/terms.hpp"

namespace grafverif::analysis {

namespace {

using Variable = Equations::Variable;

constexpr std::int64_t endless = std::numeric_limits<std::int64_t>::max();

/// Tests, in one pass over all terms, if one variable is a counter. A term is called dependent if its value is the
/// variable, or the variable plus a constant. For a counter, dependent terms occur only in comparisons with constants,
/// in conditional terms, and in the next value of the variable.
class Reader {
public:
    Reader(const Equations& equations, const Equations::Stored& stored)
        : equations_(equations),
          exprs_(equations.exprs),
          stored_(stored),
          depends_on_it_(equations.exprs.size()),
          added_(equations.exprs.size()) {}

    std::optional<Counter> read() {
        const Variable& variable = equations_.variables[stored_.variable];
        meet(variable.initial);
        for (std::uint32_t term = 0; term < exprs_.size() && good_; ++term) look(Id<Expr>{term});
        for (const Id<Expr> term : {stored_.next, stored_.first}) assign(term);
        for (const Equations::Write& write : stored_.writes) assign(write.value);
        check_other_uses();
        const Type kept = integer_type(least_, greatest_ + (most_ > 0 ? 1 : 0));
        if (!good_ || kept.low < variable.type.low || kept.high > variable.type.high ||
            bit_count(kept) >= bit_count(variable.type))
            return {};
        return Counter{kept, most_, most_ == 0 ? endless : (variable.type.high - greatest_) / most_};
    }

private:
    bool is_number(Id<Expr> term) const { return exprs_[term].op == Op::Integer; }

    void meet(std::int64_t value) {
        least_ = met_ ? std::min(least_, value) : value;
        greatest_ = met_ ? std::max(greatest_, value) : value;
        met_ = true;
    }

    void compare(Id<Expr> term) {
        if (is_number(term)) greatest_ = std::max(greatest_, exprs_[term].value);
        else good_ = good_ && depends_on_it_[term.index];
    }

    void look(Id<Expr> id) {
        const Expr& node = exprs_[id];
        const auto operands = exprs_.operands(id);
        if (node.op == Op::Variable) {
            depends_on_it_[id.index] = node.value == static_cast<std::int64_t>(stored_.variable.index);
            return;
        }
        if (std::ranges::none_of(operands, [&](Id<Expr> operand) -> bool { return depends_on_it_[operand.index]; }))
            return;
        if (is_comparison(node.op)) {
            for (const Id<Expr> operand : operands) compare(operand);
        } else if (node.op == Op::Plus && operands.size() == 2) {
            const bool first = depends_on_it_[operands[0].index];
            add(id, operands[first ? 0 : 1], operands[first ? 1 : 0]);
        } else if (node.op == Op::Conditional && !depends_on_it_[operands[0].index]) {
            depends_on_it_[id.index] = true;
            for (const Id<Expr> operand : operands.subspan(1)) {
                assign(operand);
                added_[id.index] = std::max(added_[id.index], added_[operand.index]);
            }
        } else {
            good_ = false;
        }
    }

    void add(Id<Expr> id, Id<Expr> term, Id<Expr> what) {
        good_ = good_ && is_number(what) && exprs_[what].value >= 0 && exprs_[what].value <= greatest_integer;
        depends_on_it_[id.index] = true;
        if (good_) added_[id.index] = added_[term.index] + exprs_[what].value;
        most_ = std::max(most_, added_[id.index]);
    }

    void assign(Id<Expr> term) {
        if (!term.valid()) return;
        if (is_number(term)) meet(exprs_[term].value);
        else good_ = good_ && depends_on_it_[term.index];
    }

    /// Checks that no output and no other stored variable has a dependent term as its value.
    void check_other_uses() {
        const auto refuse = [&](Id<Expr> term) { good_ = good_ && !(term.valid() && depends_on_it_[term.index]); };
        for (const Equations::Output& output : equations_.outputs) refuse(output.value);
        for (const Equations::Stored& other : equations_.stored) {
            if (other.variable == stored_.variable) continue;
            refuse(other.next);
            refuse(other.first);
            for (const Equations::Write& write : other.writes) refuse(write.value);
        }
    }

    const Equations& equations_;
    const Exprs& exprs_;
    const Equations::Stored& stored_;
    std::vector<bool>
        depends_on_it_;  ///< for each term: true if its value is the variable, or the variable plus a constant
    std::vector<std::int64_t> added_;  ///< for each term: upper bound of the added constant
    std::int64_t least_ = 0, greatest_ = 0, most_ = 0;
    bool met_ = false, good_ = true;
};

}  // namespace

std::vector<std::optional<Counter>> counters(const Equations& equations) {
    constexpr std::size_t most_terms = 20'000'000;  // maximum number of terms visited in total
    std::vector<std::optional<Counter>> result(equations.variables.size());
    if (equations.stored.size() * equations.exprs.size() > most_terms) return result;
    for (const Equations::Stored& stored : equations.stored)
        if (!equations.variables[stored.variable].type.boolean)
            result[stored.variable.index] = Reader(equations, stored).read();
    return result;
}

}  // namespace grafverif::analysis
