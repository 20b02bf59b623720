// SPDX-License-Identifier: MIT
#include "support/nusmv_reader.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

namespace grafverif {

namespace {

bool starts_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
/// True if `c` may be part of a name; NuSMV reads `a-b` as one identifier.
bool in_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$' || c == '#' || c == '-';
}

std::vector<std::string_view> tokens(std::string_view text) {
    std::vector<std::string_view> result;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t begin = at;
        if (std::isspace(static_cast<unsigned char>(text[at])) != 0) {
            ++at;
            continue;
        }
        if (text.substr(at).starts_with("--")) {
            at = std::min(text.find('\n', at), text.size());
            continue;
        }
        if (starts_name(text[at])) {
            while (at < text.size() && in_name(text[at])) ++at;
        } else if (std::isdigit(static_cast<unsigned char>(text[at])) != 0) {
            while (at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0) ++at;
        } else {
            static constexpr std::array<std::string_view, 7> long_ones{":=", "..", "->", "!=", "<=", ">=", "<->"};
            const auto found =
                std::ranges::find_if(long_ones, [&](std::string_view one) { return text.substr(at).starts_with(one); });
            at += found == long_ones.end() ? 1 : found->size();
        }
        result.push_back(text.substr(begin, at - begin));
    }
    return result;
}

constexpr std::array<std::string_view, 13> keywords{"MODULE",    "VAR",   "IVAR",    "ASSIGN", "DEFINE",
                                                    "INVAR",     "TRANS", "JUSTICE", "SPEC",   "LTLSPEC",
                                                    "INVARSPEC", "NAME",  ""};

struct NusmvReader {
    NusmvModel model = {};
    std::vector<std::string_view> token = {};
    std::size_t at = 0;

    std::string_view peek() const { return at < token.size() ? token[at] : std::string_view(); }
    std::string_view take() { return at < token.size() ? token[at++] : std::string_view(); }
    bool accept(std::string_view expected) {
        if (peek() != expected) return false;
        ++at;
        return true;
    }
    void expect(std::string_view expected) {
        if (accept(expected) || !model.error_text.empty()) return;
        model.error_text = "expected `" + std::string(expected) + "`, got `" + std::string(peek()) + "`";
        if (at > 0) model.error_text += " after `" + std::string(token[at - 1]) + "`";
        at = token.size();
    }
    bool at_section() const { return peek().empty() || std::ranges::find(keywords, peek()) != keywords.end(); }

    std::int64_t number() {
        const bool negative = accept("-");
        std::int64_t value = 0;
        const std::string_view text = take();
        std::from_chars(text.data(), text.data() + text.size(), value);
        return negative ? -value : value;
    }

    std::string identifier() {
        std::string name(take());
        while (accept(".")) name += "." + std::string(take());
        return name;
    }

    // -- expressions, loosest first: conditional, |, &, comparison, sum, product, prefix ------------------------------
    Id<Expr> expression() {
        const Id<Expr> condition = disjunction();
        if (!accept("?")) return condition;
        const Id<Expr> then = expression();
        expect(":");
        return model.exprs.conditional(condition, then, expression());
    }
    Id<Expr> disjunction() {
        Id<Expr> left = conjunction();
        while (accept("|")) left = model.exprs.disjunction(left, conjunction());
        return left;
    }
    Id<Expr> conjunction() {
        Id<Expr> left = comparison();
        while (accept("&")) left = model.exprs.conjunction(left, comparison());
        return left;
    }
    Id<Expr> comparison() {
        Id<Expr> left = sum();
        while (true) {
            if (accept("=")) left = model.exprs.apply(Op::Equal, left, sum());
            else if (accept("!=")) left = model.exprs.apply(Op::NotEqual, left, sum());
            else if (accept("<")) left = model.exprs.apply(Op::Less, left, sum());
            else if (accept("<=")) left = model.exprs.apply(Op::LessEqual, left, sum());
            else if (accept(">")) left = model.exprs.apply(Op::Greater, left, sum());
            else if (accept(">=")) left = model.exprs.apply(Op::GreaterEqual, left, sum());
            else return left;
        }
    }
    Id<Expr> sum() {
        Id<Expr> left = product();
        while (true) {
            if (accept("+")) left = model.exprs.apply(Op::Plus, left, product());
            else if (accept("-")) left = model.exprs.apply(Op::Minus, left, product());
            else return left;
        }
    }
    Id<Expr> product() {
        Id<Expr> left = prefix();
        while (true) {
            if (accept("*")) left = model.exprs.apply(Op::Times, left, prefix());
            else if (accept("/")) left = model.exprs.apply(Op::Divide, left, prefix());
            else if (accept("mod")) left = model.exprs.apply(Op::Modulo, left, prefix());
            else return left;
        }
    }
    Id<Expr> prefix() {
        if (accept("!")) return model.exprs.negation(prefix());
        if (accept("-")) return model.exprs.apply(Op::Negate, std::array{prefix()});
        if (accept("(")) {
            const Id<Expr> inner = expression();
            expect(")");
            return inner;
        }
        if (accept("TRUE")) return model.exprs.constant(true);
        if (accept("FALSE")) return model.exprs.constant(false);
        if (!peek().empty() && std::isdigit(static_cast<unsigned char>(peek().front())) != 0)
            return model.exprs.integer(number());
        if (peek().empty() || !starts_name(peek().front())) expect("a term");
        return model.leaf(identifier());
    }
    /// Reads a conditional such as `case c : v; TRUE : w; esac`, or another expression.
    Id<Expr> value() {
        if (!accept("case")) return expression();
        std::vector<std::pair<Id<Expr>, Id<Expr>>> cases;
        while (!accept("esac") && at < token.size()) {
            const Id<Expr> condition = expression();
            expect(":");
            cases.emplace_back(condition, expression());
            expect(";");
        }
        if (cases.empty() || !is_true(model.exprs, cases.back().first)) {
            expect("a last case TRUE");
            return model.exprs.constant(false);
        }
        Id<Expr> result = cases.back().second;
        for (std::size_t k = cases.size() - 1; k-- > 0;)
            result = model.exprs.conditional(cases[k].first, cases[k].second, result);
        return result;
    }

