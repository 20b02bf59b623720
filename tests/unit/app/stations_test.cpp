// SPDX-License-Identifier: MIT
// Tests the stations of bench/stations: each file is in canonical form and has at least ten properties, and its charts
// have no findings.
#include <gtest/gtest.h>

#include <algorithm>

#include "run_program.hpp"

namespace grafverif::app {
namespace {

std::vector<std::string> station_files() {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(root / "bench/stations"))
        if (entry.path().extension() == ".grafcet") found.push_back(entry.path().stem().string());
    std::ranges::sort(found);
    return found;
}

class Stations : public testing::TestWithParam<std::string> {
protected:
    const std::string file = (root / "bench/stations" / (GetParam() + ".grafcet")).string();
};

TEST_P(Stations, AreInCanonicalFormWithoutFindings) {
    EXPECT_EQ(grafverif({"fmt", "--check", file}).code, ExitCode::Done);
    const Result result = grafverif({"analyse", file});
    EXPECT_EQ(result.code, ExitCode::Done) << result.out << result.err;
    EXPECT_TRUE(result.out.ends_with(": no findings\n")) << result.out;
}

TEST_P(Stations, HaveAboutTenProperties) {
    const Result result = grafverif({"check", "--list", file});
    EXPECT_EQ(result.code, ExitCode::Done) << result.err;
    EXPECT_GE(std::ranges::count(result.out, '\n'), 10) << result.out;
}

/// The search of the complete loop reaches its limit on the number of states; a proof without a search follows.
TEST(StationProperties, WithObserversNeedNoLargeSearchForTheTimelock) {
    const Result result = grafverif({"check", (root / "bench/stations/lift.grafcet").string(), "--property", "stops"});
    EXPECT_NE(result.out.find("no_timelock (not declared)  holds"), std::string::npos) << result.out << result.err;
}

INSTANTIATE_TEST_SUITE_P(Bench, Stations, testing::ValuesIn(station_files()),
                         [](const testing::TestParamInfo<std::string>& parameter) { return parameter.param; });

}  // namespace
}  // namespace grafverif::app
