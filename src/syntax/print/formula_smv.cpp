// SPDX-License-Identifier: MIT
// Reads CTL and LTL formulas in the syntax of NuSMV 2.6. The operators, from lowest to highest precedence, are: `->`,
// `<->`, `? :`, `| xor xnor`, `&`, `U S V T` (LTL), path operators, relations, `in`, sums, products, `!` and `-`.
// Therefore `AG x -> y` is `(AG x) -> y`, and `!a = b` is `(!a) = b`. Between `A [` and `]` the language is pure CTL,
// without `? :`.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "syntax/print/formula_reader.hpp"
#include "syntax/print/legal_names.hpp"

namespace grafverif::formulas {

namespace {

using Type = FormulaName::Type;

constexpr std::array<std::string_view, 26> smv_symbols{"<->", "->", "!=", "<=", ">=", "..", "(", ")", "[",
                                                       "]",   "{",  "}",  "!",  "&",  "|",  "=", "<", ">",
                                                       "+",   "-",  "*",  "/",  "?",  ":",  ",", "."};

/// A subformula with its position and type.
struct Subformula {
    std::size_t begin = 0, end = 0;
    Type type = Type::Any;
    bool temporal = false;  ///< true if the subformula contains a path operator
};

std::string_view described(Type type) {
    switch (type) {
    case Type::Boolean: return "a condition";
    case Type::Number: return "a number";
    case Type::Value: return "a named value";
    case Type::Any: break;
    }
    return "anything";
}

class SmvReader : public Reader {
public:
    SmvReader(FormulaLanguage language, std::string_view text, const FormulaNames& names)
        : Reader(text, smv_symbols, "$#-"), ltl_(language == FormulaLanguage::Ltl), names_(names) {}

    void read() {
        const Subformula whole = implication();
        if (kind_ != Kind::End) expected("an operator or the end of the formula");
        require(whole, Type::Boolean, "a formula");
    }

private:
    // -- type checks --------------------------------------------------------------------------------------------------

    void require(const Subformula& part, Type type, std::string_view who) {
        if (part.type == Type::Any || part.type == type) return;
        fail(part.begin, part.end,
             fmt::format("expected {1} for {0}, found {2}", who, described(type), described(part.type)));
    }
    void require_plain(const Subformula& part, std::string_view op) {
        if (!part.temporal) return;
        fail(part.begin, part.end, fmt::format("an operand of `{}` contains a path operator", op));
    }
    void require_alike(const Subformula& left, const Subformula& right, std::string_view op) {
        if (left.type == Type::Any || right.type == Type::Any || left.type == right.type) return;
        fail(right.begin, right.end,
             fmt::format("`{}` has {} on one side and {} on the other", op, described(left.type),
                         described(right.type)));
    }
    std::string an_operand(std::string_view op) const { return fmt::format("an operand of `{}`", op); }
    Subformula joined(const Subformula& left, const Subformula& right, Type type) const {
        return {left.begin, right.end, type, left.temporal || right.temporal};
    }

    // -- conditions ---------------------------------------------------------------------------------------------------

    template <class Operand>
    Subformula logical(std::initializer_list<std::string_view> operators, const Operand& operand) {
        Subformula left = operand();
        for (std::string_view op = accept_one(operators); !op.empty(); op = accept_one(operators)) {
            const Subformula right = operand();
            require(left, Type::Boolean, an_operand(op));
            require(right, Type::Boolean, an_operand(op));
            left = joined(left, right, Type::Boolean);
        }
        return left;
    }

    Subformula implication() {
        const Nest nest(*this);
        return logical({"->"}, [this] { return logical({"<->"}, [this] { return choice(); }); });
    }

    Subformula choice() {
        const Nest nest(*this);
        const Subformula condition =
            logical({"|", "xor", "xnor"}, [this] { return logical({"&"}, [this] { return until(); }); });
        if (in_until_ || !accept("?")) return condition;
        const Subformula then = implication();
        expect(":");
        const Subformula otherwise = choice();
        require(condition, Type::Boolean, an_operand("?"));
        for (const Subformula& part : {condition, then, otherwise}) require_plain(part, "?");
        require_alike(then, otherwise, "? :");
        return joined(condition, otherwise, then.type == Type::Any ? otherwise.type : then.type);
    }

    Subformula until() {
        if (!ltl_) return path();
        return logical({"U", "S", "V", "T"}, [this] { return path(); });
    }

    // -- path operators -----------------------------------------------------------------------------------------------

