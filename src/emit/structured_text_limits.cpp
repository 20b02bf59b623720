// SPDX-License-Identifier: MIT
// What a block cannot compute exactly as the equations say.
#include <limits>
#include <string>
#include <vector>

#include "grafverif/emit/structured_text.hpp"
#include "grafverif/ir/interval.hpp"
#include "grafverif/support/messages.hpp"

namespace grafverif::structured_text {

namespace {

constexpr std::int64_t least = std::numeric_limits<std::int32_t>::min();
constexpr std::int64_t greatest = std::numeric_limits<std::int32_t>::max();

/// For each term: why DINT arithmetic does not compute it, or an empty text. Children precede parents: one pass.
class Obstacles {
public:
    explicit Obstacles(const Equations& equations) : exprs_(equations.exprs), reasons_(equations.exprs.size()) {
        const TypeOf type_of = [&](const Expr& leaf) {
            return equations.variables[Id<Equations::Variable>{static_cast<std::uint32_t>(leaf.value)}].type;
        };
        for (std::uint32_t index = 0; index < exprs_.size(); ++index) {
            const Id<Expr> term{index};
            for (const Id<Expr> operand : exprs_.operands(term))
                if (reasons_[index] == nullptr) reasons_[index] = reasons_[operand.index];
            if (reasons_[index] == nullptr) reasons_[index] = own(term, type_of);
        }
    }

    const char* of(Id<Expr> term) const { return term.valid() ? reasons_[term.index] : nullptr; }

private:
    const char* own(Id<Expr> term, const TypeOf& type_of) const {
        const Expr& node = exprs_[term];
        if (!is_arithmetic(node.op) && node.op != Op::Integer) return nullptr;
        const bool divides = node.op == Op::Divide || node.op == Op::Modulo;
        if (divides && exprs_[exprs_.operands(term)[1]].op != Op::Integer) return "a division by what is no constant";
        if (divides && exprs_[exprs_.operands(term)[1]].value == 0) return "a division by zero";
        const Interval values = interval(exprs_, term, type_of);
        return values.low < least || values.high > greatest ? "a value that may need more than 32 bits" : nullptr;
    }

    const Exprs& exprs_;
    std::vector<const char*> reasons_;
};

}  // namespace

bool expressible(const Equations& equations, Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.errors();
    const Obstacles obstacles(equations);
    const auto check = [&](Id<Expr> term, Span where) {
        if (const char* reason = obstacles.of(term)) diagnostics.add(messages::not_in_structured_text(where, reason));
    };
    for (const Equations::Firing& firing : equations.firings) check(firing.condition, firing.origin);
    for (const Equations::Output& output : equations.outputs) check(output.value, output.origin);
    for (const Equations::Stored& stored : equations.stored)
        for (const Equations::Write& write : stored.writes) {
            check(write.trigger, write.origin);
            check(write.value, write.origin);
        }
    for (const Equations::Previous& previous : equations.previous) check(previous.value, previous.origin);
    for (const Equations::Watch& watch : equations.watches) check(watch.value, watch.origin);
    for (const Equations::Conflict& conflict : equations.conflicts) check(conflict.condition, conflict.origin);
    for (const Equations::Timer& timer : equations.timers)
        if (timer.rise_ms > greatest || timer.fall_ms > greatest)
            diagnostics.add(messages::not_in_structured_text(timer.origin, "a duration of more than 24 days"));
    return diagnostics.errors() == errors;
}

}  // namespace grafverif::structured_text
