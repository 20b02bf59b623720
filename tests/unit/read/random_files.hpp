// SPDX-License-Identifier: MIT
// Random files of other formats, most of them charts, some with an error that authors make: for the randomized tests of
// import.
#pragma once

#include <random>
#include <string>

namespace grafverif {

using FileRandom = std::mt19937_64;

/// A GRAFCET in AGRAFE's meta-model: partial grafcets, macro-steps, enclosing steps, orders, actions and terms of every
/// kind.
std::string random_agrafe(FileRandom& random);
/// A Sequential Function Chart in text, with all qualifiers, statements, times and branches.
std::string random_sfc(FileRandom& random);
/// The same kind of chart in PLCopen XML.
std::string random_plcopen(FileRandom& random);

/// `text` with some lines removed, duplicated or exchanged, and with values of attributes and words from other
/// positions.
std::string mutated(const std::string& text, FileRandom& random);

}  // namespace grafverif
