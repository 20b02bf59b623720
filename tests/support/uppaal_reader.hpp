// SPDX-License-Identifier: MIT
// Reads a UPPAAL project of ours back into a Network, so that tests can say that nothing was lost: names as they were
// before they were legalised (from the map in the header), roles from the groups of declarations, what a template reads
// and writes from its summary, properties from the queries.
//
// What a project does not hold stays out: positions, properties that no query can say, and `settled` where no property
// asks for it.
#pragma once

#include <string>

#include "grafverif/ir/network.hpp"

namespace grafverif::test {

/// Throws std::runtime_error where `xml` is not what the emitter writes.
Network read_uppaal(const std::string& xml);

/// What reading back `network` after emission can give: the network without what a project does not hold.
Network as_read_back(Network network);

/// The canonical text of a network, its variables sorted by name: a project groups them by role.
std::string comparable_text(const Network& network);

}  // namespace grafverif::test
