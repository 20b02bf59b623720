// SPDX-License-Identifier: MIT
// Error recovery of the lexer: reports a token that the parser cannot accept and determines the position at which to
// resume (see lexer.hpp).
#include <algorithm>
#include <ranges>
#include <string>

#include "support/messages.hpp"
#include "support/messages_notation.hpp"
#include "syntax/language/builder.hpp"
#include "syntax/language/expectation.hpp"
#include "syntax/language/lexer.hpp"

namespace grafverif::tree {

namespace {

using Symbols = Parser::symbol_kind;

/// True for keywords that begin a top-level declaration.
bool declares_in_file(Symbol kind) {
    switch (kind) {
    case Symbols::S_GRAFCET:
    case Symbols::S_COMPONENT:
    case Symbols::S_CLOSED_LOOP:
    case Symbols::S_INCLUDE:
    case Symbols::S_PROGRAM: return true;
    default: return false;
    }
}

/// True for reserved words that begin a declaration of a chart. An action of a step cannot begin with one of these
/// words.
bool declares_in_chart(Symbol kind) {
    switch (kind) {
    case Symbols::S_INPUT:
    case Symbols::S_OUTPUT:
    case Symbols::S_INTERNAL:
    case Symbols::S_STEP:
    case Symbols::S_TRANSITION: return true;
    default: return false;
    }
}

/// True for keywords that begin a declaration in a block.
bool declares_in_block(Symbol kind) {
    switch (kind) {
    case Symbols::S_CONSTRAINT:
    case Symbols::S_CONSTANT:
    case Symbols::S_INITIAL_WORD:
    case Symbols::S_LINKED:
    case Symbols::S_ENTRY:
    case Symbols::S_EXIT:
    case Symbols::S_MACRO:
    case Symbols::S_ENCLOSING:
    case Symbols::S_PARTIAL:
    case Symbols::S_EXPANSION:
    case Symbols::S_VARIABLE:
    case Symbols::S_CLOCK:
    case Symbols::S_LOCATION:
    case Symbols::S_URGENT:
    case Symbols::S_TIMED:
    case Symbols::S_CONTROLLER:
    case Symbols::S_GRAIN:
    case Symbols::S_TIME:
    case Symbols::S_PLANT:
    case Symbols::S_ENVIRONMENT:
    case Symbols::S_PROPERTY:
    case Symbols::S_FAULT:
    case Symbols::S_OBSERVER:
    case Symbols::S_SCHEDULE:
    case Symbols::S_FOR:
    case Symbols::S_ACCEPT: return true;
    default: return declares_in_chart(kind);
    }
}

}  // namespace

std::string_view Lexer::seen_text(Span where) const {
    return std::string_view(source_->text).substr(where.begin, where.end - where.begin);
}

bool Lexer::begins_line(Span where) const {
    const std::string_view before = std::string_view(source_->text).substr(0, where.begin);
    for (const char byte : before | std::views::reverse) {
        if (byte == '\n') return true;
        if (byte != ' ' && byte != '\t' && byte != '\r') return false;
    }
    return true;
}

/// Returns the width of the white space at the beginning of the line that contains `place`.
std::size_t Lexer::indentation(std::uint32_t place) const {
    const std::string_view before = std::string_view(source_->text).substr(0, place);
    const std::string_view line = before.substr(before.rfind('\n') + 1);
    return std::min(line.find_first_not_of(" \t"), line.size());
}

/// Reports a missing `}` if a `}` is permitted at `where`. In addition, the text must end at
/// `where`, or a line must begin at `where` with a declaration that the current block does not
/// allow. Returns true if it has reported an error.
bool Lexer::report_missing_brace(Kind seen, Span where, std::span<const Kind> expected) {
    if (blocks_.empty() || !contains(expected, Symbols::S_CLOSE)) return false;
    const bool at_end = seen == Symbols::S_YYEOF, in_file = declares_in_file(seen);
    const bool in_chart = blocks_.back().kind == BlockKind::Actions && declares_in_chart(seen);
    if (!at_end && !((in_file || in_chart) && begins_line(where))) return false;
    const bool by_indentation = less_indented_.source.valid() && !in_chart;
    const Span heading = by_indentation ? less_indented_ : blocks_.back().heading;
    diagnostics_->add(messages::missing_brace(heading, seen_text(heading), at_end ? Span{} : where,
                                              by_indentation ? Span{} : after(before_where_)));
    return true;
}

/// Reports operators and keywords of other languages, and keywords of the .grafcet language at positions that do not
/// allow them. Returns true if it has reported an error.
bool Lexer::report_other_notation(Kind seen, Span where, std::span<const Kind> expected) {
    const std::string_view text = seen_text(where), before = seen_text(before_where_);
    const bool in_pattern = contains(expected, Symbols::S_PRECEDES);
    if (seen == Symbols::S_STRING && before_ == Symbols::S_VIOLATED && contains(expected, Symbols::S_COLON))
        return diagnostics_->add(messages::expected_before_sentence(spanning(before_where_, where))), true;
    const bool after_pattern =
        contains(expected, Symbols::S_AT) || (before_ == Symbols::S_STABLE && earlier_ == Symbols::S_AT);
    const bool after_colon = (seen == Symbols::S_VIOLATED && before_ == Symbols::S_EXPECTED) ||
                             (after_pattern && (seen == Symbols::S_EXPECTED || text == "expect"));
    if (after_colon) return diagnostics_->add(messages::expected_after_colon(where)), true;
    if (seen == Symbols::S_ARROW && before_ == Symbols::S_MINUS && before_where_.end == where.begin)
        return diagnostics_->add(messages::other_spelling(spanning(before_where_, where), "-->", "leads to")), true;
    if (seen == Symbols::S_ARROW && contains(expected, Symbols::S_IMPLIES) && contains(expected, Symbols::S_AT))
        return diagnostics_->add(messages::other_spelling(where, text, "=>")), true;
    if (in_pattern && before_ == Symbols::S_IDENTIFIER && earlier_ == Symbols::S_COLON) {
        const std::string meant = pattern_of(before);
        if (!meant.empty()) return diagnostics_->add(messages::other_pattern(before_where_, before, meant)), true;
    }
    const std::string keyword = declares_in_file(seen) || declares_in_block(seen) ? "" : keyword_of(text, expected);
    if (!keyword.empty()) return diagnostics_->add(messages::other_keyword(where, text, keyword)), true;
    return false;
}

void Lexer::report_unexpected(Kind seen, Span where, std::span<const Kind> expected) {
    recovering_ = true;
    if (seen == Symbols::S_CUT_OFF) seen = Symbols::S_YYEOF;
    const bool again = reported_.source.valid() && reported_.begin == where.begin && reported_.end == where.end;
    reported_ = where;
    if (again) return;
    const std::string_view text = seen_text(where);
    if (seen == Symbols::S_IS && contains(expected, Symbols::S_EQUAL))
        return diagnostics_->add(messages::single_equals(where, "a comparison operator", "=="));
    if (seen == Symbols::S_IS && contains(expected, Symbols::S_ASSIGN))
        return diagnostics_->add(messages::single_equals(where, "an assignment", ":="));
    if (seen == Symbols::S_IDENTIFIER && contains(expected, Symbols::S_AND)) {
        if (text == "AND" || text == "And") return diagnostics_->add(messages::other_spelling(where, text, "&&"));
        if (text == "OR" || text == "Or") return diagnostics_->add(messages::other_spelling(where, text, "||"));
    }
    if (report_missing_brace(seen, where, expected) || report_other_notation(seen, where, expected)) return;
    const bool too_late = seen == Symbols::S_YYEOF || seen == Symbols::S_CLOSE || begins_line(where);
    if (too_late && contains(expected, Symbols::S_SEMICOLON))
        return diagnostics_->add(messages::missing_semicolon(after(before_where_)));
    const std::string words = expectation(expected);
    if (seen == Symbols::S_YYEOF) return diagnostics_->add(messages::unexpected_end(after(before_where_), words));
    diagnostics_->add(messages::unexpected(where, text, words));
}

/// Inserts the missing `}` of the `count` innermost open blocks.
void Lexer::close_blocks(std::size_t count) {
    for (; count > 0; --count) pending_.emplace_back(Parser::token::CLOSE, here_);
}

/// Skips tokens, starting with the last returned token, until the parser can resume.
void Lexer::resynchronise() {
    if (diagnostics_->full()) {
        pending_.clear();
        pending_.emplace_back(Parser::token::END, here_);
        return;
    }
    std::size_t nested = 0;
    while (!blocks_.empty() && blocks_.back().kind == BlockKind::Set) {
        blocks_.pop_back();
        ++nested;
    }
    const auto resume = [&](std::size_t closing) {
        pending_.emplace_back(Parser::token::RESUME, here_);
        close_blocks(closing);
    };
    Kind kind = last_ == Symbols::S_CUT_OFF ? Symbols::S_YYEOF : last_;
    Token token;
    bool first = true;
    const auto step = [&] {
        Token scanned = scanner_.next(*this);
        token.clear();
        token.move(scanned);
        kind = token.kind();
        first = false;
    };
    // True if the parser has already failed to resume at this token.
    const bool stuck = last_where_.end == handed_back_ && kind != Symbols::S_YYEOF;
    const auto push_back_token = [&] {
        handed_back_ = first ? last_where_.end : token.location.end;
        if (!first) pending_.push_back(token);
        else if (declares_in_file(kind) || declares_in_block(kind))
            pending_.emplace_back(static_cast<Parser::token_kind_type>(kind), last_name_, last_where_);
        else pending_.emplace_back(static_cast<Parser::token_kind_type>(kind), last_where_);
    };

    if (stuck) step();
    for (;; step()) {
        const Span where = first ? last_where_ : token.location;
        if (kind == Symbols::S_YYEOF || (declares_in_file(kind) && begins_line(where))) {
            resume(blocks_.size());
            push_back_token();
            break;
        }
        if (blocks_.empty()) continue;
        if (kind == Symbols::S_OPEN) ++nested;
        if (nested == 0 && kind == Symbols::S_CLOSE) {
            resume(0);
            push_back_token();
            break;
        }
        if (nested > 0 && kind == Symbols::S_CLOSE && --nested == 0) {
            step();
            resume(0);
            if (kind != Symbols::S_SEMICOLON) push_back_token();
            break;
        }
        if (nested > 0) continue;
        if (kind == Symbols::S_SEMICOLON) {
            resume(0);
            break;
        }
        if (declares_in_block(kind) && begins_line(where)) {
            const bool in_actions = blocks_.back().kind == BlockKind::Actions;
            if (in_actions && !declares_in_chart(kind)) continue;
            resume(in_actions ? 1 : 0);
            push_back_token();
            break;
        }
    }
    recovering_ = false;
    brackets_ = prefixes_ = 0;
    last_ = Symbols::S_YYEMPTY;
    declaring_ = Symbols::S_YYEMPTY;
}

}  // namespace grafverif::tree
