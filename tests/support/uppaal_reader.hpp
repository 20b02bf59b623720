// SPDX-License-Identifier: MIT
// Reads an exported UPPAAL project back into a Network, so that tests can check that it is complete: original names
// from the map in the header, roles from the groups of declarations, variables that a template reads and writes from
// its summary, properties from the queries.
//
// Elements that a project does not contain are omitted: locations in files, properties without a query, and `settled`
// if no property reads it.
#pragma once

#include <string>

#include "grafverif/ir/network.hpp"

namespace grafverif::test {

/// Throws std::runtime_error if `xml` is not of the emitter's form.
Network read_uppaal(const std::string& xml);

/// The expected result of reading back `network`: the network without the elements that a project does not contain.
Network as_read_back(Network network);

/// The canonical text of a network, with its variables sorted by name: a project groups them by role.
std::string comparable_text(const Network& network);

}  // namespace grafverif::test
