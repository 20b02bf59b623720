// SPDX-License-Identifier: MIT
// Tests that output files are complete or unchanged, regardless of obstacles, failures and concurrent runs.
#include "pipeline/files.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <system_error>
#include <thread>

#include "app/system/write_files.hpp"
#include "run_program.hpp"

namespace {

/// The number of the call that fails, among the counted calls; 0 means that no call fails. If `fail_on`, all later
/// calls fail too.
std::atomic<int> fail_at = 0, calls = 0;
std::atomic<bool> fail_on = false;

bool fails(int error) {
    if (fail_at == 0) return false;
    const int call = ++calls;
    if (fail_on ? call < fail_at : call != fail_at) return false;
    errno = error;
    return true;
}

}  // namespace

// These functions replace functions of the C library.
extern "C" {
int renameat(int from, const char* old_name, int to, const char* new_name) noexcept {
    return fails(EIO) ? -1 : static_cast<int>(::syscall(SYS_renameat, from, old_name, to, new_name));
}
int linkat(int from, const char* old_name, int to, const char* new_name, int flags) noexcept {
    return fails(EPERM) ? -1 : static_cast<int>(::syscall(SYS_linkat, from, old_name, to, new_name, flags));
}
int fsync(int file) { return fails(EIO) ? -1 : static_cast<int>(::syscall(SYS_fsync, file)); }
int fchmod(int file, mode_t mode) noexcept {
    return fails(EPERM) ? -1 : static_cast<int>(::syscall(SYS_fchmod, file, mode));
}
ssize_t write(int file, const void* text, size_t size) {
    return fails(ENOSPC) ? -1 : static_cast<ssize_t>(::syscall(SYS_write, file, text, size));
}
int mkdir(const char* path, mode_t mode) noexcept {
    return fails(ENOSPC) ? -1 : static_cast<int>(::syscall(SYS_mkdir, path, mode));
}
}

