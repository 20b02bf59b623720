// SPDX-License-Identifier: MIT
#include "pipeline/variants/supervise_text.hpp"

#include <algorithm>
#include <string_view>

#include "read/formats.hpp"
#include "support/messages.hpp"
#include "support/overloaded.hpp"
#include "syntax/language/format.hpp"
#include "syntax/language/parse.hpp"

namespace grafverif {

namespace {

/// Adds the syntax trees of terms to the tables of a parsed file.
class TreeTerms {
public:
    TreeTerms(tree::File& file, Span where) : file_(file), where_(where) {}

    Id<tree::Expr> operator()(const NamedTerm& term) {
        std::vector<Id<tree::Expr>> groups;
        for (const auto& group : term.terms) {
            std::vector<Id<tree::Expr>> literals;
            for (const auto& [name, value] : group) literals.push_back(value ? leaf(name) : negated(leaf(name)));
            groups.push_back(joined(term.all ? tree::Op::Or : tree::Op::And, literals));
        }
        return joined(term.all ? tree::Op::And : tree::Op::Or, groups);
    }

    /// Returns the conjunction of `old` and `added`; returns only `added` if `old` is invalid or the constant true.
    Id<tree::Expr> both(Id<tree::Expr> old, Id<tree::Expr> added) {
        if (!old.valid() || file_.exprs[old].op == tree::Op::True) return added;
        std::vector<Id<tree::Expr>> operands = operands_of(old);
        std::ranges::copy(operands_of(added), std::back_inserter(operands));
        return joined(tree::Op::And, operands);
    }

private:
    Id<tree::Expr> add(tree::Op op) { return file_.exprs.add({.op = op, .where = where_}); }
    Id<tree::Word> word(std::string_view text) { return file_.words.add({std::string(text)}); }

    Id<tree::Expr> leaf(const std::string& name) {
        const std::size_t dot = name.find('.');
        const Id<tree::Expr> first = add(tree::Op::Name);
        file_.exprs[first].word = word(name.substr(0, dot));
        if (dot == std::string::npos) return first;
        const Id<tree::Expr> member = add(tree::Op::Member);
        file_.exprs[member].word = word(name.substr(dot + 1));
        append(file_.exprs, member, first);
        return member;
    }
    Id<tree::Expr> negated(Id<tree::Expr> operand) {
        const Id<tree::Expr> made = add(tree::Op::Not);
        append(file_.exprs, made, operand);
        return made;
    }
    /// Returns the conjunction or disjunction of the operands. The operands are moved into the new term, not copied.
    Id<tree::Expr> joined(tree::Op op, const std::vector<Id<tree::Expr>>& operands) {
        if (operands.empty()) return add(op == tree::Op::And ? tree::Op::True : tree::Op::False);
        if (operands.size() == 1) return operands.front();
        const Id<tree::Expr> made = add(op);
        for (const Id<tree::Expr> operand : operands) {
            file_.exprs[operand].next = {};
            append(file_.exprs, made, operand);
        }
        return made;
    }
    std::vector<Id<tree::Expr>> operands_of(Id<tree::Expr> term) const {
        if (file_.exprs[term].op != tree::Op::And) return {term};
        std::vector<Id<tree::Expr>> found;
        for (Id<tree::Expr> operand = file_.exprs[term].first; operand.valid(); operand = file_.exprs[operand].next)
            found.push_back(operand);
        return found;
    }

