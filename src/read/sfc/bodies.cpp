// SPDX-License-Identifier: MIT
// What a list of statements assigns, as terms over the values before it: the statements are executed on terms.
#include <algorithm>

#include "support/messages.hpp"
#include "read/sfc/sfc.hpp"

namespace grafverif {

namespace {

constexpr std::size_t most_terms = 20'000;   ///< of one body
constexpr int deepest_call = 20;

class Execution {
public:
    explicit Execution(Sfc& sfc) : sfc_(sfc) {}

    bool run(const st::Block& block, SfcEffects& state, int calls) {
        for (const Id<st::Statement> id : block)
            if (!statement(sfc_.file.statements[id], state, calls)) return false;
        return true;
    }

private:
    bool refuse(Span where, std::string_view what, std::string_view hint) {
        sfc_.draft.refuse(where, what, hint);
        return false;
    }

    SfcTerm term(Id<st::Expr> expr, const SfcEffects& state, SfcKind expected) {
        sfc_.state = &state;
        const SfcTerm found = term_of(sfc_, expr, expected);
        sfc_.state = nullptr;
        return found;
    }

    bool statement(const st::Statement& statement, SfcEffects& state, int calls) {
        if (sfc_.terms > most_terms) return refuse(statement.where, "a body with so many cases", "split it into several actions");
        switch (statement.kind) {
        case st::StatementKind::Assign: return assign(statement, state);
        case st::StatementKind::If:
        case st::StatementKind::Case:   return choose(statement, state, calls);
        case st::StatementKind::Call:   return call(statement, state, calls);
        case st::StatementKind::For: case st::StatementKind::While: case st::StatementKind::Repeat:
            return refuse(statement.where, "a loop", "write out its passes");
        case st::StatementKind::Return: case st::StatementKind::Exit:
            return refuse(statement.where, "a jump out of the statements", "use `IF`");
        }
        return false;
    }

    bool assign(const st::Statement& statement, SfcEffects& state) {
        const std::string path = path_of(sfc_.file, statement.target);
        const Span where = sfc_.file.exprs[statement.target].where;
        if (path.empty()) return refuse(where, "an assignment to a part of an array or pointer", "use a variable of its own");
        const auto known = sfc_.by_name.find(st::capitals(path));
        SfcTerm value = term(statement.value, state, known == sfc_.by_name.end() ? SfcKind::Boolean : sfc_.variables[known->second].kind);
        if (value.kind == SfcKind::Bad) return false;
        const SfcVariable& target = variable_of(sfc_, path, where, value.kind, true);
        if (target.role == tree::VariableKind::Input) {
            refuse(where, "an assignment to the input `" + path + '`', "assign a variable of the chart's own");
            return sfc_.draft.lossy();
        }
        const tree::Expr node = sfc_.draft[value.expr];
        if (target.kind == SfcKind::Boolean && value.kind == SfcKind::Integer && node.op == tree::Op::Number && node.value <= 1)
            value = {sfc_.draft.constant(node.value == 1, node.where), SfcKind::Boolean};
        if (target.kind != value.kind || target.kind == SfcKind::Time)
            return refuse(where, "an assignment of another type than BOOL and integers", "use variables of one type");
        if (target.kind == SfcKind::Integer) state[target.name] = {{}, {}, value.expr};
        else state[target.name] = {value.expr, sfc_.draft.constant(false, where), {}};
        return true;
    }

    bool call(const st::Statement& statement, SfcEffects& state, int calls) {
        const st::Expr& node = sfc_.file.exprs[statement.value];
        const st::Expr& callee = sfc_.file.exprs[node.first];
        const bool plain = callee.op == st::Op::Name && st::operands(sfc_.file, statement.value).size() == 1;
        for (const st::Action& action : sfc_.unit.actions) {
            if (!plain || action.name.word != callee.word) continue;
            if (action.opaque) return refuse(statement.where, "a call of an action that is not in Structured Text", "write it in Structured Text");
            if (calls >= deepest_call) return refuse(statement.where, "an action that calls itself", "write it out");
            return run(action.body, state, calls + 1);
        }
        refuse(statement.where, "a call of a function block", "write what it does with Boolean and integer variables");
        return sfc_.draft.lossy();   // what it computes is declared elsewhere: inputs of the chart
    }

