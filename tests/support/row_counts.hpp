// SPDX-License-Identifier: MIT
// Statistics of a randomized test, which are stored with the test's result and printed if GRAFVERIF_TEST_COUNTS is set.
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

namespace grafverif {

inline void print_counts(const std::map<std::string, int>& counts) {
    for (const auto& [what, count] : counts) {
        testing::Test::RecordProperty(what, count);
        if (std::getenv("GRAFVERIF_TEST_COUNTS") != nullptr) std::printf("%7d %s\n", count, what.c_str());
    }
}

}  // namespace grafverif
