// SPDX-License-Identifier: MIT
#include "syntax/st/st_lexer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "support/messages.hpp"
#include "support/messages_program.hpp"
#include "support/xml_text.hpp"
#include "syntax/st/st_builder.hpp"
#include "syntax/st/st_tree.hpp"

namespace grafverif::st {

namespace {

// The following functions compute the values of literals of IEC 61131-3.

constexpr std::int64_t longest = std::int64_t{1} << 40U;  ///< maximum duration in milliseconds

struct Unit {
    std::string_view name = {};
    std::int64_t microseconds = 0;
};
constexpr std::array<Unit, 6> units = {
    {{"MS", 1000}, {"US", 1}, {"D", 86'400'000'000}, {"H", 3'600'000'000}, {"M", 60'000'000}, {"S", 1'000'000}}};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string without_underscores(std::string_view digits) {
    std::string kept;
    for (const char c : digits)
        if (c != '_') kept += c;
    return kept;
}

/// Returns the value of an integer such as `1_000`, or nullopt if the integer is too large.
std::optional<std::int64_t> integer_of(std::string_view digits, int base) {
    const std::string kept = without_underscores(digits);
    std::int64_t value = 0;
    const auto [end, failure] = std::from_chars(kept.data(), kept.data() + kept.size(), value, base);
    if (failure != std::errc() || end != kept.data() + kept.size()) return {};
    return value;
}

/// Removes the first part of a duration, such as `30m`, from `rest`. Returns the value of this part in microseconds;
/// empty if the part is invalid.
std::optional<std::int64_t> part_of(std::string_view& rest) {
    std::size_t end = 0;
    while (end < rest.size() && is_digit(rest[end])) ++end;
    const auto whole = integer_of(rest.substr(0, end), 10);
    if (end == 0 || !whole) return {};
    std::string_view decimals;
    if (end < rest.size() && rest[end] == '.') {
        std::size_t stop = ++end;
        while (stop < rest.size() && is_digit(rest[stop])) ++stop;
        decimals = rest.substr(end, stop - end);
        end = stop;
    }
    rest.remove_prefix(end);
    for (const Unit& unit : units) {
        if (!rest.starts_with(unit.name)) continue;
        rest.remove_prefix(unit.name.size());
        if (*whole > longest) return {};
        std::int64_t scale = unit.microseconds;
        std::int64_t value = 0;
        if (__builtin_mul_overflow(*whole, scale, &value)) return {};
        for (const char digit : decimals) {
            if (digit != '0' && scale % 10 != 0) return {};
            scale /= 10;
            value += (digit - '0') * scale;
        }
        return value;
    }
    return {};
}

/// Returns the number of milliseconds of a duration such as `1h30m` or `2.5s`. The result is empty if the text is
/// invalid, or the duration is negative, too long or not a whole number of milliseconds.
std::optional<std::int64_t> milliseconds_of(std::string_view duration) {
    const std::string kept = capitals(without_underscores(duration));
    std::string_view rest = kept;
    if (rest.starts_with('-') || rest.empty()) return {};
    std::int64_t total = 0;
    while (!rest.empty()) {
        const auto part = part_of(rest);
        if (!part || *part > 1000 * longest) return {};
        total += *part;
        if (total > 1000 * longest) return {};
    }
    if (total % 1000 != 0) return {};
    return total / 1000;
}

using Token = Parser::symbol_type;
using Symbols = Parser::symbol_kind;

constexpr std::size_t longest_name = 1000;
constexpr std::size_t deepest_brackets = 1000;
constexpr std::size_t deepest_blocks = 100;

std::string shown(Parser::symbol_kind_type symbol) {
    const std::string name = Parser::symbol_name(symbol);
    return name.find(' ') == std::string::npos ? '`' + name + '`' : name;
}

bool is_operator(Parser::symbol_kind_type symbol) {
    return (symbol >= Symbols::S_LESS && symbol <= Symbols::S_CARET) || symbol == Symbols::S_AND ||
           symbol == Symbols::S_OR || symbol == Symbols::S_AND_THEN || symbol == Symbols::S_OR_ELSE ||
           symbol == Symbols::S_XOR || symbol == Symbols::S_MOD || symbol == Symbols::S_DOT ||
           symbol == Symbols::S_OPEN;
}

/// Describes the tokens that are allowed at a position. A group of tokens, such as the tokens that begin an expression,
/// is described by one name.
std::string expectation(std::span<const Parser::symbol_kind_type> expected) {
    const auto has = [&](Parser::symbol_kind_type symbol) {
        return std::ranges::find(expected, symbol) != expected.end();
    };
    if (has(Symbols::S_IF)) return "a statement";
    if (has(Symbols::S_INTEGER) && has(Symbols::S_IDENTIFIER)) return "an expression";
    std::vector<std::string> items;
    for (const auto symbol : expected)
        if (!is_operator(symbol) && symbol != Symbols::S_YYerror && symbol != Symbols::S_PRIORITY)
            items.push_back(shown(symbol));
    if (has(Symbols::S_AND)) items.emplace_back("an operator");
    if (items.empty() || items.size() > 6) return "another keyword or symbol";
    std::string text;
    for (std::size_t i = 0; i < items.size(); ++i)
        text += (i == 0 ? "" : i + 1 == items.size() ? " or " : ", ") + items[i];
    return text;
}

}  // namespace

Lexer::Lexer(const Text& text, Kind goal, File& file, const Sources& sources, Diagnostics& diagnostics)
    : text_(&text),
      units_(goal == Parser::token::UNITS_FOLLOW || goal == Parser::token::PROGRAMS_FOLLOW),
      goal_(goal),
      file_(&file),
      sources_(&sources),
      diagnostics_(&diagnostics) {
    if (!text.empty()) here_ = {text.front().where.source, text.front().where.begin, text.front().where.begin};
}

Token Lexer::next() {
    if (!started_) {
        started_ = true;
        open_next_piece();
        return {goal_, here_};
    }
    if (too_deep_ || ended_ || !scanner_) return {Parser::token::END, Span{here_.source, here_.end, here_.end}};
    auto passing = Symbols::S_YYEMPTY;  // end keyword of the skipped section TYPE or CONFIGURATION
    for (;;) {
        Token token = scanner_->next(*this);
        const auto kind = token.kind();
        if (kind == Symbols::S_YYEOF && !ended_) continue;
        if (goal_ == Parser::token::PROGRAMS_FOLLOW) {
            if (kind == Symbols::S_TYPE) section_ = Parser::token::TYPE;
            if (kind == Symbols::S_CONFIGURATION) section_ = Parser::token::CONFIGURATION;
            if (kind == Symbols::S_END_TYPE || kind == Symbols::S_END_CONFIGURATION) section_ = Parser::token::END;
            return token;
        }
        if (kind == Symbols::S_TYPE) passing = Symbols::S_END_TYPE;
        else if (kind == Symbols::S_CONFIGURATION) passing = Symbols::S_END_CONFIGURATION;
        else if (passing == Symbols::S_YYEMPTY || kind == Symbols::S_YYEOF) return token;
        else if (kind == passing) passing = Symbols::S_YYEMPTY;
    }
}

bool Lexer::open_next_piece() {
    if (piece_ == text_->size()) return false;
    const Piece& piece = (*text_)[piece_++];
    const std::string_view written = std::string_view((*sources_)[piece.where.source].text)
                                         .substr(piece.where.begin, piece.where.end - piece.where.begin);
    origins_.clear();
    base_ = piece.where.begin;
    at_ = 0;
    here_ = {piece.where.source, piece.where.begin, piece.where.begin};
    std::string_view text = written;
    if (piece.escaped && written.find('&') != std::string_view::npos) {
        decoded_ = unescape_xml(written, piece.where.begin, origins_);
        text = decoded_;
    }
    scanner_.emplace(text);
    return true;
}

Token Lexer::end_of_piece() {
    if (!open_next_piece()) ended_ = true;
    return {Parser::token::END, Span{here_.source, here_.end, here_.end}};
}

// -- functions for the rules of the scanner ---------------------------------------------------------------------------

void Lexer::advance(std::size_t length) {
    const auto place = [this](std::uint32_t at) { return origins_.empty() ? base_ + at : origins_[at]; };
    here_.begin = place(at_);
    at_ += static_cast<std::uint32_t>(length);
    here_.end = place(at_);
}

void Lexer::comment(std::string_view match) { file_->comments.push_back({std::string(match), here_}); }

/// Counts open brackets, prefix operators and nested statements. Reports an error and returns true if a number exceeds
/// its limit.
bool Lexer::nests_too_deep(Kind kind) {
    switch (kind) {
    case Parser::token::LEFT:
    case Parser::token::OPEN: ++brackets_; break;
    case Parser::token::RIGHT:
    case Parser::token::CLOSE: brackets_ -= brackets_ > 0 ? 1 : 0; break;
    case Parser::token::SEMICOLON: brackets_ = 0; break;
    case Parser::token::IF:
    case Parser::token::CASE:
    case Parser::token::FOR:
    case Parser::token::WHILE:
    case Parser::token::REPEAT: ++blocks_; break;
    case Parser::token::END_IF:
    case Parser::token::END_CASE:
    case Parser::token::END_FOR:
    case Parser::token::END_WHILE:
    case Parser::token::END_REPEAT: blocks_ -= blocks_ > 0 ? 1 : 0; break;
    default: break;
    }
    const bool prefix = kind == Parser::token::NOT || kind == Parser::token::MINUS || kind == Parser::token::PLUS;
    prefixes_ = prefix ? prefixes_ + 1 : 0;
    if (brackets_ + prefixes_ <= deepest_brackets && blocks_ <= deepest_blocks) return false;
    diagnostics_->add(messages::too_deep(here_, blocks_ > deepest_blocks ? deepest_blocks : deepest_brackets));
    return true;
}

/// Returns an error token. Called if the nesting exceeds its limit; the lexer then ignores the remaining text.
Token Lexer::failed() {
    too_deep_ = true;
    return Parser::make_YYerror(here_);
}

Token Lexer::sign(Kind kind) {
    if (nests_too_deep(kind)) return failed();
    return {kind, here_};
}

Token Lexer::c_sign(Kind kind, std::string_view match) {
    if (goal_ == Parser::token::PROPERTY_FOLLOWS) return sign(kind);
    const bool comparison = kind == Parser::token::EQUAL || kind == Parser::token::NOT_EQUAL;
    if (goal_ != Parser::token::PROGRAMS_FOLLOW || !comparison) return unexpected_character(match);
    diagnostics_->add(
        messages::not_standard(here_, "`" + std::string(match) + "`", kind == Parser::token::EQUAL ? "`=`" : "`<>`"));
    return sign(kind);
}

Token Lexer::extension(Kind kind, std::string_view match, std::string_view meaning) {
    diagnostics_->add(messages::not_standard(here_, "`" + std::string(match) + "`", meaning));
    return sign(kind);
}

Token Lexer::type_word(Kind kind, std::string_view match) {
    return section_ == Parser::token::TYPE ? Token(kind, here_) : word(Parser::token::IDENTIFIER, match);
}

Token Lexer::configuration_word(Kind kind, std::string_view match) {
    return section_ == Parser::token::CONFIGURATION ? Token(kind, here_) : word(Parser::token::IDENTIFIER, match);
}

Token Lexer::unit_word(Kind kind, std::string_view match) {
    if (!units_) return word(Parser::token::IDENTIFIER, match);
    brackets_ = 0;
    return {kind, here_};
}

Token Lexer::section(Section section) { return {Parser::token::VAR, section, here_}; }

Token Lexer::word(Kind kind, std::string_view match) {
    prefixes_ = 0;
    if (match.size() > longest_name) {
        diagnostics_->add(messages::name_too_long(here_, match, longest_name));
        match = match.substr(0, longest_name);
    }
    return {kind, Name{file_->intern(match), here_}, here_};
}

Token Lexer::integer(std::string_view digits, int base) {
    prefixes_ = 0;
    const auto value = integer_of(digits, base);
    if (!value) diagnostics_->add(messages::number_too_large(here_));
    return {Parser::token::INTEGER, value.value_or(0), here_};
}

/// Reads a literal that begins with a type name: an integer or a bit string, such as `INT#5` or
/// `BYTE#-1`, or a duration. Literals with other type names are not supported.
Token Lexer::typed_integer(std::string_view match) {
    const std::size_t hash = match.find('#');
    const std::string type = capitals(match.substr(0, hash));
    static const std::vector<std::string> integers = {"SINT",  "INT",   "DINT", "LINT", "USINT", "UINT",
                                                      "UDINT", "ULINT", "BYTE", "WORD", "DWORD", "LWORD"};
    if (type == "T" || type == "TIME" || type == "LTIME" || type == "LT") return time(match);
    if (std::ranges::find(integers, type) == integers.end()) return word(Parser::token::LITERAL, match);
    const bool negative = match[hash + 1] == '-';
    const bool sign = negative || match[hash + 1] == '+';
    const auto value = integer_of(match.substr(hash + (sign ? 2 : 1)), 10);
    if (!value) diagnostics_->add(messages::number_too_large(here_));
    return {Parser::token::INTEGER, negative ? -value.value_or(0) : value.value_or(0), here_};
}

Token Lexer::time(std::string_view match) {
    prefixes_ = 0;
    const auto milliseconds = milliseconds_of(match.substr(match.find('#') + 1));
    if (!milliseconds) diagnostics_->add(messages::bad_duration(here_, match));
    return {Parser::token::TIME, milliseconds.value_or(1000), here_};
}

Token Lexer::unterminated(std::string_view what, std::string_view end) {
    diagnostics_->add(messages::unterminated({here_.source, here_.begin, here_.begin + 2}, what, end));
    return failed();
}

Token Lexer::unexpected_character(std::string_view match) {
    diagnostics_->add(messages::unexpected_character(here_, match));
    return Parser::make_YYerror(here_);
}

void Lexer::report_unexpected(Span where, std::span<const Parser::symbol_kind_type> expected) {
    if (too_deep_) return;
    if (where.begin == where.end) {
        diagnostics_->add(messages::unexpected_end(where, expectation(expected)));
        return;
    }
    const std::string_view seen =
        std::string_view((*sources_)[where.source].text).substr(where.begin, where.end - where.begin);
    diagnostics_->add(messages::unexpected(where, seen, expectation(expected)));
}

}  // namespace grafverif::st
