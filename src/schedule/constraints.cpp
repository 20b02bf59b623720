// SPDX-License-Identifier: MIT
#include "schedule/constraints.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "grafverif/bdd/terms.hpp"
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

/// The inputs that the constraints taken so far leave, as a function of their bits.
class Inputs {
public:
    /// Bits of one place are neighbours, so that inputs can be compared.
    explicit Inputs(const ClosedLoop& loop) : loop_(loop), terms_(loop.exprs, [this](const Expr& leaf) { return term(leaf); }) {
        std::size_t most = 0;
        for (const ClosedLoop::Constraint& constraint : loop.constraints)
            for (const Id<ClosedLoop::Shared> input : inputs_of(loop, constraint.condition).value_or(std::vector<Id<ClosedLoop::Shared>>{})) {
                const Type type = loop.shared[input].type;
                if (words_.try_emplace(input, BddWord{type, {}}).second) most = std::max(most, bit_count(type));
            }
        for (std::size_t place = most; place-- > 0;)
            for (auto& [input, word] : words_)
                if (place < bit_count(word.type)) word.bits.insert(word.bits.begin(), space_.add_variables(1));
        for (const auto& [input, word] : words_) left_ &= in_range(space_, word);
    }

    /// Whether the constraints so far and this one hold together of some inputs; nothing: that takes too much memory.
    std::optional<bool> admit(Id<Expr> condition) {
        try {
            const BddTerm& found = terms_(condition);
            left_ &= found.bits.front() & ~found.undefined;
            return !left_.is_false();
        } catch (const BddExhausted&) {
            return {};
        }
    }

private:
    BddTerm term(const Expr& leaf) const {
        const Id<ClosedLoop::Symbol> symbol{static_cast<std::uint32_t>(leaf.value)};
        return term_of(space_, words_.at(std::get<ClosedLoop::SharedSymbol>(loop_.symbols[symbol]).shared));
    }

    const ClosedLoop& loop_;
    BddSpace space_ = BddSpace({std::uint64_t{1} << 28U});
    std::map<Id<ClosedLoop::Shared>, BddWord> words_ = {};
    Bdd left_ = Bdd::constant(true);
    BddTerms terms_;
};

}  // namespace

bool constraints_agree(const ClosedLoop& loop, Diagnostics& diagnostics) {
    Inputs inputs(loop);
    for (const ClosedLoop::Constraint& constraint : loop.constraints) {
        if (!inputs_of(loop, constraint.condition)) continue;
        const std::optional<bool> admitted = inputs.admit(constraint.condition);
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
