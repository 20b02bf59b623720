// SPDX-License-Identifier: MIT
// Lexer: returns the tokens of a text with their positions to the parser, and finds the position at which the parser
// resumes after an error.
//
// The lexer stores comments and blank lines in tree::File, outside the tree. After an error, the lexer skips to the
// next declaration, where it returns the token RESUME. The lexer resumes after a `;`, before the `}` that ends the
// current block, or at a keyword that begins a declaration and is the first token of a line. A top-level declaration
// (`grafcet`, ...) at the start of a line ends every open block. A declaration of a chart ends the action list of a
// step. Therefore, a missing `}` causes only one error. If the text ends inside a block, the lexer returns the token
// CUT_OFF before the token END. Reason: a Bison parser aborts if it cannot discard the token that caused an error.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "grafcet_parser.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "support/overloaded.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif::tree {

/// Returns the span from the beginning of `first` to the end of `last`.
inline Span spanning(Span first, Span last) { return {first.source, first.begin, last.end}; }

/// State of the generated scanner.
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

    /// Creates a lexer that reads `part` of `source`.
    Lexer(const Source& source, Span part, tree::File& file, Diagnostics& diagnostics,
          const std::atomic<bool>* stop = nullptr);

    /// Returns the position of the first occurrence of each word of the file.
    std::span<const Span> first_places() const { return first_places_; }
    /// Returns the next token.
    Token next();
    /// Reports the last returned token as unexpected, and skips to the next declaration.
    void report_unexpected(Kind seen, Span where, std::span<const Kind> expected);

    // The rules of the scanner call the following functions.
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
    Token index();

private:
    enum class BlockKind { Body, Actions, Set };
    struct Block {
        BlockKind kind = BlockKind::Body;
        Span heading = {};  ///< keyword and name of the block: `grafcet press`
    };

    Token broken(Diagnostic diagnostic);
    void report(Diagnostic diagnostic);
    void begin_element();
    void consumed();
    bool nests_too_deep(Kind next) const;
    void resynchronise();
    void close_blocks(std::size_t count);
    bool begins_line(Span where) const;
    std::size_t indentation(std::uint32_t place) const;
    bool report_missing_brace(Kind seen, Span where, std::span<const Kind> expected);
    bool report_other_notation(Kind seen, Span where, std::span<const Kind> expected);
    Span operator_of_ctl() const;
    std::optional<Token> error_of_ctl();
    std::string_view seen_text(Span where) const;

    const Source* source_;
    Scanner scanner_;
    tree::File* file_;
    tree::Words words_;
    std::vector<Span> first_places_ = {};
    Diagnostics* diagnostics_;
    const std::atomic<bool>* stop_;

    std::string_view match_ = {};  ///< current match of the scanner
    Span here_ = {};               ///< position of `match_`
    std::uint32_t line_ends_ = 0;  ///< number of line ends since the last token or comment
    bool anything_ = false;        ///< true after the first token or comment

    std::deque<Token> pending_ = {};  ///< tokens to return before scanning continues
    bool recovering_ = false;
    bool cut_off_ = false;           ///< true if the text ended within a block, and CUT_OFF was returned
    Span reported_ = {};             ///< the last reported token, which is not reported again
    std::uint32_t handed_back_ = 0;  ///< end of the token that was returned again after the last error; if an
                                     ///< error occurs at the same token again, the token is skipped
    Kind last_ = Parser::symbol_kind::S_YYEMPTY;  ///< the last returned token
    Span last_where_ = {};
    tree::Name last_name_ = {};
    Kind before_ = Parser::symbol_kind::S_YYEMPTY;  ///< the last token that the parser accepted
    Span before_where_ = {};
    Kind earlier_ = Parser::symbol_kind::S_YYEMPTY;    ///< the accepted token before `before_`
    Kind declaring_ = Parser::symbol_kind::S_YYEMPTY;  ///< the last keyword that began a block
    Span heading_ = {};                                ///< span of `declaring_` and the next name
    std::vector<Block> blocks_ = {};                   ///< open blocks
    Span less_indented_ = {};  ///< heading of the first block whose `}` is indented less than its heading
    std::size_t brackets_ = 0, prefixes_ = 0;
};

}  // namespace grafverif::tree
