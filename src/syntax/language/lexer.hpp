// SPDX-License-Identifier: MIT
// Lexer: the words of a text for the parser, with their places, and the way back after an error.
//
// Comments and blank lines are put aside in the file. After an error the lexer skips to where the next declaration
// begins and says RESUME there: past a `;`, before the `}` that ends the block at hand, or at a word that begins a
// declaration and a line. A declaration of a file (`grafcet`, ...) at the start of a line ends every open block, a
// declaration of a chart ends the actions of a step: a missing `}` costs one error. A text that ends in a
// block says CUT_OFF first, for a parser of Bison gives up where it cannot throw away what it stumbled over.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <string_view>
#include <vector>

#include "grafcet_parser.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "support/overloaded.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif::tree {

/// From the beginning of `first` to the end of `last`.
inline Span spanning(Span first, Span last) { return {first.source, first.begin, last.end}; }

/// What the generated scanner keeps.
class Scanner {
public:
    explicit Scanner(std::string_view text);
    ~Scanner();
    Scanner(const Scanner&) = delete;
    Scanner& operator=(const Scanner&) = delete;

    Parser::symbol_type next(Lexer& lexer);

private:
    void* state_ = nullptr;
};

class Lexer {
public:
    using Token = Parser::symbol_type;
    using Kind = Parser::symbol_kind_type;

    /// Reads `part` of `source`.
    Lexer(const Source& source, Span part, tree::File& file, Diagnostics& diagnostics);

    /// Where each word of the file is first written.
    std::span<const Span> first_places() const { return first_places_; }
    /// The next token for the parser.
    Token next();
    /// Reports the token last handed out, and goes on with the next declaration.
    void report_unexpected(Kind seen, Span where, std::span<const Kind> expected);

    // What the rules of the scanner call.
    void advance(std::string_view match);
    void lines();
    void comment();
    Token word(Parser::token_kind_type kind);
    Token wide_name();
    Token sign(Parser::token_kind_type kind);
    Token string();
    Token duration();
    Token decimal_without_unit();
    Token other_spelling(Parser::token_kind_type kind, std::string_view meant);
    Token unterminated_comment();
    Token unterminated_string();
    Token unexpected_character();

private:
    enum class BlockKind { Body, Actions, Set };
    struct Block {
        BlockKind kind = BlockKind::Body;
        Span heading = {};  ///< `grafcet press`: the word and the name that the block belongs to
    };

    Token broken(Diagnostic diagnostic);
    void report(Diagnostic diagnostic);
    void begin_thing();
    void consumed();
    bool nests_too_deep(Kind next) const;
    void resynchronise();
    void close_blocks(std::size_t count);
    bool begins_line(Span where) const;
    std::size_t indentation(std::uint32_t place) const;
    bool report_missing_brace(Kind seen, Span where, std::span<const Kind> expected);
    bool report_other_notation(Kind seen, Span where, std::span<const Kind> expected);
    Span operator_of_ctl() const;
    std::string_view seen_text(Span where) const;

    const Source* source_;
    Scanner scanner_;
    tree::File* file_;
    tree::Words words_;
    std::vector<Span> first_places_ = {};
    Diagnostics* diagnostics_;

    std::string_view match_ = {};  ///< what the scanner has just found
    Span here_ = {};               ///< where
    std::uint32_t line_ends_ = 0;  ///< since the last token or comment
    bool anything_ = false;        ///< some token or comment has been seen

    std::deque<Token> pending_ = {};  ///< to be handed out before anything new
    bool recovering_ = false;
    bool cut_off_ = false;                        ///< the text has ended within a block, and the parser has been told
    Span reported_ = {};                          ///< the token last reported: not a second time
    std::uint32_t handed_back_ = 0;               ///< end of the last token handed out a second time: there is no third
    Kind last_ = Parser::symbol_kind::S_YYEMPTY;  ///< the token last handed out
    Span last_where_ = {};
    tree::Name last_name_ = {};
    Kind before_ = Parser::symbol_kind::S_YYEMPTY;  ///< the one before it, consumed
    Span before_where_ = {};
    Kind earlier_ = Parser::symbol_kind::S_YYEMPTY;    ///< the one before that
    Kind declaring_ = Parser::symbol_kind::S_YYEMPTY;  ///< the last word that begins a block
    Span heading_ = {};                                ///< that word and the name after it
    std::vector<Block> blocks_ = {};                   ///< open ones
    Span less_indented_ = {};  ///< heading of the first block whose `}` is indented less than its heading
    std::size_t brackets_ = 0, prefixes_ = 0;
};

}  // namespace grafverif::tree
