// SPDX-License-Identifier: MIT
#include "report/vcd.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>

#include "traces.hpp"

namespace grafverif {
namespace {

/// Reads the part of IEEE 1364-2005, 18.2, that grafverif writes.
struct Waves {
    std::map<std::string, std::string> codes = {};  ///< codes by hierarchical name
    std::map<std::string, std::string> types = {};
    std::map<std::string, std::map<std::int64_t, std::string>> changes = {};  ///< value changes by code and time
    std::vector<std::int64_t> times = {};

    std::string at(const std::string& name, std::int64_t time) const {
        const auto& list = changes.at(codes.at(name));
        return std::prev(list.upper_bound(time))->second;
    }
};

Waves read(const std::string& text) {
    Waves waves;
    std::istringstream in(text);
    std::vector<std::string> scopes;
    std::string token;
    const auto until_end = [&] {
        std::vector<std::string> list;
        while (in >> token && token != "$end") list.push_back(token);
        return list;
    };
    while (in >> token) {
        if (token == "$comment" || token == "$timescale" || token == "$enddefinitions") until_end();
        else if (token == "$scope") scopes.push_back(until_end().at(1));
        else if (token == "$upscope") until_end(), scopes.pop_back();
        else if (token == "$var") {
            const auto words = until_end();
            EXPECT_EQ(words.size(), 4u);
            std::string name;
            for (const std::string& scope : scopes) name += scope + ".";
            waves.codes[name + words.at(3)] = words.at(2);
            waves.types[name + words.at(3)] = words.at(0) + " " + words.at(1);
        } else if (token == "$dumpvars" || token == "$end") continue;
        else if (token[0] == '#') waves.times.push_back(std::stoll(token.substr(1)));
        else if (token[0] == 'b') {
            const std::string value = token.substr(1);
            in >> token;
            waves.changes[token][waves.times.back()] = value;
        } else {
            EXPECT_TRUE(token[0] == '0' || token[0] == '1') << token;
            waves.changes[token.substr(1)][waves.times.back()] = token.substr(0, 1);
        }
    }
    EXPECT_TRUE(scopes.empty());
    return waves;
}

std::string dump(const ChartRun& run) {
    std::ostringstream out;
    print_vcd(run, out);
    return out.str();
}

TEST(Vcd, DeclaresEverySignalOnceWithAUniqueCode) {
    const Waves waves = read(dump(sample_run()));
    std::set<std::string> codes;
    for (const auto& [name, code] : waves.codes) codes.insert(code);
    EXPECT_EQ(codes.size(), waves.codes.size());
    for (const char* name : {"inputs.START", "inputs.LEVEL", "outputs.GO", "outputs.IDLE", "internals.COUNT", "plant.X",
                             "steps.X0", "steps.X1", "steps.G2.X2", "loop"})
        EXPECT_EQ(waves.codes.count(name), 1u) << name;
    EXPECT_EQ(waves.codes.size(), 10u);
    EXPECT_EQ(waves.types.at("inputs.START"), "wire 1");
    EXPECT_EQ(waves.types.at("internals.COUNT"), "integer 32");
}

TEST(Vcd, KeepsTheOrderOfStepsWithinAnInstant) {
    const Waves waves = read(dump(sample_run()));
    EXPECT_EQ(waves.times, (std::vector<std::int64_t>{0, 1, 2, 1'500'000, 1'500'001, 1'501'001}));
    EXPECT_EQ(waves.at("inputs.START", 0), "0");
    EXPECT_EQ(waves.at("inputs.START", 1), "1");
    EXPECT_EQ(waves.at("outputs.GO", 1), "0");
    EXPECT_EQ(waves.at("outputs.GO", 2), "1");
    EXPECT_EQ(waves.at("inputs.LEVEL", 0), "10");
    EXPECT_EQ(waves.at("plant.X", 1'500'001), "100");
    EXPECT_EQ(waves.at("internals.COUNT", 2), std::string(32, '1')) << "two's complement of -1";
    EXPECT_EQ(waves.at("loop", 2), "0");
    EXPECT_EQ(waves.at("loop", 1'500'000), "1");
}

TEST(Vcd, GivesEverySignalAValueAtTheStart) {
    const Waves waves = read(dump(sample_run()));
    for (const auto& [name, code] : waves.codes) EXPECT_EQ(waves.changes.at(code).begin()->first, 0) << name;
}

TEST(Vcd, HasCodesForMoreSignalsThanCharacters) {
    ChartRun run = sample_run();
    for (int i = 0; i < 20'000; ++i) run.signals.add({ChartRun::Role::Plant, "p" + std::to_string(i), {}});
    for (ChartRun::Event& moment : run.moments) moment.after.values.resize(run.signals.size());
    const Waves waves = read(dump(run));
    std::set<std::string> codes;
    for (const auto& [name, code] : waves.codes) codes.insert(code);
    EXPECT_EQ(codes.size(), 20'010u);
}

TEST(Vcd, StepsBelongToTheModulesOfTheirControllerAndPartialChart) {
    ChartRun run = sample_run();
    for (ChartRun::Step& step : run.steps) step.controller = "press";
    std::ostringstream out;
    print_vcd(run, out);
    const Waves waves = read(out.str());
    EXPECT_TRUE(waves.codes.contains("steps.press.X1"));
    EXPECT_TRUE(waves.codes.contains("steps.press.G2.X2"));
}

}  // namespace
}  // namespace grafverif
