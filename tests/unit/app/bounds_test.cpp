// SPDX-License-Identifier: MIT
// Tests the limits of a run for every command on input that exceeds them: `--timeout`, `--max-memory`, Ctrl-C, and
// memory that the system refuses. The tests measure processor time of the program, which does not depend on the load of
// the machine.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/system/watchdog.hpp"
#include "support/test_size.hpp"
#include "unit/app/run_program.hpp"

namespace grafverif::app {
namespace {

using Json = nlohmann::json;
using namespace std::chrono_literals;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;  // the sanitizer itself uses additional memory and time
#else
constexpr bool sanitized = false;
#endif

struct Ended {
    int code = -1, signal = 0;
    double seconds = 0;         ///< processor time
    std::size_t mebibytes = 0;  ///< peak resident memory
    std::string out = {}, err = {};
};

struct Setting {
    std::optional<std::size_t> address_space = {};  ///< bytes, as set by `ulimit -v`
    std::optional<double> interrupt_after = {};     ///< seconds of processor time
};

double processor_seconds(pid_t child) {
    std::ifstream stat("/proc/" + std::to_string(child) + "/stat");
    std::string text((std::istreambuf_iterator<char>(stat)), {});
    std::istringstream fields(text.substr(std::min(text.size(), text.rfind(')') + 1)));
    std::string skipped;
    for (int i = 0; i < 11; ++i) fields >> skipped;
    double user = 0, system = 0;
    fields >> user >> system;
    return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

/// Runs the program in a separate process, as a user starts it, with a standard input that never
/// ends.
Ended run_bounded(const Folder& folder, std::vector<std::string> arguments, const Setting& setting) {
    arguments.insert(arguments.begin(), GRAFVERIF_PROGRAM);
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    const std::string out = folder.file("out"), err = folder.file("err");
    int silent[2] = {};
    if (::pipe2(silent, O_CLOEXEC) != 0) return {};
    const pid_t child = ::fork();
    if (child == 0) {
        const int to_out = ::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600),
                  to_err = ::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        ::dup2(silent[0], STDIN_FILENO);
        ::dup2(to_out, STDOUT_FILENO);
        ::dup2(to_err, STDERR_FILENO);
        if (setting.address_space) {
            const rlimit limit{*setting.address_space, *setting.address_space};
            ::setrlimit(RLIMIT_AS, &limit);
        }
        ::execv(pointers[0], pointers.data());
        ::_exit(127);
    }
    int status = 0;
    rusage used = {};
    bool requested = false;
    const auto deadline = std::chrono::steady_clock::now() + 120s;
    while (::wait4(child, &status, WNOHANG, &used) == 0) {
        if (setting.interrupt_after && !requested && processor_seconds(child) >= *setting.interrupt_after)
            requested = ::kill(child, SIGINT) == 0;
        if (std::chrono::steady_clock::now() > deadline) ::kill(child, SIGKILL);
        std::this_thread::sleep_for(5ms);
    }
    ::close(silent[0]);
    ::close(silent[1]);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
    };
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1,
            WIFSIGNALED(status) ? WTERMSIG(status) : 0,
            seconds(used.ru_utime) + seconds(used.ru_stime),
            static_cast<std::size_t>(used.ru_maxrss) / 1024,
            folder.read("out"),
            folder.read("err")};
}

/// Returns a loop whose chart is a single ring. The second scan violates the first property of the loop.
std::string ring(std::size_t steps) {
    std::string text = "grafcet ring {\n    input a, b;\n    output O;\n";
    for (std::size_t i = 0; i < steps; ++i)
        text += (i == 0 ? "    initial step " : "    step ") + std::to_string(i) + " { O; }\n";
    for (std::size_t i = 0; i < steps; ++i)
        text += "    transition t" + std::to_string(i) + ": " + std::to_string(i) + " -> " +
                std::to_string((i + 1) % steps) + (i % 2 == 0 ? " when a;\n" : " when b;\n");
    return text +
           "}\n\nclosed_loop l {\n    controller ring;\n    environment A = push_button(OUT = a);\n"
           "    environment B = push_button(OUT = b);\n    property early: never X1;\n    property late: never X" +
           std::to_string(steps - 1) + ";\n}\n";
}

/// Returns a ring of steps as a Sequential Function Chart.
std::string sequence(std::size_t steps) {
    std::string text =
        "PROGRAM p\nVAR_INPUT\n a : BOOL;\nEND_VAR\nVAR_OUTPUT\n O : BOOL;\nEND_VAR\nINITIAL_STEP S0:\n "
        "O(N);\nEND_STEP\n";
    for (std::size_t i = 1; i < steps; ++i) text += "STEP S" + std::to_string(i) + ":\n O(N);\nEND_STEP\n";
    for (std::size_t i = 0; i < steps; ++i)
        text += "TRANSITION FROM S" + std::to_string(i) + " TO S" + std::to_string((i + 1) % steps) +
                " := a;\nEND_TRANSITION\n";
    return text + "END_PROGRAM\n";
}

