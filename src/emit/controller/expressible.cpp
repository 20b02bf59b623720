// SPDX-License-Identifier: MIT
// Detects constructs that 32-bit integers and timers cannot compute exactly according to the equations.
#include <limits>
#include <vector>

#include "emit/controller/code.hpp"
#include "ir/interval.hpp"

namespace grafverif::controller {

namespace {

constexpr std::int64_t longest_ms = std::numeric_limits<std::int32_t>::max();

/// For each term: the reason why 32-bit arithmetic does not compute the term exactly, or an empty text if the result is
/// exact. One pass over the table is sufficient, because children precede parents.
class Obstacles {
public:
    explicit Obstacles(const Equations& equations) : exprs_(equations.exprs), reasons_(equations.exprs.size()) {
        const std::vector<bool> wide = wide_terms(equations.exprs, [&](const Expr& leaf) {
            return equations.variables[Id<Equations::Variable>{static_cast<std::uint32_t>(leaf.value)}].type;
        });
        for (std::uint32_t index = 0; index < exprs_.size(); ++index) {
            const Id<Expr> term{index};
            for (const Id<Expr> operand : exprs_.operands(term))
                if (reasons_[index] == nullptr) reasons_[index] = reasons_[operand.index];
            if (reasons_[index] == nullptr) reasons_[index] = own(term);
            if (reasons_[index] == nullptr && wide[index]) reasons_[index] = "a value that may need more than 32 bits";
        }
    }

    const char* of(Id<Expr> term) const { return term.valid() ? reasons_[term.index] : nullptr; }

private:
    const char* own(Id<Expr> term) const {
        const Expr& node = exprs_[term];
        const bool divides = node.op == Op::Divide || node.op == Op::Modulo;
        if (divides && exprs_[exprs_.operands(term)[1]].op != Op::Integer) return "a division by a variable";
        if (divides && exprs_[exprs_.operands(term)[1]].value == 0) return "a division by zero";
        // If the dividend is the least integer, the remainder of a division by -1 is undefined in C.
        if (node.op == Op::Modulo && exprs_[exprs_.operands(term)[1]].value == -1)
            return "a remainder of a division by -1";
        return nullptr;
    }

    const Exprs& exprs_;
    std::vector<const char*> reasons_;
};

}  // namespace

bool expressible(const Equations& equations, Diagnostic (*message)(Span where, std::string_view what),
                 Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.errors();
    const Obstacles obstacles(equations);
    const auto check = [&](Id<Expr> term, Span where) {
        if (const char* reason = obstacles.of(term)) diagnostics.add(message(where, reason));
    };
    for (const Equations::Firing& firing : equations.firings) check(firing.condition, firing.origin);
    for (const Equations::Output& output : equations.outputs) check(output.value, output.origin);
    for (const Equations::Stored& stored : equations.stored)
        for (const Equations::Write& write : stored.writes) {
            check(write.trigger, write.origin);
            check(write.value, write.origin);
        }
    for (const Equations::Previous& previous : equations.previous) check(previous.value, previous.origin);
    for (const Equations::ObservedTerm& watch : equations.watches) check(watch.value, watch.origin);
    for (const Equations::Conflict& conflict : equations.conflicts) check(conflict.condition, conflict.origin);
    for (const Equations::Timer& timer : equations.timers)
        if (timer.rise_ms > longest_ms || timer.fall_ms > longest_ms)
            diagnostics.add(message(timer.origin, "a duration of more than 24 days"));
    return diagnostics.errors() == errors;
}

}  // namespace grafverif::controller
