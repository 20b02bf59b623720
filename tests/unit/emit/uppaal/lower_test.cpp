// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "emit/uppaal/uppaal.hpp"
#include "unit/emit/uppaal/hand_networks.hpp"

namespace grafverif {
namespace {

std::vector<std::string> template_names(const Network& network) {
    std::vector<std::string> names;
    for (const Network::Template& automaton : network.templates) names.push_back(automaton.name);
    return names;
}

std::string template_of(const Network& network, std::uint32_t process) {
    return network.templates[network.processes[{process}].automaton].name;
}

TEST(LowerForUppaal, SplitsATemplateWhoseProcessesStartAtSeveralLocations) {
    const Network network = uppaal::lower(test::station());
    EXPECT_EQ(template_names(network), (std::vector<std::string>{"cylinder_5_3", "end_sensor_there", "end_sensor",
                                                                 "push_button", "plc_cycle", "timer"}));
    EXPECT_EQ(template_of(network, 1), "end_sensor_there");
    EXPECT_EQ(template_of(network, 2), "end_sensor");
}

TEST(LowerForUppaal, LetsEveryProcessStartAtTheInitialLocationOfItsTemplate) {
    const Network before = test::station(), network = uppaal::lower(before);
    ASSERT_EQ(network.processes.size(), before.processes.size());
    for (const Id<Network::Process> id : network.processes.ids()) {
        EXPECT_EQ(network.processes[id].initial, before.processes[id].initial);
        EXPECT_EQ(network.templates[network.processes[id].automaton].initial, network.processes[id].initial);
    }
}

TEST(LowerForUppaal, KeepsTheMeaning) {
    for (const Network& before : {test::station(), test::awkward_names(), test::crowded()}) {
        const Network network = uppaal::lower(before);
        EXPECT_EQ(verify(network), std::vector<std::string>{});
        EXPECT_EQ(network.properties, before.properties);
        Network left = expand(before), right = expand(network);
        EXPECT_EQ(left, right);
    }
}

TEST(LowerForUppaal, KeepsTheNameIfAllStartAtOneOtherLocation) {
    Network network = test::station();
    network.processes[{2}].initial = {1};  // both sensors now start in this location
    const Network lowered = uppaal::lower(network);
    EXPECT_EQ(template_of(lowered, 1), "end_sensor");
    EXPECT_EQ(template_of(lowered, 2), "end_sensor");
    EXPECT_EQ(lowered.templates.size(), network.templates.size());
}

TEST(LowerForUppaal, AvoidsANameThatAnotherTemplateHas) {
    Network network = test::station();
    network.templates[{0}].name = "end_sensor_there";
    EXPECT_EQ(template_of(uppaal::lower(network), 1), "end_sensor_there_2");
}

TEST(LowerForUppaal, WidensAConstantBeyondDefaultIntegers) {
    const Network network = uppaal::lower(test::station());
    const Network::Template& timer = network.templates[{5}];
    EXPECT_EQ(timer.parameters[{0}].type, integer_type(-32768, 60000));
    const Network::Template& cylinder = network.templates[{0}];
    EXPECT_EQ(cylinder.parameters[{3}].type, integer_type(-32768, 32767));
}

TEST(LowerForUppaal, ChangesNothingTwice) {
    const Network once = uppaal::lower(test::station());
    EXPECT_EQ(uppaal::lower(once), once);
}

}  // namespace
}  // namespace grafverif
