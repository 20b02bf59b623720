// SPDX-License-Identifier: MIT
// element_of: lookup in a list in which the element must be present.
#pragma once

#include <algorithm>
#include <stdexcept>

namespace grafverif {

/// The first element of `list` whose `projection` equals `value`. Throws std::logic_error, an internal error, if there
/// is none: an unchecked end() would be undefined behaviour.
template <class List, class Value, class Projection>
auto& element_of(List& list, const Value& value, Projection projection) {
    const auto found = std::ranges::find(list, value, projection);
    if (found == std::ranges::end(list)) throw std::logic_error("a list lacks a required element");
    return *found;
}

}  // namespace grafverif
