// SPDX-License-Identifier: MIT
// Properties as UPPAAL queries. A formula is a single line, because UPPAAL ends a query at the end of the line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "emit/uppaal/names.hpp"
#include "grafverif/ir/network.hpp"

namespace grafverif::uppaal {

struct Query {
    Id<Property> property = {};
    std::string name = {};               ///< that of the property, or `S.X7` of one that expands
    std::string formula = {};            ///< empty: not expressible; the comment states why
    std::string comment = {};            ///< begins with the name of the property
    std::optional<bool> satisfied = {};  ///< expected result; empty if no single query has one
    std::string reason = {};             ///< reason why it is not expressible
};

/// In the order of the properties.
std::vector<Query> queries(const Network& network, const Names& names);

}  // namespace grafverif::uppaal
