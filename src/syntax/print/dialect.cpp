// SPDX-License-Identifier: MIT
// Defines the dialects of the target languages and prints expressions. The precedence levels, from lowest to highest,
// are: conditional, or, and, comparison, sum, product, prefix, atom. Each dialect assigns operators to these levels
// according to the precedence in the target language.
#include "syntax/print/dialect.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <ostream>
#include <sstream>

#include "support/overloaded.hpp"

namespace grafverif {

namespace {

constexpr int conditional_level = 1;
constexpr int or_level = 2;
constexpr int and_level = 3;
constexpr int comparison_level = 4;
constexpr int sum_level = 5;
constexpr int product_level = 6;
constexpr int prefix_level = 7;

/// Returns the spelling of an operator in the .grafcet language and in UPPAAL, which both use the
/// operators of C.
Spelling c_spelling(Op op) {
    switch (op) {
    case Op::False: return {"false", atom_precedence};
    case Op::True: return {"true", atom_precedence};
    case Op::Integer:
    case Op::Duration:
    case Op::Variable:
    case Op::Step:
    case Op::Parameter:
    case Op::At: return {"", atom_precedence};
    case Op::Timed: return {"", product_level};
    case Op::Not: return {"!", prefix_level};
    case Op::And: return {"&&", and_level};
    case Op::Or: return {"||", or_level};
    case Op::Rise: return {"rise", atom_precedence};
    case Op::Fall: return {"fall", atom_precedence};
    case Op::Equal: return {"==", comparison_level};
    case Op::NotEqual: return {"!=", comparison_level};
    case Op::Less: return {"<", comparison_level};
    case Op::LessEqual: return {"<=", comparison_level};
    case Op::Greater: return {">", comparison_level};
    case Op::GreaterEqual: return {">=", comparison_level};
    case Op::Negate: return {"-", prefix_level};
    case Op::Plus: return {"+", sum_level};
    case Op::Minus: return {"-", sum_level};
    case Op::Times: return {"*", product_level};
    case Op::Divide: return {"/", product_level};
    case Op::Modulo: return {"%", product_level};
    case Op::Conditional: return {"?", conditional_level};
    }
    unreachable();
}

}  // namespace

Spelling chart_spelling(Op op) { return c_spelling(op); }

Spelling uppaal_spelling(Op op) { return c_spelling(op); }

// `not` has the precedence of comparisons, so that both `not (a == b)` and `(not a) == b` are printed with brackets.
Spelling plain_spelling(Op op) {
    switch (op) {
    case Op::Not: return {"not", comparison_level};
    case Op::And: return {"and", and_level};
    case Op::Or: return {"or", or_level};
    default: return c_spelling(op);
    }
}

Spelling latex_spelling(Op op) {
    switch (op) {
    case Op::False: return {"\\mathrm{false}", atom_precedence};
    case Op::True: return {"\\mathrm{true}", atom_precedence};
    case Op::Not: return {"\\neg", comparison_level};
    case Op::And: return {"\\wedge", and_level};
    case Op::Or: return {"\\vee", or_level};
    case Op::Rise: return {"\\uparrow", atom_precedence};
    case Op::Fall: return {"\\downarrow", atom_precedence};
    case Op::Equal: return {"=", comparison_level};
    case Op::NotEqual: return {"\\neq", comparison_level};
    case Op::LessEqual: return {"\\leq", comparison_level};
    case Op::GreaterEqual: return {"\\geq", comparison_level};
    case Op::Times: return {"\\cdot", product_level};
    case Op::Modulo: return {"\\bmod", product_level};
    case Op::Conditional: return {"\\mathbin{?}", conditional_level};
    default: return c_spelling(op);
    }
}

Spelling nusmv_spelling(Op op) {
    switch (op) {
    case Op::False: return {"FALSE", atom_precedence};
    case Op::True: return {"TRUE", atom_precedence};
    case Op::And: return {"&", and_level};
    case Op::Or: return {"|", or_level};
    case Op::Equal: return {"=", comparison_level};
    case Op::Modulo: return {"mod", product_level};
    case Op::Conditional: return {"?", atom_precedence};
    default: return c_spelling(op);
    }
}

Spelling structured_text_spelling(Op op) {
    switch (op) {
    case Op::False: return {"FALSE", atom_precedence};
    case Op::True: return {"TRUE", atom_precedence};
    case Op::Not: return {"NOT", prefix_level};
    case Op::And: return {"AND", and_level};
    case Op::Or: return {"OR", or_level};
    case Op::Equal: return {"=", comparison_level};
    case Op::NotEqual: return {"<>", comparison_level};
    case Op::Modulo: return {"MOD", product_level};
    case Op::Conditional: return {"SEL", atom_precedence};
    default: return c_spelling(op);
    }
}

Spelling scl_spelling(Op op) {
    Spelling spelling = structured_text_spelling(op);
    if (op == Op::Conditional) spelling.arguments = {"G := ", "IN0 := ", "IN1 := "};
    return spelling;
}

// In C, the operand of `!` is printed in brackets unless it is a leaf. An operand `!x` of a comparison is also printed
// in brackets, because compilers warn about `!x == y`.
Spelling c_language_spelling(Op op) {
    switch (op) {
    case Op::Not: return {"!", comparison_level};
    case Op::Conditional: return {"?", atom_precedence};
    default: return c_spelling(op);
    }
}

namespace {

struct Printer {
    std::ostream& out;
    const Exprs& exprs;
    Dialect dialect;
    const LeafPrinter& leaf;

