// SPDX-License-Identifier: MIT
// Messages about notation: keywords of other languages, unclosed blocks, characters that are displayed differently from
// their meaning, and forcing orders of several partial charts. They are defined in messages_language.cpp and
// messages_chart.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "grafverif/support/diagnostic.hpp"

namespace grafverif::messages {

/// `heading`: `grafcet press`, the beginning of the block; `next`: what cannot be in it, or not valid at the end of the
/// text; `place`: where `}` can be inserted, or not valid.
Diagnostic missing_brace(Span heading, std::string_view text, Span next, Span place);
Diagnostic expected_before_sentence(Span where);
Diagnostic expected_after_colon(Span where);
Diagnostic other_pattern(Span where, std::string_view seen, std::string_view meant);
Diagnostic other_keyword(Span where, std::string_view seen, std::string_view meant);
/// `Fill.T`, `Fill.X` of IEC 61131-3.
Diagnostic step_member(Span where, std::string_view step_variable, std::string_view member);
// Text that editors and terminals display differently from its meaning; `more`: number of further occurrences in the
// file.
Diagnostic line_separator(Span where, std::uint32_t code, std::size_t more);
Diagnostic bidi_control(Span where, std::uint32_t code, std::size_t more);
Diagnostic control_character(Span where, std::uint32_t code, std::size_t more);
Diagnostic fullwidth_character(Span where, std::string_view name, std::string_view ascii);
/// `what`: `name`, `keyword` or `step variable`; `characters`: those of `name` that are not ASCII, as `U+0430`.
Diagnostic confusable_names(Span where, std::string_view name, std::string_view characters, std::string_view what,
                            std::string_view other, Span first);
/// Two partial charts that are active together force one chart to different situations.
Diagnostic forced_differently(Span where, std::string_view chart, Span first);

}  // namespace grafverif::messages
