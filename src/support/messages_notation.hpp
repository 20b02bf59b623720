// SPDX-License-Identifier: MIT
// Messages about notation: keywords of other languages, unclosed blocks, characters whose display is misleading, and
// forcing orders of several partial charts. The messages are defined in messages_language.cpp and messages_chart.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "grafverif/support/diagnostic.hpp"

namespace grafverif::messages {

/// `heading` is the position of the beginning of the block, and `text` is its text, such as `grafcet press`. `next` is
/// the position of the token that is not allowed in the block, or invalid at the end of the text. `place` is the
/// position at which `}` can be inserted, or invalid if there is no such position.
Diagnostic missing_brace(Span heading, std::string_view text, Span next, Span place);
Diagnostic expected_before_sentence(Span where);
Diagnostic expected_after_colon(Span where);
Diagnostic other_pattern(Span where, std::string_view seen, std::string_view meant);
Diagnostic other_keyword(Span where, std::string_view seen, std::string_view meant);
/// A name in the notation of IEC 61131-3, such as `Fill.T` or `Fill.X`.
Diagnostic step_member(Span where, std::string_view step_variable, std::string_view member);
// Characters that make editors and terminals display misleading text. `more` is the number of further occurrences in
// the file.
Diagnostic line_separator(Span where, std::uint32_t code, std::size_t more);
Diagnostic bidi_control(Span where, std::uint32_t code, std::size_t more);
Diagnostic control_character(Span where, std::uint32_t code, std::size_t more);
Diagnostic fullwidth_character(Span where, std::string_view name, std::string_view ascii);
/// `what` is `name`, `keyword` or `step variable`. `characters` lists the characters of `name` that are not ASCII, such
/// as `U+0430`.
Diagnostic confusable_names(Span where, std::string_view name, std::string_view characters, std::string_view what,
                            std::string_view other, Span first);
/// Two partial charts that are active simultaneously force one partial chart to different situations.
Diagnostic forced_differently(Span where, std::string_view chart, Span first);

Diagnostic too_many_indices(Span where, std::size_t limit);
Diagnostic blocks_too_deep(Span where, std::size_t limit);

}  // namespace grafverif::messages
