// SPDX-License-Identifier: MIT
// Tests the program as a process with little memory, with memory filled with garbage, or with an interruption, for
// every command on samples. The program must end with one of its exit codes or by the signal that was sent, and its
// files must be complete.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <csignal>
#include <map>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <random>

#include "app/system/process.hpp"
#include "support/test_size.hpp"
#include "unit/app/run_program.hpp"

namespace grafverif::app {
namespace {

using Words = std::vector<std::string>;
using std::chrono::steady_clock;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;  // the memory of a sanitized program cannot be limited
#else
constexpr bool sanitized = false;
#endif

const std::string tanks = (root / "samples/tanks/tanks.grafcet").string();
const std::string blinker = (root / "samples/blinker/blinker.grafcet").string();

/// Returns command lines of most commands. Each of them takes at most some seconds. FOLDER stands for an output folder.
const std::vector<Words>& verbs() {
    static const std::vector<Words> all{
        {"fmt", tanks},
        {"import", tanks},
        {"draw", tanks},
        {"equations", tanks, "--format", "latex"},
        {"components"},
        {"uppaal", blinker},
        {"nusmv", tanks},
        {"nusmv", blinker, "--plant", "automata"},
        {"build", blinker, "-o", "FOLDER/models", "--create-dirs"},
        {"st", tanks},
        {"analyse", tanks, "--format", "json"},
        {"check", blinker, "--format", "json", "--junit", "FOLDER/report.xml"},
        {"check", tanks, "--untimed", "--format", "json"},
        {"check", blinker, "--untimed", "--plant", "automata"},
        {"report", blinker, "-o", "FOLDER/report.html"},
        {"automaton", tanks, "--counts"},
        {"mealy", tanks, "--counts"},
        {"testgen", tanks, "-o", "FOLDER/test.csv"},
        {"simulate", blinker, "--random", "1", "--steps", "200"},
        {"plc", tanks},
        {"compare", tanks, tanks},
        {"mutate", blinker, "--limit", "2", "--state", "FOLDER/state.jsonl"},
        {"supervise", blinker},
        {"aiger", blinker},
        {"btor2", blinker},
        {"pins", blinker},
        {"test", tanks, "--cover", "locations", "--against", std::string(GRAFVERIF_PROGRAM) + " plc " + tanks},
    };
    return all;
}

Words with(Words before, const Words& words, const Folder& folder) {
    before.emplace_back(GRAFVERIF_PROGRAM);
    for (const std::string& word : words)
        before.push_back(word.starts_with("FOLDER") ? folder.file(word.substr(7)) : word);
    return before;
}

ProgramResult ran(const Words& words) {
    return run_program(words, "0,0,0,1,1\n1,1,0,1,1\nwait 3s\n0,0,1,0,0\n",
                       {.deadline = steady_clock::now() + std::chrono::seconds(120)});
}

/// Returns `text` without the parts that differ from run to run, namely the path of the folder and all numbers.
std::string comparable(std::string text, const Folder& folder) {
    for (const std::string& place : {folder.file("")})
        for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place))
            text.erase(at, place.size());
    std::string result;
    for (std::size_t at = 0; at < text.size(); ++at)
        if (std::isdigit(static_cast<unsigned char>(text[at])) == 0 && text[at] != '.' && text[at] != '-' &&
            text[at] != 'e')
            result += text[at];
    return result;
}

TEST(Memory, FilledWithGarbageChangesNothing) {
    for (const Words& verb : verbs()) {
        SCOPED_TRACE(verb[0]);
        std::string seen;
        for (const char* filling : {"MALLOC_PERTURB_=0", "MALLOC_PERTURB_=191", "MALLOC_PERTURB_=85"}) {
            const Folder folder;
            const ProgramResult result = ran(with({"/usr/bin/env", filling}, verb, folder));
            ASSERT_EQ(result.end, ProgramResult::End::Exited) << filling << '\n' << result.err;
            ASSERT_LE(result.status, 3) << result.err;
            const std::string now = std::to_string(result.status) + comparable(result.out + result.err, folder);
            if (seen.empty()) seen = now;
            EXPECT_EQ(now, seen) << filling;
        }
    }
}

/// Returns a command that runs the program in an address space of `kilobytes`.
Words within(std::size_t kilobytes) {
    return {"/bin/sh", "-c", fmt::format("ulimit -v {}; exec \"$0\" \"$@\"", kilobytes)};
}

