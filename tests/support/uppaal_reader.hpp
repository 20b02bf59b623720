// SPDX-License-Identifier: MIT
// Reads an exported UPPAAL project back into a Network, so that tests can check that the project is
// complete. The reader obtains original names from the map in the header, and roles from the groups
// of declarations. The variables that a template reads and writes are in its summary, and the
// properties are in the queries.
//
// The result omits elements that a project does not contain: locations in source files, properties without a query, and
// `settled` if no property reads it.
#pragma once

#include <string>

#include "grafverif/ir/network.hpp"

namespace grafverif::test {

/// Reads the project. Throws std::runtime_error if `xml` does not have the form that the emitter writes.
Network read_uppaal(const std::string& xml);

/// Returns the expected result of reading `network` back: the network without the elements that a project does not
/// contain.
Network as_read_back(Network network);

/// Returns the canonical text of a network with its variables sorted by name, because a project groups them by role.
std::string comparable_text(const Network& network);

}  // namespace grafverif::test
