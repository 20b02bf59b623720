// SPDX-License-Identifier: MIT
#include "syntax/language/builder.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include "support/messages.hpp"
#include "support/messages_notation.hpp"

namespace grafverif::tree {

// -- declarations ----------------------------------------------------------------------------------------------------

void Builder::declare(Declaration declaration) { file_->declarations.push_back(std::move(declaration)); }

void Builder::broken() {
    broken_ = true;
    file_->broken = true;
}

Builder::Marks Builder::take_marks() { return {std::exchange(broken_, false), std::exchange(replicated_, false)}; }

void Builder::lost() {
    broken_ = replicated_ = false;
    file_->broken = file_->incomplete = true;
}

Chart Builder::chart(Name name, std::vector<Variables> parameters, std::vector<ChartItem> items, Span where) {
    const auto [broken, replicated] = take_marks();
    const bool expanded = replicated || !parameters.empty();
    return {name, std::move(items), where, broken, expanded, std::move(parameters)};
}

Partial Builder::instance(Name name, Name chart, std::vector<Argument> arguments, Span where) {
    replicated_ = true;
    return {PartialKind::Partial, name, {}, where, chart, std::move(arguments)};
}

Component Builder::component(Name name, Component body, Span where) {
    const auto [broken, replicated] = take_marks();
    return {name, std::move(body.parameters), std::move(body.items), where, broken, replicated};
}

Component Builder::component_body(std::vector<Variables> parameters, std::vector<ComponentItem> items) const {
    return {{}, std::move(parameters), std::move(items), {}, false, false};
}

ClosedLoop Builder::loop(Name name, std::vector<LoopItem> items, Span where) {
    const auto [broken, replicated] = take_marks();
    return {name, std::move(items), where, broken, replicated};
}

Variables Builder::variables(VariableKind kind, Variables variables, Span where) const {
    variables.kind = kind;
    variables.where = where;
    return variables;
}

Step Builder::step(Step marks, Name name, std::vector<Action> actions, Span where) const {
    marks.name = name;
    marks.actions = std::move(actions);
    marks.where = where;
    return marks;
}

Step Builder::macro_step(Step marks, Name name, Name expansion, std::vector<Action> actions, Span where) const {
    marks.kind = StepKind::Macro;
    marks.contents = {expansion};
    return step(std::move(marks), name, std::move(actions), where);
}

Step Builder::enclosing_step(Step marks, Name name, std::vector<Name> enclosed, std::vector<Action> actions,
                             Span where) const {
    marks.kind = StepKind::Enclosing;
    marks.contents = std::move(enclosed);
    return step(std::move(marks), name, std::move(actions), where);
}

ForcingOrder Builder::forcing(Name chart, std::vector<Name> situation, Span where) const {
    if (situation.empty()) return {chart, ForcedTo::Empty, {}, where};
    if (situation.size() == 1 && file_->text(situation.front()) == "INIT") return {chart, ForcedTo::Initial, {}, where};
    return {chart, ForcedTo::Steps, std::move(situation), where};
}

Transition Builder::links(std::vector<Name> from, std::vector<Name> to) const {
    return {{}, std::move(from), std::move(to), {}, {}, {}};
}

Transition Builder::transition(Transition links, Id<Expr> condition, std::vector<Assignment> assignments,
                               Span where) const {
    links.condition = condition;
    links.assignments = std::move(assignments);
    links.where = where;
    return links;
}

Property Builder::pattern(Pattern pattern, std::vector<Id<Expr>> operands) const {
    Property property;
    property.pattern = pattern;
    property.operands = std::move(operands);
    return property;
}

Property Builder::scoped(Pattern plain, Sentence::Kind kind, std::vector<Id<Expr>> operands, Property scope) const {
    const bool watched = plain == Pattern::Watched || !scope.operands.empty();
    scope.pattern = watched ? Pattern::Watched : plain;
    scope.watch.kind = watched ? kind : Sentence::Kind{};
    scope.operands.insert(scope.operands.begin(), operands.begin(), operands.end());
    return scope;
}

Property Builder::scope(Sentence::Scope scope, std::vector<Id<Expr>> operands) const {
    Property property;
    property.watch.scope = scope;
    property.operands = std::move(operands);
    return property;
}

Property Builder::bounded(Sentence::Kind kind, std::vector<Id<Expr>> operands, Id<Expr> bound, Property scope) const {
    Property property = scoped(Pattern::Watched, kind, std::move(operands), std::move(scope));
    property.bound = bound;
    return property;
}

Property Builder::uncounted(std::vector<Id<Expr>> operands, Name times, Property scope) {
    diagnostics_->add(messages::missing_count(times.where));
    broken();
    return bounded(Sentence::Kind::Occurrences, std::move(operands), {}, std::move(scope));
}

Property Builder::formula(Pattern pattern, std::string raw, Span where) const {
    Property property;
    property.pattern = pattern;
    property.raw = std::move(raw);
    property.raw_where = where;
    return property;
}

Property Builder::named(Name name, std::string text, bool expected_violated, Property pattern, bool at_stable,
                        Span where) const {
    pattern.name = name;
    pattern.text = std::move(text);
    pattern.expected_violated = expected_violated;
    pattern.at_stable = at_stable;
    pattern.where = where;
    return pattern;
}

// -- expressions ------------------------------------------------------------------------------------------------------

Id<Expr> Builder::node(Op op, std::initializer_list<Id<Expr>> operands, Span where) {
    std::size_t depth = 0;
    for (const Id<Expr> operand : operands) depth = std::max<std::size_t>(depth, file_->exprs[operand].depth);
    if (depth >= deepest_expression) {
        if (!too_deep_.source.valid() || too_deep_.begin != where.begin)
            diagnostics_->add(messages::too_deep(where, deepest_expression));
        too_deep_ = where;
        broken();
        return constant(Op::False, where);
    }
    Expr expr;
    expr.op = op;
    expr.depth = static_cast<std::uint16_t>(depth + 1);
    expr.where = where;
    const Id<Expr> id = file_->exprs.add(expr);
    for (const Id<Expr> operand : operands) append(file_->exprs, id, operand);
    return id;
}

Id<Expr> Builder::constant(Op op, Span where) {
    Expr expr;
    expr.op = op;
    expr.where = where;
    return file_->exprs.add(expr);
}

Id<Expr> Builder::number(Name digits) {
    const std::string_view text = file_->text(digits);
    std::int64_t value = 0;
    if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc())
        diagnostics_->add(messages::number_too_large(digits.where));
    const Id<Expr> id = constant(Op::Number, digits.where);
    file_->exprs[id].value = value;
    return id;
}

