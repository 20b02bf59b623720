// SPDX-License-Identifier: MIT
// Checks that every diagnostic code has a test: tests/diagnostics/<code>[-n].grafcet.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "repository/files.hpp"

namespace grafverif::repository {
namespace {

namespace fs = std::filesystem;

/// Returns the codes in src/support/messages*.cpp: the first string of each error(...) or warning(...).
std::set<std::string> codes() {
    static const std::regex pattern(R"re((?:error|warning)\(\s*"([a-z0-9-]+)")re");
    std::string text;
    for (const auto& entry : fs::directory_iterator(root / "src/support"))
        if (entry.path().filename().string().starts_with("messages")) text += text_of(entry.path());
    std::set<std::string> found;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
        found.insert((*match)[1]);
    return found;
}

/// Codes whose test needs more than a chart: files that are missing, are too large or cannot be written, options of the
/// command line, programs that are not installed, and restrictions of one target. The tests in unit_app check these
/// codes.
const std::set<std::string> of_the_world = {"cannot-read",       "cannot-write",       "too-large",
                                            "no-closed-loop",    "no-such-choice",     "ambiguous-choice",
                                            "not-expressible",   "bad-sequence",       "not-in-structured-text",
                                            "cannot-run",        "nothing-to-test",    "stopped",
                                            "out-of-memory",     "bound-reached",      "nothing-to-import",
                                            "left-out",          "missing-program",    "cure-left-out",
                                            "output-is-input",   "output-twice",       "cannot-listen",
                                            "missing-folder",    "not-in-depfile",     "not-comparable",
                                            "beyond-32-bits",    "not-a-state-file",   "other-format",
                                            "threads-refused",   "not-in-program",     "recursive-unit",
                                            "program-too-large", "unbounded-loop",     "no-program",
                                            "several-programs",  "bad-property",       "deprecated-option",
                                            "not-standard",      "cycle-without-time", "undocumented-reading",
                                            "bad-log",           "unrecorded",         "no-faults",
                                            "not-in-c"};

TEST(Repository, EveryDiagnosticHasATest) {
    const std::set<std::string> all = codes();
    ASSERT_GT(all.size(), 30u);
    std::set<std::string> shown;
    static const std::regex bracketed(R"re(\[([a-z0-9-]+)\])re");
    for (const auto& entry : fs::directory_iterator(root / "tests/diagnostics")) {
        if (entry.path().extension() != ".expected") continue;
        const std::string text = text_of(entry.path());
        for (std::sregex_iterator match(text.begin(), text.end(), bracketed), end; match != end; ++match)
            shown.insert((*match)[1]);
    }
    for (const std::string& code : all)
        EXPECT_TRUE(shown.contains(code) || of_the_world.contains(code))
            << "no file in tests/diagnostics reports `" << code << '`';
}

}  // namespace
}  // namespace grafverif::repository
