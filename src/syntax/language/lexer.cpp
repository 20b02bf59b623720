// SPDX-License-Identifier: MIT
#include "syntax/language/lexer.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <string>

#include "support/messages.hpp"
#include "support/messages_notation.hpp"
#include "support/printable.hpp"
#include "support/text/identifier.hpp"
#include "syntax/language/builder.hpp"
#include "syntax/language/expectation.hpp"

namespace grafverif::tree {

namespace {

using Token = Parser::symbol_type;
using Symbols = Parser::symbol_kind;

constexpr std::size_t longest_name = 1000;

/// The parts of a duration such as `1.5s`: digits before the decimal point, decimals and unit. The
/// unit may be unknown to the language.
struct Measure {
    std::string_view digits = {}, decimals = {}, unit = {};
};

Measure measure(std::string_view text) {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const std::size_t whole = static_cast<std::size_t>(std::ranges::find_if_not(text, is_digit) - text.begin());
    Measure parts{text.substr(0, whole), {}, text.substr(whole)};
    if (!parts.unit.starts_with('.')) return parts;
    const std::string_view rest = parts.unit.substr(1);
    const std::size_t length = static_cast<std::size_t>(std::ranges::find_if_not(rest, is_digit) - rest.begin());
    parts.decimals = rest.substr(0, length);
    parts.unit = rest.substr(length);
    return parts;
}

std::optional<std::uint16_t> milliseconds_in(std::string_view unit) {
    if (unit == "ms") return 1;
    if (unit == "s") return 1000;
    if (unit == "min") return 60'000;
    return {};
}

/// True for keywords that begin the heading of a block.
bool begins_block(Parser::symbol_kind_type kind) {
    switch (kind) {
    case Symbols::S_GRAFCET:
    case Symbols::S_COMPONENT:
    case Symbols::S_CLOSED_LOOP:
    case Symbols::S_PARTIAL:
    case Symbols::S_EXPANSION:
    case Symbols::S_OBSERVER:
    case Symbols::S_FOR:
    case Symbols::S_STEP: return true;
    default: return false;
    }
}

/// Returns the number `digits`.`decimals` multiplied by `factor`. The result is empty if the product is not an integer
/// or exceeds the range of durations.
std::optional<std::int64_t> scaled(std::string_view digits, std::string_view decimals, std::int64_t factor) {
    constexpr std::int64_t bound = std::int64_t{1} << 40U;
    std::int64_t whole = 0;
    if (std::from_chars(digits.data(), digits.data() + digits.size(), whole).ec != std::errc() ||
        whole > bound / factor)
        return {};
    std::int64_t result = whole * factor;
    for (const char digit : decimals) {
        if (digit != '0' && factor % 10 != 0) return {};
        factor /= 10;
        result += (digit - '0') * factor;
    }
    return result;
}

}  // namespace

Lexer::Lexer(const Source& source, Span part, tree::File& file, Diagnostics& diagnostics, const std::atomic<bool>* stop)
    : source_(&source),
      scanner_(std::string_view(source.text).substr(part.begin, part.end - part.begin)),
      file_(&file),
      words_(file.words),
      diagnostics_(&diagnostics),
      stop_(stop),
      here_{part.source, part.begin, part.begin} {
    last_where_ = here_;
}

Token Lexer::next() {
    if (stop_ != nullptr && stop_->load(std::memory_order_relaxed)) {
        blocks_.clear();
        return {0, here_};
    }
    if (recovering_) resynchronise();
    else consumed();
    Token token;
    if (!pending_.empty()) {
        token.move(pending_.front());
        pending_.pop_front();
    } else {
        Token scanned = scanner_.next(*this);
        token.move(scanned);
    }
    if (token.kind() == Symbols::S_YYEOF && !blocks_.empty() && !cut_off_) {
        cut_off_ = true;
        token.clear();
        Token cut(Parser::token::CUT_OFF, Span{here_.source, here_.end, here_.end});
        token.move(cut);
    }
    if (nests_too_deep(token.kind())) {
        Token error = broken(messages::too_deep(token.location, deepest_expression));
        token.clear();
        token.move(error);
    }
    if (token.kind() == Symbols::S_OPEN && blocks_.size() >= deepest_block) {
        Token error = broken(messages::blocks_too_deep(token.location, deepest_block));
        token.clear();
        token.move(error);
    }
    last_ = token.kind();
    last_where_ = token.location;
    return token;
}

// -- functions for the rules of the scanner --------------------------------------------------------------------------

void Lexer::advance(std::string_view match) {
    match_ = match;
    here_.begin = here_.end;
    here_.end += static_cast<std::uint32_t>(match.size());
}

void Lexer::lines() { line_ends_ += static_cast<std::uint32_t>(match_.size()); }

/// Begins a token or comment. If a blank line precedes this token or comment, records the blank line.
void Lexer::begin_element() {
    if (line_ends_ > 1 && anything_) file_->gaps.push_back(here_.begin);
    line_ends_ = 0;
    anything_ = true;
}

void Lexer::comment() {
    const bool own_line = line_ends_ > 0 || !anything_;
    begin_element();
    std::string kept(match_);
    while (!kept.empty() && (kept.back() == '\r' || kept.back() == ' ' || kept.back() == '\t')) kept.pop_back();
    file_->comments.push_back({std::move(kept), here_, own_line});
}

Token Lexer::word(Parser::token_kind_type kind) {
    begin_element();
    std::string_view text = match_;
    if (text.size() > longest_name) {
        report(messages::name_too_long(here_, text, longest_name));
        text = text.substr(0, longest_name);
    }
    last_name_ = {words_.intern(text), here_};
    if (last_name_.word.index == first_places_.size()) first_places_.push_back(here_);
    return {kind, last_name_, here_};
}

/// Reads an identifier with non-ASCII characters, or reports the first character that identifiers cannot contain.
Token Lexer::wide_name() {
    const std::size_t length = identifier_length(match_);
    if (length < match_.size()) {
        begin_element();
        const std::string_view character = match_.substr(length, first_glyph(match_.substr(length)).bytes);
        const auto begin = here_.begin + static_cast<std::uint32_t>(length);
        const Span where{here_.source, begin, begin + static_cast<std::uint32_t>(character.size())};
        return broken(messages::unexpected_character(where, character));
    }
    const std::string name = composed(match_);
    match_ = name;
    Token token = word(Parser::token::IDENTIFIER);
    match_ = {};
    return token;
}

Token Lexer::sign(Parser::token_kind_type kind) {
    begin_element();
    if (kind == Parser::token::END) return {kind, Span{here_.source, here_.end, here_.end}};
    return {kind, here_};
}

Token Lexer::string() {
    begin_element();
    return {Parser::token::STRING, std::string(match_.substr(1, match_.size() - 2)), here_};
}

Token Lexer::duration() {
    begin_element();
    const Measure parts = measure(match_);
    const auto unit = milliseconds_in(parts.unit);
    if (!unit) return broken(messages::unknown_unit(here_, match_));
    const auto milliseconds = scaled(parts.digits, parts.decimals, *unit);
    if (!milliseconds) report(messages::bad_duration(here_, match_));
    Expr leaf;
    leaf.op = Op::Duration;
    leaf.value = milliseconds.value_or(1000);
    leaf.unit_ms = milliseconds ? *unit : std::uint16_t{0};
    leaf.where = here_;
    return {Parser::token::DURATION, leaf, here_};
}

Token Lexer::decimal_without_unit() {
    begin_element();
    return broken(messages::decimal_number(here_, match_));
}

/// Returns the span of an operator of CTL or UPPAAL, such as `A[]` or `<>`. Conditions: the current token is the
/// bracket in this operator, and the operator begins a pattern. The result is invalid in all other cases.
Span Lexer::operator_of_ctl() const {
    const std::string_view brackets = std::string_view(source_->text).substr(here_.begin, 2);
    if (brackets != "[]" && brackets != "<>") return {};
    const Span both{here_.source, here_.begin, here_.begin + 2};
    if (before_ == Symbols::S_COLON) return both;
    const std::string_view letter = seen_text(before_where_);
    const bool is_letter = before_ == Symbols::S_IDENTIFIER && (letter == "A" || letter == "E");
    return is_letter && earlier_ == Symbols::S_COLON ? spanning(before_where_, both) : Span{};
}

/// Reports an operator of CTL or UPPAAL that begins a pattern. The message names the corresponding keyword of the
/// .grafcet language.
std::optional<Token> Lexer::error_of_ctl() {
    const Span where = operator_of_ctl();
    if (!where.source.valid()) return {};
    const std::string pattern = pattern_of(seen_text(where));
    if (pattern.empty()) return {};
    return broken(messages::other_pattern(where, seen_text(where), pattern));
}

Token Lexer::other_spelling(Parser::token_kind_type kind, std::string_view meant) {
    begin_element();
    if (const auto error = error_of_ctl()) return *error;
    report(messages::other_spelling(here_, match_, meant));
    return {kind, here_};
}

Token Lexer::unterminated_comment() {
    begin_element();
    return broken(messages::unterminated({here_.source, here_.begin, here_.begin + 2}, "comment", "*/"));
}

Token Lexer::unterminated_string() {
    begin_element();
    return broken(messages::unterminated(here_, "string", "\""));
}

Token Lexer::unexpected_character() {
    begin_element();
    return broken(messages::unexpected_character(here_, match_));
}

/// Reads a `[`. The `[` begins an index unless it belongs to an operator of CTL or UPPAAL.
Token Lexer::index() {
    begin_element();
    if (const auto error = error_of_ctl()) return *error;
    return {Parser::token::INDEX, here_};
}

/// Reports a lexical error, and skips to the next declaration, where the parser resumes.
Token Lexer::broken(Diagnostic diagnostic) {
    const Span where = diagnostic.where;
    report(std::move(diagnostic));
    recovering_ = true;
    return Parser::make_YYerror(where);
}

/// Reports an error unless the lexer is skipping tokens after an earlier error, so that each fault causes only one
/// error.
void Lexer::report(Diagnostic diagnostic) {
    if (!recovering_) diagnostics_->add(std::move(diagnostic));
}

// -- returned tokens --------------------------------------------------------------------------------------------------

bool Lexer::nests_too_deep(Kind next) const {
    switch (next) {
    case Symbols::S_LEFT:
    case Symbols::S_INDEX:
    case Symbols::S_NOT:
    case Symbols::S_NOT_WORD:
    case Symbols::S_MINUS:
    case Symbols::S_UP:
    case Symbols::S_DOWN: return !recovering_ && brackets_ + prefixes_ >= deepest_expression;
    default: return false;
    }
}

/// Records that the parser has accepted the last returned token.
void Lexer::consumed() {
    switch (last_) {
    case Symbols::S_NOT:
    case Symbols::S_NOT_WORD:
    case Symbols::S_MINUS:
    case Symbols::S_UP:
    case Symbols::S_DOWN: ++prefixes_; break;
    case Symbols::S_LEFT:
    case Symbols::S_INDEX: ++brackets_; break;
    default:
        if ((last_ == Symbols::S_RIGHT || last_ == Symbols::S_INDEX_END) && brackets_ > 0) --brackets_;
        if (last_ == Symbols::S_SEMICOLON || last_ == Symbols::S_OPEN || last_ == Symbols::S_CLOSE) brackets_ = 0;
        prefixes_ = 0;
    }
    if (begins_block(before_) && heading_.end == before_where_.end) heading_ = spanning(heading_, last_where_);
    if (begins_block(last_)) heading_ = last_where_;
    switch (last_) {
    case Symbols::S_OPEN:
        if (before_ == Symbols::S_ASSIGN || before_ == Symbols::S_OF) blocks_.push_back({BlockKind::Set, last_where_});
        else blocks_.push_back({declaring_ == Symbols::S_STEP ? BlockKind::Actions : BlockKind::Body, heading_});
        break;
    case Symbols::S_CLOSE:
        if (!blocks_.empty() && !less_indented_.source.valid() && seen_text(last_where_) == "}" &&
            begins_line(last_where_) && indentation(last_where_.begin) < indentation(blocks_.back().heading.begin))
            less_indented_ = blocks_.back().heading;
        if (!blocks_.empty()) blocks_.pop_back();
        if (blocks_.empty()) less_indented_ = {};
        [[fallthrough]];
    case Symbols::S_SEMICOLON: declaring_ = Symbols::S_YYEMPTY; break;
    case Symbols::S_STEP:
    case Symbols::S_PARTIAL:
    case Symbols::S_EXPANSION:
    case Symbols::S_TRANSITION: declaring_ = last_; break;
    default: break;
    }
    earlier_ = before_;
    before_ = last_;
    before_where_ = last_where_;
}

}  // namespace grafverif::tree