    bool at_unary_path() const {
        return ltl_ ? is_one_of({"X", "Y", "Z", "G", "H", "F", "O"})
                    : is_one_of({"EX", "AX", "EF", "AF", "EG", "AG", "EBF", "ABF", "EBG", "ABG"});
    }

    Subformula path() {
        const Nest nest(*this);
        const std::size_t begin = begin_;
        if (is("!") && path_follows()) {
            advance();
            return temporal(begin, path(), "!");
        }
        if (!ltl_ && is_one_of({"A", "E"})) return until_of_ctl();
        if (!at_unary_path()) return relation();
        const std::string op(here());
        advance();
        if (op.size() == 3) subrange();
        if (ltl_ && op.find_first_of("GHFO") == 0 && is("[")) bounds();
        return temporal(begin, path(), op);
    }

    Subformula temporal(std::size_t begin, const Subformula& operand, std::string_view op) {
        require(operand, Type::Boolean, an_operand(op));
        return {begin, operand.end, Type::Boolean, operand.temporal || op != "!"};
    }

    /// True if the next token is a path operator, or if only `!` operators precede a path operator.
    bool path_follows() {
        SmvReader ahead = *this;
        while (ahead.accept("!")) {
        }
        return ahead.at_unary_path() || (!ltl_ && ahead.is_one_of({"A", "E"}));
    }

    Subformula until_of_ctl() {
        const std::size_t begin = begin_;
        advance();
        expect("[");
        const bool outer = std::exchange(in_until_, true);
        const Subformula before = implication();
        if (accept("BU")) subrange();
        else expect("U");
        const Subformula after = implication();
        in_until_ = outer;
        expect("]");
        require(before, Type::Boolean, an_operand("U"));
        require(after, Type::Boolean, an_operand("U"));
        return {begin, before_, Type::Boolean, true};
    }

    void number() {
        if (kind_ == Kind::Number) advance();
        else expected("a number");
    }
    void subrange() {
        accept_one({"-", "+"});
        number();
        expect("..");
        accept_one({"-", "+"});
        number();
    }
    void bounds() {
        advance();
        number();
        expect(",");
        number();
        expect("]");
    }

    // -- relations and numbers ----------------------------------------------------------------------------------------

    Subformula relation() {
        Subformula left = membership();
        const std::initializer_list<std::string_view> operators{"=", "!=", "<=", ">=", "<", ">"};
        for (std::string_view op = accept_one(operators); !op.empty(); op = accept_one(operators)) {
            const Subformula right = membership();
            for (const Subformula& part : {left, right}) {
                require_plain(part, op);
                if (op != "=" && op != "!=") require(part, Type::Number, an_operand(op));
            }
            require_alike(left, right, op);
            left = joined(left, right, Type::Boolean);
        }
        return left;
    }

    Subformula membership() {
        const Subformula left = sum();
        if (!accept("in")) return left;
        require_plain(left, "in");
        const Subformula set = members(left);
        return {left.begin, set.end, Type::Boolean, false};
    }

    /// Reads a set such as `{a, b}` or `1..3`. Reports an error if a member has another type than `one`.
    Subformula members(const Subformula& one) {
        const std::size_t begin = begin_;
        if (!accept("{")) {
            const Subformula low = sum();
            expect("..");
            const Subformula high = sum();
            for (const Subformula& part : {one, low, high}) require(part, Type::Number, an_operand("in"));
            return joined(low, high, Type::Number);
        }
        do {
            const Subformula member = implication();
            require_plain(member, "in");
            require_alike(one, member, "in");
        } while (accept(","));
        expect("}");
        return {begin, before_, one.type, false};
    }

    template <class Operand>
    Subformula numeric(std::initializer_list<std::string_view> operators, const Operand& operand) {
        Subformula left = operand();
        for (std::string_view op = accept_one(operators); !op.empty(); op = accept_one(operators)) {
            const Subformula right = operand();
            for (const Subformula& part : {left, right}) {
                require_plain(part, op);
                require(part, Type::Number, an_operand(op));
            }
            left = joined(left, right, Type::Number);
        }
        return left;
    }

    Subformula sum() {
        return numeric({"+", "-"}, [this] { return numeric({"*", "/", "mod"}, [this] { return operand(); }); });
    }

    // -- operands -----------------------------------------------------------------------------------------------------

