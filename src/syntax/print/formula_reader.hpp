// SPDX-License-Identifier: MIT
// Base class of the readers of formulas: tokens and error handling. A reader stops at the first error.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "syntax/print/formula.hpp"

namespace grafverif::formulas {

class Reader {
public:
    std::optional<FormulaFault> fault() && { return std::move(fault_); }

protected:
    enum class Kind { End, Name, Number, Symbol };

    /// In `symbols`, longer symbols must precede their prefixes. `in_names` contains the characters that are allowed in
    /// names in addition to letters, digits and `_`.
    Reader(std::string_view text, std::span<const std::string_view> symbols, std::string_view in_names)
        : text_(text), symbols_(symbols), in_names_(in_names) {
        advance();
    }

    bool is(std::string_view token) const { return kind_ != Kind::End && here() == token; }
    bool is_one_of(std::initializer_list<std::string_view> tokens) const;
    std::string_view here() const { return text_.substr(begin_, end_ - begin_); }
    void advance();
    bool accept(std::string_view token);
    /// Accepts and returns the next token if it is one of `tokens`; otherwise the result is empty.
    std::string_view accept_one(std::initializer_list<std::string_view> tokens);
    void expect(std::string_view token);
    void expected(std::string_view what);
    /// Records an error if it is the first one, and skips the rest of the text.
    void fail(std::size_t begin, std::size_t end, std::string what);
    void fail_here(std::string what) { fail(begin_, end_, std::move(what)); }
    std::string shown() const { return kind_ == Kind::End ? "the end" : '`' + std::string(here()) + '`'; }

    /// Counts one level of nesting during its lifetime, and reports an error if the nesting is too deep.
    class Nest {
    public:
        explicit Nest(Reader& reader);
        ~Nest() { --reader_.depth_; }
        Nest(const Nest&) = delete;
        Nest& operator=(const Nest&) = delete;

    private:
        Reader& reader_;
    };

    std::string_view text_ = {};
    std::span<const std::string_view> symbols_ = {};
    std::string_view in_names_ = {};
    Kind kind_ = Kind::End;
    std::size_t begin_ = 0, end_ = 0;  ///< range of the current token
    std::size_t before_ = 0;           ///< end of the previous token
    std::size_t depth_ = 0;
    std::optional<FormulaFault> fault_ = {};

private:
    void refuse_character();
};

}  // namespace grafverif::formulas
