// SPDX-License-Identifier: MIT
// Random files of other formats, most of them charts, some of them with a fault that authors make: for the laws of
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

/// `text` with some lines dropped, doubled or exchanged, values of attributes and words taken from other places of it.
std::string mutated(const std::string& text, FileRandom& random);

}  // namespace grafverif
