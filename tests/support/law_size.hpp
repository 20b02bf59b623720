// SPDX-License-Identifier: MIT
// How many random cases a law tries: a small number by default, times the environment variable GRAFVERIF_LAWS.
#pragma once

#include <algorithm>
#include <cstdlib>

namespace grafverif {

inline int law_size(int cases) {
    const char* factor = std::getenv("GRAFVERIF_LAWS");
    return factor == nullptr ? cases : cases * std::max(1, std::atoi(factor));
}

}  // namespace grafverif
