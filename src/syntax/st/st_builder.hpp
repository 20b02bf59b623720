// SPDX-License-Identifier: MIT
// st::Builder: semantic actions of grammars/st.yy. The builder adds expressions, statements and units to an st::File.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/support/diagnostic.hpp"
#include "syntax/language/places.hpp"
#include "syntax/st/st_tree.hpp"

namespace grafverif::st {

class Lexer;

/// Returns the span from the beginning of `first` to the end of `last`.
inline Span joined(Span first, Span last) { return {first.source, first.begin, last.end}; }

class Builder {
public:
    Builder(File& file, Diagnostics& diagnostics) : file_(&file), diagnostics_(&diagnostics) {}

    void expression(Id<Expr> expression) { expression_ = expression; }
    void statements(Block block) { block_ = std::move(block); }
    void globals(std::vector<Variable> variables);
    void unit(UnitKind kind, Name name, Unit body, Span where);
    void unit(UnitKind kind, Name name, Type result, Unit body, Span where);
    Type enumeration(std::vector<Name> values) const;
    void type(Name name, Type type, Id<Expr> initial, Span where);
    void structure(Name name, std::vector<Variable> members, Span where);
    Type array(const std::vector<Id<Expr>>& ranges, Type element) const;
    void task(Name name, std::vector<Id<Expr>> arguments, Span where);
    void instance(Name name, Name task, Name type, std::vector<Id<Expr>> arguments, Span where);

    std::vector<Variable> section(Section section, Qualifiers qualifiers, std::vector<Variable> variables) const;
    std::vector<Variable> variables(std::vector<Name> names, std::string address, Type type, Id<Expr> initial,
                                    Span where) const;
    void add_variables(Unit& unit, std::vector<Variable> variables) const;
    /// Adds a step to a unit. `begin` and `end` are the positions of the first and the last keyword of the step.
    void step(Unit& unit, bool initial, Name name, std::vector<Association> actions, Span begin, Span end) const;
    void transition(Unit& unit, Transition transition) const;
    void action(Unit& unit, Name name, Block body, Span begin, Span end) const;
    Association association(Name action, std::vector<Id<Expr>> arguments, Span where);

    Id<Statement> assign(Id<Expr> target, Id<Expr> value, Span where);
    Id<Statement> call_statement(Id<Expr> call, Span where);
    Id<Statement> if_statement(Id<Expr> condition, Block body, std::vector<Branch> alternatives, Branch otherwise,
                               Span where);
    Id<Statement> case_statement(Id<Expr> selector, std::vector<Branch> cases, Branch otherwise, Span where);
    Id<Statement> loop(StatementKind kind, Block body, Span where, Id<Expr> condition = {});
    Id<Statement> for_statement(Id<Expr> variable, std::array<Id<Expr>, 3> range, Block body, Span where);
    Id<Statement> plain(StatementKind kind, Span where);
    Branch branch(std::vector<Id<Expr>> conditions, Block body, Span where) const;

    Id<Expr> leaf(Op op, Span where);
    Id<Expr> number(Op op, std::int64_t value, Span where);
    Id<Expr> word(Op op, Name word);
    Id<Expr> other(Span where);
    Id<Expr> unary(Op op, Id<Expr> operand, Span where);
    /// Adds a binary operator. `AND`, `OR` and `XOR` are flattened: a left operand with the same operator is merged, so
    /// that a conjunction is one node.
    Id<Expr> binary(Op op, Id<Expr> left, Id<Expr> right, Span where);
    Id<Expr> bracketed(Id<Expr> expression, Span where);
    Id<Expr> member(Id<Expr> owner, Name name, Span where);
    Id<Expr> index(Id<Expr> array, const std::vector<Id<Expr>>& indices, Span where);
    Id<Expr> call(Id<Expr> callee, const std::vector<Id<Expr>>& arguments, Span where);
    Id<Expr> argument(Op op, Name formal, Id<Expr> value, Span where);
    std::string text(Name name) const { return std::string(file_->text(name)); }

    std::optional<Id<Expr>> read_expression() const { return expression_; }
    Block read_statements() const { return block_; }

private:
    Id<Expr> node(Op op, std::initializer_list<Id<Expr>> operands, Span where);
    void adopt(Id<Expr> node, Id<Expr> operand);
    void set_name(Id<Expr> node, Name name);
    Network& chart(Unit& unit, Span where) const;

    File* file_;
    Diagnostics* diagnostics_;
    std::optional<Id<Expr>> expression_ = {};
    Block block_ = {};
};

}  // namespace grafverif::st
