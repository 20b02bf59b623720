// SPDX-License-Identifier: MIT
// Tests calls of external programs with the real operating system. The external programs are shell scripts.
#include "app/system/process.hpp"

#include <gtest/gtest.h>

#include <system_error>

#include "unit/app/run_program.hpp"

namespace grafverif::app {
namespace {

using End = ProgramResult::End;
using std::chrono::milliseconds;
using std::chrono::steady_clock;

ProgramResult shell(const std::string& script, const std::string& input = "", const ProgramLimits& limits = {}) {
    return run_program({"/bin/sh", "-c", script}, input, limits);
}

TEST(Process, OutputErrorAndExitCodeAreSeparate) {
    EXPECT_EQ(shell("echo out; echo err >&2; exit 3"), (ProgramResult{End::Exited, 3, "out\n", "err\n"}));
}

TEST(Process, ArgumentsReachTheProgramAsTheyAre) {
    EXPECT_EQ(run_program({"/bin/echo", "a b", "$HOME", "*;"}, "", {}).out, "a b $HOME *;\n");
}

TEST(Process, TheInputIsReadToItsEnd) {
    const std::string input(300'000, 'x');
    EXPECT_EQ(shell("cat", input).out, input);
    EXPECT_EQ(shell("exit 0", input).status, 0) << "a program need not read its input";
}

TEST(Process, SignalIsDistinguishedFromAnExitCode) {
    EXPECT_EQ(shell("kill -TERM $$"), (ProgramResult{End::Signalled, 15, "", ""}));
}

TEST(Process, DeadlineEndsTheProgramAndItsChildren) {
    const auto start = steady_clock::now();
    const ProgramResult result = shell("echo begun; sleep 60 & sleep 60", "", {.deadline = start + milliseconds(200)});
    EXPECT_EQ(result.end, End::TimedOut);
    EXPECT_EQ(result.out, "begun\n");
    EXPECT_LT(steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(Process, InterruptEndsTheProgram) {
    const std::atomic<bool> stop = true;
    EXPECT_EQ(shell("sleep 60", "", {.stop = &stop}).end, End::Stopped);
}

TEST(Process, OutputWithoutEndIsCut) {
    const ProgramResult result = shell("yes", "", {.max_output = 1000});
    EXPECT_EQ(result.end, End::TooMuchOutput);
    EXPECT_LT(result.out.size(), 200'000U);
}

TEST(Process, BackgroundProgramDoesNotBlockTheCaller) {
    const auto start = steady_clock::now();
    EXPECT_EQ(shell("sleep 60 & echo done").out, "done\n");
    EXPECT_LT(steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(Process, FailureToStartIsAnError) { EXPECT_THROW(run_program({"/does/not/exist"}, "", {}), std::system_error); }

TEST(Process, ProgramsAreFoundOnThePathIfTheyCanBeRun) {
    const Folder first, second;
    first.write("tool", "not a program");
    fs::permissions(second.write("tool", "#!/bin/sh\n"), fs::perms::owner_all);
    const Path path(fs::path(first.file("")).string() + "::" + fs::path(second.file("")).string());
    EXPECT_EQ(find_program("tool"), fs::path(second.file("tool")));
    EXPECT_EQ(find_program("no_such_tool"), std::nullopt);
    EXPECT_EQ(find_program(""), std::nullopt);
    EXPECT_EQ(find_program(first.file("tool")), std::nullopt) << "the file is not executable";
    EXPECT_EQ(find_program(second.file("tool")), fs::path(second.file("tool")));
}

TEST(Process, TemporaryFolderIsRemovedWithItsObject) {
    fs::path path;
    {
        const TemporaryFolder folder;
        path = folder.path();
        std::ofstream(path / "model.xml") << "text";
        EXPECT_TRUE(fs::exists(path / "model.xml"));
    }
    EXPECT_FALSE(fs::exists(path));
}

}  // namespace
}  // namespace grafverif::app
