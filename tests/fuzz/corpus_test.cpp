// SPDX-License-Identifier: MIT
// Replays the corpus, which contains the initial inputs and all findings, in every build.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz/targets.hpp"

namespace grafverif::fuzz {
namespace {

namespace fs = std::filesystem;

class Corpus : public testing::TestWithParam<Target> {};

TEST_P(Corpus, ViolatesNoGuarantee) {
    std::vector<fs::path> files;
    for (const auto& entry :
         fs::directory_iterator(fs::path(GRAFVERIF_SOURCE_DIR) / "tests/fuzz/corpus" / GetParam().name))
        files.push_back(entry.path());
    std::ranges::sort(files);
    ASSERT_FALSE(files.empty());
    for (const fs::path& path : files) {
        SCOPED_TRACE(path);
        std::ifstream file(path, std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(file), {}};
        EXPECT_EQ(GetParam().error_text(bytes), "");
        EXPECT_EQ(GetParam().error_text(bytes.substr(0, bytes.size() / 2)), "") << "first half of the file";
    }
}

INSTANTIATE_TEST_SUITE_P(Of, Corpus, testing::ValuesIn(targets().begin(), targets().end()),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace grafverif::fuzz
