// SPDX-License-Identifier: MIT
// st::Lexer: returns the tokens of a text, with their source positions, to the parser. The text consists of pieces. In
// a piece of XML, the lexer replaces character references (`&lt;`, `&#10;`) first; the positions are those in the
// original source.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/support/diagnostic.hpp"
#include "st_parser.hpp"
#include "support/overloaded.hpp"
#include "syntax/st/parse_st.hpp"

namespace grafverif::st {

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
    using Kind = Parser::token_kind_type;

    /// Creates a lexer whose first token is `goal`, which selects the start symbol of the parser.
    /// Unless `goal` selects units or programs, keywords of units and charts are treated as names.
    Lexer(const Text& text, Kind goal, File& file, const Sources& sources, Diagnostics& diagnostics);

    Token next();
    void report_unexpected(Span where, std::span<const Parser::symbol_kind_type> expected);

    // The rules of the scanner call the following functions.
    void advance(std::size_t length);
    void comment(std::string_view match);
    Token sign(Kind kind);
    /// Returns the token of a C operator, such as `&&`. C operators are allowed in properties; in programs, only `==`
    /// and `!=` are accepted, with a warning.
    Token c_sign(Kind kind, std::string_view match);
    /// Returns the token of a word that is not part of the standard, and adds a warning.
    Token extension(Kind kind, std::string_view match, std::string_view meaning);
    Token type_word(Kind kind, std::string_view match);
    Token configuration_word(Kind kind, std::string_view match);
    Token unit_word(Kind kind, std::string_view match);
    Token section(Section section);
    Token word(Kind kind, std::string_view match);
    Token integer(std::string_view digits, int base);
    Token typed_integer(std::string_view match);
    Token time(std::string_view match);
    Token unterminated(std::string_view what, std::string_view end);
    Token unexpected_character(std::string_view match);
    Token end_of_piece();

private:
    bool open_next_piece();
    bool nests_too_deep(Kind kind);
    Token failed();

    const Text* text_;
    std::size_t piece_ = 0;  ///< index of the next piece
    std::optional<Scanner> scanner_ = {};
    std::string decoded_ = {};
    std::vector<std::uint32_t> origins_ = {};  ///< source position of each byte of `decoded_`; empty if these
                                               ///< positions are consecutive
    std::uint32_t base_ = 0;                   ///< source position of the piece if `origins_` is empty
    std::uint32_t at_ = 0;                     ///< offset of the end of the last match in the piece
    bool units_ = false;
    Kind section_ = Parser::token::END;  ///< the open section, TYPE or CONFIGURATION; END if none
    bool started_ = false, ended_ = false;
    Kind goal_;
    File* file_;
    const Sources* sources_;
    Diagnostics* diagnostics_;
    Span here_ = {};
    std::size_t brackets_ = 0, prefixes_ = 0, blocks_ = 0;
    bool too_deep_ = false;
};

}  // namespace grafverif::st
