// SPDX-License-Identifier: MIT
// Properties as UPPAAL queries. A formula is one line: UPPAAL ends a query at the line's end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "emit/uppaal/names.hpp"
#include "grafverif/ir/network.hpp"

namespace grafverif::uppaal {

struct Query {
    Id<Property> property = {};
    std::string name = {};               ///< the property's, or `S.X7` of one that expands
    std::string formula = {};            ///< empty: cannot be said; the comment says why
    std::string comment = {};            ///< begins with the property's name
    std::optional<bool> satisfied = {};  ///< expected; nothing where no single query is told what to expect
    std::string reason = {};             ///< why it cannot be said
};

/// In the order of the properties.
std::vector<Query> queries(const Network& network, const Names& names);

}  // namespace grafverif::uppaal
