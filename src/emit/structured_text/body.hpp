// SPDX-License-Identifier: MIT
// The statements of a controller in Structured Text.
#pragma once

#include <string>

#include "emit/structured_text/names.hpp"

namespace grafverif::structured_text {

struct Body {
    std::string text = {};
    std::vector<bool> waits = {};  ///< for each variable: true if its new value needs a temporary variable
};

/// Returns the statements of one PLC cycle. Requires verify(equations).empty() and that the equations are expressible.
Body body_of(const Equations& equations, const Names& names, const Options& options);

/// Returns a literal such as `T#3s`.
std::string time_literal(std::int64_t milliseconds);

}  // namespace grafverif::structured_text
