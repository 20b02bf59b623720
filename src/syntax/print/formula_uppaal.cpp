// SPDX-License-Identifier: MIT
// Reads the symbolic queries of UPPAAL and the expressions in these queries. The reader ignores operator precedence,
// because UPPAAL parses the query again. For the reader, an expression is a sequence of operands and operators. An
// operand may have prefix operators and indices.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "support/overloaded.hpp"
#include "syntax/print/formula_reader.hpp"
#include "syntax/print/legal_names.hpp"

namespace grafverif::formulas {

std::optional<FormulaFault> smv_fault(FormulaLanguage language, std::string_view text, const FormulaNames& names);

namespace {

constexpr std::array<std::string_view, 36> uppaal_symbols{
    "-->", "[]", "<>", "<?", ">?", "&&", "||", "==", "!=", "<=", ">=", "<<", ">>", ":=", "++", "+=", "(", ")",
    "[",   "]",  "!",  "<",  ">",  "+",  "-",  "*",  "/",  "%",  "&",  "|",  "^",  "?",  ":",  "=",  ",", "."};

class UppaalReader : public Reader {
public:
    UppaalReader(std::string_view text, const FormulaNames& names) : Reader(text, uppaal_symbols, ""), names_(names) {}

    void read() {
        const bool of_paths = quantifier();
        expression();
        if (!of_paths) {
            if (kind_ == Kind::End && !fault_)
                return fail_here("a query must start with `A[]`, `A<>`, `E<>` or `E[]`, or have the form `p --> q`");
            expect("-->");
            expression();
        }
        if (kind_ != Kind::End) refuse_operator();
    }

private:
    bool quantifier() {
        if (!is("A") && !is("E")) return false;
        const bool all = accept("A");
        if (!all) advance();
        deadlock_ = is(all ? "[]" : "<>");
        if (accept_one({"[]", "<>"}).empty()) expected("`[]` or `<>`");
        return true;
    }

    void refuse_operator() {
        if (is_one_of({"=", ":=", "++", "+="}))
            return fail_here(fmt::format("{} is an assignment; write `==` for equality", shown()));
        expected("an operator or the end of the formula");
    }

    void expression() {
        const Nest nest(*this);
        operand();
        for (;;) {
            if (accept("?")) {
                expression();
                expect(":");
                operand();
            } else if (!accept_one({"&&", "||", "and", "or", "imply", "==", "!=", "<=", ">=", "<?", ">?", "<<",
                                    ">>", "<",  ">",   "+",  "-",     "*",  "/",  "%",  "&",  "|",  "^"})
                            .empty()) {
                operand();
            } else if (is_one_of({"=", ":=", "++", "+="})) {
                return refuse_operator();
            } else {
                return;
            }
        }
    }

    void operand() {
        const Nest nest(*this);
        while (!accept_one({"!", "-", "+", "not"}).empty()) {
        }
        if (is_one_of({"forall", "exists", "sum"})) return over_range();
        if (accept("(")) {
            expression();
            expect(")");
        } else if (kind_ == Kind::Number) {
            advance();
            if (accept(".")) number();
        } else if (accept("true") || accept("false")) {
        } else if (is("deadlock")) {
            if (!deadlock_) fail_here("`deadlock` is allowed only in `A[]` and `E<>`");
            advance();
        } else if (accept("abs")) {
            expect("(");
            expression();
            expect(")");
        } else {
            name();
        }
        while (accept("[")) {
            expression();
            expect("]");
        }
    }

    void number() {
        if (kind_ == Kind::Number) advance();
        else expected("a number");
    }

    std::string word() {
        if (kind_ != Kind::Name || is_reserved(Target::Uppaal, here())) expected("an operand");
        std::string name(here());
        advance();
        return name;
    }

    void name() {
        const std::size_t begin = begin_;
        std::string path = word();
        const bool bound = std::ranges::find(bound_, path) != bound_.end();
        while (accept(".")) path += '.' + word();
        if (names_ && !bound && !fault_ && !names_(path))
            fail(begin, before_, fmt::format("the model does not declare `{}`", path));
    }

    /// Reads a quantified expression such as `forall (i : int[0, 3]) ...`.
    void over_range() {
        advance();
        expect("(");
        bound_.push_back(word());
        expect(":");
        expect("int");
        expect("[");
        expression();
        expect(",");
        expression();
        expect("]");
        expect(")");
        expression();
        bound_.pop_back();
    }

    const FormulaNames& names_;
    bool deadlock_ = false;
    std::vector<std::string> bound_ = {};
};

}  // namespace

}  // namespace grafverif::formulas

namespace grafverif {

std::string_view word(FormulaLanguage language) {
    switch (language) {
    case FormulaLanguage::Ctl: return "CTL";
    case FormulaLanguage::Ltl: return "LTL";
    case FormulaLanguage::Uppaal: return "UPPAAL";
    }
    unreachable();
}

std::optional<FormulaLanguage> formula_language(Pattern pattern) {
    switch (pattern) {
    case Pattern::RawCtl: return FormulaLanguage::Ctl;
    case Pattern::RawLtl: return FormulaLanguage::Ltl;
    case Pattern::RawUppaal: return FormulaLanguage::Uppaal;
    case Pattern::Always:
    case Pattern::Never:
    case Pattern::Reachable:
    case Pattern::Inevitable:
    case Pattern::LeadsTo:
    case Pattern::NoDeadlock:
    case Pattern::NoTimelock:
    case Pattern::ReachableAllSteps:
    case Pattern::ExactlyOneOf:
    case Pattern::Watched:
    case Pattern::AlwaysPossible: return {};
    }
    unreachable();
}

std::optional<FormulaFault> formula_fault(FormulaLanguage language, std::string_view text, const FormulaNames& names) {
    if (language != FormulaLanguage::Uppaal) return formulas::smv_fault(language, text, names);
    formulas::UppaalReader reader(text, names);
    reader.read();
    return std::move(reader).fault();
}

}  // namespace grafverif
