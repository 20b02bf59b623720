// SPDX-License-Identifier: MIT
// What the parser expected, in plain words.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grafcet_parser.hpp"

namespace grafverif::tree {

using Symbol = Parser::symbol_kind_type;

/// "`;` or an operator": the tokens that could have stood there, those of one kind under one name.
std::string expectation(std::span<const Symbol> expected);

/// The pattern of properties that `word` means in CTL, LTL, UPPAAL or with a misspelling: `always` for `AG`; or empty.
std::string pattern_of(std::string_view word);
/// The expected keyword that `word` means: `when` for `if`, `grafcet` for `graphcet`; or empty.
std::string keyword_of(std::string_view word, std::span<const Symbol> expected);

bool contains(std::span<const Symbol> symbols, Symbol symbol);

}  // namespace grafverif::tree
