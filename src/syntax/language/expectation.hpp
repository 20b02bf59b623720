// SPDX-License-Identifier: MIT
// Describes expected tokens in messages about syntax errors.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grafcet_parser.hpp"

namespace grafverif::tree {

using Symbol = Parser::symbol_kind_type;

/// Describes the tokens that are allowed at a position, grouped by type, such as "`;` or an operator".
std::string expectation(std::span<const Symbol> expected);

/// Returns the property pattern that corresponds to `word`, for example `always` for `AG`. `word` is an operator of
/// CTL, LTL or UPPAAL, or a misspelt pattern. The result is empty if no pattern corresponds to `word`.
std::string pattern_of(std::string_view word);
/// Returns the expected keyword that corresponds to `word`, for example `when` for `if`, or `grafcet` for `graphcet`.
/// `word` is a keyword of another language or a misspelt keyword. The result is empty if no expected keyword
/// corresponds to `word`.
std::string keyword_of(std::string_view word, std::span<const Symbol> expected);

bool contains(std::span<const Symbol> symbols, Symbol symbol);

}  // namespace grafverif::tree
