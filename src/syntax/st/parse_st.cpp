// SPDX-License-Identifier: MIT
#include "syntax/st/parse_st.hpp"

#include "support/memory_reserve.hpp"
#include "syntax/st/st_builder.hpp"
#include "syntax/st/st_lexer.hpp"

namespace grafverif::st {

namespace {

/// Parses `text` from the start symbol `goal`, and adds the result to `file`. Returns true if `text` has no error.
bool parsed(Builder& build, const Text& text, Parser::token_kind_type goal, File& file, const Sources& sources,
            Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.errors();
    Lexer lexer(text, goal, file, sources, diagnostics);
    Parser parser = made_with_reserve([&] { return Parser(lexer, build); });
    const bool complete = parser.parse() == 0;
    return complete && diagnostics.errors() == errors;
}

}  // namespace

std::optional<Id<Expr>> parse_expression(const Text& text, File& file, const Sources& sources,
                                         Diagnostics& diagnostics) {
    Builder build(file, diagnostics);
    if (!parsed(build, text, Parser::token::EXPRESSION_FOLLOWS, file, sources, diagnostics)) return {};
    return build.read_expression();
}

std::optional<Block> parse_statements(const Text& text, File& file, const Sources& sources, Diagnostics& diagnostics) {
    Builder build(file, diagnostics);
    if (!parsed(build, text, Parser::token::STATEMENTS_FOLLOW, file, sources, diagnostics)) return {};
    return build.read_statements();
}

bool parse_units(const Text& text, File& file, const Sources& sources, Diagnostics& diagnostics) {
    Builder build(file, diagnostics);
    return parsed(build, text, Parser::token::UNITS_FOLLOW, file, sources, diagnostics);
}

bool parse_programs(const Text& text, File& file, const Sources& sources, Diagnostics& diagnostics) {
    Builder build(file, diagnostics);
    return parsed(build, text, Parser::token::PROGRAMS_FOLLOW, file, sources, diagnostics);
}

std::optional<Id<Expr>> parse_property(const Text& text, File& file, const Sources& sources, Diagnostics& diagnostics) {
    Builder build(file, diagnostics);
    if (!parsed(build, text, Parser::token::PROPERTY_FOLLOWS, file, sources, diagnostics)) return {};
    return build.read_expression();
}

}  // namespace grafverif::st
