// SPDX-License-Identifier: MIT
// Tests every command on every valid chart with at most two steps, one transition, one input and one output, including
// empty charts. Programs often fail on missing elements.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/every_command.hpp"
#include "read/text.hpp"
#include "support/test_size.hpp"
#include "unit/app/run_program.hpp"

namespace grafverif {
namespace {

/// The possible actions of a step. `o` is the output, and `{}` marks the position of the condition.
constexpr std::array actions = {"",
                                "o;",
                                "o if {};",
                                "o after 1s;",
                                "o for 1s;",
                                "o := true on activation;",
                                "o := {} on deactivation;",
                                "o := false on event rise({});"};

/// Returns the possible conditions in a chart with the given elements.
std::vector<std::string> conditions(bool input, bool output, std::size_t steps) {
    std::vector<std::string> list{"true", "false"};
    if (input) list.insert(list.end(), {"a", "!a", "rise(a)", "1s/a"});
    if (output) list.insert(list.end(), {"o", "fall(o)"});
    if (steps > 0) list.insert(list.end(), {"X0", "2s/X0"});
    return list;
}

/// Returns the possible sets of transitions: the empty set, and each single transition from some of the steps to some
/// of the steps.
std::vector<std::string> transitions(const std::vector<std::string>& conditions, std::size_t steps) {
    std::vector<std::string> list{""};
    const std::vector<std::string> sets = steps == 0   ? std::vector<std::string>{""}
                                          : steps == 1 ? std::vector<std::string>{"", "0"}
                                                       : std::vector<std::string>{"", "0", "1", "0, 1"};
    for (const std::string& from : sets)
        for (const std::string& to : sets)
            for (const std::string& condition : conditions)
                if (!from.empty() || !to.empty())
                    list.push_back(fmt::format("    transition t: {} -> {} when {};\n", from, to, condition));
    return list;
}

/// Returns the declarations of each step with or without an initial mark, and with or without an action.
std::vector<std::string> steps(std::size_t count, bool output, const std::string& term) {
    std::vector<std::string> list{""};
    for (std::size_t step = 0; step < count; ++step) {
        std::vector<std::string> longer;
        for (const std::string& before : list)
            for (const char* initial : {"initial ", ""})
                for (const char* action : actions) {
                    if (*action != '\0' && (!output || before.find('{') != std::string::npos))
                        continue;  // the tested charts have at most one action
                    const std::string does = fmt::format(fmt::runtime(action), term);
                    longer.push_back(before + fmt::format("    {}step {}{};\n", initial, step,
                                                          does.empty() ? "" : " { " + does + " }"));
                }
        list = std::move(longer);
    }
    for (std::string& text : list)
        for (std::size_t at = text.find("};"); at != std::string::npos; at = text.find("};", at)) text.erase(at + 1, 1);
    return list;
}

std::vector<std::string> shapes() {
    std::vector<std::string> list;
    for (const bool input : {false, true})
        for (const bool output : {false, true})
            for (std::size_t count = 0; count <= 2; ++count) {
                const std::string frame = fmt::format("grafcet small {{\n{}{}", input ? "    input a;\n" : "",
                                                      output ? "    output o;\n" : "");
                for (const std::string& body : steps(count, output, input ? "a" : "X0"))
                    for (const std::string& transition : transitions(conditions(input, output, count), count))
                        list.push_back(frame + body + transition + "}\n");
            }
    return list;
}

std::optional<Model> read(const std::string& text) {
    Sources sources;
    Diagnostics diagnostics;
    return read_text(sources.add({"small.grafcet", text}), sources, {}, diagnostics);
}

/// Returns a closed loop of the chart and a plant with arbitrary behaviour.
std::string loop_of(const std::string& chart) {
    return "component any(output OUT) {\n    initial location on;\n    timed on -> on when true do OUT := !OUT;\n}\n" +
           chart + "closed_loop smallest {\n    controller small;\n" +
           (chart.find("input a") == std::string::npos ? "" : "    environment A = any(OUT = a);\n") +
           "    property p: reachable all steps;\n    property q: no deadlock;\n}\n";
}

TEST(SmallShapes, AreAcceptedByEveryCommand) {
    const app::Folder folder;
    const std::span<const fuzz::VerbRun> runs = fuzz::command_runs();
    const std::vector<std::string> all = shapes();
    const std::size_t law = static_cast<std::size_t>(test_size(1));
    // Every stride-th chart is tested; with GRAFVERIF_TEST_SIZE=8 or more, every chart is tested.
    const std::size_t stride = law >= 8 ? 1 : 8 / law;
    const std::size_t each = (law + 7) / 8;  // number of commands for each chart: the test size / 8, rounded up
    std::size_t legal = 0, next = 0;
    for (const std::string& chart : all) {
        const auto alone = read(chart);
        if (!alone || ++legal % stride != 0) continue;
        const std::string loop = loop_of(chart);
        const auto with_loop = read(loop);
        ASSERT_TRUE(with_loop) << loop;
        for (std::size_t k = 0; k < std::min(each, runs.size()); ++k) {
            const fuzz::VerbRun& run = runs[next++ % runs.size()];
            const bool looped = run.of_loop || next % 2 == 0;
            const std::string file = folder.write("small.grafcet", looped ? loop : chart);
            ASSERT_EQ(fuzz::error_text(run, file, looped ? *with_loop : *alone, folder.file("written")), "");
        }
    }
    std::cout << legal << " of " << all.size() << " charts are valid\n";
    EXPECT_GT(legal, 1000U);
}

/// Tests empty files, empty charts and empty loops.
TEST(SmallShapes, EmptyOnesAreRejectedByName) {
    const app::Folder folder;
    for (const char* text : {"", "\n", "// nothing\n", "grafcet g {}\n", "closed_loop l {}\n", "component c() {}\n",
                             "grafcet g { initial step 0; }\nclosed_loop l {}\n",
                             "grafcet g { initial step 0; }\ngrafcet h { initial step 0; }\n"}) {
        SCOPED_TRACE(text);
        const std::string file = folder.write("nothing.grafcet", text);
        for (const fuzz::VerbRun& run : fuzz::command_runs())
            EXPECT_EQ(fuzz::error_text(run, file, {}, folder.file("written")), "");
    }
}

}  // namespace
}  // namespace grafverif
