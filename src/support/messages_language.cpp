// SPDX-License-Identifier: MIT
// Texts of parser diagnostics (in the section `reading` of messages.hpp).
#include <fmt/format.h>

#include "support/messages.hpp"
#include "support/messages_notation.hpp"
#include "support/messages_system.hpp"
#include "support/wording.hpp"

namespace grafverif::messages {

Diagnostic file_too_large(Span where, std::size_t mebibytes) {
    return error("too-large", where, fmt::format("the file is larger than {} MiB; split it with `include`", mebibytes));
}

Diagnostic invalid_utf8(Span where, unsigned char byte) {
    return error("invalid-utf8", where, fmt::format("byte 0x{:02X} is not UTF-8; save the file as UTF-8", byte));
}

Diagnostic read_as_latin(Span where) {
    return warning("read-as-latin", where,
                   "the text is not UTF-8 and is read as Latin-1 (Windows-1252); save the file as UTF-8");
}

Diagnostic utf16(Span where) { return error("invalid-utf8", where, "the text is UTF-16; save the file as UTF-8"); }

Diagnostic incomplete_utf16(Span where) {
    return error("invalid-utf8", where, "the text is UTF-16 and ends within a character; save the file as UTF-8");
}

Diagnostic unexpected_character(Span where, std::string_view character) {
    const auto byte = static_cast<unsigned char>(character.front());
    const bool printable = byte > 0x20 && byte != 0x7F;
    const std::string shown = printable ? fmt::format("`{}`", character) : fmt::format("byte 0x{:02X}", byte);
    return error("unexpected-character", where,
                 fmt::format("{} is not allowed here; use letters, digits and `_` in names", shown));
}

Diagnostic unterminated(Span where, std::string_view what, std::string_view end) {
    return error(fmt::format("unterminated-{}", what), where,
                 fmt::format("this {} is not closed; close it with `{}`", what, end));
}

Diagnostic unknown_unit(Span where, std::string_view text) {
    return error("unknown-unit", where,
                 fmt::format("`{}` is neither a duration nor a name; end durations in `ms`, `s` or `min`, and do not "
                             "start names with a digit",
                             clipped(text)));
}

Diagnostic bad_duration(Span where, std::string_view text) {
    return error(
        "bad-duration", where,
        fmt::format("`{}` is not a whole number of milliseconds or is too large; change the duration", clipped(text)));
}

Diagnostic decimal_number(Span where, std::string_view text) {
    return error("decimal-number", where,
                 fmt::format("`{}` is not an integer; use decimals only in durations, as in `1.5s`", clipped(text)));
}

Diagnostic number_too_large(Span where) {
    return error("number-too-large", where, "the number exceeds 64 bits; write a smaller number");
}

Diagnostic name_too_long(Span where, std::string_view name, std::size_t limit) {
    return error(
        "name-too-long", where,
        fmt::format("the name `{}` has {} bytes; shorten it to at most {}", clipped(name), name.size(), limit));
}

Diagnostic too_deep(Span where, std::size_t limit) {
    return error("too-deep", where,
                 fmt::format("the expression is nested deeper than {} levels; use internal variables", limit));
}

Diagnostic too_many_indices(Span where, std::size_t limit) {
    return error("too-deep", where, fmt::format("the name has more than {} indices; remove some of them", limit));
}

Diagnostic blocks_too_deep(Span where, std::size_t limit) {
    return error("too-deep", where,
                 fmt::format("the blocks are nested deeper than {} levels; reduce the nesting", limit));
}

Diagnostic empty_replication(Span where, std::string_view index, std::int64_t low, std::int64_t high) {
    return error(
        "bad-range", where,
        fmt::format("the range {}..{} of `{}` is empty; write the lower bound first", low, high, clipped(index)));
}

Diagnostic expansion_too_large(Span where, std::size_t limit) {
    return error("too-large", where,
                 fmt::format("the copies of replications and instances contain more than {} declarations and terms; "
                             "reduce the ranges of the index variables",
                             limit));
}

Diagnostic in_copy(Span where, std::string_view values) {
    return note(where, fmt::format("in the copy with `{}`", values));
}

Diagnostic in_instance(Span where, std::string_view instance, std::string_view values) {
    const std::string copy = values.empty() ? "" : fmt::format(", in the copy with `{}`", values);
    return note(where, fmt::format("in the instance `{}`{}", clipped(instance), copy));
}

Diagnostic other_spelling(Span where, std::string_view seen, std::string_view meant) {
    return with_fix(
        error("other-spelling", where, fmt::format("`{}` is not an operator here; write `{}`", seen, meant)), where,
        meant);
}

Diagnostic single_equals(Span where, std::string_view what, std::string_view meant) {
    return with_fix(error("single-equals", where, fmt::format("`=` is not {}; write `{}`", what, meant)), where, meant);
}

Diagnostic missing_semicolon(Span where) {
    return with_fix(error("missing-semicolon", where, "the declaration is not terminated; append `;`"), where, ";");
}

Diagnostic unexpected(Span where, std::string_view seen, std::string_view expected) {
    return error("unexpected", where, fmt::format("unexpected `{}`; expected {}", clipped(seen), expected));
}

Diagnostic unexpected_end(Span where, std::string_view expected) {
    return error("unexpected-end", where, fmt::format("unexpected end of input; expected {}", expected));
}

Diagnostic missing_brace(Span heading, std::string_view text, Span next, Span place) {
    Diagnostic diagnostic =
        error("missing-brace", heading, fmt::format("the block of `{}` is not closed; append `}}`", clipped(text)));
    if (next.source.valid()) diagnostic.notes.push_back(note(next, "this is not allowed within the block"));
    return place.source.valid() ? with_fix(std::move(diagnostic), place, "\n}") : diagnostic;
}

Diagnostic expected_before_sentence(Span where) {
    return error(
        "misplaced-expectation", where,
        "`expected violated` must follow the quoted sentence of the property; write `property NAME \"...\" expected "
        "violated: PATTERN;`");
}

Diagnostic expected_after_colon(Span where) {
    return error("misplaced-expectation", where,
                 "`expected violated` must precede the colon; write `property NAME expected violated: PATTERN;`");
}

Diagnostic other_pattern(Span where, std::string_view seen, std::string_view meant) {
    return with_fix(
        error("other-spelling", where, fmt::format("`{}` is not a pattern of properties; write `{}`", seen, meant)),
        where, meant);
}

Diagnostic other_keyword(Span where, std::string_view seen, std::string_view meant) {
    return with_fix(
        error("unexpected", where, fmt::format("unexpected `{}`; did you mean `{}`?", clipped(seen), meant)), where,
        meant);
}

Diagnostic step_member(Span where, std::string_view step_variable, std::string_view member) {
    const bool time = member == "T" || member == "t";
    return error("other-spelling", where,
                 fmt::format("`.{0}` of a step is IEC 61131-3 notation; write {1}{2}`", member,
                             time ? "a time condition such as `2s/" : "`", clipped(step_variable)));
}

// -- text whose display is misleading --------------------------------------------------------------------------------

namespace {

std::string further(std::size_t more) { return more == 0 ? "" : fmt::format(" (and {} more)", more); }

}  // namespace

Diagnostic line_separator(Span where, std::uint32_t code, std::size_t more) {
    return warning("line-separator", where,
                   fmt::format("U+{:04X}{} ends a line in editors, but does not end a comment or count as a line; "
                               "replace it with a line feed",
                               code, further(more)));
}

Diagnostic bidi_control(Span where, std::uint32_t code, std::size_t more) {
    return warning(
        "bidi-control", where,
        fmt::format("U+{:04X}{} changes the displayed order of the text, which can hide parts of it; remove it", code,
                    further(more)));
}

Diagnostic control_character(Span where, std::uint32_t code, std::size_t more) {
    return warning(
        "control-character", where,
        fmt::format("the control character U+{:04X}{} can hide text when displayed; remove it", code, further(more)));
}

Diagnostic fullwidth_character(Span where, std::string_view name, std::string_view ascii) {
    return warning("fullwidth-character", where,
                   fmt::format("`{}` has fullwidth letters or digits and is not `{}`; write them in ASCII",
                               clipped(name), clipped(ascii)));
}

Diagnostic confusable_names(Span where, std::string_view name, std::string_view characters, std::string_view what,
                            std::string_view other, Span first) {
    Diagnostic diagnostic = warning("confusable-names", where,
                                    fmt::format("`{}` ({}) looks like the {} `{}` but differs from it; rename it",
                                                clipped(name), characters, what, clipped(other)));
    if (first.source.valid()) diagnostic.notes.push_back(note(first, fmt::format("the {} is here", what)));
    return diagnostic;
}

}  // namespace grafverif::messages
