// SPDX-License-Identifier: MIT
// Tests that reading an emitted project back results in the emitted network, apart from elements that a project does
// not contain. Therefore, the project is complete, and its names identify the original names.
#include <gtest/gtest.h>

#include <sstream>

#include "emit/uppaal/uppaal.hpp"
#include "support/random_network.hpp"
#include "support/test_size.hpp"
#include "support/uppaal_reader.hpp"
#include "unit/emit/uppaal/hand_networks.hpp"

namespace grafverif {
namespace {

std::string emitted(const Network& lowered) {
    std::ostringstream out;
    uppaal::emit(lowered, out);
    return out.str();
}

void expect_read_back(const Network& network) {
    const Network lowered = uppaal::lower(network);
    const Network read = test::read_uppaal(emitted(lowered));
    EXPECT_EQ(test::comparable_text(read), test::comparable_text(test::as_read_back(lowered)));
}

TEST(UppaalProject, IsReadBackAsTheNetworkThatWasEmitted) {
    expect_read_back(test::station());
    expect_read_back(test::awkward_names());
    expect_read_back(test::crowded());
}

TEST(UppaalProject, IsReadBackWithSeveralControllers) {
    Network network = test::station();
    network.controllers.add(
        {{.name = "second", .mode = ExecutionMode::EveryCycle}, {4}, {1}, network.controllers[{0}].stable});
    expect_read_back(network);
}

TEST(UppaalProject, OfAnyNetworkIsReadBack) {
    for (int seed = 0; seed < test_size(300); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        expect_read_back(random_network(random));
        if (testing::Test::HasFailure()) return;
    }
}

}  // namespace
}  // namespace grafverif
