// SPDX-License-Identifier: MIT
// Tests the exported models with NuSMV, if it is installed. NuSMV must accept every model and confirm that its
// transition relation is total. The number of states and the verdicts must equal those of an explicit search of the
// transition system.
#include "emit/nusmv/nusmv.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <sstream>

#include "support/explicit_search.hpp"
#include "support/random_loop.hpp"
#include "support/random_system.hpp"
#include "support/test_size.hpp"
#include "support/untimed_loop.hpp"

namespace grafverif {
namespace {

using System = TransitionSystem;

bool nusmv_is_installed() { return std::system("command -v NuSMV >/dev/null 2>&1") == 0; }

/// Returns the output of NuSMV for `model` and `commands`, or nothing after `time_limit` seconds, because NuSMV takes
/// minutes for some small models.
std::optional<std::string> nusmv_says(const std::string& model, const std::string& commands, int time_limit) {
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / ("grafverif_nusmv_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "model.smv") << model;
    std::ofstream(folder / "commands") << "read_model -i " << (folder / "model.smv").string() << "\n"
                                       << commands << "quit\n";
    const std::string command = "timeout " + std::to_string(time_limit) + " NuSMV -source " +
                                (folder / "commands").string() + " 2>&1 </dev/null";
    FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return {};
    std::string text;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
    const int status = pclose(pipe);
    std::filesystem::remove_all(folder);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 124) return {};
    return text;
}

// -- comparisons
// --------------------------------------------------------------------------------------------------------

std::string emitted(const System& system) {
    std::ostringstream out;
    nusmv::emit(system, out);
    return out.str();
}

struct Compared {
    std::size_t systems = 0, states = 0, verdicts = 0, given_up = 0;
};

/// Larger models are skipped, because NuSMV may take minutes for them.
constexpr std::size_t most_states = 300;

void compare(const System& system, Compared& compared) {
    const std::string model = emitted(system);
    const std::optional<SystemGraph> graph = explored(system, most_states, 256);
    if (!graph) return;
    const std::vector<std::string> names = nusmv::spelling(system).properties;
    std::string commands = "set dynamic_reorder 1\nflatten_hierarchy\nencode_variables\nbuild_model\ncheck_fsm\n";
    commands += "print_reachable_states\n";
    std::vector<bool> expected;
    for (const Id<Property> id : system.properties.ids()) {
        const Pattern pattern = system.properties[id].pattern;
        if (pattern == Pattern::RawCtl || pattern == Pattern::RawLtl) continue;
        commands += "check_property -P \"" + names[id.index] + "\"\n";
        expected.push_back(explicit_verdict(system, *graph, system.properties[id]) != (pattern == Pattern::Reachable));
    }
    const std::optional<std::string> answer = nusmv_says(model, commands, 2);
    if (!answer) {
        ++compared.given_up;
        return;
    }
    const std::string& output = *answer;
    ASSERT_NE(output.find("The transition relation is total"), std::string::npos) << output << model;
    ++compared.systems;
    ASSERT_NE(output.find("reachable states: " + std::to_string(graph->states.size()) + " ("), std::string::npos)
        << graph->states.size() << " states expected\n"
        << output << model;
    std::vector<bool> found;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("-- specification") || line.starts_with("-- invariant"))
            found.push_back(line.ends_with("true"));
    ASSERT_EQ(found, expected) << output << model;
    compared.states += graph->states.size();
    compared.verdicts += found.size();
}

TEST(NusmvOracle, AgreesWithAnExplicitSearchOnRandomLoopsInEveryApproachAndSchedule) {
    if (!nusmv_is_installed()) GTEST_SKIP() << "NuSMV is not on the PATH";
    const int cases = test_size(4);
    Compared compared;
    for (int seed = 1; seed <= cases; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const Model model = random_loop(random);
        for (System& system : untimed_models(model, chance(random, 30))) {
            SCOPED_TRACE(system.scope);
            ask_more(system, random);
            ASSERT_NO_FATAL_FAILURE(compare(system, compared));
        }
    }
    std::cout << "seeds 1 to " << cases << ": " << compared.systems << " models, " << compared.states
              << " states counted, " << compared.verdicts << " verdicts compared, " << compared.given_up
              << " not decided\n";
    EXPECT_GT(compared.systems, compared.given_up);
}

TEST(NusmvOracle, AcceptsTheGoldenModels) {
    if (!nusmv_is_installed()) GTEST_SKIP() << "NuSMV is not on the PATH";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(GRAFVERIF_SOURCE_DIR "/tests/golden")) {
        if (entry.path().extension() != ".smv") continue;
        SCOPED_TRACE(entry.path().string());
        std::ostringstream model;
        model << std::ifstream(entry.path()).rdbuf();
        const auto output = nusmv_says(
            model.str(), "set dynamic_reorder 1\nflatten_hierarchy\nencode_variables\nbuild_model\ncheck_fsm\n", 60);
        ASSERT_TRUE(output);
        EXPECT_NE(output->find("The transition relation is total"), std::string::npos) << *output;
    }
}

}  // namespace
}  // namespace grafverif