namespace grafverif::app {
namespace {

TEST(WriteFiles, OverwritesNothingThroughALinkPreparedForItsDraft) {
    const Folder folder;
    folder.write("victim", "precious");
    fs::create_symlink(folder.file("victim"), folder.file("out." + std::to_string(::getpid()) + ".part"));
    write_files({{folder.file("out"), "text"}});
    EXPECT_EQ(folder.read("victim"), "precious");
    EXPECT_EQ(folder.read("out"), "text");
}

TEST(WriteFiles, FollowsLinksWithoutTarget) {
    const Folder folder;
    fs::create_directories(folder.file("far/away"));
    folder.write("far/there", "old");
    fs::create_symlink("far/there", folder.file("link"));
    fs::create_symlink("link", folder.file("chain"));
    fs::create_symlink("far/away/new", folder.file("dangling"));
    fs::create_symlink("loop", folder.file("loop"));
    write_files({{folder.file("chain"), "new"}, {folder.file("dangling"), "made"}});
    EXPECT_EQ(folder.read("far/there"), "new");
    EXPECT_EQ(folder.read("far/away/new"), "made");
    for (const char* link : {"link", "chain", "dangling"}) EXPECT_TRUE(fs::is_symlink(folder.file(link))) << link;
    EXPECT_THROW(write_files({{folder.file("loop"), "text"}}), std::system_error);
}

TEST(WriteFiles, KeepsPermissionsAndReplacesNothingThatMayNotBeWritten) {
    const Folder folder;
    fs::permissions(folder.write("secret", "old"), fs::perms(0640));
    write_files({{folder.file("secret"), "new"}});
    EXPECT_EQ(fs::status(folder.file("secret")).permissions(), fs::perms(0640));
    if (::geteuid() == 0) GTEST_SKIP() << "root can write to every file";
    fs::permissions(folder.file("secret"), fs::perms(0440));
    EXPECT_THROW(write_files({{folder.file("secret"), "newer"}}), std::system_error);
    EXPECT_EQ(folder.read("secret"), "new");
}

/// Returns the content of the folder, sorted by name.
std::string state(const Folder& folder) {
    std::vector<std::string> parts;
    for (const auto& entry : fs::recursive_directory_iterator(folder.file("")))
        parts.push_back(
            fs::relative(entry.path(), folder.file("")).string() + "=" +
            (entry.is_directory() ? "" : folder.read(fs::relative(entry.path(), folder.file("")).string())));
    std::ranges::sort(parts);
    std::string text;
    for (const std::string& part : parts) text += part + "\n";
    return text;
}

/// Runs `work` repeatedly in a folder with files, and lets a different call fail in each run. The repetition ends when
/// a run contains no further call. `look` receives the folder, and true if `work` threw an exception.
template <class Work, class Look>
int with_each_call_failing(const Work& work, const Look& look) {
    int failures = 0;
    for (int k = 1;; ++k) {
        SCOPED_TRACE(k);
        const Folder folder;
        fs::create_directory(folder.file("b"));
        folder.write("one", "old 1");
        folder.write("b/two", "old 2");
        const std::string before = state(folder);
        calls = 0;
        fail_at = k;
        bool thrown = false;
        try {
            work(folder);
        } catch (const std::system_error&) {
            thrown = true;
        }
        fail_at = 0;
        look(folder, before, thrown);
        failures += thrown ? 1 : 0;
        if (calls < k) return failures;  // there are no more calls that can fail
    }
}

std::vector<OutputFile> set_of(const Folder& folder) {
    return {{folder.file("one"), "new 1"},
            {folder.file("three"), "new 3"},
            {folder.file("b/two"), "new 2"},
            {folder.file("c/d/four"), "new 4"}};
}

TEST(WriteFiles, SetIsWrittenCompletelyOrNotAtAllIfAnyCallFails) {
    const int failures = with_each_call_failing(
        [](const Folder& folder) { write_files(set_of(folder)); },
        [](const Folder& folder, const std::string& before, bool thrown) {
            if (thrown) EXPECT_EQ(state(folder), before);
            else EXPECT_EQ(state(folder), "b/two=new 2\nb=\nc/d/four=new 4\nc/d=\nc=\none=new 1\nthree=new 3\n");
        });
    EXPECT_GE(failures, 14);
}

TEST(WriteFiles, SingleFileIsReplacedOrKeptIfAnyCallFails) {
    for (const char* name : {"one", "three", "b/two"}) {
        SCOPED_TRACE(name);
        const int failures = with_each_call_failing(
            [&](const Folder& folder) {
                write_files({{folder.file(name), "new"}});
            },
            [&](const Folder& folder, const std::string& before, bool thrown) {
                if (thrown) EXPECT_EQ(state(folder), before);
                else EXPECT_EQ(folder.read(name), "new");
            });
        EXPECT_GE(failures, 4);
    }
}

TEST(WriteFiles, FilesAreKeptIfAllLaterCallsFail) {
    fail_on = true;
    for (const bool single : {true, false})
        with_each_call_failing(
            [&](const Folder& folder) {
                const std::vector<OutputFile> set = set_of(folder);
                write_files(single ? std::vector{set.front()} : set);
            },
            [](const Folder& folder, const std::string&, bool) {
                for (const auto& [name, number] : {std::pair("one", "1"), std::pair("b/two", "2")}) {
                    const std::string text = folder.read(name);
                    EXPECT_TRUE(text == std::string("old ") + number || text == std::string("new ") + number)
                        << name << ": " << text;
                }
            });
    fail_on = false;
}

TEST(Mutate, AStateFileThatCannotBeWrittenIsAnErrorAndTheOldOneStays) {
    const Folder folder;
    const std::string file = folder.write("c.grafcet",
                                          "grafcet c { input a; output L; initial step 0; step 1 { L; } transition t: "
                                          "0 -> 1 when a; transition u: 1 -> 0 "
                                          "when !a; }\n");
    const std::vector<std::string> arguments = {"mutate", file, "--limit", "1", "--state", folder.file("state")};
    fail_on = true;
    std::size_t refused = 0, with_results = 0;
    for (int k = 1;; ++k) {
        folder.write("state", "");
        calls = 0;
        fail_at = k;
        const Result result = grafverif(arguments);
        fail_at = 0;
        if (calls < k) break;
        EXPECT_EQ(result.code, ExitCode::Input) << k;
        EXPECT_NE(result.err.find("cannot write `"), std::string::npos) << result.err;
        EXPECT_EQ(folder.read("state").find_first_not_of('{'), folder.read("state").empty() ? std::string::npos : 1U);
        ++refused;
        with_results += result.out.empty() ? 0U : 1U;
    }
    fail_on = false;
    EXPECT_GT(refused, with_results);
    EXPECT_GT(with_results, 0U) << "results are printed even if they cannot be stored";
    EXPECT_EQ(folder.entries(), 2U);
}

TEST(WriteFiles, RemovesOnlyTheRemainsOfKilledRuns) {
    const Folder folder;
    folder.write(".grafverif-0123456789abcdef.part", "draft");
    for (const char* mine : {".grafverif-config", ".grafverif-0123456789abcdeg.part",
                             "x.grafverif-0123456789abcdef.part", ".grafverif-0123456789abcdef.part~"})
        folder.write(mine, "mine");
    fs::create_symlink("nowhere", folder.file(".grafverif-aaaaaaaaaaaaaaaa.part"));
    write_files({{folder.file("out"), "text"}});
    EXPECT_FALSE(fs::exists(folder.file(".grafverif-0123456789abcdef.part")));
    EXPECT_EQ(folder.entries(), 6u) << state(folder);
}

TEST(WriteFiles, OfConcurrentRunsOneCompleteSetRemains) {
    const Folder folder;
    fs::create_directory(folder.file("b"));
    std::vector<std::thread> runs;
    for (int run = 0; run < 4; ++run)
        runs.emplace_back([&folder, run] {
            for (int k = 0; k < 10; ++k) {
                const std::string tag = std::to_string(run) + "." + std::to_string(k);
                std::vector<OutputFile> set{
                    {folder.file("one"), tag}, {folder.file("b/two"), tag}, {folder.file("three"), tag}};
                if (run % 2 != 0) std::ranges::reverse(set);
                write_files(set);
            }
        });
    for (std::thread& run : runs) run.join();
    EXPECT_EQ(folder.read("one"), folder.read("b/two"));
    EXPECT_EQ(folder.read("one"), folder.read("three"));
    EXPECT_EQ(folder.entries(), 4u) << state(folder);
}

TEST(WriteFiles, WritesDirectlyToDevicesAndPipes) {
    const Folder folder;
    ASSERT_EQ(::mkfifo(folder.file("pipe").c_str(), 0600), 0);
    std::string received;
    std::thread reader([&] { received = folder.read("pipe"); });
    write_files({{folder.file("pipe"), std::string(200'000, 'x')}, {"/dev/null", "gone"}});
    reader.join();
    EXPECT_EQ(received.size(), 200'000u);
    EXPECT_TRUE(fs::is_fifo(folder.file("pipe")));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    EXPECT_THROW(write_files({{"/dev/full", "text"}}), std::system_error);
}

const std::string door = (root / "samples/oven_door/oven_door.grafcet").string();

TEST(Outputs, StandardOutputHasSeveralNames) {
    const std::string equations = grafverif({"equations", door}).out;
    for (const char* name : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"})
        EXPECT_EQ(grafverif({"equations", door, "-o", name}).out, equations) << name;
    EXPECT_EQ(grafverif({"equations", door, "-o", "/dev/stderr"}).err, equations);
}

TEST(Outputs, ThatAreInputsOfTheSameRunAreRejected) {
    const Folder folder;
    const std::string part =
        "grafcet part { input x; output L; initial step 0; step 1 { L; } transition t: 0 -> 1 when x; transition u: 1 "
        "-> 0 when !x; }\n";
    const std::string main = folder.write("main.grafcet", "include \"part.grafcet\";\n");
    folder.write("part.grafcet", part);
    folder.write("pairs.csv", "variable1,variable2,reason\n");
    fs::create_symlink("main.grafcet", folder.file("link"));
    fs::create_hard_link(folder.file("part.grafcet"), folder.file("twin"));
    fs::create_directory(folder.file("d"));
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"equations", main, "-o", main},
             {"equations", main, "-o", folder.file("d/../main.grafcet")},
             {"equations", main, "-o", folder.file("link")},
             {"equations", folder.file("link"), "-o", main},
             {"equations", main, "-o", folder.file("part.grafcet")},
             {"equations", main, "-o", folder.file("twin")},
             {"check", main, "--junit", main},
             {"check", main, "--trace-vcd", folder.file("twin")},
             {"fmt", main, "-o", main},
             {"analyse", main, "--exclusions", folder.file("pairs.csv"), "-o", folder.file("pairs.csv")},
         }) {
        SCOPED_TRACE(arguments.back());
        const std::string before = state(folder);
        const Result result = grafverif(arguments);
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_NE(result.err.find("[output-is-input]"), std::string::npos) << result.err;
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(state(folder), before);
    }
    EXPECT_EQ(grafverif({"fmt", main, "-i"}).code, ExitCode::Done);
}

TEST(Outputs, OfOneRunAreDifferentFiles) {
    const Folder folder;
    folder.write("there", "");
    fs::create_hard_link(folder.file("there"), folder.file("twin"));
    fs::create_symlink("nowhere", folder.file("link"));
    for (const auto& [one, other] : {std::pair("new", "new"), std::pair("there", "twin"), std::pair("link", "nowhere"),
                                     std::pair("new", "./new")}) {
        SCOPED_TRACE(other);
        const std::string before = state(folder);
        const Result result =
            grafverif({"check", door, "--junit", folder.file(one), "--trace-svg", folder.file(other)});
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_NE(result.err.find("[output-twice]"), std::string::npos) << result.err;
        EXPECT_EQ(state(folder), before);
    }
    EXPECT_NE(grafverif({"check", door, "--quiet", "--junit", "/dev/null", "--trace-svg", "/dev/null"}).code,
              ExitCode::Input);
}

TEST(ReadFile, AcceptsOnlyRegularFilesAndNeverBlocks) {
    const Folder folder;
    ASSERT_EQ(::mkfifo(folder.file("pipe").c_str(), 0600), 0);
    fs::create_symlink("pipe", folder.file("link"));
    std::string why;
    for (const auto& [path, reason] :
         {std::pair(folder.file("pipe"), "the path is a pipe, not a file"),
          std::pair(folder.file("link"), "the path is a pipe, not a file"),
          std::pair(folder.file(""), "the path is a folder"),
          std::pair(std::string("/dev/zero"), "the path is a device, not a file"),
          std::pair(folder.file("none"), "no such file"), std::pair(folder.file("none/deeper"), "no such file")}) {
        EXPECT_EQ(content_of_file(path, why), std::nullopt);
        EXPECT_EQ(why, reason) << path;
    }
}

// -- includes ---------------------------------------------------------------------------------------------------------

std::string chart(const std::string& name) {
    return "grafcet " + name +
           " { input x; output L; initial step 0; step 1 { L; } transition t: 0 -> 1 when x; transition u: 1 -> 0 when "
           "!x; }\n";
}

TEST(FilesBelow, SkipsKernelFileSystemsAndStopsOnRequest) {
    const Folder folder;
    folder.write("one.grafcet", "");
    std::size_t most = 100;
    EXPECT_EQ(files_below(folder.file(""), ".grafcet", most).files.size(), 1u);
    EXPECT_GT(most, 90u);
    EXPECT_TRUE(files_below("/proc", "", most).files.empty());
    EXPECT_GT(most, 90u);
    const std::atomic<bool> stop = true;
    EXPECT_TRUE(files_below(folder.file(""), ".grafcet", most, &stop).files.empty());
    EXPECT_EQ(most, 0u) << "the search was incomplete";
}

TEST(Include, FileWithSeveralPathsIsReadOnce) {
    const Folder folder;
    for (const char* link : {"a", "b"}) fs::create_symlink(".", folder.file(link));
    constexpr int files = 40;  // 2^40 include paths lead to the last file
    for (int k = 0; k < files; ++k) {
        const std::string next = "f" + std::to_string(k + 1) + ".grafcet\";\n";
        folder.write("f" + std::to_string(k) + ".grafcet", "include \"a/" + next + "include \"b/" + next);
    }
    folder.write("f" + std::to_string(files) + ".grafcet", chart("last"));
    const Result result = grafverif({"equations", folder.file("f0.grafcet")});
    EXPECT_EQ(result.code, ExitCode::Done) << result.err;
    folder.write("self.grafcet", "include \"a/self.grafcet\";\n");
    EXPECT_NE(grafverif({"equations", folder.file("self.grafcet")}).err.find("[include-cycle]"), std::string::npos);
}

TEST(Include, PipesDevicesAndFoldersAreRejected) {
    const Folder folder;
    ASSERT_EQ(::mkfifo(folder.file("pipe").c_str(), 0600), 0);
    fs::create_directory(folder.file("folder"));
    for (const auto& [name, reason] :
         {std::pair("pipe", "the path is a pipe"), std::pair("folder", "the path is a folder"),
          std::pair("none", "no such file"), std::pair("/nowhere/at/all", "no such file")}) {
        const std::string main = folder.write("main.grafcet", "include \"" + std::string(name) + "\";\n");
        const Result result = grafverif({"equations", main});
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_NE(result.err.find(reason), std::string::npos) << result.err;
    }
    EXPECT_NE(grafverif({"equations", folder.file("pipe")}).err.find("the path is a pipe"), std::string::npos);
    const std::string main = folder.write("main.grafcet", "include \"/dev/zero\";\n");
    EXPECT_NE(grafverif({"equations", main, "-I", "/dev"}).err.find("the path is a device"), std::string::npos);
}

/// Changes the current folder for the lifetime of the object.
class Standing {
public:
    explicit Standing(const fs::path& folder) : before_(fs::current_path()) { fs::current_path(folder); }
    ~Standing() { fs::current_path(before_); }
    Standing(const Standing&) = delete;
    Standing& operator=(const Standing&) = delete;

private:
    fs::path before_;
};

TEST(Include, ReachIsTheSameFromEveryFolder) {
    const Folder folder;
    fs::create_directories(folder.file("project/charts/deep"));
    folder.write("project/parts.grafcet", chart("part"));
    folder.write("outside.grafcet", chart("outside"));
    folder.write("project/charts/main.grafcet", "include \"../parts.grafcet\";\n");
    folder.write("project/charts/far.grafcet", "include \"../../outside.grafcet\";\n");
    const auto codes = [&](const std::string& name, const std::vector<std::string>& options = {}) {
        std::vector<ExitCode> found;
        for (const char* from : {"", "project", "project/charts", "project/charts/deep"}) {
            const Standing standing(folder.file(from));
            for (const fs::path& path : {fs::path(folder.file("project/charts/" + name)),
                                         fs::relative(folder.file("project/charts/" + name))}) {
                std::vector<std::string> arguments{"equations", path.string()};
                arguments.insert(arguments.end(), options.begin(), options.end());
                found.push_back(grafverif(arguments).code);
            }
        }
        return found;
    };
    const std::vector<ExitCode> fine(8, ExitCode::Done), refused(8, ExitCode::Input);
    EXPECT_EQ(codes("main.grafcet"), refused);
    for (const char* mark : {"project/.git", "project/grafverif.project"}) {
        folder.write(mark, "");
        EXPECT_EQ(codes("main.grafcet"), fine) << mark;
        EXPECT_EQ(codes("far.grafcet"), refused) << mark;
        fs::remove(folder.file(mark));
    }
    EXPECT_EQ(codes("main.grafcet", {"-I", folder.file("project")}), fine);
    EXPECT_EQ(codes("far.grafcet", {"-I", folder.file("project"), "-I", folder.file("")}), fine);
    fs::create_directory_symlink(folder.file(""), folder.file("project/charts/way_out"));
    folder.write("project/charts/link.grafcet", "include \"way_out/outside.grafcet\";\n");
    EXPECT_EQ(codes("link.grafcet"), refused) << "links are resolved before the check";
}

TEST(Include, FoldersOfTheCommandLineAreLookedInNext) {
    const Folder folder;
    for (const char* name : {"main", "one", "two"}) fs::create_directory(folder.file(name));
    folder.write("one/part.grafcet", chart("of_one"));
    folder.write("two/part.grafcet", chart("of_two"));
    const std::string main = folder.write("main/main.grafcet", "include \"part.grafcet\";\n");
    const auto found = [&](const std::vector<std::string>& options) {
        std::vector<std::string> arguments{"fmt", main};
        arguments = {"st", main, "--format", "text"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const std::string out = grafverif(arguments).out;
        for (const char* name : {"of_one", "of_two", "beside"})
            if (out.find(name) != std::string::npos) return std::string(name);
        return std::string("none");
    };
    EXPECT_EQ(found({}), "none");
    EXPECT_EQ(found({"-I", folder.file("one"), "-I", folder.file("two")}), "of_one");
    EXPECT_EQ(found({"-I", folder.file("two"), "-I", folder.file("one")}), "of_two");
    folder.write("main/part.grafcet", chart("beside"));
    EXPECT_EQ(found({"-I", folder.file("two")}), "beside");
    EXPECT_NE(grafverif({"st", main, "-I", folder.file("none")}).err.find("[cannot-read]"), std::string::npos);
}

TEST(Include, TheMainFileMayComeFromStandardInput) {
    const Folder folder;
    folder.write("part.grafcet", chart("part"));
    const Standing standing(folder.file(""));
    for (const char* name : {"-", "/dev/stdin"})
        EXPECT_EQ(grafverif({"equations", name}, chart("typed")).code, ExitCode::Done) << name;
    const Result included = grafverif({"equations", "-"}, "include \"part.grafcet\";\n");
    EXPECT_EQ(included.code, ExitCode::Done) << included.err;
    EXPECT_NE(grafverif({"equations", "-"}, "grafcet").err.find("<standard input>:1:"), std::string::npos);
}

TEST(Within, RestrictsMainFilesAndIncludedFiles) {
    const Folder folder;
    folder.write("outside.grafcet", chart("outside"));
    fs::create_directory(folder.file("inside"));
    folder.write("inside/fine.grafcet", chart("fine"));
    folder.write("inside/includes.grafcet", "include \"../outside.grafcet\";\n");
    fs::create_symlink("../outside.grafcet", folder.file("inside/link.grafcet"));
    const auto drawn = [&](const std::string& name, const std::string& input = "") {
        return grafverif({"draw", name, "-I", folder.file(""), "--within", folder.file("inside")}, input);
    };
    EXPECT_EQ(drawn(folder.file("inside/fine.grafcet")).code, ExitCode::Done);
    EXPECT_EQ(drawn("-", chart("typed")).code, ExitCode::Done);
    fs::create_symlink("../missing.grafcet", folder.file("inside/dangling.grafcet"));
    for (const char* name : {"outside.grafcet", "missing.grafcet", "inside/link.grafcet", "inside/includes.grafcet",
                             "inside/missing/../link.grafcet", "inside/dangling.grafcet"})
        EXPECT_NE(drawn(folder.file(name)).err.find("outside the permitted folders"), std::string::npos) << name;
    EXPECT_EQ(grafverif({"draw", folder.file("inside/fine.grafcet"), "--within", folder.file("none")}).code,
              ExitCode::Input);
}

}  // namespace
}  // namespace grafverif::app
