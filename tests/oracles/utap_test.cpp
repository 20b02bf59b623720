// SPDX-License-Identifier: MIT
// Tests exported projects with the parser of UPPAAL: the program `syntaxcheck` of utap parses and type-checks a file as
// UPPAAL does.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "emit/uppaal/uppaal.hpp"
#include "support/random_network.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

/// Returns the errors of syntaxcheck, without its warnings.
std::string error_texts(const std::string& xml) {
    const auto file =
        std::filesystem::temp_directory_path() / ("grafverif_utap_" + std::to_string(::getpid()) + ".xml");
    const auto log = std::filesystem::path(file).replace_extension(".log");
    std::ofstream(file) << xml;
    const int status = std::system(("syntaxcheck " + file.string() + " > " + log.string() + " 2>&1").c_str());
    std::ifstream lines(log);
    std::string errors = WEXITSTATUS(status) > 2 ? "syntaxcheck terminated abnormally\n" : "";
    for (std::string line; std::getline(lines, line);) {
        // A strict invariant causes a warning, and so does an update that assigns only scratch variables.
        const bool warning = line.find("$Strict_invariant") != std::string::npos ||
                             line.find("$Expression_does_not_have_any_effect") != std::string::npos;
        if (!warning) errors += line + '\n';
    }
    std::filesystem::remove(file);
    std::filesystem::remove(log);
    return errors;
}

TEST(Utap, AcceptsEveryProject) {
    if (std::system("command -v syntaxcheck > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "syntaxcheck of utap is not on the PATH";
    for (int seed = 0; seed < test_size(50); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        std::ostringstream xml;
        uppaal::emit(uppaal::lower(random_network(random)), xml);
        EXPECT_EQ(error_texts(xml.str()), "") << "seed " << seed;
    }
}

TEST(Utap, AcceptsTheProjectsOfTheSamples) {
    if (std::system("command -v syntaxcheck > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "syntaxcheck of utap is not on the PATH";
    for (const auto& entry : std::filesystem::directory_iterator(GRAFVERIF_SOURCE_DIR "/tests/golden")) {
        std::ifstream file(entry.path() / "4-uppaal.xml");
        if (!file) continue;
        EXPECT_EQ(error_texts({std::istreambuf_iterator<char>(file), {}}), "") << entry.path();
    }
}

TEST(Utap, RejectsAMalformedProject) {
    if (std::system("command -v syntaxcheck > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "syntaxcheck of utap is not on the PATH";
    EXPECT_NE(error_texts("<nta><declaration>bool a b;</declaration><system>system;</system></nta>"), "");
}

}  // namespace
}  // namespace grafverif
