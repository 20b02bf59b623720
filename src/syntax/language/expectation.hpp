// SPDX-License-Identifier: MIT
// What the parser expected, in plain words.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "grafcet_parser.hpp"

namespace grafverif::tree {

using Symbol = Parser::symbol_kind_type;

/// "`;` or an operator": the tokens that could have stood there, those of one kind under one name.
std::string expectation(std::span<const Symbol> expected);

bool contains(std::span<const Symbol> symbols, Symbol symbol);

}  // namespace grafverif::tree
