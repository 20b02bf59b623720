// SPDX-License-Identifier: MIT
#include "read/draft.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "support/messages.hpp"
#include "support/printable.hpp"
#include "support/text/identifier.hpp"

namespace grafverif {

namespace {

constexpr std::size_t deepest_expression = 1000;
// Maximum length of an imported name in bytes. The input language permits names of up to 1,000 bytes; the difference
// leaves space for a prefix and a number.
constexpr std::size_t longest_name = 900;

/// Reserved words of the input language, which are not allowed as names (see grammars/grafcet.yy).
constexpr std::array reserved = {"grafcet",  "component", "closed_loop", "include", "input", "output",
                                 "internal", "step",      "transition",  "when",    "do",    "force",
                                 "and",      "or",        "not",         "true",    "false", "always",
                                 "never",    "reachable", "inevitable",  "possible"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

Draft::Draft(Id<Source> source, bool lossy, Diagnostics& diagnostics)
    : words_(file_.words), diagnostics_(&diagnostics), lossy_(lossy), errors_(diagnostics.errors()) {
    file_.source = source;
}

Id<tree::Expr> Draft::leaf(tree::Op op, Span where) {
    tree::Expr expr;
    expr.op = op;
    expr.where = where;
    return file_.exprs.add(expr);
}

Id<tree::Expr> Draft::constant(bool value, Span where) { return leaf(value ? tree::Op::True : tree::Op::False, where); }

Id<tree::Expr> Draft::number(std::int64_t value, Span where) {
    const Id<tree::Expr> id = leaf(tree::Op::Number, where);
    file_.exprs[id].value = value < 0 ? -value : value;
    return value < 0 ? node(tree::Op::Negate, {id}, where) : id;
}

Id<tree::Expr> Draft::duration(std::int64_t milliseconds, Span where) {
    const Id<tree::Expr> id = leaf(tree::Op::Duration, where);
    file_.exprs[id].value = milliseconds;
    return id;
}

Id<tree::Expr> Draft::variable(std::string_view name, Span where) {
    const Id<tree::Expr> id = leaf(tree::Op::Name, where);
    file_.exprs[id].word = words_.intern(name);
    return id;
}

Id<tree::Expr> Draft::member(std::string_view owner, std::string_view name, Span where) {
    const Id<tree::Expr> id = node(tree::Op::Member, {variable(owner, where)}, where);
    file_.exprs[id].word = words_.intern(name);
    return id;
}

std::vector<Id<tree::Expr>> Draft::operands(Id<tree::Expr> id) const {
    std::vector<Id<tree::Expr>> all;
    for (Id<tree::Expr> one = file_.exprs[id].first; one.valid(); one = file_.exprs[one].next) all.push_back(one);
    return all;
}

Id<tree::Expr> Draft::node(tree::Op op, const std::vector<Id<tree::Expr>>& given, Span where) {
    std::vector<Id<tree::Expr>> all;
    for (const Id<tree::Expr> one : given) {
        if (!one.valid()) return {};
        const bool joins = (op == tree::Op::And || op == tree::Op::Or) && file_.exprs[one].op == op;
        if (!joins) all.push_back(one);
        else
            for (const Id<tree::Expr> inner : operands(one)) all.push_back(inner);
    }
    std::size_t depth = 0;
    for (const Id<tree::Expr> one : all) depth = std::max<std::size_t>(depth, file_.exprs[one].depth);
    if (depth >= deepest_expression) {
        diagnostics_->add(messages::too_deep(where, deepest_expression));
        return {};
    }
    const Id<tree::Expr> id = leaf(op, where);
    file_.exprs[id].depth = static_cast<std::uint16_t>(depth + 1);
    for (const Id<tree::Expr> one : all) {
        file_.exprs[one].next = {};
        tree::append(file_.exprs, id, one);
    }
    return id;
}

Id<tree::Expr> Draft::copy(Id<tree::Expr> term) {
    if (!term.valid()) return {};
    const std::vector<Id<tree::Expr>> inner = operands(term);
    tree::Expr node = file_.exprs[term];
    node.first = node.last = node.next = {};
    const Id<tree::Expr> id = file_.exprs.add(node);
    for (const Id<tree::Expr> one : inner) {  // deepest_expression limits the recursion depth
        const Id<tree::Expr> copied = copy(one);
        tree::append(file_.exprs, id, copied);
    }
    return id;
}

void Draft::comment(Span where, std::string line, bool trailing) {
    file_.comments.push_back({std::move(line), where, !trailing});
}

void Draft::refuse(Span where, std::string_view what, std::string_view hint) {
    if (!lossy_) {
        diagnostics_->add(messages::cannot_import(where, what, hint));
        return;
    }
    diagnostics_->add(messages::left_out(where, what));
    std::string line = "// omitted: ";
    for (const char c : what) line += c == '\n' || c == '\r' ? ' ' : c;
    file_.comments.push_back({std::move(line), {where.source, 0, 0}, true});
}

void Draft::group_variables(tree::Chart& chart) const {
    std::unordered_set<std::uint32_t> commented;
    for (const tree::Comment& comment : file_.comments) commented.insert(comment.where.begin);
    const auto kind_of = [](const tree::ChartItem& item) {
        const auto* variables = std::get_if<tree::Variables>(&item);
        return variables == nullptr ? std::numeric_limits<int>::max() : static_cast<int>(variables->kind);
    };
    std::ranges::stable_sort(chart.items, {}, kind_of);
    const auto plain = [&](const tree::Variables& variables) {
        const tree::Variable& one = variables.variables.back();
        return one.type == tree::TypeWord::None && !one.value.valid() && !commented.contains(variables.where.begin);
    };
    std::vector<tree::ChartItem> items;
    for (tree::ChartItem& item : chart.items) {
        auto* next = std::get_if<tree::Variables>(&item);
        auto* last = items.empty() ? nullptr : std::get_if<tree::Variables>(&items.back());
        const bool joins =
            next != nullptr && last != nullptr && last->kind == next->kind && plain(*last) && plain(*next);
        if (joins) last->variables.push_back(next->variables.front());
        else items.push_back(std::move(item));
    }
    chart.items = std::move(items);
}

tree::File Draft::take() {
    file_.incomplete = file_.broken = diagnostics_->errors() != errors_;
    return std::move(file_);
}

std::string LegalNames::make(std::string_view preferred, Span where) {
    std::string name = invent(preferred);
    if (name != preferred) draft_->diagnostics().add(messages::renamed(where, preferred, name));
    return name;
}

std::string LegalNames::invent(std::string_view preferred) {
    std::string name;
    for (std::string_view rest = preferred.substr(0, longest_name); !rest.empty();) {
        const std::string_view character = rest.substr(0, first_glyph(rest).bytes);
        if (identifier_length("_" + std::string(character)) > character.size()) name += character;
        else if (!name.empty() && name.back() != '_') name += '_';
        rest.remove_prefix(character.size());
    }
    name = composed(name);
    if (identifier_length(name) == 0 && !name.empty() && !is_digit(name[0])) name = '_' + name;
    const bool numbered = std::ranges::all_of(name, is_digit);
    if (name.empty()) name = "_";
    if (is_digit(name[0]) && !(kind_ == Kind::Label && numbered)) name = '_' + name;
    if (std::ranges::find(reserved, name) != reserved.end()) name += '_';
    const bool step_like = kind_ == Kind::Variable && name.size() > 1 && name[0] == 'X' && is_digit(name[1]);
    if (step_like) name = "_" + name;
    return taken_.fresh(name);
}

}  // namespace grafverif
