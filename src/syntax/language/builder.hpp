// SPDX-License-Identifier: MIT
// Builder: semantic actions of the grammar. The builder adds expressions to the table of the file and declarations to
// the list of the file. The builder also records if the current declaration contains a syntax error.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "grafverif/support/diagnostic.hpp"
#include "syntax/language/places.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif::tree {

class Lexer;

class Builder {
public:
    Builder(tree::File& file, Diagnostics& diagnostics) : file_(&file), diagnostics_(&diagnostics) {}

    void declare(tree::Declaration declaration);
    void broken();
    void lost();

    tree::Chart chart(tree::Name name, std::vector<tree::Variables> parameters, std::vector<tree::ChartItem> items,
                      Span where);
    /// Returns the declaration of a chart instance, `partial NAME = CHART(...);`.
    tree::Partial instance(tree::Name name, tree::Name chart, std::vector<tree::Argument> arguments, Span where);
    tree::Component component(tree::Name name, tree::Component body, Span where);
    tree::Component component_body(std::vector<tree::Variables> parameters,
                                   std::vector<tree::ComponentItem> items) const;
    tree::ClosedLoop loop(tree::Name name, std::vector<tree::LoopItem> items, Span where);

    tree::Variables variables(tree::VariableKind kind, tree::Variables variables, Span where) const;
    tree::Step step(tree::Step marks, tree::Name name, std::vector<tree::Action> actions, Span where) const;
    tree::Step macro_step(tree::Step marks, tree::Name name, tree::Name expansion, std::vector<tree::Action> actions,
                          Span where) const;
    tree::Step enclosing_step(tree::Step marks, tree::Name name, std::vector<tree::Name> enclosed,
                              std::vector<tree::Action> actions, Span where) const;
    tree::ForcingOrder forcing(tree::Name chart, std::vector<tree::Name> situation, Span where) const;
    tree::Transition links(std::vector<tree::Name> from, std::vector<tree::Name> to) const;
    tree::Transition transition(tree::Transition links, Id<tree::Expr> condition,
                                std::vector<tree::Assignment> assignments, Span where) const;
    tree::Property pattern(Pattern pattern, std::vector<Id<tree::Expr>> operands) const;
    /// Returns a property with the pattern `plain` if `scope` is global; otherwise returns a property of the type
    /// `kind` with this scope.
    tree::Property scoped(Pattern plain, Sentence::Kind kind, std::vector<Id<tree::Expr>> operands,
                          tree::Property scope) const;
    tree::Property scope(Sentence::Scope scope, std::vector<Id<tree::Expr>> operands) const;
    /// Returns a property with the duration or count `bound`.
    tree::Property bounded(Sentence::Kind kind, std::vector<Id<tree::Expr>> operands, Id<tree::Expr> bound,
                           tree::Property scope) const;
    /// Reports an error: no number precedes the keyword `times`.
    tree::Property uncounted(std::vector<Id<tree::Expr>> operands, tree::Name times, tree::Property scope);
    tree::Property formula(Pattern pattern, std::string raw, Span where) const;
    tree::Property named(tree::Name name, std::string text, bool expected_violated, tree::Property pattern,
                         bool at_stable, Span where) const;
    std::string text(tree::Name name) const { return std::string(file_->text(name)); }

    Id<tree::Expr> constant(tree::Op op, Span where);
    Id<tree::Expr> number(tree::Name digits);
    Id<tree::Expr> duration(const tree::Expr& leaf) { return file_->exprs.add(leaf); }
    Id<tree::Expr> name(tree::Name name);
    /// Returns `name` with one more index.
    tree::Name indexed(tree::Name name, Id<tree::Expr> index);
    tree::Replication replication(tree::Name index, tree::Range range, Span where);
    Id<tree::Expr> replicated(tree::Op op, const tree::Replication& replication, Id<tree::Expr> term, Span where);
    Id<tree::Expr> member(Id<tree::Expr> owner, tree::Name name, Span where);
    Id<tree::Expr> place(Id<tree::Expr> owner, tree::Name name, Span where);
    Id<tree::Expr> unary(tree::Op op, Id<tree::Expr> operand, Span where);
    /// Adds a binary operator. `&&` and `||` are flattened: a left operand with the same operator and without brackets
    /// is merged, so that a conjunction is one node.
    Id<tree::Expr> binary(tree::Op op, Id<tree::Expr> left, Id<tree::Expr> right, Span where);
    Id<tree::Expr> bracketed(Id<tree::Expr> expression, Span where);

private:
    Id<tree::Expr> node(tree::Op op, std::initializer_list<Id<tree::Expr>> operands, Span where);
    Id<tree::Expr> named_node(tree::Op op, Id<tree::Expr> owner, tree::Name name, Span where);
    /// Facts that the parser has found about the current declaration: the declaration contains a
    /// syntax error (`broken`) or replicated declarations (`replicated`).
    struct Marks {
        bool broken = false, replicated = false;
    };
    /// Returns the recorded facts about the current declaration, and resets them for the next
    /// declaration.
    Marks take_marks();

    tree::File* file_;
    Diagnostics* diagnostics_;
    bool broken_ = false;
    bool replicated_ = false;
    /// Position of the last expression that was reported as too deep. Enclosing expressions are not reported again.
    Span too_deep_ = {};
};

}  // namespace grafverif::tree