    // -- modules
    // -------------------------------------------------------------------------------------------------------
    std::vector<std::string> list() {
        std::vector<std::string> result;
        if (!accept("(")) return result;
        do result.push_back(identifier());
        while (accept(","));
        expect(")");
        return result;
    }

    void variable(NusmvModel::Module& module, bool chosen) {
        const std::string name = identifier();
        expect(":");
        if (accept("boolean")) {
            module.variables.push_back({name, {}, {}, chosen});
        } else if (accept("{")) {
            std::vector<std::string> values;
            do values.push_back(identifier());
            while (accept(","));
            expect("}");
            const auto last = static_cast<std::int64_t>(values.size()) - 1;
            module.variables.push_back({name, integer_type(0, last), std::move(values), chosen});
        } else if (!peek().empty() && !starts_name(peek().front())) {
            const std::int64_t low = number();
            expect("..");
            module.variables.push_back({name, integer_type(low, number()), {}, chosen});
        } else {
            const std::string of = identifier();
            module.instances.push_back({name, of, list()});
        }
        expect(";");
    }

    void assignment(NusmvModel::Module& module) {
        const bool initial = peek() == "init";
        if (!accept("init")) expect("next");
        expect("(");
        const std::string name = identifier();
        expect(")");
        expect(":=");
        const bool added = (initial ? module.initial : module.next).emplace(name, value()).second;
        if (!added) expect("one assignment only of " + name);
        expect(";");
    }

    void definition(NusmvModel::Module& module) {
        const std::string name = identifier();
        expect(":=");
        if (!module.defines.emplace(name, value()).second) expect("one definition only of " + name);
        expect(";");
    }

    void specification(NusmvModel::Module& module, std::string_view keyword) {
        expect("NAME");
        NusmvModel::Specification made{std::string(keyword), identifier(), {}};
        expect(":=");
        while (peek() != ";" && at < token.size())
            made.formula += (made.formula.empty() ? "" : " ") + std::string(take());
        expect(";");
        module.specifications.push_back(std::move(made));
    }

    void section(NusmvModel::Module& module) {
        const std::string_view keyword = take();
        const auto each = [&](auto read) {
            while (!at_section()) read();
        };
        if (keyword == "VAR" || keyword == "IVAR") each([&] { variable(module, keyword == "IVAR"); });
        else if (keyword == "ASSIGN") each([&] { assignment(module); });
        else if (keyword == "DEFINE") each([&] { definition(module); });
        else if (keyword == "INVAR" || keyword == "TRANS" || keyword == "JUSTICE") {
            (keyword == "INVAR"   ? module.invariants
             : keyword == "TRANS" ? module.transitions
                                  : module.justice)
                .push_back(expression());
            expect(";");
        } else if (keyword == "SPEC" || keyword == "LTLSPEC" || keyword == "INVARSPEC") specification(module, keyword);
        else expect("a section");
    }

    void read() {
        while (at < token.size()) {
            expect("MODULE");
            NusmvModel::Module module;
            module.name = identifier();
            module.parameters = list();
            while (at < token.size() && peek() != "MODULE") section(module);
            model.modules.push_back(std::move(module));
        }
    }
};

}  // namespace

Id<Expr> NusmvModel::leaf(std::string_view identifier) {
    const auto found = std::ranges::find(identifiers, identifier);
    const auto index = static_cast<std::uint32_t>(found - identifiers.begin());
    if (found == identifiers.end()) identifiers.emplace_back(identifier);
    return exprs.leaf(Op::Variable, index);
}

NusmvModel read_nusmv(std::string_view text) {
    NusmvReader reader{{}, tokens(text)};
    reader.read();
    return std::move(reader.model);
}

}  // namespace grafverif