TEST(Memory, ThatIsShortEndsTheProgramByAnExitCode) {
    if (sanitized) GTEST_SKIP() << "sanitizers need more address space than the limits allow";
    const Folder folder;
    std::size_t least = 8192;  // the program does not start with less memory
    while (ran(with(within(least), {"--version"}, folder)).status != 0) least += 1024;
    const std::string large = (root / "samples/testing_station/testing_station.grafcet").string();
    std::vector<Words> runs = verbs();
    runs.insert(runs.end(), {{"check", large},
                             {"check", large, "--untimed"},
                             {"analyse", large},
                             {"automaton", large, "--counts"},
                             {"check", large, "--untimed", "--engine", "bmc", "--timeout", "2s"},
                             {"check", large, "--untimed", "--engine", "auto", "--timeout", "2s"}});
    std::mt19937 random(7);
    for (int k = 0; k < test_size(1); ++k)
        for (const Words& verb : runs) {
            const std::size_t limit = least + random() % 40'000;
            SCOPED_TRACE(fmt::format("ulimit -v {}; grafverif {}", limit, fmt::join(verb, " ")));
            Words words = with(within(limit), verb, folder);
            const ProgramResult result = ran(words);
            EXPECT_EQ(result.end, ProgramResult::End::Exited) << "signal " << result.status << '\n' << result.err;
            EXPECT_LE(result.status, 3) << result.err;
        }
}

TEST(Memory, OfASmallStackIsEnough) {
    if (sanitized) GTEST_SKIP() << "sanitizers need a large stack";
    const Folder folder;
    for (const std::string limits : {"ulimit -s 2048", "ulimit -s 512", "ulimit -s 2048 -v 1000000"}) {
        SCOPED_TRACE(limits);
        for (const Words& verb : {Words{"--version"}, Words{"check", blinker}}) {
            const ProgramResult result = ran(with({"/bin/bash", "-c", limits + "; exec \"$0\" \"$@\""}, verb, folder));
            EXPECT_EQ(result.end, ProgramResult::End::Exited) << "signal " << result.status << '\n' << result.err;
            EXPECT_EQ(result.status, 0) << result.err;
        }
    }
}

TEST(Memory, HasNoErrorsUnderValgrind) {
    if (sanitized) GTEST_SKIP() << "valgrind does not support sanitizers";
    const auto valgrind = find_program("valgrind");
    if (!valgrind) GTEST_SKIP() << "valgrind is not installed";
    const Folder folder;
    const std::string chart =
        folder.write("pulse.grafcet",
                     "grafcet pulse { input a; output TICK; initial step 1; step 2 { TICK; }\n"
                     "transition t1: 1 -> 2 when 5s/X1 || a; transition t2: 2 -> 1 when true; }\n"
                     "closed_loop l { controller pulse; environment A = free(OUT = a); property p: reachable X2; }\n");
    const std::vector<Words> all{{"testgen", chart},
                                 {"check", chart, "--untimed"},
                                 {"check", chart},
                                 {"analyse", chart},
                                 {"st", chart},
                                 {"build", chart, "-o", "FOLDER/models", "--create-dirs"},
                                 {"simulate", chart, "--random", "1"}};
    for (std::size_t k = 0; k < all.size() && static_cast<int>(k) < test_size(1); ++k) {
        const ProgramResult result =
            ran(with({valgrind->string(), "-q", "--error-exitcode=99", "--max-stackframe=8000000"}, all[k], folder));
        EXPECT_EQ(result.end, ProgramResult::End::Exited);
        EXPECT_NE(result.status, 99) << all[k][0] << '\n' << result.err;
    }
}

/// Checks that the program imports no function that opens a connection or starts a shell: `serve` only accepts
/// connections.
TEST(Program, ConnectsToNoNetworkAndStartsNoShell) {
    if (sanitized) GTEST_SKIP() << "sanitizers import additional functions";
    const auto nm = find_program("nm");
    if (!nm) GTEST_SKIP() << "nm is not installed";
    const ProgramResult listed = run_program({nm->string(), "-D", "--undefined-only", GRAFVERIF_PROGRAM}, "",
                                             {.deadline = steady_clock::now() + std::chrono::seconds(60)});
    ASSERT_NE(listed.out.find(" U kill@"), std::string::npos) << "nm lists no imports:\n" << listed.out << listed.err;
    for (const char* call :
         {"connect", "getaddrinfo", "gethostbyname", "sendto", "system", "popen", "wordexp", "dlopen"})
        EXPECT_EQ(listed.out.find(std::string(" U ") + call + "@"), std::string::npos) << call;
}

