// SPDX-License-Identifier: MIT
// Prints the canonical text of a Network, for display, golden files, and comparison without regard to source locations.
// Two networks with equal texts have the same meaning. The text is not read back.
#pragma once

#include <iosfwd>
#include <string>

#include "grafverif/ir/network.hpp"

namespace grafverif {

void print_network(std::ostream& out, const Network& network);
std::string network_text(const Network& network);

}  // namespace grafverif
