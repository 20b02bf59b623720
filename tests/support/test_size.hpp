// SPDX-License-Identifier: MIT
// The number of random cases of a randomized test. The number is small by default, and the
// environment variable GRAFVERIF_TEST_SIZE multiplies it.
#pragma once

#include <algorithm>
#include <cstdlib>

namespace grafverif {

inline int test_size(int cases) {
    const char* factor = std::getenv("GRAFVERIF_TEST_SIZE");
    return factor == nullptr ? cases : cases * std::max(1, std::atoi(factor));
}

}  // namespace grafverif
