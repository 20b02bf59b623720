// SPDX-License-Identifier: MIT
#pragma once

#include <sstream>
#include <string>

#include "emit/uppaal/uppaal.hpp"

namespace grafverif::test {

/// Returns the UPPAAL project of a network that is not lowered yet.
inline std::string project(const Network& network) {
    std::ostringstream out;
    uppaal::emit(uppaal::lower(network), out);
    return std::move(out).str();
}

}  // namespace grafverif::test
