// SPDX-License-Identifier: MIT
// Generates random files of other formats for the randomized tests of import. Most of them are charts; some contain a
// typical mistake of an author.
#pragma once

#include <random>
#include <string>

namespace grafverif {

using FileRandom = std::mt19937_64;

/// Returns a GRAFCET in AGRAFE's meta-model, with partial grafcets, macro-steps, enclosing steps, forcing orders, and
/// actions and terms of every kind.
std::string random_agrafe(FileRandom& random);
/// Returns a Sequential Function Chart as text, with all qualifiers, statements, times and branches.
std::string random_sfc(FileRandom& random);
/// Returns the same kind of chart in PLCopen XML.
std::string random_plcopen(FileRandom& random);

/// Returns `text` with some lines removed, duplicated or exchanged, and with some attribute values and words replaced
/// by those at other positions.
std::string mutated(const std::string& text, FileRandom& random);

}  // namespace grafverif
