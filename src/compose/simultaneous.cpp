// SPDX-License-Identifier: MIT
#include "compose/simultaneous.hpp"

#include <algorithm>
#include <limits>

#include "ir/interval.hpp"

namespace grafverif {

namespace {

/// Terms with fewer nodes are repeated instead of being stored in a scratch variable.
constexpr std::uint64_t least_shared_size = 8;
constexpr std::size_t not_overwritten = std::numeric_limits<std::size_t>::max();

class Simultaneous {
public:
    Simultaneous(Composition& composition, const std::vector<Network::Assignment>& updates, const std::string& prefix)
        : composition_(composition), updates_(updates), prefix_(prefix), facts_(exprs().size()) {}

    std::vector<Network::Assignment> build() {
        find_reached();
        const std::vector<Interval> ranges = intervals(exprs(), [this](const Expr& leaf) { return type_of(leaf); });
        for (const Id<Expr> term : reached_) add(term, ranges[term.index]);
        for (const Network::Assignment& update : updates_) {
            const Id<Expr> value = facts_[update.value.index].replaced;
            if (value != update.target) list_.push_back({update.target, value});
        }
        return std::move(list_);
    }

private:
    struct Facts {
        bool reached = false;
        bool boolean = true;
        bool kept = false;                       ///< true if the value must be computed before the first update
        std::size_t uses = 0;                    ///< number of terms and updates that read the term
        std::size_t earliest = not_overwritten;  ///< index of the first update that overwrites a variable of the term

        /// Number of nodes, where a subterm in a scratch variable counts as one node.
        std::uint64_t size = 1;
        Id<Expr> replaced = {};  ///< the term in which scratch variables replace shared subterms
    };

    Exprs& exprs() { return composition_.network.exprs; }

    Type type_of(const Expr& leaf) const {
        if (leaf.op != Op::Variable) return {};
        return composition_.network.variables[{static_cast<std::uint32_t>(leaf.value)}].type;
    }

    /// Finds the terms that the updates read. Operands precede the terms that contain them.
    void find_reached() {
        for (std::size_t k = 0; k < updates_.size(); ++k) {
            Facts& target = facts_[updates_[k].target.index];
            target.earliest = std::min(target.earliest, k);
            Facts& value = facts_[updates_[k].value.index];
            value.reached = true;
            ++value.uses;
        }
        for (auto index = static_cast<std::uint32_t>(facts_.size()); index-- > 0;) {
            if (!facts_[index].reached) continue;
            reached_.push_back({index});
            for (const Id<Expr> operand : exprs().operands(Id<Expr>{index})) {
                facts_[operand.index].reached = true;
                ++facts_[operand.index].uses;
            }
        }
        std::ranges::reverse(reached_);
        for (const Id<Expr> term : reached_)
            for (const Id<Expr> operand : exprs().operands(term))
                facts_[term.index].earliest = std::min(facts_[term.index].earliest, facts_[operand.index].earliest);
        for (std::size_t k = 0; k < updates_.size(); ++k)
            if (Facts& value = facts_[updates_[k].value.index]; value.earliest < k) value.kept = true;
    }

    void add(Id<Expr> term, const Interval& range) {
        const Expr node = exprs()[term];
        const std::span<const Id<Expr>> written = exprs().operands(term);
        const std::vector<Id<Expr>> operands(written.begin(), written.end());
        Facts& facts = facts_[term.index];
        std::vector<Id<Expr>> replaced;
        for (const Id<Expr> operand : operands) {
            facts.size += facts_[operand.index].size;
            replaced.push_back(facts_[operand.index].replaced);
        }
        if (operands.empty()) facts.boolean = node.op == Op::Variable ? type_of(node).boolean : node.op != Op::Integer;
        else if (node.op == Op::Conditional) facts.boolean = facts_[operands[1].index].boolean;
        else facts.boolean = !is_arithmetic(node.op);
        facts.replaced = operands.empty() ? term : exprs().apply(node.op, replaced);
        const bool is_shared = facts.uses > 1 && facts.size >= least_shared_size;
        if (!facts.kept && !is_shared) return;
        const Id<Expr> scratch = leaf(composition_.network, scratch_variable(facts.boolean, range));
        list_.push_back({scratch, facts.replaced});
        facts.replaced = scratch;
        facts.size = 1;
    }

    Id<Network::Variable> scratch_variable(bool boolean, const Interval& range) {
        return composition_.network.variables.add({.name = composition_.names.fresh(prefix_ + "shared"),
                                                   .role = Network::Role::Internal,
                                                   .type = boolean ? Type{} : integer_type(range.low, range.high),
                                                   .initial = boolean ? 0 : range.low,
                                                   .scratch = true});
    }

    Composition& composition_;
    const std::vector<Network::Assignment>& updates_;
    const std::string& prefix_;
    std::vector<Facts> facts_;
    std::vector<Id<Expr>> reached_ = {};
    std::vector<Network::Assignment> list_ = {};
};

}  // namespace

std::vector<Network::Assignment> simultaneous(Composition& composition, const std::vector<Network::Assignment>& updates,
                                              const std::string& prefix) {
    return Simultaneous(composition, updates, prefix).build();
}

}  // namespace grafverif
