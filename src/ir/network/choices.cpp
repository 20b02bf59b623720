// SPDX-License-Identifier: MIT
#include "ir/network/choices.hpp"

#include <algorithm>
#include <utility>

#include "ir/interval.hpp"
#include "ir/literal.hpp"

namespace grafverif {

namespace {

constexpr std::int64_t most_copies = 1024;  // maximum number of copies of one edge
constexpr std::int64_t most_cases = 64;     // maximum number of assignments to the variables of one invariant

}  // namespace

Id<Expr> Choices::leaf(std::vector<Id<Expr>> terms, Op op, std::size_t writes) {
    Choice made{std::move(terms), op, writes};
    const auto known = std::ranges::find_if(choices_, [&](const Choice& other) { return other.is(made); });
    const auto index = static_cast<std::uint32_t>(known - choices_.begin());
    if (known == choices_.end()) {
        Id<Expr> shape = made.terms.front();
        while (whole_.exprs[shape].op == Op::Conditional) shape = whole_.exprs.operands(shape)[1];
        const Expr& node = whole_.exprs[shape];
        made.boolean =
            node.op == Op::Variable ? variable(node).type.boolean : !is_arithmetic(node.op) && node.op != Op::Integer;
        if (!made.boolean) {
            const Interval values =
                interval(whole_.exprs, made.terms.front(), [this](const Expr& leaf) { return variable(leaf).type; });
            made.low = values.low;
            made.high = values.high;
        }
        for (const Id<Expr> term : made.terms)
            for (const Id<Expr> read : leaves(whole_.exprs, term))
                made.reads.push_back({static_cast<std::uint32_t>(whole_.exprs[read].value)});
        choices_.push_back(std::move(made));
    }
    return to_.leaf(Op::Parameter, index);
}

bool Choices::few() const {
    std::int64_t copies = 1;
    for (const Choice& choice : choices_) {
        const std::int64_t most = most_copies / copies;
        if (choice.low < least_integer || choice.high > greatest_integer) return false;
        if (choice.high - choice.low >= most) return false;
        copies *= choice.high - choice.low + 1;
    }
    return true;
}

void Choices::begin() {
    values_.clear();
    for (const Choice& choice : choices_) values_.push_back(choice.low);
}

bool Choices::next() {
    for (std::size_t k = 0; k < values_.size(); ++k) {
        if (++values_[k] <= choices_[k].high) return true;
        values_[k] = choices_[k].low;
    }
    return false;
}

Id<Expr> Choices::value(std::size_t choice) const {
    return literal(to_, {.boolean = choices_[choice].boolean}, values_[choice]);
}

Id<Expr> Choices::chosen(Id<Expr> term) const {
    if (choices_.empty()) return term;
    return translate(to_, term, to_, [&](const Expr& node) {
        const auto index = static_cast<std::uint32_t>(node.value);
        return node.op == Op::Parameter ? value(index) : to_.leaf(node.op, index);
    });
}

/// Returns the value of `choice` for the given values of variables; empty if the value depends on other variables.
std::optional<std::int64_t> Choices::value_of(const Choice& choice, const Values& values) const {
    const bool any = choice.op == Op::Or;
    std::optional<std::int64_t> all;
    for (const Id<Network::Variable> read : choice.reads)
        if (!values.contains(read)) return {};
    for (const Id<Expr> term : choice.terms) {
        const std::optional<std::int64_t> value = evaluate(
            whole_.exprs, term, [&](const Expr& leaf) { return values.at({static_cast<std::uint32_t>(leaf.value)}); });
        if (!value) return {};
        all = !all ? *value : any ? std::max(*all, *value) : std::min(*all, *value);
    }
    return all;
}

bool Choices::report_of(const std::vector<Id<Network::Variable>>& variables) const {
    return std::ranges::any_of(choices_, [&](const Choice& choice) {
        return choice.writes == 0 && std::ranges::all_of(choice.reads, [&](Id<Network::Variable> read) {
                   return std::ranges::find(variables, read) != variables.end();
               });
    });
}

std::optional<std::vector<Choices::Values>> Choices::possible_before(
    const std::vector<Id<Network::Variable>>& variables) const {
    std::int64_t count = 1;
    std::vector<Values> all{{}};
    for (const Id<Network::Variable> id : variables) {
        const Type& type = whole_.variables[id].type;
        if (type.high - type.low >= most_cases / count) return {};
        count *= type.high - type.low + 1;
        std::vector<Values> more;
        for (const Values& values : all)
            for (std::int64_t value = type.low; value <= type.high; ++value) (more.emplace_back(values))[id] = value;
        all = std::move(more);
    }
    bool tells = false;
    for (std::size_t k = 0; k < choices_.size(); ++k) {
        if (choices_[k].writes != 0 || !value_of(choices_[k], all.front())) continue;
        tells = true;
        std::erase_if(all, [&](const Values& values) { return value_of(choices_[k], values) != values_[k]; });
        if (all.empty()) break;
    }
    return tells ? std::optional(std::move(all)) : std::nullopt;
}

bool Choices::as_at_first() const {
    Values first;
    for (const Id<Network::Variable> id : whole_.variables.ids()) first[id] = whole_.variables[id].initial;
    for (std::size_t k = 0; k < choices_.size(); ++k)
        if (value_of(choices_[k], first).value_or(0) != values_[k]) return false;
    return true;
}

}  // namespace grafverif
