// SPDX-License-Identifier: MIT
// element_of: finds an element in a list that must contain it.
#pragma once

#include <algorithm>
#include <stdexcept>

namespace grafverif {

/// Returns the first element of `list` whose `projection` equals `value`. If there is no such element, throws
/// std::logic_error, which indicates an internal error.
template <class List, class Value, class Projection>
auto& element_of(List& list, const Value& value, Projection projection) {
    const auto found = std::ranges::find(list, value, projection);
    if (found == std::ranges::end(list)) throw std::logic_error("a list lacks a required element");
    return *found;
}

}  // namespace grafverif
