// SPDX-License-Identifier: MIT
#include "read/program/incomplete.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "syntax/st/parse_st.hpp"
#include "syntax/st/st_lexer.hpp"

namespace grafverif::program {

namespace {

using Symbol = st::Parser::symbol_kind;

constexpr std::string_view ends = "END_PROGRAM END_FUNCTION_BLOCK END_FUNCTION";

/// Returns the keyword that ends a unit whose first keyword is `keyword`, or an empty text if units cannot begin with
/// `keyword`.
std::string_view end_of_unit(st::Parser::symbol_kind_type keyword) {
    switch (keyword) {
    case Symbol::S_PROGRAM: return "END_PROGRAM";
    case Symbol::S_FUNCTION_BLOCK: return "END_FUNCTION_BLOCK";
    case Symbol::S_FUNCTION: return "END_FUNCTION";
    default: return {};
    }
}

/// The header of a unit in an incomplete text. `declarations` extends from the keyword of the unit to its last
/// declaration, and `whole` to the beginning of the next unit.
struct Header {
    st::Name name = {};
    Span declarations = {}, whole = {};
    std::string_view end = {};
};

/// Returns the headers of all units of the text.
std::vector<Header> headers_of(Span whole, st::File& file, const Sources& sources) {
    const st::Text text = {{whole, false}};
    Diagnostics ignored;
    st::Lexer lexer(text, st::Parser::token::PROGRAMS_FOLLOW, file, sources, ignored);
    std::vector<Header> headers;
    bool in_configuration = false;
    for (;;) {
        const st::Lexer::Token token = lexer.next();
        const auto kind = token.kind();
        if (kind == Symbol::S_YYEOF) break;
        if (kind == Symbol::S_CONFIGURATION) in_configuration = true;
        if (kind == Symbol::S_END_CONFIGURATION) in_configuration = false;
        if (in_configuration) continue;
        if (!headers.empty()) headers.back().whole.end = token.location.end;
        Header* const last = headers.empty() ? nullptr : &headers.back();
        if (const std::string_view end = end_of_unit(kind); !end.empty()) {
            if (last != nullptr) last->whole.end = token.location.begin;
            headers.push_back({{}, token.location, token.location, end});
        } else if (last != nullptr && kind == Symbol::S_IDENTIFIER && !last->name.valid()) {
            last->name = token.value.as<st::Name>();
            last->declarations.end = token.location.end;
        } else if (last != nullptr && kind == Symbol::S_END_VAR) {
            last->declarations.end = token.location.end;
        }
    }
    std::erase_if(headers, [](const Header& header) { return !header.name.valid(); });
    return headers;
}

}  // namespace

void add_incomplete_units(Span whole, st::File& file, Sources& sources) {
    const std::vector<Header> headers = headers_of(whole, file, sources);
    const Id<Source> keywords = sources.add({"<keywords>", std::string(ends)});
    for (const Header& header : headers) {
        const bool known =
            std::ranges::any_of(file.units, [&](const st::Unit& unit) { return unit.name.word == header.name.word; });
        if (known) continue;
        const auto begin = static_cast<std::uint32_t>(ends.find(header.end));
        const Span end = {keywords, begin, begin + static_cast<std::uint32_t>(header.end.size())};
        Diagnostics ignored;
        const std::size_t before = file.units.size();
        st::parse_programs({{header.declarations, false}, {end, false}}, file, sources, ignored);
        for (std::size_t k = before; k < file.units.size(); ++k) file.units[k].where = header.whole;
    }
}

}  // namespace grafverif::program
