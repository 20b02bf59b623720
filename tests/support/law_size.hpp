// SPDX-License-Identifier: MIT
// Number of random cases of a randomized test: a small number by default, multiplied by the environment variable
// GRAFVERIF_LAWS.
#pragma once

#include <algorithm>
#include <cstdlib>

namespace grafverif {

inline int law_size(int cases) {
    const char* factor = std::getenv("GRAFVERIF_LAWS");
    return factor == nullptr ? cases : cases * std::max(1, std::atoi(factor));
}

}  // namespace grafverif
