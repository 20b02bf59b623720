// SPDX-License-Identifier: MIT
#include "unit/emit/uppaal/dtd.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "emit/uppaal/uppaal.hpp"
#include "support/random_network.hpp"
#include "support/test_size.hpp"
#include "unit/emit/uppaal/hand_networks.hpp"
#include "unit/emit/uppaal/project_text.hpp"

namespace grafverif {
namespace {

using test::has_xmllint;
using test::is_valid;

TEST(UppaalDtd, HoldsForProjects) {
    if (!has_xmllint()) GTEST_SKIP() << "xmllint (libxml2-utils) is not installed";
    EXPECT_TRUE(is_valid(test::project(test::station())));
    EXPECT_TRUE(is_valid(test::project(test::awkward_names())));
    EXPECT_TRUE(is_valid(test::project(test::crowded())));
    for (int seed = 0; seed < test_size(20); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        EXPECT_TRUE(is_valid(test::project(random_network(random)))) << "seed " << seed;
    }
}

TEST(UppaalDtd, DetectsAMisplacedElement) {
    if (!has_xmllint()) GTEST_SKIP() << "xmllint (libxml2-utils) is not installed";
    std::string xml = test::project(test::station());
    const std::size_t init = xml.find("\t\t<init ");
    const std::string element = xml.substr(init, xml.find('\n', init) + 1 - init);
    xml.erase(init, element.size()).insert(xml.find("\t\t<location"), element);
    EXPECT_FALSE(is_valid(xml));
}

}  // namespace
}  // namespace grafverif
