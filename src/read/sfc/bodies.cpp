// SPDX-License-Identifier: MIT
// Executes lists of statements symbolically: computes the assigned values as terms over the values before the
// statements.
#include <algorithm>

#include "read/sfc/sfc.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

constexpr std::size_t most_terms = 200'000;  ///< maximum number of terms per body, because IF and CASE copy terms
constexpr int deepest_call = 20;

class Execution {
public:
    explicit Execution(Sfc& sfc) : sfc_(sfc), first_term_(sfc.draft.file().exprs.size()) {}

    /// Executes `block`: returns the values assigned after the statements. `before` contains the values assigned before
    /// the statements. The result is empty if a statement is rejected.
    std::optional<SfcEffects> run(const st::Block& block, SfcEffects before, int calls) {
        std::optional<SfcEffects> state = std::move(before);
        for (const Id<st::Statement> id : block)
            if (state) state = statement(sfc_.file.statements[id], std::move(*state), calls);
        return state;
    }

    const std::set<std::string>& reads() const { return reads_; }

private:
    std::nullopt_t refuse(Span where, std::string_view what, std::string_view hint) {
        sfc_.draft.refuse(where, what, hint);
        return std::nullopt;
    }

    bool too_large() const { return sfc_.draft.file().exprs.size() - first_term_ > most_terms; }
    std::nullopt_t refuse_size(Span where) {
        return refuse(where, "a list of statements whose translation is too large", "split it into several actions");
    }

    SfcTerm term(Id<st::Expr> expr, const SfcEffects& state, SfcKind expected) {
        return term_of(sfc_, {{}, &state, &reads_}, expr, expected);
    }

    std::optional<SfcEffects> statement(const st::Statement& statement, SfcEffects state, int calls) {
        if (too_large()) return refuse_size(statement.where);
        switch (statement.kind) {
        case st::StatementKind::Assign: return assign(statement, std::move(state));
        case st::StatementKind::If:
        case st::StatementKind::Case: return choose(statement, state, calls);
        case st::StatementKind::Call: return call(statement, std::move(state), calls);
        case st::StatementKind::For:
        case st::StatementKind::While:
        case st::StatementKind::Repeat: return refuse(statement.where, "a loop", "write out its iterations");
        case st::StatementKind::Return:
        case st::StatementKind::Exit: return refuse(statement.where, "a RETURN or EXIT statement", "use `IF`");
        }
        return {};
    }

    std::optional<SfcEffects> assign(const st::Statement& statement, SfcEffects state) {
        const std::string path = path_of(sfc_.file, statement.target);
        const Span where = sfc_.file.exprs[statement.target].where;
        if (path.empty())
            return refuse(where, "an assignment to an array element or a dereferenced pointer",
                          "use a separate variable");
        const auto known = sfc_.by_name.find(st::capitals(path));
        SfcTerm value = term(statement.value, state,
                             known == sfc_.by_name.end() ? SfcKind::Boolean : sfc_.variables[known->second].kind);
        if (value.kind == SfcKind::Bad) return {};
        const SfcVariable& target = variable_of(sfc_, path, where, value.kind, true);
        if (target.role == tree::VariableKind::Input) {
            refuse(where, "an assignment to the input `" + path + '`', "assign an output or a local variable");
            return left_out(std::move(state));
        }
        const tree::Expr node = sfc_.draft[value.expr];
        if (target.kind == SfcKind::Boolean && value.kind == SfcKind::Integer && node.op == tree::Op::Number &&
            node.value <= 1)
            value = {sfc_.draft.constant(node.value == 1, node.where), SfcKind::Boolean};
        if (target.kind != value.kind || target.kind == SfcKind::Time)
            return refuse(where, "an assignment that mixes types, or whose variable is neither BOOL nor an integer,",
                          "use BOOL variables only, or integer variables only");
        if (target.kind == SfcKind::Integer) state[target.name] = {{}, {}, value.expr};
        else state[target.name] = {value.expr, sfc_.draft.constant(false, where), {}};
        return state;
    }

    std::optional<SfcEffects> call(const st::Statement& statement, SfcEffects state, int calls) {
        const st::Expr& node = sfc_.file.exprs[statement.value];
        const st::Expr& callee = sfc_.file.exprs[node.first];
        const bool plain = callee.op == st::Op::Name && st::operands(sfc_.file, statement.value).size() == 1;
        for (const st::Action& action : sfc_.unit.actions) {
            if (!plain || action.name.word != callee.word) continue;
            if (action.opaque)
                return refuse(statement.where, "a call of an action that is not in Structured Text",
                              "write it in Structured Text");
            if (calls >= deepest_call)
                return refuse(statement.where, "an action that calls itself", "replace the call by statements");
            return run(action.body, std::move(state), calls + 1);
        }
        refuse(statement.where, "a call of a function block",
               "replace the call by assignments to BOOL or integer variables");
        return left_out(std::move(state));  // the results of the call become inputs of the chart
    }

    /// Returns the state after a rejected statement: with the option `--lossy` the unchanged state, otherwise nullopt.
    std::optional<SfcEffects> left_out(SfcEffects state) const {
        return sfc_.draft.lossy() ? std::optional(std::move(state)) : std::nullopt;
    }

