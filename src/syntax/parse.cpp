// SPDX-License-Identifier: MIT
#include "grafverif/syntax/parse.hpp"

#include <cstddef>
#include <string_view>

#include "grafverif/support/messages.hpp"
#include "syntax/builder.hpp"
#include "syntax/lexer.hpp"
#include "syntax/readable.hpp"

namespace grafverif {

namespace {

/// Parses `part` into `file`; whether no error was found.
bool parsed(tree::Builder& build, Span part, tree::Parser::token_kind_type goal, tree::File& file,
            const Sources& sources, Diagnostics& diagnostics) {
    if (!is_readable(part, sources, diagnostics)) {
        file.lost = true;
        return false;
    }
    const std::size_t errors = diagnostics.errors();
    tree::Lexer lexer(sources[part.source], part, goal, file, diagnostics);
    tree::Parser parser(lexer, build);
    if (parser.parse() != 0) file.lost = true;
    return diagnostics.errors() == errors;
}

}  // namespace

tree::File parse_file(Id<Source> source, const Sources& sources, Diagnostics& diagnostics) {
    tree::File file;
    file.source = source;
    const std::size_t size = std::min(sources[source].text.size(), largest_text + 1);
    const Span whole = without_mark({source, 0, static_cast<std::uint32_t>(size)}, sources);
    tree::Builder build(file, diagnostics);
    if (!parsed(build, whole, tree::Parser::token::FILE_FOLLOWS, file, sources, diagnostics)) file.broken = true;
    return file;
}

std::optional<LoneCondition> parse_condition(Span where, const Sources& sources, Diagnostics& diagnostics) {
    LoneCondition lone;
    lone.file.source = where.source;
    tree::Builder build(lone.file, diagnostics);
    if (!parsed(build, where, tree::Parser::token::CONDITION_FOLLOWS, lone.file, sources, diagnostics)) return {};
    lone.condition = build.read_condition();
    return lone;
}

std::optional<LoneProperty> parse_property(Span where, const Sources& sources, Diagnostics& diagnostics) {
    LoneProperty lone;
    lone.file.source = where.source;
    tree::Builder build(lone.file, diagnostics);
    if (!parsed(build, where, tree::Parser::token::PROPERTY_FOLLOWS, lone.file, sources, diagnostics)) return {};
    lone.property = build.read_property();
    return lone;
}

}  // namespace grafverif
