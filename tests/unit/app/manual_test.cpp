// SPDX-License-Identifier: MIT
// Tests that manual pages and shell completion contain the complete option table.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "app/options.hpp"
#include "run_program.hpp"

namespace grafverif::app {
namespace {

std::string with_escaped_dashes(std::string text) {
    for (std::size_t at = 0; (at = text.find('-', at)) != std::string::npos; at += 2) text.insert(at, 1, '\\');
    return text;
}

TEST(Manual, HasAPageForEachCommandWithAllItsOptions) {
    const std::string overview = grafverif({"manual"}).out;
    ASSERT_GT(all_commands().size(), 20U);
    for (const CliCommand& verb : all_commands()) {
        SCOPED_TRACE(verb.name);
        EXPECT_NE(overview.find("grafverif\\-" + verb.name + "\\fR(1)"), std::string::npos);
        const Result page = grafverif({"manual", verb.name});
        ASSERT_EQ(page.code, ExitCode::Done) << page.err;
        for (const OptionText& option : option_texts(verb))
            EXPECT_NE(page.out.find("\\fB\\-\\-" + with_escaped_dashes(option.name) + "\\fR"), std::string::npos)
                << option.name;
    }
}

TEST(Manual, HasNoLineThatIsARequestByChance) {
    const std::set<std::string> requests = {".TH", ".nh", ".ad", ".SH", ".TP", ".PP", ".B", ".I", ".BR", ".nf", ".fi"};
    for (const CliCommand& verb : all_commands()) {
        std::istringstream page(grafverif({"manual", verb.name}).out);
        for (std::string line; std::getline(page, line);) {
            EXPECT_FALSE(line.starts_with('\'')) << verb.name << ": " << line;
            if (line.starts_with('.')) {
                EXPECT_TRUE(requests.contains(line.substr(0, line.find(' ')))) << verb.name << ": " << line;
            }
        }
    }
}

TEST(Completion, ContainsEachCommandAndOptionForEachShell) {
    for (const char* shell : {"bash", "zsh", "fish"}) {
        const std::string script = grafverif({"completion", shell}).out;
        for (const CliCommand& verb : all_commands()) {
            SCOPED_TRACE(shell + (" " + verb.name));
            EXPECT_NE(script.find(verb.name), std::string::npos);
            for (const OptionText& option : option_texts(verb)) {
                const std::string dashes = shell == std::string("fish") ? "-l " : "--";
                EXPECT_NE(script.find(dashes + option.name), std::string::npos) << option.name;
            }
        }
    }
}

TEST(Completion, RejectsUnknownShellsAndTheManualUnknownCommands) {
    const Result shell = grafverif({"completion", "tcsh"});
    EXPECT_EQ(shell.code, ExitCode::Input);
    EXPECT_NE(shell.err.find("invalid argument `tcsh` of `completion`; use one of `bash|zsh|fish`"), std::string::npos)
        << shell.err;
    const Result verb = grafverif({"manual", "chekc"});
    EXPECT_EQ(verb.code, ExitCode::Input);
    EXPECT_NE(verb.err.find("unknown command `chekc`"), std::string::npos) << verb.err;
}

}  // namespace
}  // namespace grafverif::app
