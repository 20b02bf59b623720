// SPDX-License-Identifier: MIT
// The nearest of names that are at hand.
#pragma once

#include <string>
#include <string_view>

#include "syntax/resolve/nearest.hpp"

namespace grafverif {

/// The one of `candidates` that a misspelt `name` may have meant; empty: none is near.
template <class Names>
std::string nearest_of(std::string_view name, const Names& candidates) {
    Nearest nearest(name);
    for (const auto& candidate : candidates) nearest.offer(candidate);
    return nearest.best();
}

}  // namespace grafverif
