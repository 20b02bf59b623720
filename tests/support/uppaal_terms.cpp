// SPDX-License-Identifier: MIT
#include "support/uppaal_terms.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

namespace grafverif::test {
namespace {

bool is_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

constexpr std::array<std::string_view, 14> symbols = {
    "-->", "E<>", "A<>", "A[]", "&&", "||", "==", "!=", "<=", ">=", "[]", "<>", ":=", "->"};

Token next_token(std::string_view text) {
    const auto run = [&](auto belongs) {
        std::size_t length = 0;
        while (length < text.size() && belongs(text[length])) ++length;
        return std::string(text.substr(0, length));
    };
    if (text.starts_with("//")) return {Token::Kind::Comment, std::string(text.substr(0, text.find('\n')))};
    for (const std::string_view symbol : symbols)
        if (text.starts_with(symbol)) return {Token::Kind::Symbol, std::string(symbol)};
    if (is_digit(text[0])) return {Token::Kind::Number, run(is_digit)};
    if (is_name(text[0])) return {Token::Kind::Name, run(is_name)};
    return {Token::Kind::Symbol, std::string(text.substr(0, 1))};
}

std::optional<Op> comparison(const std::string& text) {
    if (text == "==") return Op::Equal;
    if (text == "!=") return Op::NotEqual;
    if (text == "<") return Op::Less;
    if (text == "<=") return Op::LessEqual;
    if (text == ">") return Op::Greater;
    if (text == ">=") return Op::GreaterEqual;
    return {};
}

}  // namespace

std::vector<Token> tokens(std::string_view text) {
    std::vector<Token> list;
    while (!text.empty()) {
        if (std::isspace(static_cast<unsigned char>(text.front())) != 0) {
            text.remove_prefix(1);
            continue;
        }
        Token token = next_token(text);
        text.remove_prefix(token.text.size());
        if (token.kind == Token::Kind::Comment) token.text.erase(0, token.text.starts_with("// ") ? 3 : 2);
        list.push_back(std::move(token));
    }
    list.push_back({});
    return list;
}

const Token& Cursor::peek(std::size_t ahead) const { return tokens_[std::min(next_ + ahead, tokens_.size() - 1)]; }

Token Cursor::take() {
    Token token = peek();
    if (next_ + 1 < tokens_.size()) ++next_;
    return token;
}

bool Cursor::accept(std::string_view text) {
    if (!at(text)) return false;
    take();
    return true;
}

void Cursor::expect(std::string_view text) {
    if (!accept(text)) throw std::runtime_error("expected `" + std::string(text) + "`, found `" + peek().text + "`");
}

std::string Cursor::name() {
    if (peek().kind != Token::Kind::Name) throw std::runtime_error("expected a name, found `" + peek().text + "`");
    return take().text;
}

std::int64_t Cursor::number() {
    const bool negative = accept("-");
    if (peek().kind != Token::Kind::Number) throw std::runtime_error("expected a number, found `" + peek().text + "`");
    const std::int64_t value = std::stoll(take().text);
    return negative ? -value : value;
}

Id<Expr> TermReader::term(Cursor& cursor) const {
    const Id<Expr> condition = disjunction(cursor);
    if (!cursor.accept("?")) return condition;
    const Id<Expr> then = disjunction(cursor);
    cursor.expect(":");
    return exprs.conditional(condition, then, term(cursor));
}

Id<Expr> TermReader::disjunction(Cursor& cursor) const {
    std::vector<Id<Expr>> operands = {conjunction(cursor)};
    while (cursor.accept("||")) operands.push_back(conjunction(cursor));
    return operands.size() == 1 ? operands[0] : exprs.disjunction(operands);
}

Id<Expr> TermReader::conjunction(Cursor& cursor) const {
    std::vector<Id<Expr>> operands = {conjunct(cursor)};
    while (cursor.accept("&&")) operands.push_back(conjunct(cursor));
    return operands.size() == 1 ? operands[0] : exprs.conjunction(operands);
}

Id<Expr> TermReader::conjunct(Cursor& cursor) const {
    const Id<Expr> left = sum(cursor);
    const std::optional<Op> relation = comparison(cursor.peek().text);
    if (!relation) return left;
    cursor.take();
    return exprs.apply(*relation, left, sum(cursor));
}

Id<Expr> TermReader::sum(Cursor& cursor) const {
    Id<Expr> left = product(cursor);
    while (cursor.at("+") || cursor.at("-")) {
        const Op op = cursor.take().text == "+" ? Op::Plus : Op::Minus;
        left = exprs.apply(op, left, product(cursor));
    }
    return left;
}

Id<Expr> TermReader::product(Cursor& cursor) const {
    Id<Expr> left = primary(cursor);
    while (cursor.at("*") || cursor.at("/") || cursor.at("%")) {
        const std::string token = cursor.take().text;
        left = exprs.apply(token == "*" ? Op::Times : token == "/" ? Op::Divide : Op::Modulo, left, primary(cursor));
    }
    return left;
}

Id<Expr> TermReader::primary(Cursor& cursor) const {
    if (cursor.accept("!")) return exprs.negation(primary(cursor));
    if (cursor.accept("-")) return exprs.apply(Op::Negate, std::array{primary(cursor)});
    if (cursor.accept("(")) {
        const Id<Expr> inner = term(cursor);
        cursor.expect(")");
        return inner;
    }
    if (cursor.peek().kind == Token::Kind::Number) return exprs.integer(cursor.number());
    const std::string word = cursor.name();
    if (word == "true" || word == "false") return exprs.constant(word == "true");
    if (cursor.accept(".")) return member(word, cursor.name());
    if (!cursor.accept("(")) return name(word);
    cursor.expect(")");
    return function(word);
}

}  // namespace grafverif::test
