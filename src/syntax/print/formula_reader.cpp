// SPDX-License-Identifier: MIT
#include "syntax/print/formula_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/text/encoding.hpp"

namespace grafverif::formulas {

namespace {

constexpr std::size_t deepest = 200;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

}  // namespace

bool Reader::is_one_of(std::initializer_list<std::string_view> tokens) const {
    return std::ranges::any_of(tokens, [this](std::string_view token) { return is(token); });
}

void Reader::advance() {
    before_ = end_;
    begin_ = std::min(text_.find_first_not_of(" \t", end_), text_.size());
    end_ = begin_;
    kind_ = Kind::End;
    if (begin_ == text_.size() || fault_) return;
    const std::string_view rest = text_.substr(begin_);
    const auto ends = [&](const auto& belongs) {
        const auto end = std::find_if_not(rest.begin(), rest.end(), belongs);
        return begin_ + static_cast<std::size_t>(end - rest.begin());
    };
    for (const std::string_view comment : {"--", "//", "/*"})
        if (rest.starts_with(comment) && !rest.starts_with("-->"))
            return fail(begin_, begin_ + 2,
                        fmt::format("`{}` starts a comment, which is not allowed in a formula", comment));
    if (is_letter(rest[0])) {
        kind_ = Kind::Name;
        end_ =
            ends([this](char c) { return is_letter(c) || is_digit(c) || in_names_.find(c) != std::string_view::npos; });
        return;
    }
    if (is_digit(rest[0])) {
        kind_ = Kind::Number;
        end_ = ends(is_digit);
        if (end_ < text_.size() && is_letter(text_[end_])) fail(begin_, end_ + 1, "a number may contain only digits");
        else if (end_ - begin_ > 9) fail_here("a number may have at most nine digits");
        return;
    }
    const auto symbol = std::ranges::find_if(symbols_, [&](std::string_view one) { return rest.starts_with(one); });
    if (symbol == symbols_.end()) return refuse_character();
    kind_ = Kind::Symbol;
    end_ = begin_ + symbol->size();
}

void Reader::refuse_character() {
    const auto byte = static_cast<unsigned char>(text_[begin_]);
    if (byte == ';') return fail(begin_, begin_ + 1, "`;` would end the formula; write one formula per property");
    std::size_t end = begin_ + 1;
    while (byte >= 0x80 && end < text_.size() && continues_character(text_[end])) ++end;
    const bool printable = byte > 0x20 && byte != 0x7F;
    const std::string shown =
        printable ? fmt::format("`{}`", text_.substr(begin_, end - begin_)) : fmt::format("byte 0x{:02X}", byte);
    fail(begin_, end, fmt::format("{} is not allowed in a formula", shown));
}

bool Reader::accept(std::string_view token) {
    if (!is(token)) return false;
    advance();
    return true;
}

std::string_view Reader::accept_one(std::initializer_list<std::string_view> tokens) {
    for (const std::string_view token : tokens)
        if (accept(token)) return token;
    return {};
}

void Reader::expect(std::string_view token) {
    if (!accept(token)) expected(fmt::format("`{}`", token));
}

void Reader::expected(std::string_view what) { fail_here(fmt::format("expected {}, got {}", what, shown())); }

void Reader::fail(std::size_t begin, std::size_t end, std::string what) {
    if (!fault_) fault_ = {begin, end, std::move(what)};
    kind_ = Kind::End;
    begin_ = end_ = text_.size();
}

Reader::Nest::Nest(Reader& reader) : reader_(reader) {
    if (++reader_.depth_ > deepest) reader_.fail_here(fmt::format("nested deeper than {} levels", deepest));
}

}  // namespace grafverif::formulas
