// SPDX-License-Identifier: MIT
// Descriptions of expected tokens for syntax errors.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grafcet_parser.hpp"

namespace grafverif::tree {

using Symbol = Parser::symbol_kind_type;

/// Describes the tokens that are allowed at a position, grouped by type: "`;` or an operator".
std::string expectation(std::span<const Symbol> expected);

/// Returns the property pattern that corresponds to `word`, which is an operator of CTL, LTL or UPPAAL or a misspelt
/// pattern: `always` for `AG`. The result is empty if no pattern corresponds to `word`.
std::string pattern_of(std::string_view word);
/// Returns the expected keyword that corresponds to `word`, which is a keyword of another language or a misspelt
/// keyword: `when` for `if`, `grafcet` for `graphcet`. The result is empty if no expected keyword corresponds to
/// `word`.
std::string keyword_of(std::string_view word, std::span<const Symbol> expected);

bool contains(std::span<const Symbol> symbols, Symbol symbol);

}  // namespace grafverif::tree