/// Inputs that no command can process within a second.
struct Inputs {
    Folder folder = {};
    std::string chart = folder.write("ring.grafcet", ring(300'000));
    std::string foreign = folder.write("sequence.txt", sequence(200'000));

    std::vector<std::vector<std::string>> commands() const {
        return {{"fmt", chart},
                {"draw", chart},
                {"equations", chart},
                {"st", chart},
                {"import", foreign},
                {"check", chart},
                {"check", chart, "--untimed"},
                {"analyse", chart},
                {"report", chart},
                {"automaton", chart},
                {"mealy", chart},
                {"testgen", chart},
                {"nusmv", chart},
                {"uppaal", chart},
                {"pins", chart},
                {"build", chart, "-o", folder.file("build"), "--create-dirs"},
                {"simulate", chart},
                {"plc", chart},
                {"test", chart, "--against", "cat"}};
    }
    /// Returns every `nth` command, or all commands if larger randomized tests are requested.
    std::vector<std::vector<std::string>> some_commands(std::size_t nth, std::size_t from) const {
        std::vector<std::vector<std::string>> some, all = commands();
        for (std::size_t i = test_size(1) > 1 ? 0 : from; i<all.size(); i += test_size(1)> 1 ? 1 : nth)
            some.push_back(all[i]);
        return some;
    }
};

std::vector<std::string> with(std::vector<std::string> command, const std::vector<std::string>& more) {
    command.insert(command.end(), more.begin(), more.end());
    return command;
}

/// Checks the output of a run that a limit has ended: a message of one line, the right exit code, and no partial
/// output.
void expect_bounded(const Ended& ended, const std::string& why) {
    EXPECT_EQ(ended.signal, 0);
    EXPECT_EQ(ended.code, 3) << ended.err;
    EXPECT_NE(ended.err.find(why), std::string::npos) << ended.err;
    EXPECT_EQ(ended.out, "");
}

TEST(Bounds, EveryCommandKeepsTheTimeLimit) {
    const Inputs inputs;
    for (const std::vector<std::string>& command : inputs.commands()) {
        if (command.front() == "test") continue;  // the limit of this command applies to one response
        SCOPED_TRACE(command.front());
        const Ended ended = run_bounded(inputs.folder, with(command, {"--timeout", "100ms"}), {});
        expect_bounded(ended, "[stopped]");
        EXPECT_LT(ended.seconds, 0.1 * 1.1 + 0.5 + 0.3);
        EXPECT_FALSE(fs::exists(inputs.folder.file("build")));
    }
}

TEST(Bounds, EveryCommandEndsOnInterrupt) {
    const Inputs inputs;
    for (const std::vector<std::string>& command : inputs.some_commands(3, 1)) {
        SCOPED_TRACE(command.front());
        const double at_work = sanitized ? 1 : 0.1;  // by this time, the program handles the signal
        const Ended ended = run_bounded(inputs.folder, command, {.interrupt_after = at_work});
        expect_bounded(ended, "[stopped]");
        EXPECT_NE(ended.err.find("Ctrl-C"), std::string::npos) << ended.err;
        EXPECT_LT(ended.seconds, at_work + 0.5 + 0.4);
    }
}

TEST(Bounds, EveryCommandKeepsTheMemoryLimit) {
    const Inputs inputs;
    for (const std::vector<std::string>& command : inputs.some_commands(2, 0)) {
        SCOPED_TRACE(command.front());
        const Ended ended = run_bounded(inputs.folder, with(command, {"--max-memory", "20M"}), {});
        expect_bounded(ended, "[out-of-memory]");
        if (!sanitized) {
            EXPECT_LT(ended.mebibytes, 22 + 32 + 16);
        }
    }
}

TEST(Bounds, RefusedMemoryIsReportedWithoutASignal) {
    if (sanitized) GTEST_SKIP() << "sanitizers reserve more address space than the limit";
    const Inputs inputs;
    for (const std::vector<std::string>& command : inputs.some_commands(2, 1)) {
        SCOPED_TRACE(command.front());
        expect_bounded(run_bounded(inputs.folder, command, {.address_space = std::size_t{80} << 20U}),
                       "[out-of-memory]");
    }
}

/// Returns the property `name` from the output of `check`.
Json property(const Ended& ended, const std::string& name) {
    const Json report = Json::parse(ended.out, nullptr, false);
    if (report.is_discarded()) ADD_FAILURE() << "not JSON: " << ended.out << ended.err;
    else
        for (const Json& each : report["properties"])
            if (each["name"] == name) return each;
    return {};
}

TEST(Bounds, ResultsSoFarAreReported) {
    const Folder folder;
    // The chart has many timers and buttons, and therefore too many states for any limit of time or memory.
    std::string text = "grafcet g {\n    input a";
    for (int i = 0; i < 60; ++i) text += ", b" + std::to_string(i);
    text +=
        ";\n    output O;\n    initial step 0 { O; }\n    step 1;\n    transition t: 0 -> 1 when a;\n    transition u: "
        "1 -> 0 when 1000s/X1;\n}\n"
        "closed_loop l {\n    controller g;\n    environment A = push_button(OUT = a);\n";
    for (int i = 0; i < 60; ++i)
        text += "    environment B" + std::to_string(i) + " = push_button(OUT = b" + std::to_string(i) + ");\n";
    const std::string chart =
        folder.write("g.grafcet", text + "    property early: never X1;\n    property late: never X0 && X1;\n}\n");
    const std::vector<std::string> command = {"check", chart,     "--monolithic",           "--format",
                                              "json",  "--junit", folder.file("report.xml")};
    const auto expect_partial = [&](const Ended& ended, const std::string& why) {
        SCOPED_TRACE(why);
        EXPECT_EQ(ended.code, 1) << ended.err;  // an unexpected verdict takes precedence over unknown ones
        EXPECT_EQ(property(ended, "early")["verdict"], "violated") << ended.err;
        EXPECT_EQ(property(ended, "late")["verdict"], "unknown");
        EXPECT_NE(property(ended, "late")["reason"].dump().find(why), std::string::npos) << ended.out;
        EXPECT_NE(folder.read("report.xml").find("</testsuites>"), std::string::npos);
    };
    const Ended late = run_bounded(folder, with(command, {"--timeout", "2s"}), {});
    expect_partial(late, "stopped");
    EXPECT_LT(late.seconds, 2 * 1.1 + 0.5 + 0.3);
    expect_partial(run_bounded(folder, command, {.interrupt_after = 0.5}), "stopped");
    expect_partial(run_bounded(folder, with(command, {"--max-memory", "50M"}), {}), "memory");
    if (!sanitized) expect_partial(run_bounded(folder, command, {.address_space = std::size_t{100} << 20U}), "memory");
}

TEST(Bounds, EndlessPrintingEndsAfterTheTimeLimit) {
    int written[2] = {};
    ASSERT_EQ(::pipe2(written, O_CLOEXEC), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(written[1], STDERR_FILENO);
        const Watchdog guard({.timeout = 100ms, .timed_out = "too late\n"});
        work_is_done();
        volatile std::uint64_t printed = 0;
        for (;;) printed = printed + 1;
    }
    ::close(written[1]);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 3);
    char text[16] = {};
    EXPECT_EQ(::read(written[0], text, sizeof text), 9);
    EXPECT_STREQ(text, "too late\n");
    ::close(written[0]);
}

TEST(Bounds, LimitBeyondTheRangeOfTheClockIsIgnored) {
    const Folder folder;
    const std::string chart = folder.write("g.grafcet", ring(2));
    for (const char* time : {"106751991167h", "2562047788015h", "18446744073709551615ms"}) {
        const Ended ended =
            run_bounded(folder, {"check", chart, "--timeout", time, "--max-memory", "17179869183G"}, {});
        EXPECT_EQ(ended.code, 1) << time << ended.out << ended.err;
        EXPECT_NE(ended.out.find("violated"), std::string::npos) << ended.out;
    }
    EXPECT_EQ(grafverif({"check", chart, "--timeout", "99999999999999999999h"}).code, ExitCode::Input);
}

TEST(Bounds, WorkGrowsLinearlyWithTheInput) {
    // If the input is twice as large, the program must need about twice the time. Four times the time would indicate a
    // quadratic algorithm.
    const Folder folder;
    const auto seconds = [&](const std::string& text, const std::vector<std::string>& command, std::size_t at) {
        std::vector<std::string> whole = command;
        whole.insert(whole.begin() + 1, folder.write("c" + std::to_string(at) + ".grafcet", text));
        return run_bounded(folder, whole, {}).seconds;
    };
    const auto lone = [](std::size_t steps) { return ring(steps).substr(0, ring(steps).find("closed_loop")); };
    const auto many = [](std::size_t buttons) {
        std::string text = "grafcet v {\n", loop = "}\nclosed_loop l {\n    controller v;\n";
        for (std::size_t i = 0; i < buttons; ++i) {
            const std::string n = std::to_string(i);
            text += "    input a" + n + ";\n";
            loop += "    environment A" + n + " = push_button(OUT = a" + n + ");\n";
        }
        return text + "    output O;\n    initial step 0 { O; }\n" + loop + "}\n";
    };
    struct Case {
        std::string small = {}, large = {};
        std::vector<std::string> command = {};
    };
    for (const Case& c : {Case{lone(4'000), lone(16'000), {"check", "--timeout", "0s"}},
                          Case{many(1'000), many(4'000), {"simulate", "--random", "1", "--steps", "2"}}}) {
        SCOPED_TRACE(c.command.front());
        const double small = seconds(c.small, c.command, 1), large = seconds(c.large, c.command, 2);
        EXPECT_LT(large, 10 * (small + 0.05)) << small;
    }
}

}  // namespace
}  // namespace grafverif::app
