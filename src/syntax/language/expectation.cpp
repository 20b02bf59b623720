// SPDX-License-Identifier: MIT
#include "syntax/language/expectation.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "syntax/resolve/nearest_of.hpp"

namespace grafverif::tree {

namespace {

using Symbols = Parser::symbol_kind;

/// True for identifiers and contextual keywords. A contextual keyword is also allowed as a name.
bool is_word(Symbol symbol) {
    return (symbol >= Symbols::S_CONSTRAINT && symbol <= Symbols::S_FALL) || symbol == Symbols::S_IDENTIFIER;
}

bool begins_expression(Symbol symbol) {
    switch (symbol) {
    case Symbols::S_NOT_WORD:
    case Symbols::S_TRUE:
    case Symbols::S_FALSE:
    case Symbols::S_NUMBER:
    case Symbols::S_DURATION:
    case Symbols::S_NOT:
    case Symbols::S_MINUS:
    case Symbols::S_UP:
    case Symbols::S_DOWN:
    case Symbols::S_LEFT: return true;
    default: return is_word(symbol);
    }
}

bool is_operator(Symbol symbol) {
    switch (symbol) {
    case Symbols::S_AND_WORD:
    case Symbols::S_OR_WORD:
    case Symbols::S_IMPLIES_WORD:
    case Symbols::S_IN:
    case Symbols::S_DOT:
    case Symbols::S_MINUS: return true;
    default: return symbol >= Symbols::S_AND && symbol <= Symbols::S_MODULO && symbol != Symbols::S_NOT;
    }
}

std::string shown(Symbol symbol) {
    const std::string name = Parser::symbol_name(symbol);
    return name.find(' ') == std::string::npos ? '`' + name + '`' : name;
}

struct Group {
    std::string name = {};
    /// The two tokens that identify the group: the group is expected if and only if both tokens are expected.
    Symbol marks = Symbols::S_YYEMPTY, marks_too = Symbols::S_YYEMPTY;
};

/// The declarations of each type of block. Each type is identified by two tokens that are allowed only in this type of
/// block.
const std::array<Group, 4> declarations = {{
    {"a declaration of the chart", Symbols::S_STEP, Symbols::S_TRANSITION},
    {"a declaration of the component", Symbols::S_LOCATION, Symbols::S_URGENT},
    {"a declaration of the closed loop", Symbols::S_PLANT, Symbols::S_PROPERTY},
    {"`grafcet`, `component`, `closed_loop`, `program` or `include`", Symbols::S_GRAFCET, Symbols::S_INCLUDE},
}};

std::string listed(const std::vector<std::string>& items) {
    std::string text;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (i > 0) text += i + 1 == items.size() ? " or " : ", ";
        text += items[i];
    }
    return text;
}

}  // namespace

bool contains(std::span<const Symbol> symbols, Symbol symbol) {
    return std::ranges::find(symbols, symbol) != symbols.end();
}

std::string pattern_of(std::string_view word) {
    constexpr std::array<std::array<std::string_view, 2>, 15> notations = {{{"eventually", "inevitable"},
                                                                            {"finally", "inevitable"},
                                                                            {"F", "inevitable"},
                                                                            {"AF", "inevitable"},
                                                                            {"A<>", "inevitable"},
                                                                            {"<>", "inevitable"},
                                                                            {"globally", "always"},
                                                                            {"invariant", "always"},
                                                                            {"G", "always"},
                                                                            {"AG", "always"},
                                                                            {"A[]", "always"},
                                                                            {"[]", "always"},
                                                                            {"possibly", "reachable"},
                                                                            {"EF", "reachable"},
                                                                            {"E<>", "reachable"}}};
    const auto* const found = std::ranges::find(notations, word, [](const auto& each) { return each[0]; });
    if (found != notations.end()) return std::string((*found)[1]);
    return nearest_of(word, std::array<std::string_view, 4>{"always", "never", "reachable", "inevitable"});
}

std::string keyword_of(std::string_view word, std::span<const Symbol> expected) {
    constexpr std::array<std::array<std::string_view, 2>, 10> notations = {{{"if", "when"},
                                                                            {"then", "do"},
                                                                            {"chart", "grafcet"},
                                                                            {"sfc", "grafcet"},
                                                                            {"template", "component"},
                                                                            {"system", "closed_loop"},
                                                                            {"import", "include"},
                                                                            {"var", "variable"},
                                                                            {"place", "step"},
                                                                            {"assert", "property"}}};
    Nearest nearest(word);
    for (const Symbol symbol : expected) {
        if (symbol < Symbols::S_GRAFCET || symbol > Symbols::S_FALL) continue;
        const std::string keyword = Parser::symbol_name(symbol);
        if (std::ranges::find(notations, std::array<std::string_view, 2>{word, keyword}) != notations.end())
            return keyword;
        nearest.offer(keyword);
    }
    const std::string& best = nearest.best();
    constexpr std::size_t shortest = 4;  // a word with fewer letters resembles too many keywords
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    return word.size() >= shortest || std::ranges::equal(word, best, same) ? best : "";
}

std::string expectation(std::span<const Symbol> expected) {
    std::vector<std::string> items;
    const bool names = contains(expected, Symbols::S_IDENTIFIER);
    const bool expressions = contains(expected, Symbols::S_TRUE);
    const bool operators = contains(expected, Symbols::S_AND);
    const Group* group = nullptr;
    if (!names) {
        for (const Group& candidate : declarations)
            if (contains(expected, candidate.marks) && contains(expected, candidate.marks_too)) group = &candidate;
    }
    if (group != nullptr) items.push_back(group->name);
    if (expressions) items.emplace_back("an expression");
    else if (names) items.emplace_back("a name");
    if (operators) items.emplace_back("an operator");

    const bool patterns = contains(expected, Symbols::S_ALWAYS);
    for (const Symbol symbol : expected) {
        if (patterns && (symbol == Symbols::S_NO || symbol == Symbols::S_EXACTLY)) items.push_back(shown(symbol));
        if (symbol == Symbols::S_RESUME || (names && is_word(symbol))) continue;
        if (symbol == Symbols::S_INDEX && expected.size() > 1) continue;  // an index is possible after most names
        if (expressions && begins_expression(symbol)) continue;
        if (operators && is_operator(symbol)) continue;
        if (group != nullptr && (is_word(symbol) || symbol < Symbols::S_CONSTRAINT)) continue;
        items.push_back(shown(symbol));
    }
    return listed(items);
}

}  // namespace grafverif::tree