    /// Returns the condition of a branch of CASE: a disjunction over the labels of the branch. A label `V` becomes
    /// `selector = V`, and a range `L..H` becomes `L <= selector AND selector <= H`.
    Id<tree::Expr> matches(const st::Statement& statement, const st::Branch& branch, const SfcEffects& state) {
        Id<tree::Expr> any = sfc_.draft.constant(false, branch.where);
        for (const Id<st::Expr> label : branch.conditions) {
            const st::Expr node = sfc_.file.exprs[label];
            const auto compared = [&](tree::Op op, Id<st::Expr> bound) -> Id<tree::Expr> {
                const SfcTerm selector = term(statement.value, state, SfcKind::Integer),
                              value = term(bound, state, SfcKind::Integer);
                if (selector.kind == SfcKind::Bad || value.kind == SfcKind::Bad) return {};
                return sfc_.draft.node(op, {selector.expr, value.expr}, node.where);
            };
            const Id<tree::Expr> one = node.op == st::Op::Range
                                           ? both(sfc_.draft, compared(tree::Op::GreaterEqual, node.first),
                                                  compared(tree::Op::LessEqual, node.last))
                                           : compared(tree::Op::Equal, label);
            any = either(sfc_.draft, any, one);
            if (!any.valid()) return {};
        }
        return any;
    }

    /// Executes the branches of IF or CASE. A branch is taken if its condition is true and no earlier branch is taken.
    /// The result merges the states of all branches.
    std::optional<SfcEffects> choose(const st::Statement& statement, const SfcEffects& before, int calls) {
        Id<tree::Expr> open = sfc_.draft.constant(true, statement.where);  // condition that no earlier branch is taken
        std::vector<Taken> taken;
        for (const st::Branch& branch : statement.branches) {
            Id<tree::Expr> here = condition(statement, branch, before);
            if (!here.valid()) return {};
            std::optional<SfcEffects> after = run(branch.body, before, calls);
            if (!after) return {};
            taken.push_back({both(sfc_.draft, sfc_.draft.copy(open), sfc_.draft.copy(here)), std::move(*after)});
            open = both(sfc_.draft, open, opposite(sfc_.draft, here));
            if (!open.valid() || too_large()) return refuse_size(statement.where);
        }
        taken.push_back({open, before});
        return merged(statement, taken, before);
    }

    Id<tree::Expr> condition(const st::Statement& statement, const st::Branch& branch, const SfcEffects& state) {
        if (branch.conditions.empty()) return sfc_.draft.constant(true, branch.where);
        if (statement.kind == st::StatementKind::Case) return matches(statement, branch, state);
        return boolean_of(sfc_, {{}, &state, &reads_}, branch.conditions.front());
    }

    struct Taken {
        Id<tree::Expr> condition = {};
        SfcEffects effects = {};

        const SfcEffect* effect(const std::string& name) const {
            const auto found = effects.find(name);
            return found == effects.end() ? nullptr : &found->second;
        }
    };

    std::optional<SfcEffects> merged(const st::Statement& statement, const std::vector<Taken>& taken,
                                     const SfcEffects& before) {
        SfcEffects result;
        for (const Taken& branch : taken)
            for (const auto& [name, effect] : branch.effects) result.try_emplace(name, SfcEffect{});
        for (auto& [name, effect] : result) {
            const bool integer = std::ranges::any_of(taken, [&name = name](const Taken& branch) {
                const SfcEffect* const own = branch.effect(name);
                return own != nullptr && own->value.valid();
            });
            if (!integer) {
                effect = merged(name, taken, statement.where);
                if (!effect.set.valid() || !effect.keep.valid()) return {};
                continue;
            }
            const auto old = before.find(name);
            const bool touched =
                old == before.end() || std::ranges::any_of(taken, [&, &name = name](const Taken& branch) {
                    const SfcEffect* const own = branch.effect(name);
                    return own == nullptr || own->value != old->second.value;
                });
            if (touched)
                return refuse(statement.where, "an integer that is assigned under a condition",
                              "assign it in a separate step");
            effect = old->second;
        }
        return result;
    }

    /// Merges the values of a Boolean variable after several branches. The variable is set if a branch that sets it is
    /// taken, and keeps its value if a branch that keeps the value is taken.
    SfcEffect merged(const std::string& name, const std::vector<Taken>& taken, Span where) {
        SfcEffect result{sfc_.draft.constant(false, where), sfc_.draft.constant(false, where), {}};
        for (const Taken& branch : taken) {
            const SfcEffect* const own = branch.effect(name);
            const auto part = [&](Id<tree::Expr> value) {
                return both(sfc_.draft, sfc_.draft.copy(branch.condition), sfc_.draft.copy(value));
            };
            result.set =
                either(sfc_.draft, result.set, part(own == nullptr ? sfc_.draft.constant(false, where) : own->set));
            result.keep =
                either(sfc_.draft, result.keep, part(own == nullptr ? sfc_.draft.constant(true, where) : own->keep));
            if (!result.set.valid() || !result.keep.valid()) break;
        }
        return result;
    }

    Sfc& sfc_;
    std::size_t first_term_;
    std::set<std::string> reads_ = {};
};

}  // namespace

std::optional<SfcBody> body_of(Sfc& sfc, const st::Block& block) {
    Execution execution(sfc);
    std::optional<SfcEffects> effects = execution.run(block, {}, 0);
    if (!effects) return {};
    return SfcBody{std::move(*effects), execution.reads()};
}

}  // namespace grafverif