    tree::File& file_;
    Span where_ = {};
};

void put(tree::File& file, std::vector<tree::ChartItem>& items, const std::map<std::uint32_t, NamedTerm>& terms) {
    const auto add = [&](Span where, Id<tree::Expr>& condition) {
        const auto found = terms.find(where.begin);
        if (found == terms.end()) return;
        TreeTerms build(file, where);
        condition = build.both(condition, build(found->second));
    };
    for (tree::ChartItem& item : items)
        std::visit(overloaded{
                       [&](tree::Transition& transition) { add(transition.where, transition.condition); },
                       [&](tree::Step& step) {
                           for (tree::Action& action : step.actions)
                               if (auto* continuous = std::get_if<tree::ContinuousAction>(&action))
                                   add(continuous->where, continuous->condition);
                       },
                       [&](tree::Partial& partial) { put(file, partial.items, terms); },
                       [](auto&) {},
                   },
                   item);
}

/// Returns the position of the first transition or continuous action that a `for` declaration replicates. `inside` is
/// true if the declaration of `items` is itself inside a `for` declaration.
std::optional<Span> first_replicated(const std::vector<tree::ChartItem>& items, bool inside) {
    std::optional<Span> first;
    for (const tree::ChartItem& item : items) {
        std::visit(overloaded{
                       [&](const tree::Transition& transition) {
                           if (inside) first = transition.where;
                       },
                       [&](const tree::Step& step) {
                           for (const tree::Action& action : step.actions)
                               if (inside && !first && std::holds_alternative<tree::ContinuousAction>(action))
                                   first = std::get<tree::ContinuousAction>(action).where;
                       },
                       [&](const tree::Partial& partial) {
                           if (partial.chart.valid()) first = partial.where;
                           else first = first_replicated(partial.items, inside);
                       },
                       [&](const tree::ReplicatedChartItems& copies) { first = first_replicated(copies.items, true); },
                       [](const auto&) {},
                   },
                   item);
        if (first) return first;
    }
    return {};
}

tree::File tree_of(Id<Source> source, const Sources& sources) {
    Sources copy = sources;
    Diagnostics known;
    return read_any(source, copy, {true}, known);
}

bool is_grafcet_text(Id<Source> source, const Sources& sources) {
    return format_of(sources[source].text) == FileFormat::Grafcet;
}

}  // namespace

std::optional<Span> replicated_element(const Chart& chart, const Sources& sources) {
    const Id<Source> source = chart.origin.source;
    if (!chart.instance_of.empty()) return chart.origin;
    if (!source.valid() || !is_grafcet_text(source, sources)) return {};
    const tree::File file = tree_of(source, sources);
    for (const tree::Declaration& declaration : file.declarations)
        if (const auto* written = std::get_if<tree::Chart>(&declaration);
            written != nullptr && file.text(written->name) == chart.name)
            return first_replicated(written->items, false);
    return {};
}

std::string text_of(const NamedTerm& term) {
    tree::File file;
    return formatted(file, TreeTerms(file, {})(term));
}

std::string with_conditions(Id<Source> source, const Sources& sources,
                            const std::map<std::uint32_t, NamedTerm>& terms) {
    tree::File file = tree_of(source, sources);
    for (tree::Declaration& declaration : file.declarations)
        if (auto* chart = std::get_if<tree::Chart>(&declaration)) put(file, chart->items, terms);
    return formatted(is_grafcet_text(source, sources) ? file : laid_out(std::move(file)));
}

std::optional<std::string> with_marked(Id<Source> source, Sources& sources, const std::string& loop,
                                       const std::string& name, const std::string& term, Diagnostics& diagnostics) {
    const std::string question = "property " + name + ": always possible " + term + ";\n";
    const Id<Source> requested = sources.add({"--marked", "closed_loop marked {\n" + question + "}\n"});
    const tree::File parsed = parse_file(requested, sources, diagnostics);
    if (diagnostics.has_errors()) return {};
    const auto* one =
        parsed.declarations.size() == 1 ? std::get_if<tree::ClosedLoop>(&parsed.declarations[0]) : nullptr;
    if (one == nullptr || one->items.size() != 1) {
        diagnostics.add(messages::unexpected({requested, 0, 0}, "more than a term", "one term"));
        return {};
    }
    const tree::File file = tree_of(source, sources);
    for (const tree::Declaration& declaration : file.declarations) {
        const auto* found = std::get_if<tree::ClosedLoop>(&declaration);
        if (found == nullptr || file.text(found->name) != loop) continue;
        std::string text = sources[source].text;
        return text.insert(text.rfind('}', found->where.end - 1), question);
    }
    return {};
}

}  // namespace grafverif