    Subformula operand() {
        const Nest nest(*this);
        const std::size_t begin = begin_;
        if (const std::string_view op = accept_one({"!", "-"}); !op.empty()) {
            const Subformula part = operand();
            require(part, op == "!" ? Type::Boolean : Type::Number, an_operand(op));
            if (op == "-") require_plain(part, op);
            return {begin, part.end, op == "!" ? Type::Boolean : Type::Number, part.temporal};
        }
        if (accept("(")) {
            const bool outer = std::exchange(in_until_, false);
            const Subformula part = implication();
            in_until_ = outer;
            expect(")");
            return {begin, before_, part.type, part.temporal};
        }
        if (accept("TRUE") || accept("FALSE")) return {begin, before_, Type::Boolean, false};
        if (kind_ == Kind::Number) {
            advance();
            return {begin, before_, Type::Number, false};
        }
        if (kind_ == Kind::Name) return is_function() ? call() : name();
        expected("an operand");
        return {};
    }

    bool is_function() const { return is_one_of({"count", "abs", "min", "max", "toint", "bool", "next"}); }

    Subformula call() {
        const std::size_t begin = begin_;
        const std::string function(here());
        if (function == "next" && !ltl_) fail_here("`next` is allowed only in LTL, not in CTL");
        if (function == "next" && in_next_) fail_here("`next` is not allowed within `next`");
        advance();
        expect("(");
        const bool outer = std::exchange(in_next_, in_next_ || function == "next");
        std::vector<Subformula> arguments;
        do arguments.push_back(implication());
        while (accept(","));
        in_next_ = outer;
        expect(")");
        const std::size_t most = function == "count"                      ? arguments.size()
                                 : function == "min" || function == "max" ? 2
                                                                          : 1;
        if (arguments.size() != most)
            fail(begin, before_, fmt::format("`{}` takes {}", function, most == 1 ? "one operand" : "two operands"));
        for (const Subformula& part : arguments) {
            require_plain(part, function);
            if (function == "count") require(part, Type::Boolean, an_operand(function));
            if (function == "abs" || most == 2) require(part, Type::Number, an_operand(function));
        }
        if (function == "next") return {begin, before_, arguments[0].type, false};
        return {begin, before_, function == "bool" ? Type::Boolean : Type::Number, false};
    }

    Subformula name() {
        const std::size_t begin = begin_;
        refuse_word();
        std::string path(here());
        for (advance(); accept(".");) {
            if (kind_ == Kind::Name) refuse_word();
            if (kind_ != Kind::Name && kind_ != Kind::Number) expected("a name");
            path += '.' + std::string(here());
            advance();
        }
        if (!names_ || fault_) return {begin, before_, Type::Any, false};
        const std::optional<FormulaName> known = names_(path);
        if (!known) fail(begin, before_, fmt::format("the model does not declare `{}`", path));
        else if (known->of_steps && !ltl_)
            fail(begin, before_,
                 fmt::format("the value of `{}` is chosen in each step, so it is allowed only in LTL, not in CTL",
                             path));
        return {begin, before_, known ? known->type : Type::Any, false};
    }

    /// Rejects words that have the form of a name but are not allowed as names.
    void refuse_word() {
        const std::string_view word = here();
        static constexpr std::array<std::string_view, 12> of_ctl{"EX", "AX", "EF",  "AF",  "EG",  "AG",
                                                                 "A",  "E",  "EBF", "ABF", "EBG", "ABG"};
        static constexpr std::array<std::string_view, 11> of_ltl{"X", "Y", "Z", "G", "H", "F", "O", "U", "S", "V", "T"};
        const auto among = [word](const auto& words) { return std::ranges::find(words, word) != words.end(); };
        if (among(ltl_ ? std::span<const std::string_view>(of_ctl) : std::span<const std::string_view>(of_ltl)))
            return fail_here(fmt::format("`{}` is an operator of {}, but the formula is {}", word, ltl_ ? "CTL" : "LTL",
                                         ltl_ ? "LTL" : "CTL"));
        if (is_reserved(Target::Nusmv, word)) return expected("an operand");
        if (word.find_first_of("$#-") != std::string_view::npos)
            fail_here(fmt::format("NuSMV reads `{}` as one name; insert a blank before the operator", word));
    }

    bool ltl_ = false;
    const FormulaNames& names_;
    bool in_until_ = false, in_next_ = false;
};

}  // namespace

std::optional<FormulaFault> smv_fault(FormulaLanguage language, std::string_view text, const FormulaNames& names) {
    SmvReader reader(language, text, names);
    reader.read();
    return std::move(reader).fault();
}

}  // namespace grafverif::formulas
