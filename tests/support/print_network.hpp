// SPDX-License-Identifier: MIT
// The canonical text of a Network, for display, golden files and comparison up to locations. Two networks with equal
// texts have the same meaning; the text is not read back.
#pragma once

#include <iosfwd>
#include <string>

#include "grafverif/ir/network.hpp"

namespace grafverif {

void print_network(std::ostream& out, const Network& network);
std::string network_text(const Network& network);

}  // namespace grafverif
