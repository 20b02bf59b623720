// SPDX-License-Identifier: MIT
// Finds the name in a list that is most similar to a misspelt name.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "syntax/resolve/nearest.hpp"

namespace grafverif {

/// Returns the element of `candidates` that the misspelt `name` probably denotes; empty if all candidates are too
/// different.
template <class Names>
std::string nearest_of(std::string_view name, const Names& candidates) {
    Nearest nearest(name);
    for (const auto& candidate : candidates) nearest.offer(candidate);
    return nearest.best();
}

/// Returns the message that no element of the type `what` has the name `name`. The message suggests the most similar
/// known name.
template <class Names>
std::string unknown_name_text(std::string_view what, std::string_view name, const Names& known) {
    const std::string meant = nearest_of(name, known);
    return fmt::format("unknown {} `{}`{}", what, name,
                       meant.empty() ? "" : fmt::format("; did you mean `{}`?", meant));
}

}  // namespace grafverif