/// Returns a node with the word of `name`. The operands of the node are `owner`, if valid, and the
/// indices of the name.
Id<Expr> Builder::named_node(Op op, Id<Expr> owner, Name name, Span where) {
    const Id<Expr> id = owner.valid() ? node(op, {owner}, where) : constant(op, where);
    file_->exprs[id].word = name.word;
    for (Id<Expr> index = name.index; index.valid(); index = file_->exprs[index].next) {
        append(file_->exprs, id, index);
        file_->exprs[id].depth =
            std::max(file_->exprs[id].depth, static_cast<std::uint16_t>(file_->exprs[index].depth + 1));
    }
    return id;
}

namespace {

/// Returns the span from the beginning of `where` to the end of `name`. The result excludes the indices of the name,
/// which `where` includes.
Span up_to(Name name, Span where) { return {where.source, where.begin, name.where.end}; }

}  // namespace

Id<Expr> Builder::name(Name name) { return named_node(Op::Name, {}, name, name.where); }

Id<Expr> Builder::member(Id<Expr> owner, Name name, Span where) {
    return named_node(Op::Member, owner, name, up_to(name, where));
}

Id<Expr> Builder::place(Id<Expr> owner, Name location, Span where) {
    return named_node(Op::In, owner, location, up_to(location, where));
}

Name Builder::indexed(Name name, Id<Expr> index) {
    replicated_ = true;
    if (!name.index.valid()) {
        name.index = index;
        return name;
    }
    std::size_t count = 1;
    Id<Expr> last = name.index;
    for (; file_->exprs[last].next.valid(); ++count) last = file_->exprs[last].next;
    if (count < most_indices) {
        file_->exprs[last].next = index;
        return name;
    }
    if (too_deep_.begin != name.where.begin)
        diagnostics_->add(messages::too_many_indices(file_->exprs[index].where, most_indices));
    too_deep_ = name.where;
    broken();
    return name;
}

Replication Builder::replication(Name index, Range range, Span where) {
    replicated_ = true;
    return {index, range, where};
}

Id<Expr> Builder::replicated(Op op, const Replication& replication, Id<Expr> term, Span where) {
    return node(op, {name(replication.index), replication.range.low, replication.range.high, term}, where);
}

Id<Expr> Builder::unary(Op op, Id<Expr> operand, Span where) { return node(op, {operand}, where); }

Id<Expr> Builder::binary(Op op, Id<Expr> left, Id<Expr> right, Span where) {
    Expr& first = file_->exprs[left];
    const bool joins = (op == Op::And || op == Op::Or) && first.op == op && !first.bracketed;
    if (!joins || file_->exprs[right].depth >= deepest_expression) return node(op, {left, right}, where);
    first.depth = std::max<std::uint16_t>(first.depth, static_cast<std::uint16_t>(file_->exprs[right].depth + 1));
    first.where = where;
    append(file_->exprs, left, right);
    return left;
}

Id<Expr> Builder::bracketed(Id<Expr> expression, Span where) {
    Expr& inner = file_->exprs[expression];
    inner.bracketed = true;
    // The span of a name excludes the brackets around the name.
    if (inner.op != Op::Name && inner.op != Op::Member && inner.op != Op::In) inner.where = where;
    return expression;
}

}  // namespace grafverif::tree
