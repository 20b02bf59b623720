// SPDX-License-Identifier: MIT
#include "schedule/constraints.hpp"

#include <map>
#include <optional>

#include "grafverif/schedule/controller.hpp"
#include "grafverif/support/messages.hpp"

namespace grafverif {

namespace {

/// The inputs that a constraint reads; nothing where it reads something else.
std::optional<std::vector<Id<ClosedLoop::Shared>>> inputs_of(const ClosedLoop& loop, Id<Expr> condition) {
    std::vector<Id<ClosedLoop::Shared>> found;
    for (const Id<Expr> leaf : leaves(loop.exprs, condition)) {
        const Id<ClosedLoop::Symbol> symbol{static_cast<std::uint32_t>(loop.exprs[leaf].value)};
        const auto* shared = std::get_if<ClosedLoop::SharedSymbol>(&loop.symbols[symbol]);
        if (shared == nullptr) return {};
        const ClosedLoop::Shared& of = loop.shared[shared->shared];
        if (!of.reader.valid() || of.writer.valid()) return {};
        found.push_back(shared->shared);
    }
    return found;
}

/// Looks for inputs of which some constraints hold, one input after the other; a constraint is judged as soon as its
/// last input has a value.
class InputSearch {
public:
    explicit InputSearch(const ClosedLoop& loop) : loop_(loop) {}

    /// Whether the constraints taken so far and this one hold together of some inputs; nothing: not found in time.
    std::optional<bool> admits(Id<Expr> condition, const std::vector<Id<ClosedLoop::Shared>>& inputs) {
        for (const Id<ClosedLoop::Shared> input : inputs)
            if (values_.emplace(input, loop_.shared[input].type.low).second) order_.push_back(input);
        conditions_.push_back({condition, inputs});
        if (value(condition)) return true;   // of the inputs found before
        judged_.assign(order_.size() + 1, {});
        for (const auto& [one, of] : conditions_) judged_[last_input(of)].push_back(one);
        steps_ = 0;
        return search();
    }

private:
    static constexpr std::size_t most_steps = 2'000'000;

    bool value(Id<Expr> condition) const {
        const auto result = evaluate(loop_.exprs, condition, [&](const Expr& leaf) {
            const Id<ClosedLoop::Symbol> symbol{static_cast<std::uint32_t>(leaf.value)};
            return values_.at(std::get<ClosedLoop::SharedSymbol>(loop_.symbols[symbol]).shared);
        });
        return result.value_or(0) != 0;
    }

    /// How many inputs have to have a value before a condition over `inputs` has one.
    std::size_t last_input(const std::vector<Id<ClosedLoop::Shared>>& inputs) const {
        std::size_t needed = 0;
        for (const Id<ClosedLoop::Shared> input : inputs)
            for (std::size_t k = 0; k < order_.size(); ++k)
                if (order_[k] == input) needed = std::max(needed, k + 1);
        return needed;
    }

    bool fits(std::size_t depth) const {
        for (const Id<Expr> condition : judged_[depth])
            if (!value(condition)) return false;
        return true;
    }

    /// By counting: the input at the depth takes its next value, or hands back to the one before.
    std::optional<bool> search() {
        if (!fits(0)) return false;
        std::size_t depth = 0;
        if (!order_.empty()) values_[order_[0]] = loop_.shared[order_[0]].type.low;
        while (depth < order_.size()) {
            if (++steps_ > most_steps) return {};
            if (fits(depth + 1)) {
                if (++depth < order_.size()) values_[order_[depth]] = loop_.shared[order_[depth]].type.low;
                continue;
            }
            while (values_[order_[depth]] == loop_.shared[order_[depth]].type.high) {
                if (depth == 0) return false;
                --depth;
            }
            ++values_[order_[depth]];
        }
        return true;
    }

    const ClosedLoop& loop_;
    std::vector<Id<ClosedLoop::Shared>> order_ = {};
    std::map<Id<ClosedLoop::Shared>, std::int64_t> values_ = {};
    std::vector<std::pair<Id<Expr>, std::vector<Id<ClosedLoop::Shared>>>> conditions_ = {};
    std::vector<std::vector<Id<Expr>>> judged_ = {};   ///< by the number of inputs that have a value
    std::size_t steps_ = 0;
};

}  // namespace

bool constraints_agree(const ClosedLoop& loop, Diagnostics& diagnostics) {
    InputSearch search(loop);
    for (const ClosedLoop::Constraint& constraint : loop.constraints) {
        const auto inputs = inputs_of(loop, constraint.condition);
        if (!inputs) continue;
        const std::optional<bool> admitted = search.admits(constraint.condition, *inputs);
        if (admitted.value_or(false)) continue;
        diagnostics.add(messages::constraints_contradict(constraint.origin, constraint.name, admitted.has_value()));
        return false;
    }
    return true;
}

namespace schedule {

void assume_constraints(TransitionSystem& system, const ClosedLoop& loop, const LoopMeaning& meaning) {
    for (const ClosedLoop::Constraint& constraint : loop.constraints) {
        std::string reason;
        if (!inputs_of(loop, constraint.condition)) continue;
        const Id<Expr> term = term_of(system, loop, meaning, constraint.condition, reason);
        if (term.valid()) system.modules[system.main].invariants.push_back(term);
    }
}

}  // namespace schedule

}  // namespace grafverif