    /// `selector = label` or `low <= selector AND selector <= high`, any of them.
    Id<tree::Expr> matches(const st::Statement& statement, const st::Branch& branch, const SfcEffects& state) {
        Id<tree::Expr> any = sfc_.draft.constant(false, branch.where);
        for (const Id<st::Expr> label : branch.conditions) {
            const st::Expr node = sfc_.file.exprs[label];
            const auto compared = [&](tree::Op op, Id<st::Expr> bound) -> Id<tree::Expr> {
                const SfcTerm selector = term(statement.value, state, SfcKind::Integer), value = term(bound, state, SfcKind::Integer);
                if (selector.kind == SfcKind::Bad || value.kind == SfcKind::Bad) return {};
                return sfc_.draft.node(op, {selector.expr, value.expr}, node.where);
            };
            const Id<tree::Expr> one = node.op == st::Op::Range
                                           ? both(sfc_, compared(tree::Op::GreaterEqual, node.first), compared(tree::Op::LessEqual, node.last))
                                           : compared(tree::Op::Equal, label);
            any = either(sfc_, any, one);
            if (!any.valid()) return {};
        }
        return any;
    }

    bool choose(const st::Statement& statement, SfcEffects& state, int calls) {
        const SfcEffects before = state;
        Id<tree::Expr> open = sfc_.draft.constant(true, statement.where);   // no branch before this one was taken
        std::vector<std::pair<Id<tree::Expr>, SfcEffects>> taken;
        for (const st::Branch& branch : statement.branches) {
            Id<tree::Expr> here = sfc_.draft.constant(true, branch.where);
            if (!branch.conditions.empty() && statement.kind == st::StatementKind::Case) here = matches(statement, branch, before);
            else if (!branch.conditions.empty()) {
                sfc_.state = &before;
                here = boolean_of(sfc_, branch.conditions.front());
                sfc_.state = nullptr;
            }
            if (!here.valid()) return false;
            SfcEffects after = before;
            if (!run(branch.body, after, calls)) return false;
            taken.emplace_back(both(sfc_, sfc_.draft.copy(open), sfc_.draft.copy(here)), std::move(after));
            open = both(sfc_, open, opposite(sfc_, here));
            if (!open.valid() || sfc_.terms > most_terms) return refuse(statement.where, "a body with so many cases", "split it into several actions");
        }
        taken.emplace_back(open, before);
        return merge(statement, taken, state);
    }

    bool merge(const st::Statement& statement, const std::vector<std::pair<Id<tree::Expr>, SfcEffects>>& taken, SfcEffects& state) {
        SfcEffects merged;
        for (const auto& [condition, effects] : taken)
            for (const auto& [name, effect] : effects) merged.try_emplace(name, SfcEffect{});
        for (auto& [name, result] : merged) {
            const bool integer = std::ranges::any_of(taken, [&name = name](const auto& one) {
                const auto found = one.second.find(name);
                return found != one.second.end() && found->second.value.valid();
            });
            if (integer) {
                const auto old = state.find(name);
                const bool touched = std::ranges::any_of(taken, [&, &name = name](const auto& one) {
                    const auto found = one.second.find(name);
                    return found == one.second.end() ? old != state.end() : old == state.end() || found->second.value != old->second.value;
                });
                if (touched) return refuse(statement.where, "an integer that is assigned under a condition", "assign it in a step of its own");
                result = old->second;
                continue;
            }
            result = {sfc_.draft.constant(false, statement.where), sfc_.draft.constant(false, statement.where), {}};
            for (const auto& [condition, effects] : taken) {
                const auto found = effects.find(name);
                const bool kept = found == effects.end();
                const auto part = [&](Id<tree::Expr> value) { return both(sfc_, sfc_.draft.copy(condition), sfc_.draft.copy(value)); };
                result.set = either(sfc_, result.set, part(kept ? sfc_.draft.constant(false, statement.where) : found->second.set));
                result.keep = either(sfc_, result.keep, part(kept ? sfc_.draft.constant(true, statement.where) : found->second.keep));
                if (!result.set.valid() || !result.keep.valid()) return false;
            }
        }
        state = std::move(merged);
        return true;
    }

    Sfc& sfc_;
};

}  // namespace

std::optional<SfcEffects> effects_of(Sfc& sfc, const st::Block& block) {
    SfcEffects state;
    sfc.terms = 0;
    sfc.reads.clear();
    if (!Execution(sfc).run(block, state, 0)) return {};
    return state;
}

}  // namespace grafverif