/// Returns the duration of the command without an interruption.
std::chrono::duration<double> usual(const Words& verb) {
    const Folder folder;
    const auto start = steady_clock::now();
    ran(with({}, verb, folder));
    return steady_clock::now() - start;
}

TEST(Kill, AtAnyTimeLeavesNoPartialFile) {
    const Folder folder;
    const std::string lamps =
        folder.write("lamps.grafcet",
                     "grafcet lamps { input a; output o; initial step 1; step 2 { o; }\n"
                     "transition t1: 1 -> 2 when a; transition t2: 2 -> 1 when !a; }\n"
                     "closed_loop blinker_loop { controller lamps; environment A = free(OUT = a); }\n");
    const Words before{"build", lamps, "-o", "FOLDER/models", "--create-dirs"},
        after{"build", blinker, "-o", "FOLDER/models", "--create-dirs"};
    ran(with({}, after, folder));
    std::map<std::string, std::string> fresh, old;
    for (const auto& entry : fs::directory_iterator(folder.file("models")))
        fresh[entry.path().filename()] = folder.read("models/" + entry.path().filename().string());
    ASSERT_EQ(fresh.size(), 3U);
    ran(with({}, before, folder));
    for (const auto& [name, content] : fresh) old[name] = folder.read("models/" + name);
    ASSERT_TRUE(fresh != old);
    const double whole = usual(after).count();
    std::mt19937 random(11);
    for (int k = 0; k < test_size(30); ++k) {
        const double moment = whole * 1.3 * static_cast<double>(random() % 1000) / 1000;
        SCOPED_TRACE(moment);
        ran(with({"/usr/bin/timeout", "-s", "KILL", fmt::format("{:.4f}", moment + 0.0005)},
                 k % 2 == 0 ? after : before, folder));
        for (const auto& [name, content] : fresh) {
            const std::string now = folder.read("models/" + name);
            EXPECT_TRUE(now == content || now == old[name]) << name << ":\n" << now;
        }
    }
    ran(with({}, after, folder));
    for (const auto& [name, content] : fresh) EXPECT_EQ(folder.read("models/" + name), content);
}

TEST(Signals, EndEveryCommandAtAnyTime) {
    std::mt19937 random(13);
    for (const Words& verb : verbs()) {
        const double whole = std::min(usual(verb).count(), 5.0);
        for (const auto& [name, number] :
             {std::pair("INT", SIGINT), std::pair("TERM", SIGTERM), std::pair("HUP", SIGHUP)})
            for (int k = 0; k < test_size(1); ++k) {
                const double moment = whole * static_cast<double>(random() % 1000) / 1000;
                SCOPED_TRACE(fmt::format("{} by {} after {} s", verb[0], name, moment));
                const Folder folder;
                const ProgramResult result = ran(with({"/usr/bin/timeout", "--preserve-status", "-k", "60", "-s", name,
                                                       fmt::format("{:.4f}", moment + 0.0005)},
                                                      verb, folder));
                ASSERT_EQ(result.end, ProgramResult::End::Exited) << result.err;
                EXPECT_TRUE(result.status <= 3 || result.status == 128 + number) << result.status << '\n' << result.err;
                const bool json = std::ranges::find(verb, "json") != verb.end();
                EXPECT_TRUE(!json || result.status > 3 || nlohmann::json::accept(result.out)) << result.out;
                const std::string report = folder.read("report.xml");
                EXPECT_TRUE(report.empty() || pugi::xml_document().load_buffer(report.data(), report.size())) << report;
            }
    }
}

/// Returns the output of a shell that runs `commands` in the folder. `$P` is the program.
ProgramResult in_shell(const Folder& folder, const std::string& commands) {
    return run_program({"/bin/sh", "-c", "P='" GRAFVERIF_PROGRAM "'\n" + commands}, "",
                       {.deadline = steady_clock::now() + std::chrono::seconds(120), .folder = folder.file("")});
}

