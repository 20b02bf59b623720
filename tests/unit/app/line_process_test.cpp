// SPDX-License-Identifier: MIT
// Tests dialogues with programs that follow the protocol, and with programs that violate it.
#include "app/system/line_process.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <thread>

#include "run_program.hpp"

namespace grafverif::app {
namespace {

using Kind = Reply::Kind;
using std::chrono::milliseconds;
using std::chrono::steady_clock;

LineProcessLimits with_short_timeout() { return {.response_timeout = milliseconds(150)}; }

TEST(LineProcess, EachLineGetsOneResponse) {
    {
        LineProcess dialogue("while read line; do echo \"<$line>\"; done", {});
        EXPECT_EQ(dialogue.request("a"), (Reply{Kind::Line, "<a>"}));
        EXPECT_EQ(dialogue.request("b c"), (Reply{Kind::Line, "<b c>"}));
    }
    EXPECT_TRUE(no_child());
}

TEST(LineProcess, SomeLinesHaveNoResponse) {
    LineProcess dialogue("while read line; do case $line in wait*) ;; *) echo \"$line\";; esac; done", {});
    dialogue.send("wait 5s");
    EXPECT_EQ(dialogue.request("a").text, "a");
}

TEST(LineProcess, LongLinesGoThroughBothWays) {
    const std::string line(300'000, 'x');
    LineProcess dialogue("cat", {.longest_line = 400'000});
    EXPECT_EQ(dialogue.request(line), (Reply{Kind::Line, line}));
}

TEST(LineProcess, EndOfTheProgramIsExplained) {
    struct Case {
        const char* command;
        const char* text;
    };
    for (const Case& c : {
             Case{"exit 3", "the controller exited with code 3"},
             Case{"read x; exit 0", "the controller exited with code 0"},
             Case{"echo why >&2; exit 1", "the controller exited with code 1; its error output: why"},
             Case{"kill -SEGV $$", "the controller was terminated by signal 11 (Segmentation fault)"},
             Case{"printf 1,0; exit 2", "the controller exited with code 2, after the incomplete line `1,0`"},
         }) {
        SCOPED_TRACE(c.command);
        {
            LineProcess dialogue(c.command, {});
            EXPECT_EQ(dialogue.request("a").kind, Kind::Ended);
            EXPECT_EQ(dialogue.end_text(), c.text);
            EXPECT_FALSE(dialogue.not_found());
        }
        EXPECT_TRUE(no_child());
    }
}

TEST(LineProcess, AProgramThatClosesItsOutputIsNotWaitedFor) {
    const auto start = steady_clock::now();
    {
        LineProcess dialogue("exec >&-; sleep 60", {});
        EXPECT_EQ(dialogue.request("a").kind, Kind::Ended);
        EXPECT_EQ(dialogue.end_text(), "the controller closed its output");
    }
    EXPECT_LT(steady_clock::now() - start, std::chrono::seconds(20));
    EXPECT_TRUE(no_child());
}

TEST(LineProcess, DistinguishesAMissingProgramFromAFailingOne) {
    LineProcess dialogue("/nowhere/at/all", {});
    EXPECT_EQ(dialogue.request("a").kind, Kind::Ended);
    EXPECT_TRUE(dialogue.not_found());
}

TEST(LineProcess, SilentProgramsAreTerminatedAfterTheTimeout) {
    const auto start = steady_clock::now();
    for (const char* command :
         {"sleep 60", "sleep 60 & sleep 60", "trap '' TERM; sleep 60 & wait; sleep 60", "read x; printf 1; sleep 60"}) {
        SCOPED_TRACE(command);
        {
            LineProcess dialogue(command, with_short_timeout());
            EXPECT_EQ(dialogue.request("a").kind, Kind::Silent);
        }
        EXPECT_TRUE(no_child());
    }
    EXPECT_LT(steady_clock::now() - start, std::chrono::seconds(30));
}

TEST(LineProcess, ProgramThatNeverReadsDoesNotBlockTheCaller) {
    LineProcess dialogue("sleep 60", with_short_timeout());
    EXPECT_EQ(dialogue.request(std::string(1'000'000, '1')).kind, Kind::Silent);
}

TEST(LineProcess, ExcessiveOutputIsTruncated) {
    LineProcess many("yes", {});
    EXPECT_EQ(many.request("a"), (Reply{Kind::Flood, "y"}));
    LineProcess two("while read line; do echo 1; echo 2; done", {});
    Kind kind = two.request("a").kind;
    for (int k = 0; k < 100 && kind == Kind::Line; ++k) {  // the second line may arrive later
        std::this_thread::sleep_for(milliseconds(20));
        kind = two.request("a").kind;
    }
    EXPECT_EQ(kind, Kind::Flood);
    LineProcess endless("read x; tr '\\0' x < /dev/zero", {});
    const Reply answer = endless.request("a");
    EXPECT_EQ(answer.kind, Kind::Flood);
    EXPECT_LT(answer.text.size(), 200'000u);
}

TEST(LineProcess, ExcessiveErrorOutputIsTruncated) {
    LineProcess dialogue("head -c 3000000 /dev/zero | tr '\\0' x >&2; echo >&2; echo last words >&2; exit 1", {});
    EXPECT_EQ(dialogue.request("a").kind, Kind::Ended);
    EXPECT_EQ(dialogue.end_text(), "the controller exited with code 1; its error output: last words");
}

TEST(LineProcess, StopsWaitingOnRequest) {
    const std::atomic<bool> stop = true;
    LineProcess dialogue("sleep 60", {.stop = &stop});
    EXPECT_EQ(dialogue.request("a").kind, Kind::Stopped);
}

TEST(LineProcess, SignalHandlersAreRestored) {
    void (*const before)(int) = std::signal(SIGPIPE, SIG_DFL);
    {
        LineProcess dialogue("exit 0", {});
        dialogue.request("a");
        dialogue.request("b");  // the program writes into a pipe without a reader
    }
    EXPECT_EQ(std::signal(SIGPIPE, before), SIG_DFL);
}

}  // namespace
}  // namespace grafverif::app