    /// Returns the precedence of a term. A negative number has the precedence of a prefix operator.
    int precedence(Id<Expr> id) const {
        const Expr& node = exprs[id];
        if (node.op == Op::Integer && node.value < 0) return prefix_level;
        const Spelling spelling = dialect(node.op);
        return spelling.open.empty() ? spelling.precedence : atom_precedence;
    }

    /// Prints `id`, in brackets if its precedence is lower than `least`.
    void operand(Id<Expr> id, int least) const {
        if (precedence(id) >= least) {
            term(id);
            return;
        }
        out << '(';
        term(id);
        out << ')';
    }

    /// Prints an infix operator with its operands. Every infix operator is left-associative or not associative.
    void infix(Id<Expr> id, Spelling spelling) const {
        const Op op = exprs[id].op;
        const std::span<const Id<Expr>> operands = exprs.operands(id);
        for (std::size_t k = 0; k < operands.size(); ++k) {
            if (k > 0) out << ' ' << spelling.token << ' ';
            const bool may_be_equal = k == 0 && is_arithmetic(op);
            const int least = op == Op::Or ? and_level + 1 : spelling.precedence + (may_be_equal ? 0 : 1);
            operand(operands[k], least);
        }
    }

    void conditional(Id<Expr> id, Spelling spelling) const {
        const std::span<const Id<Expr>> operands = exprs.operands(id);
        if (std::isalpha(static_cast<unsigned char>(spelling.token.front())) != 0) return selection(operands, spelling);
        const bool bracketed = spelling.precedence == atom_precedence;
        if (bracketed) out << '(';
        operand(operands[0], conditional_level + 1);
        out << ' ' << spelling.token << ' ';
        operand(operands[1], conditional_level + 1);
        out << " : ";
        operand(operands[2], conditional_level);
        if (bracketed) out << ')';
    }

    /// Prints a conditional as a function call. The second argument is the value if the condition is false, and the
    /// third argument is the value if the condition is true.
    void selection(std::span<const Id<Expr>> operands, Spelling spelling) const {
        out << spelling.token << '(' << spelling.arguments[0];
        term(operands[0]);
        out << ", " << spelling.arguments[1];
        term(operands[2]);
        out << ", " << spelling.arguments[2];
        term(operands[1]);
        out << ')';
    }

    void prefix(Id<Expr> id, Spelling spelling) const {
        out << spelling.token;
        if (ends_in_letter(spelling.token)) out << ' ';
        operand(exprs.operands(id)[0], spelling.precedence + 1);
    }

    /// Prints a rising or falling edge as a function call, or as a prefix operator if the operand needs no brackets.
    void edge(Id<Expr> id, Spelling spelling) const {
        const Id<Expr> watched = exprs.operands(id)[0];
        out << spelling.token;
        if (!ends_in_letter(spelling.token)) return operand(watched, atom_precedence);
        out << '(';
        term(watched);
        out << ')';
    }

    static bool ends_in_letter(std::string_view token) {
        return !token.empty() && std::isalpha(static_cast<unsigned char>(token.back())) != 0;
    }

    void term(Id<Expr> id) const {
        const Spelling spelling = dialect(exprs[id].op);
        out << spelling.open;
        inside(id, spelling);
        out << spelling.close;
    }

    void inside(Id<Expr> id, Spelling spelling) const {
        const Expr& node = exprs[id];
        switch (node.op) {
        case Op::False:
        case Op::True: out << spelling.token; return;
        case Op::Integer: out << node.value; return;
        case Op::Duration: out << duration_text(node.value); return;
        case Op::Variable:
        case Op::Step:
        case Op::Timed:
        case Op::Parameter:
        case Op::At: leaf(out, node); return;
        case Op::Rise:
        case Op::Fall: edge(id, spelling); return;
        case Op::Not:
        case Op::Negate: prefix(id, spelling); return;
        case Op::Conditional: conditional(id, spelling); return;
        case Op::And:
        case Op::Or:
        case Op::Equal:
        case Op::NotEqual:
        case Op::Less:
        case Op::LessEqual:
        case Op::Greater:
        case Op::GreaterEqual:
        case Op::Plus:
        case Op::Minus:
        case Op::Times:
        case Op::Divide:
        case Op::Modulo: infix(id, spelling); return;
        }
        unreachable();
    }
};

}  // namespace

void print_expr(std::ostream& out, const Exprs& exprs, Id<Expr> root, Dialect dialect, const LeafPrinter& leaf) {
    Printer{out, exprs, dialect, leaf}.term(root);
}

std::string expr_text(const Exprs& exprs, Id<Expr> root, Dialect dialect, const LeafPrinter& leaf) {
    std::ostringstream out;
    print_expr(out, exprs, root, dialect, leaf);
    return out.str();
}

std::string duration_text(std::int64_t milliseconds) {
    if (milliseconds % 1000 == 0) return std::to_string(milliseconds / 1000) + "s";
    return std::to_string(milliseconds) + "ms";
}

std::optional<std::int64_t> duration_ms(std::string_view text) {
    constexpr std::int64_t longest = std::int64_t{1} << 40U;
    std::int64_t count = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (failure != std::errc{} || count <= 0 || count > longest) return {};
    std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
    unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
    const std::int64_t factor = unit == "ms" ? 1 : unit == "s" ? 1000 : unit == "min" ? 60'000 : 0;
    return factor == 0 ? std::nullopt : std::optional(count * factor);
}

}  // namespace grafverif