TEST(Init, RejectsInvalidNamesAndWritesNothingWithoutPermission) {
    const Folder folder;
    for (const char* name : {"../up", "a/b", "/abs", ".", "..", "-x", "--", "a b", "step", "7", "caf\xC3\xA9", "a\nb",
                             "$(reboot)", "\x1b[31m", ""}) {
        SCOPED_TRACE(name);
        const ProgramResult result = run_program({GRAFVERIF_PROGRAM, "init", name}, "", {.folder = folder.file("")});
        EXPECT_EQ(result.status, 2) << result.out;
        EXPECT_NE(result.err.find("error"), std::string::npos);
        EXPECT_EQ(result.err.find('\x1b'), std::string::npos);
        EXPECT_EQ(folder.entries(), 0U);
    }
    EXPECT_EQ(run_program({GRAFVERIF_PROGRAM, "init", std::string(5000, 'a')}, "", {.folder = folder.file("")}).status,
              2);
    const ProgramResult nowhere = run_program({GRAFVERIF_PROGRAM, "init", "press"}, "", {.folder = "/proc"});
    EXPECT_EQ(nowhere.status, 2);
    EXPECT_NE(nowhere.err.find("[cannot-write]"), std::string::npos) << nowhere.err;
}

TEST(Init, TwoConcurrentRunsLeaveOneCompleteProjectAndOverwriteNothing) {
    const Folder folder;
    const ProgramResult both = in_shell(folder,
                                        "export HOME=/proc/no/such/home\n"
                                        "$P init press >one 2>&1 & $P init press >two 2>&1\nwait\n"
                                        "cd press && $P check press.grafcet -q; echo $?");
    EXPECT_TRUE(both.out.ends_with("0\n")) << both.out << both.err;
    EXPECT_EQ(folder.entries(), 8U) << "a folder, its five files and two outputs";
    const std::string mine = "// mine\n";
    folder.write("press/press.grafcet", mine);
    fs::remove(folder.file("press/CMakeLists.txt"));
    EXPECT_EQ(in_shell(folder, "$P init press").status, 2);
    EXPECT_EQ(folder.read("press/press.grafcet"), mine);
    EXPECT_FALSE(fs::exists(folder.file("press/CMakeLists.txt"))) << "if one file exists, no file is written";
}

/// Four processes of `watch` have unreadable or invalid input, and two others run concurrently on one file. All six
/// processes end on request.
TEST(Watch, SurvivesUnreadableInputAndLeavesNoProcesses) {
    const Folder folder;
    folder.write("lamp.grafcet",
                 "grafcet lamp { input a; output o; initial step 1 { o; } transition t: 1 -> 1 when a; }\n");
    folder.write("broken.grafcet", std::string(100'000, '{'));
    fs::create_directory(folder.file("folder.grafcet"));
    std::ofstream(folder.file("huge.grafcet")).close();
    fs::resize_file(folder.file("huge.grafcet"), std::uintmax_t{1} << 30U);
    const ProgramResult result = in_shell(
        folder,
        "export HOME=/proc/no/such/home\nn=0; for f in missing.grafcet broken.grafcet folder.grafcet huge.grafcet "
        "lamp.grafcet lamp.grafcet\ndo n=$((n+1)); $P watch draw $f -o drawn.svg >out 2>err$n & pids=\"$pids "
        "$!\"\ndone\n"
        "for i in 1 2 3 4 5 6; do while ! grep -q 'watching' err$i; do sleep 0.05; done; done\n"
        "cat err1 err2 err3 err4 | grep -c 'exit code 2'; grep -c 'exit code 0' err5 err6\n"
        "kill -TERM $pids; for p in $pids; do wait $p; echo $?; done");
    EXPECT_EQ(result.out, "4\nerr5:1\nerr6:1\n0\n0\n0\n0\n0\n0\n") << result.err;
    EXPECT_TRUE(folder.read("drawn.svg").ends_with("</svg>\n"));
}

TEST(Watch, RejectsCommandsThatItCannotRepeat) {
    const Folder folder;
    for (const Words& words : std::vector<Words>{{"check", "-"},
                                                 {"chekc", "a.grafcet"},
                                                 {"serve", "a.grafcet"},
                                                 {"edit", "a.grafcet"},
                                                 {"lsp", "x"},
                                                 {"watch", "check", "a.grafcet"},
                                                 {"components", "x"},
                                                 {"check", "a.grafcet", "--nonsense"},
                                                 {"check", "a.grafcet", "--timeout", "5"}}) {
        std::vector<std::string> call = {GRAFVERIF_PROGRAM, "watch"};
        call.insert(call.end(), words.begin(), words.end());
        const ProgramResult result = run_program(call, "", {.folder = folder.file("")});
        EXPECT_EQ(result.status, 2) << words[0] << result.err;
        EXPECT_NE(result.err.find("; see `grafverif watch --help`"), std::string::npos) << result.err;
    }
}

}  // namespace
}  // namespace grafverif::app
