// SPDX-License-Identifier: MIT
// Compiles the C files of `grafverif pins`, explores the models with a small explorer that uses only the LTSmin
// interface, and compares the results with the timed engine.
#include "emit/pins/pins.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "check/timed/timed.hpp"
#include "support/random_loop.hpp"
#include "support/random_network.hpp"
#include "support/read_loop.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t most_states = 60'000;

std::string output_of(const std::string& command) {
    std::string text;
    FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) return "popen failed";
    std::array<char, 4096> part = {};
    while (const std::size_t read = std::fread(part.data(), 1, part.size(), pipe)) text.append(part.data(), read);
    if (pclose(pipe) != 0) text += "\nended with an error";
    return text;
}

struct Searched {
    std::uint64_t states = 0;
    std::map<std::string, std::uint64_t> labels = {};
    std::string faults = {};
};

class Pins : public testing::Test {
protected:
    Pins() {
        std::string name = (fs::temp_directory_path() / "grafverif-pins-XXXXXX").string();
        folder_ = mkdtemp(name.data());
        EXPECT_EQ(output_of(compile + " -O1 -c -o " + (folder_ / "explorer.o").string() + " " + here + "/explorer.c"),
                  "");
    }
    ~Pins() override { fs::remove_all(folder_); }

    Searched searched(const Network& network) {
        std::ofstream file(folder_ / "model.c");
        pins::emit(network, file);
        file.close();
        Searched result;
        const std::string program = (folder_ / "model").string();
        result.faults = output_of(compile + " -c -o " + program + ".o " + program + ".c && " GRAFVERIF_COMPILER " -o " +
                                  program + " " + program + ".o " + (folder_ / "explorer.o").string());
        std::istringstream lines(output_of("timeout 60 " + program));
        for (std::string word, name; lines >> word;) {
            if (word == "states") lines >> result.states;
            else if (word == "label") lines >> name >> result.labels[name];
            else std::getline(lines, name), result.faults += word + name + "\n";
        }
        return result;
    }

    /// Compares the results if the network is small enough; returns false if it is not.
    bool compare(const Network& network) {
        const TimedResult expected = check_timed(network, {.max_states = most_states});
        if (!expected.complete) return false;
        const Searched found = searched(network);
        EXPECT_EQ(found.faults, "");
        if (!found.faults.empty()) return true;
        EXPECT_EQ(found.states, expected.states);
        for (const Property& property : network.properties) {
            const auto verdict = std::ranges::find(expected.verdicts, property.name, &Verdict::property);
            const auto label = found.labels.find(property.name);
            if (verdict == expected.verdicts.end() || label == found.labels.end()) continue;
            if (verdict->outcome == Outcome::Unknown) continue;
            const bool shown = (verdict->outcome == Outcome::Violated) != (property.pattern == Pattern::Reachable);
            EXPECT_EQ(label->second != 0, shown) << property.name;
            ++labels_;
        }
        const bool breaks = std::ranges::any_of(
            expected.errors, [](const ModelError& error) { return error.kind != ModelError::Kind::ActionRace; });
        EXPECT_EQ(found.labels.at("breaks_off") != 0, breaks);
        broken_ += breaks ? 1 : 0;
        return true;
    }

    const std::string here = GRAFVERIF_SOURCE_DIR "/tests/unit/emit/pins";
    const std::string compile =
        GRAFVERIF_COMPILER " -x c -std=gnu11 -Wall -Wextra -Werror -Wno-tautological-compare -I" + here;
    int labels_ = 0, broken_ = 0;

private:
    fs::path folder_ = {};
};

TEST_F(Pins, EverySampleHasTheStatesOfTheTimedEngine) {
    int compared = 0;
    for (const char* sample : {"blinker/blinker.grafcet", "oven_door/oven_door.grafcet", "tanks/tanks.grafcet",
                               "testing_station/testing_station.grafcet", "testing_station/faulty.grafcet",
                               "assembly_station/assembly_station.grafcet", "pick_and_place/pick_and_place.grafcet"})
        for (const Grain grain : {Grain::Phased, Grain::Atomic}) {
            SCOPED_TRACE(sample);
            compared += compare(read_sample(sample, {.grain = grain}).network) ? 1 : 0;
        }
    EXPECT_GE(compared, 10);
    EXPECT_GT(labels_, 10);
}

TEST_F(Pins, RandomClosedLoopsHaveTheStatesOfTheTimedEngine) {
    int compared = 0;
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(test_size(6)); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        Model model = random_loop(random);
        if (seed % 3 == 0) add_task_cycles(model, random);
        try {
            compared +=
                compare(composed_loop(model, {.grain = seed % 2 == 0 ? Grain::Atomic : Grain::Phased}).network) ? 1 : 0;
        } catch (const std::invalid_argument&) {
            continue;  // compose rejects this loop
        }
    }
    EXPECT_GT(compared, 0);
}

TEST_F(Pins, RandomNetworksHaveTheStatesOfTheTimedEngine) {
    Random random(11);
    const int cases = test_size(25);
    int compared = 0;
    for (int i = 0; i < cases; ++i) {
        SCOPED_TRACE(i);
        compared += compare(random_network(random)) ? 1 : 0;
    }
    EXPECT_GT(compared, cases / 2);
    EXPECT_GT(broken_, 0) << "some runs of the models must end with an error";
}

}  // namespace
}  // namespace grafverif
