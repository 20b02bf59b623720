// SPDX-License-Identifier: MIT
// Source positions and nesting limits for the grammars of the input language and of Structured Text.
#pragma once

#include <cstddef>

#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// Maximum nesting of brackets and operators in one expression.
inline constexpr std::size_t deepest_expression = 1000;
/// Maximum nesting of blocks in braces.
inline constexpr std::size_t deepest_block = 100;
/// Maximum number of indices of a name.
inline constexpr std::size_t most_indices = 8;

/// Returns the empty span immediately after `span`.
inline Span after(Span span) { return {span.source, span.end, span.end}; }

/// Returns the span from the first to the last of `count` spans. Empty spans before the first nonempty span are
/// ignored.
template <class Place>
Span across(std::size_t count, const Place& place) {
    Span first = place(1);
    for (int i = 2; i <= static_cast<int>(count) && first.begin == first.end; ++i) first = place(i);
    return {first.source, first.begin, place(static_cast<int>(count)).end};
}

}  // namespace grafverif
