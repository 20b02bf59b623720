// SPDX-License-Identifier: MIT
// The canonical text of a Network: for people, goldens and comparison up to positions. Two networks that print alike
// mean the same; the text is not read back.
#pragma once

#include <iosfwd>
#include <string>

#include "grafverif/ir/network.hpp"

namespace grafverif {

void print_network(std::ostream& out, const Network& network);
std::string network_text(const Network& network);

}  // namespace grafverif
