// SPDX-License-Identifier: MIT
// Reads tokens and terms of the part of UPPAAL's language that the emitter writes, for the project reader of the tests.
// Errors throw std::runtime_error, which fails the test.
#pragma once

#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/expr.hpp"

namespace grafverif::test {

struct Token {
    enum class Kind { Name, Number, Symbol, Comment, End };
    Kind kind = Kind::End;
    std::string text = {};
};

/// Returns the tokens of `text`. A line comment is one token, without its slashes.
std::vector<Token> tokens(std::string_view text);

/// Reads tokens sequentially.
class Cursor {
public:
    explicit Cursor(std::string_view text) : tokens_(tokens(text)) {}

    const Token& peek(std::size_t ahead = 0) const;
    bool at_end() const { return peek().kind == Token::Kind::End; }
    bool at(std::string_view text) const { return peek().text == text && peek().kind != Token::Kind::Comment; }
    bool accept(std::string_view text);
    void expect(std::string_view text);
    Token take();
    std::string name();
    std::int64_t number();  ///< reads a number with an optional minus sign

    std::size_t mark() const { return next_; }
    void back_to(std::size_t mark) { next_ = mark; }

private:
    std::vector<Token> tokens_;
    std::size_t next_ = 0;
};

/// Reads terms over the names that `name` resolves. `member` resolves `process.location`, and `function` resolves a
/// call without arguments.
struct TermReader {
    Exprs& exprs;
    std::function<Id<Expr>(const std::string&)> name = {};
    std::function<Id<Expr>(const std::string&, const std::string&)> member = {};
    std::function<Id<Expr>(const std::string&)> function = {};

    Id<Expr> term(Cursor& cursor) const;      ///< reads a term, which may contain `? :`
    Id<Expr> conjunct(Cursor& cursor) const;  ///< reads a term whose operators bind tighter than `&&`
    Id<Expr> primary(Cursor& cursor) const;   ///< reads a name, a number, a call or parentheses, with prefix operators
    Id<Expr> sum(Cursor& cursor) const;

private:
    Id<Expr> disjunction(Cursor& cursor) const;
    Id<Expr> conjunction(Cursor& cursor) const;
    Id<Expr> product(Cursor& cursor) const;
};

}  // namespace grafverif::test
