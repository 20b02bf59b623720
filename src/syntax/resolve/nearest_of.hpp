// SPDX-License-Identifier: MIT
// Finds the nearest name in a list.
#pragma once

#include <fmt/format.h>

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

/// Returns the message that there is no `what` with this name. The message suggests the most similar known name.
template <class Names>
std::string unknown_name_text(std::string_view what, std::string_view name, const Names& known) {
    const std::string meant = nearest_of(name, known);
    return fmt::format("unknown {} `{}`{}", what, name,
                       meant.empty() ? "" : fmt::format("; did you mean `{}`?", meant));
}

}  // namespace grafverif
