// SPDX-License-Identifier: MIT
#include "read/integer_ranges.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>

#include "support/overloaded.hpp"

namespace grafverif {

namespace {

bool compares(tree::Op op) { return op >= tree::Op::Equal && op <= tree::Op::GreaterEqual; }

class Uses {
public:
    Uses(const tree::File& file, const std::vector<OpenInteger>& integers) : file_(file), found_(integers.size()) {
        for (std::size_t i = 0; i < integers.size(); ++i) {
            known_.emplace(integers[i].variable, i);
            found_[i] = {integers[i].initial, integers[i].initial, true};
        }
        compared_.resize(integers.size());
    }

    void items(const std::vector<tree::ChartItem>& all) {
        for (const tree::ChartItem& item : all) {
            std::visit(overloaded{
                           [](const tree::Variables&) {},
                           [this](const tree::Constraint& constraint) { term(constraint.condition); },
                           [](const tree::Accept&) {},
                           [this](const tree::Step& step) {
                               for (const tree::Action& action : step.actions) this->action(action);
                           },
                           [this](const tree::Transition& transition) {
                               term(transition.condition);
                               for (const tree::Assignment& one : transition.assignments) assignment(one);
                           },
                           [this](const tree::Partial& partial) { items(partial.items); },
                           [](const tree::ReplicatedChartItems&) {},  // imported charts have no replications
                       },
                       item);
        }
    }

    std::vector<FoundRange> ranges(const std::vector<OpenInteger>& integers) {
        for (std::size_t i = 0; i < integers.size(); ++i) {
            FoundRange& range = found_[i];
            if (!range.exact) {
                range = {integers[i].least, integers[i].greatest, false};
                continue;
            }
            for (const std::int64_t value : compared_[i]) {
                const std::int64_t margin = integers[i].input ? 1 : 0;
                range.low = std::min(range.low, value - margin);
                range.high = std::max(range.high, value + margin);
            }
            range.low = std::max(range.low, integers[i].least);
            range.high = std::min(range.high, integers[i].greatest);
        }
        return found_;
    }

private:
    std::optional<std::size_t> variable(Id<tree::Expr> id) const {
        const tree::Expr& node = file_.exprs[id];
        if (node.op != tree::Op::Name) return {};
        const auto known = known_.find(node.word);
        return known == known_.end() ? std::nullopt : std::optional(known->second);
    }

    std::optional<std::int64_t> constant(Id<tree::Expr> id) const {
        const tree::Expr& node = file_.exprs[id];
        if (node.op == tree::Op::Number) return node.value;
        if (node.op != tree::Op::Negate) return {};
        const tree::Expr& inner = file_.exprs[node.first];
        return inner.op == tree::Op::Number ? std::optional(-inner.value) : std::nullopt;
    }

    void action(const tree::Action& action) {
        std::visit(overloaded{
                       [this](const tree::ContinuousAction& one) { term(one.condition); },
                       [this](const tree::StoredAction& one) {
                           assignment(one.assignment);
                           term(one.event);
                       },
                       [](const tree::ForcingOrder&) {},
                   },
                   action);
    }

    void assignment(const tree::Assignment& one) {
        const auto known = known_.find(one.target.word);
        const auto value = constant(one.value);
        if (known != known_.end()) {
            FoundRange& range = found_[known->second];
            if (!value) range.exact = false;
            else range = {std::min(range.low, *value), std::max(range.high, *value), range.exact};
        }
        if (!value) term(one.value);
    }

    /// Marks variables that occur outside of comparisons with constants as unbounded.
    void term(Id<tree::Expr> root) {
        if (!root.valid()) return;
        std::vector<Id<tree::Expr>> work = {root};
        while (!work.empty()) {
            const Id<tree::Expr> id = work.back();
            work.pop_back();
            const tree::Expr& node = file_.exprs[id];
            if (compares(node.op)) {
                const auto left = variable(node.first), right = variable(node.last);
                const auto below = constant(node.first), above = constant(node.last);
                if (left && above) compared_[*left].push_back(*above);
                if (right && below) compared_[*right].push_back(*below);
                if ((left && above) || (right && below)) continue;
            }
            if (const auto open = variable(id)) found_[*open].exact = false;
            for (Id<tree::Expr> one = node.first; one.valid(); one = file_.exprs[one].next) work.push_back(one);
        }
    }

    const tree::File& file_;
    std::unordered_map<Id<tree::Word>, std::size_t> known_ = {};
    std::vector<FoundRange> found_;
    std::vector<std::vector<std::int64_t>> compared_ = {};
};

}  // namespace

std::vector<FoundRange> ranges_of(const tree::File& file, const tree::Chart& chart,
                                  const std::vector<OpenInteger>& integers) {
    Uses uses(file, integers);
    uses.items(chart.items);
    return uses.ranges(integers);
}

}  // namespace grafverif
