// SPDX-License-Identifier: MIT
// Translates properties to UPPAAL queries. A formula is a single line, because a query ends at the end of the line in
// UPPAAL.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "emit/uppaal/names.hpp"
#include "grafverif/ir/network.hpp"

namespace grafverif::uppaal {

struct Query {
    Id<Property> property = {};
    std::string name = {};               ///< name of the property, or `S.X7` for one step of a property over all steps
    std::string formula = {};            ///< empty if the property is not expressible; `comment` then states the reason
    std::string comment = {};            ///< comment; it begins with the name of the property
    std::optional<bool> satisfied = {};  ///< expected result; empty if a single query has no expected result
    std::string reason = {};             ///< reason why the property is not expressible
};

/// Returns the queries, in the order of the properties.
std::vector<Query> queries(const Network& network, const Names& names);

}  // namespace grafverif::uppaal
