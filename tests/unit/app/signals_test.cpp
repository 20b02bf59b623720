// SPDX-License-Identifier: MIT
// Tests signals while external programs run. The program must end as after Ctrl-C, and all processes of external
// programs must end.
#include <fcntl.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <thread>

#include "app/system/child.hpp"
#include "app/system/interrupt.hpp"
#include "app/system/process.hpp"
#include "pipeline/descriptor.hpp"
#include "run_program.hpp"

namespace grafverif::app {
namespace {

using std::chrono::steady_clock;

/// Returns a script that writes its process id and those of its children to `pids`, leaves its group and session, and
/// never ends.
std::string endless(const std::string& pids) {
    return "note() { echo $$ >> '" + pids +
           "'; }; note\n"
           "setsid sh -c 'echo $$ >> \"" +
           pids + "\"; setsid sh -c \"echo \\$\\$ >> \\\"" + pids +
           "\\\"; exec sleep 1000\" & sleep 1000' &\n"
           "trap '' TERM HUP INT\n"
           "while :; do sleep 1000; done\n";
}

bool waited_for(const std::function<bool()>& what) {
    const auto end = steady_clock::now() + std::chrono::seconds(60);
    while (!what() && steady_clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return what();
}

std::vector<pid_t> pids_in(const Folder& folder) {
    std::istringstream text(folder.read("pids"));
    return {std::istream_iterator<pid_t>(text), {}};
}

struct Outcome {
    std::optional<ChildEnd> end = {};
    std::string out = {};
};

/// Runs the program and sends it `signal` once three processes have written their ids.
Outcome ended_by(int signal, std::vector<std::string> arguments, const Folder& folder) {
    const Descriptor out(::open(folder.file("out").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
    arguments.insert(arguments.begin(), GRAFVERIF_PROGRAM);
    Child program(arguments, {out.number(), out.number(), out.number()});
    EXPECT_TRUE(waited_for([&] { return pids_in(folder).size() == 3; })) << folder.read("out");
    program.send(signal);
    EXPECT_TRUE(waited_for([&] { return program.ended().has_value(); }));
    for (const pid_t pid : pids_in(folder)) EXPECT_NE(::kill(pid, 0), 0) << "process " << pid << " still exists";
    return {program.ended(), folder.read("out")};
}

constexpr std::array all_signals = {SIGINT, SIGTERM, SIGHUP};

TEST(Signals, EndAnEngineAndItsChildProcesses) {
    for (const int signal : all_signals) {
        SCOPED_TRACE(::strsignal(signal));
        const Folder folder;
        fs::create_directory(folder.file("tmp"));
        const Variable tmp("TMPDIR", folder.file("tmp"));
        fs::permissions(folder.write("verifyta", "#!/bin/sh\n" + endless(folder.file("pids"))), fs::perms::owner_all);
        const Variable path("PATH", folder.file("") + ":/usr/bin:/bin");
        const Outcome outcome = ended_by(
            signal,
            {"check", station, "--engine", "verifyta", "--format", "json", "--junit", folder.file("report.xml")},
            folder);
        ASSERT_TRUE(outcome.end);
        EXPECT_FALSE(outcome.end->by_signal);
        EXPECT_EQ(outcome.end->status, 3);
        EXPECT_EQ(nlohmann::json::parse(outcome.out)["properties"].size(), 4u);
        pugi::xml_document report;
        EXPECT_TRUE(report.load_file(folder.file("report.xml").c_str()));
        EXPECT_EQ(report.select_nodes("//testcase").size(), 4u);
        EXPECT_TRUE(fs::is_empty(folder.file("tmp")));
    }
}

TEST(Signals, EndAControllerUnderTestAndItsChildProcesses) {
    const std::string two_tanks = (root / "samples/tanks/tanks.grafcet").string();
    for (const int signal : all_signals) {
        SCOPED_TRACE(::strsignal(signal));
        const Folder folder;
        const Outcome outcome = ended_by(signal,
                                         {"test", two_tanks, "--against", endless(folder.file("pids")), "--format",
                                          "json", "--junit", folder.file("report.xml")},
                                         folder);
        ASSERT_TRUE(outcome.end);
        EXPECT_FALSE(outcome.end->by_signal);
        EXPECT_EQ(outcome.end->status, 3);
        EXPECT_TRUE(nlohmann::json::accept(outcome.out)) << outcome.out;
        pugi::xml_document report;
        EXPECT_TRUE(report.load_file(folder.file("report.xml").c_str()));
    }
}

/// The test reads the report slowly. A high load of the machine has the same effect.
TEST(Signals, LeaveASlowlyReadReportComplete) {
    const Folder folder;
    fs::create_directory(folder.file("tmp"));
    const Variable tmp("TMPDIR", folder.file("tmp"));
    fs::permissions(folder.write("verifyta", "#!/bin/sh\n" + endless(folder.file("pids"))), fs::perms::owner_all);
    const Variable path("PATH", folder.file("") + ":/usr/bin:/bin");
    Pipe out = make_pipe();
    const int capacity = ::fcntl(out.write.number(), F_SETPIPE_SZ, 4096);
    ASSERT_GT(capacity, 0);
    std::string text(static_cast<std::size_t>(capacity), ' ');
    ASSERT_EQ(::write(out.write.number(), text.data(), text.size()), capacity) << "the pipe is full";
    const Descriptor nothing(::open("/dev/null", O_RDWR | O_CLOEXEC));
    Child program({GRAFVERIF_PROGRAM, "check", station, "--engine", "verifyta", "--format", "json"},
                  {nothing.number(), out.write.number(), nothing.number()});
    out.write = Descriptor();
    EXPECT_TRUE(waited_for([&] { return pids_in(folder).size() == 3; }));
    program.send(SIGTERM);
    text.clear();
    // This is longer than the grace period after which the watchdog ends an interrupted run that is not printing, but
    // shorter than the watchdog's limit for a reader.
    std::this_thread::sleep_for(std::chrono::seconds(1));
    for (std::array<char, 4096> part;;) {
        const ssize_t count = ::read(out.read.number(), part.data(), part.size());
        if (count <= 0) break;
        text.append(part.data(), static_cast<std::size_t>(count));
    }
    EXPECT_TRUE(nlohmann::json::accept(text)) << text;
    EXPECT_TRUE(waited_for([&] { return program.ended().has_value(); }));
}

TEST(Signals, EndTheLanguageServerWithItsDrawings) {
    for (const int signal : all_signals) {
        SCOPED_TRACE(::strsignal(signal));
        const Folder folder;
        fs::create_directory(folder.file("tmp"));
        const Variable tmp("TMPDIR", folder.file("tmp"));
        Pipe in = make_pipe();
        const Descriptor out(::open(folder.file("out").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
        Child program({GRAFVERIF_PROGRAM, "lsp"}, {in.read.number(), out.number(), out.number()});
        const auto say = [&](const nlohmann::json& message) {
            const std::string body = message.dump();
            const std::string text = "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
            EXPECT_EQ(::write(in.write.number(), text.data(), text.size()), static_cast<ssize_t>(text.size()));
        };
        const std::string chart = "grafcet c { initial step 0; step 1; transition t: 0 -> 1 when true; }";
        say({{"id", 1}, {"method", "initialize"}, {"params", {{"capabilities", nlohmann::json::object()}}}});
        say({{"method", "textDocument/didOpen"},
             {"params", {{"textDocument", {{"uri", "file:///no/c"}, {"version", 1}, {"text", chart}}}}}});
        say({{"id", 2},
             {"method", "workspace/executeCommand"},
             {"params", {{"command", "grafverif.draw"}, {"arguments", {"file:///no/c"}}}}});
        EXPECT_TRUE(waited_for([&] { return folder.read("out").find("<svg") != std::string::npos; }))
            << folder.read("out");
        EXPECT_FALSE(fs::is_empty(folder.file("tmp"))) << "a drawing is kept for the browser";
        program.send(signal);
        EXPECT_TRUE(waited_for([&] { return program.ended().has_value(); }));
        ASSERT_TRUE(program.ended());
        EXPECT_EQ(program.ended()->status, 3);
        EXPECT_TRUE(fs::is_empty(folder.file("tmp")));
    }
}

TEST(Signals, ThatAreIgnoredStayIgnored) {
    EXPECT_EXIT(
        {
            std::signal(SIGHUP, SIG_IGN);
            const Interrupt interrupt;
            std::raise(SIGHUP);
            std::_Exit(interrupt.requested() ? 1 : 0);
        },
        testing::ExitedWithCode(0), "");
}

TEST(Signals, TheSecondOneEndsTheProgram) {
    EXPECT_EXIT(
        {
            const Interrupt interrupt;
            std::raise(SIGTERM);
            if (interrupt.requested()) std::cerr << "requested";
            std::raise(SIGHUP);
        },
        testing::KilledBySignal(SIGHUP), "requested");
}

TEST(Signals, WaitForUninterruptibleSections) {
    EXPECT_EXIT(
        {
            const SignalBlocker whole;
            std::raise(SIGTERM);
            std::cerr << "done";
        },
        testing::KilledBySignal(SIGTERM), "done");
}

TEST(Process, ChildOutsideItsGroupEndsWithItToo) {
    const Folder folder;
    const ProgramResult result = run_program(
        {"/bin/sh", "-c",
         "setsid setsid sh -c 'echo $$ > \"" + folder.file("pids") + "\"; exec sleep 1000' & while ! [ -s '" +
             folder.file("pids") + "' ]; do sleep 0.01; done; echo done"},
        "", {});
    EXPECT_EQ(result.out, "done\n");
    const std::vector<pid_t> pids = pids_in(folder);
    ASSERT_EQ(pids.size(), 1u);
    EXPECT_NE(::kill(pids[0], 0), 0);
    EXPECT_TRUE(no_child());
}

TEST(Process, EarlierChildProcessesAreNotAffected) {
    const pid_t other_child = ::fork();
    if (other_child == 0) {
        ::pause();
        std::_Exit(0);
    }
    EXPECT_EQ(run_program({"/bin/echo", "hello"}, "", {}).out, "hello\n");
    EXPECT_EQ(::waitpid(other_child, nullptr, WNOHANG), 0);
    ::kill(other_child, SIGKILL);
    ::waitpid(other_child, nullptr, 0);
}

TEST(TemporaryFolder, ThoseOfKilledRunsAreRemovedAndNoOthers) {
    const Folder folder;
    const Variable tmp("TMPDIR", folder.file(""));
    const TemporaryFolder alive;
    for (const char* name :
         {"grafverif-run-killed", "grafverif-run-nobody", "grafverif-run-longer-name", "grafverif-models"})
        fs::create_directory(folder.file(name));
    folder.write("grafverif-run-killed/.grafverif-run", "");
    folder.write("grafverif-run-killed/model.smv", "MODULE main");
    folder.write("grafverif-run-nobody/mine", "precious");
    { const TemporaryFolder next; }
    EXPECT_FALSE(fs::exists(folder.file("grafverif-run-killed")));
    EXPECT_TRUE(fs::exists(alive.path()));
    for (const char* name : {"grafverif-run-nobody/mine", "grafverif-run-longer-name", "grafverif-models"})
        EXPECT_TRUE(fs::exists(folder.file(name))) << name;
}

/// Names of folders that must be quoted in command lines and scripts.
const std::vector<std::string> odd_names = {"a b",        "it's", "\"",       "$HOME;*", "back\\slash",
                                            "line\nfeed", "-o",   "\xC3\xBC", "#"};

TEST(Engines, WorkWithAnyNameOfTheTemporaryFolder) {
    const Folder folder;
    const Variable path("PATH", folder.file("") + ":" + std::getenv("PATH"));
    fs::permissions(
        folder.write(
            "verifyta",
            "#!/bin/sh\ngrep -q '<!DOCTYPE nta' \"$1\" && grep -q . \"$2\" && echo ' -- Formula is satisfied.'\n"),
        fs::perms::owner_all);
    fs::permissions(folder.write("nuXmv",
                                 "#!/bin/sh\nread first < \"$2\"; file=$(sed -n 's/^read_model -i //p' \"$2\")\ngrep "
                                 "-q 'MODULE main' \"$file\" && echo found >&2\n"),
                    fs::perms::owner_all);
    const std::string two_tanks = (root / "samples/tanks/tanks.grafcet").string();
    for (const std::string& name : odd_names) {
        SCOPED_TRACE(name);
        const fs::path tmp = fs::path(folder.file("t")) / name;
        fs::create_directories(tmp);
        const Variable variable("TMPDIR", tmp.string());
        const Result timed = grafverif({"check", station, "--engine", "verifyta", "--property", "P14"});
        EXPECT_EQ(timed.code, ExitCode::Done) << timed.out << timed.err;
        const Result untimed = grafverif({"check", two_tanks, "--engine", "nuXmv"});
        EXPECT_NE(untimed.out.find("end of its output: found"), std::string::npos) << untimed.out;
        if (find_program("NuSMV")) {
            const Result real = grafverif({"check", two_tanks, "--engine", "NuSMV"});
            EXPECT_NE(real.out.find("2880 states"), std::string::npos) << real.out;
        }
        EXPECT_TRUE(fs::is_empty(tmp));
    }
}

}  // namespace
}  // namespace grafverif::app
