// SPDX-License-Identifier: MIT
// Finds the nearest name in a list.
#pragma once

#include <string>
#include <string_view>

#include "syntax/resolve/nearest.hpp"

namespace grafverif {

/// Returns the element of `candidates` that the misspelt `name` probably denotes; empty if none is near enough.
template <class Names>
std::string nearest_of(std::string_view name, const Names& candidates) {
    Nearest nearest(name);
    for (const auto& candidate : candidates) nearest.offer(candidate);
    return nearest.best();
}

}  // namespace grafverif
