// SPDX-License-Identifier: MIT
// Tests the requirements of build systems on outputs: predictable names, dependency files, and no accidental files.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "app/depfile.hpp"
#include "app/options.hpp"
#include "run_program.hpp"

namespace grafverif::app {
namespace {

std::string loop(const std::string& name, const std::string& chart) {
    return "closed_loop " + name + " {\n    controller " + chart +
           ";\n    environment E = push_button(OUT = x);\n    property p: always true;\n}\n";
}
std::string chart(const std::string& name) {
    return "grafcet " + name +
           " { input x; output L; initial step 0; step 1 { L; } transition t: 0 -> 1 when x; transition u: 1 -> 0 when "
           "!x; }\n";
}

/// Returns the output of `command`, which a shell runs.
std::string printed(const std::string& command) {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
    std::string text;
    std::array<char, 4096> buffer = {};
    for (std::size_t got = 0; (got = std::fread(buffer.data(), 1, buffer.size(), pipe.get())) > 0;)
        text.append(buffer.data(), got);
    return text;
}

TEST(Depfile, NamesEveryFileReadAndEveryFileWritten) {
    const Folder folder;
    fs::create_directory(folder.file("lib"));
    folder.write("lib/deep.grafcet", chart("deep"));
    folder.write("part.grafcet", "include \"deep.grafcet\";\n");
    const std::string main =
        folder.write("main.grafcet", "include \"part.grafcet\";\ninclude \"part.grafcet\";\n" + loop("main", "deep"));
    const std::string out = folder.file("out");
    const Result result = grafverif({"build", main, "-I", folder.file("lib"), "-o", out, "--create-dirs", "--name", "m",
                                     "--depfile", out + "/m.d"});
    EXPECT_EQ(result.code, ExitCode::Done) << result.err;
    const std::string part = folder.file("part.grafcet"), deep = folder.file("lib/deep.grafcet");
    EXPECT_EQ(folder.read("out/m.d"), out + "/m.xml " + out + "/m.q " + out + "/m.smv: \\\n  " + main + " \\\n  " +
                                          part + " \\\n  " + deep + "\n\n" + main + ":\n\n" + part + ":\n\n" + deep +
                                          ":\n");
}

TEST(CCode, SpecialFileReceivesBothFiles) {
    const Folder folder;
    const std::string main = folder.write("main.grafcet", chart("c"));
    EXPECT_EQ(grafverif({"c", main, "-o", "/dev/null"}).code, ExitCode::Done);
    EXPECT_FALSE(fs::exists("/dev/null.h"));
}

TEST(Depfile, IsWrittenByEveryCommandThatWritesFiles) {
    const Folder folder;
    const std::string main = folder.write("main.grafcet", chart("c") + loop("l", "c"));
    const std::string pairs = folder.write("pairs.csv", "variable1,variable2,reason\n");
    const std::string out = folder.file("out"), depfile = folder.file("out.d");
    for (const char* verb : {"uppaal", "nusmv", "aiger", "btor2", "pins", "c", "draw", "equations", "report", "analyse",
                             "automaton", "mealy", "testgen", "st", "fmt"}) {
        SCOPED_TRACE(verb);
        fs::remove(depfile);
        EXPECT_EQ(grafverif({verb, main, "-o", out, "--depfile", depfile}).code, ExitCode::Done);
        const std::string second = verb == std::string("aiger") ? ".json" : verb == std::string("c") ? ".h" : "";
        const std::string outputs = second.empty() ? out : out + " " + out + second;
        EXPECT_TRUE(folder.read("out.d").starts_with(outputs + ": \\\n  " + main + "\n")) << folder.read("out.d");
    }
    EXPECT_EQ(grafverif({"analyse", main, "--exclusions", pairs, "-o", out, "--depfile", depfile}).code,
              ExitCode::Done);
    EXPECT_NE(folder.read("out.d").find(pairs), std::string::npos);
    EXPECT_EQ(grafverif({"check", main, "--junit", out, "--depfile", depfile, "--depfile-target", "stamp"}).code,
              ExitCode::Done);
    EXPECT_TRUE(folder.read("out.d").starts_with("stamp: \\\n"));
    fs::remove(depfile);
    EXPECT_EQ(grafverif({"check", main, "--depfile", depfile, "--depfile-target", "stamp"}).code, ExitCode::Done);
    EXPECT_TRUE(folder.read("out.d").starts_with("stamp: \\\n"));
}

TEST(Depfile, IsUnchangedIfNothingIsWritten) {
    const Folder folder;
    const std::string main = folder.write("main.grafcet", "grafcet broken {");
    folder.write("out.d", "before");
    EXPECT_EQ(grafverif({"uppaal", main, "-o", folder.file("out"), "--depfile", folder.file("out.d")}).code,
              ExitCode::Input);
    EXPECT_EQ(folder.read("out.d"), "before");
}

TEST(Depfile, IsRejectedIfItWouldBeEmpty) {
    const Folder folder;
    const std::string main = folder.write("main.grafcet", chart("c") + loop("l", "c"));
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"equations", main, "--depfile", "d"},
                                               {"equations", main, "-o", "-", "--depfile", "d"},
                                               {"check", main, "--depfile", "d"},
                                               {"equations", main, "--depfile-target", "d"}}) {
        const Result result = grafverif(arguments);
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_NE(result.err.find("`--depfile"), std::string::npos) << result.err;
    }
    EXPECT_NE(grafverif({"equations", main, "-o", folder.file("two\nlines"), "--depfile", folder.file("d")})
                  .err.find("[not-in-depfile]"),
              std::string::npos);
    EXPECT_FALSE(fs::exists(folder.file("two\nlines")));
    EXPECT_FALSE(fs::exists(folder.file("d")));
}

/// Returns names that contain every ASCII character in the middle, at the beginning and at the end, and backslashes
/// before some characters. The result contains only names that `reader` can represent on the given
/// side of the colon of a rule.
std::vector<std::string> hostile_names(DepfileSide side, DepfileReader reader) {
    std::vector<std::string> names = {"plain",   "$(x) y",   "a\\ b",  "a\\#b",    "a\\\\#b",     "a\\:b",
                                      "a\\$b",   "a\\\\$b",  "a\\*b",  "a\\%b",    "a\\|b",       "a\\\\ # $$b",
                                      "a[b]*?c", "(x86) %~", "a(b).c", "a = b%%c", "l'eau & co.", "\u00e9\u00e8 %"};
    for (char c = 1; c > 0; ++c)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '/' && c != '.')
            for (const std::string& name : {std::string("a") + c + "b", c + std::string("b"), std::string("a") + c})
                names.push_back(name);
    std::erase_if(names, [&](const std::string& name) { return !depfile_name(name, side, reader); });
    return names;
}

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
    return text;
}

TEST(Depfile, RejectsNamesThatItsReaderCannotRepresent) {
    using enum DepfileReader;
    const auto refused = [](DepfileSide side, DepfileReader reader) {
        std::string text;
        for (char c = 1; c > 0; ++c)
            if (c >= ' ' && !depfile_name(std::string("a") + c + "b", side, reader)) text += c;
        EXPECT_FALSE(depfile_name("a\nb", side, reader) || depfile_name("a\rb", side, reader) ||
                     depfile_name("", side, reader));
        return text;
    };
    EXPECT_EQ(refused(DepfileSide::File, Make), "*;=?[\x7f");
    EXPECT_EQ(refused(DepfileSide::Result, Make), "*;=?[\x7f");
    EXPECT_EQ(refused(DepfileSide::File, Ninja), "\"&'*;<>?^`|\x7f");
    EXPECT_EQ(refused(DepfileSide::File, CMake), "\\\x7f");
    EXPECT_EQ(depfile_name("a\tb%", DepfileSide::File, Make), "a\\\tb%");
    EXPECT_FALSE(depfile_name("a\tb", DepfileSide::Result, Make));
    EXPECT_EQ(depfile_name("100%", DepfileSide::Result, Make), "100\\%");
    EXPECT_FALSE(depfile_name("a\tb", DepfileSide::File, Ninja) || depfile_name("a\tb", DepfileSide::File, CMake));
    const Folder folder;
    const std::string main = folder.write("a;b.grafcet", chart("c") + loop("l", "c"));
    const Result result = grafverif({"equations", main, "-o", folder.file("out"), "--depfile", folder.file("out.d")});
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_NE(result.err.find("a depfile for Make cannot represent the file name `" + main + "`"), std::string::npos);
    EXPECT_EQ(folder.entries(), 1u) << "nothing is written";
    EXPECT_EQ(grafverif({"equations", main, "-o", folder.file("out"), "--depfile", folder.file("out.d"),
                         "--depfile-format", "cmake"})
                  .code,
              ExitCode::Done);
}

TEST(Depfile, RepresentsNamesExactlyForMake) {
    if (printed("command -v make").empty()) GTEST_SKIP() << "make is not installed";
    const Folder folder;
    const std::vector<std::string> files = hostile_names(DepfileSide::File, DepfileReader::Make);
    for (const std::string& name : files) folder.write(name, "");
    folder.write("Makefile",
                 depfile_text({"read"}, files, DepfileReader::Make) + "read: ; @: $(info $^)\n.PHONY: read\n");
    EXPECT_EQ(printed("make -rs -C '" + folder.file("") + "' read"), joined(files) + "\n");

    const Folder another;
    const std::vector<std::string> results = hostile_names(DepfileSide::Result, DepfileReader::Make);
    std::string made, text = "all:";
    std::vector<std::string> wanted;
    for (const std::string& name : results) {
        const auto file = depfile_name(name, DepfileSide::File, DepfileReader::Make);
        if (!file) continue;
        text += " \\\n  " + *file;
        wanted.push_back(name);
        made += name + "\n";
    }
    for (const std::string& name : wanted)
        text += "\n" + *depfile_name(name, DepfileSide::Result, DepfileReader::Make) + ": ; @: $(info $@)\n";
    another.write("Makefile", text);
    EXPECT_EQ(printed("make -rs -C '" + another.file("") + "' all"), made);
}

TEST(Depfile, IsActedOnByMake) {
    if (printed("command -v make").empty()) GTEST_SKIP() << "make is not installed";
    const std::vector<std::string> names = {"plain", "a b", "a$b", "a#b", "a\\b", "a:b", "a%b", "100%", "a\\#b", "a|b"};
    const auto reader = DepfileReader::Make;
    for (const std::string result : {"result", "the $result #1\\2 of 3%"}) {
        for (const std::string& touched : names) {
            SCOPED_TRACE(touched);
            const Folder folder;
            for (const std::string& name : names) folder.write(name, "");
            folder.write(result, "");
            folder.write("all", "");
            folder.write("Makefile", "all: " + *depfile_name(result, DepfileSide::File, reader) + "\n" +
                                         depfile_text({result}, names, reader) +
                                         *depfile_name(result, DepfileSide::Result, reader) + ": ; @false\n");
            const auto old = fs::file_time_type::clock::now() - std::chrono::hours(2);
            for (const std::string& name : names) fs::last_write_time(folder.file(name), old);
            fs::last_write_time(folder.file(result), old + std::chrono::hours(1));
            const std::string make = "make -rq -C '" + folder.file("") + "' >/dev/null 2>&1; echo $?";
            EXPECT_EQ(printed(make), "0\n") << "nothing has changed";
            fs::last_write_time(folder.file(touched), old + std::chrono::hours(2));
            EXPECT_EQ(printed(make), "1\n") << "one file has changed";
            fs::remove(folder.file(touched));
            EXPECT_EQ(printed(make), "1\n") << "one file is missing";
        }
    }
}

TEST(Depfile, RepresentsNamesExactlyForNinja) {
    if (printed("command -v ninja").empty()) GTEST_SKIP() << "ninja is not installed";
    const Folder folder;
    const std::vector<std::string> files = hostile_names(DepfileSide::File, DepfileReader::Ninja);
    for (const std::string& name : files) folder.write(name, "");
    folder.write("result.d.in", depfile_text({"result"}, files, DepfileReader::Ninja));
    folder.write("plain.d.in", depfile_text({"the $result #1\\2 of 3%"}, files, DepfileReader::Ninja));
    folder.write("build.ninja",
                 "rule r\n  command = cp result.d.in result.d && touch result\n  depfile = result.d\n  deps = gcc\n"
                 "rule p\n  command = cp plain.d.in plain.d && touch 'the $$result #1\\2 of 3%'\n  depfile = plain.d\n"
                 "build result: r\nbuild the$ $$result$ #1\\2$ of$ 3%: p\n");
    const std::string ninja = "ninja -C '" + folder.file("") + "' ";
    ASSERT_EQ(std::system((ninja + ">/dev/null").c_str()), 0);
    std::string expected;
    for (const std::string& name : files) expected += "    " + name + "\n";
    const std::string deps = printed(ninja + "-t deps result 2>/dev/null");
    EXPECT_NE(deps.find(expected), std::string::npos) << deps;
    EXPECT_NE(printed(ninja).find("no work to do"), std::string::npos);
}

TEST(Depfile, RepresentsNamesExactlyForCMake) {
    if (printed("command -v cmake").empty()) GTEST_SKIP() << "cmake is not installed";
    const Folder folder;
    const std::vector<std::string> files = hostile_names(DepfileSide::File, DepfileReader::CMake);
    folder.write("in.d", depfile_text({"result"}, files, DepfileReader::CMake));
    const std::string here = "'" + folder.file("") + "' ";
    ASSERT_EQ(std::system(("cd " + here + "&& cmake -E cmake_transform_depfile Ninja gccdepfile " + here + here + here +
                           here + "in.d out.d")
                              .c_str()),
              0);
    std::string expected = "result:";
    for (const std::string& name : files) expected += " \\\n  " + name;
    // The escapes in the output depend on the installed version of CMake. This function removes the escapes.
    const auto plain = [](std::string text) {
        for (const auto& [written, meant] : {std::pair{"\\ ", " "}, {"\\#", "#"}, {"$$", "$"}})
            for (std::size_t at = 0; (at = text.find(written, at)) != std::string::npos;) text.replace(at, 2, meant);
        return text;
    };
    const std::string read = plain(folder.read("out.d"));
    expected = plain(expected);
    EXPECT_EQ(read.substr(0, expected.size()), expected);
}

TEST(Build, AcceptsSeveralFilesWithAllTheirLoops) {
    const Folder folder;
    const std::string one = folder.write("one.grafcet", chart("c") + loop("first", "c") + loop("second", "c"));
    const std::string two = folder.write("two.grafcet", chart("c") + loop("third", "c"));
    const std::string out = folder.file("out");
    EXPECT_NE(grafverif({"build", one, two, "-o", out, "--create-dirs"}).err.find("[ambiguous-choice]"),
              std::string::npos);
    EXPECT_FALSE(fs::exists(out)) << "after an error, no file is written";
    const Result all =
        grafverif({"build", one, two, "--all", "-o", out, "--create-dirs", "--depfile", folder.file("d")});
    EXPECT_EQ(all.code, ExitCode::Done) << all.err;
    for (const char* name : {"first", "second", "third"})
        for (const char* ending : {".xml", ".q", ".smv"}) {
            EXPECT_TRUE(fs::exists(out + "/" + name + ending)) << name << ending;
            EXPECT_NE(all.out.find(std::string(name) + ending), std::string::npos);
        }
    EXPECT_EQ(std::ranges::count(folder.read("d"), '\n'), 7) << folder.read("d");
    EXPECT_EQ(grafverif({"build", one, "--loop", "first"}).code, ExitCode::Done) << "the default folder is created";
    fs::remove_all("first.grafverif");
    const Result twice = grafverif({"build", two, two, "-o", out});
    EXPECT_NE(twice.err.find("[output-twice]"), std::string::npos) << twice.err;
}

TEST(Build, NamesItsFilesAsRequested) {
    const Folder folder;
    const std::string one = folder.write("one.grafcet", chart("c") + loop("first", "c"));
    EXPECT_EQ(grafverif({"build", one, "-o", folder.file(""), "--name", "press"}).code, ExitCode::Done);
    for (const char* name : {"press.xml", "press.q", "press.smv"}) EXPECT_TRUE(fs::exists(folder.file(name))) << name;
    for (const std::vector<std::string>& wrong : std::vector<std::vector<std::string>>{{"--name", "a/b"},
                                                                                       {"--name", ""},
                                                                                       {"--name", "n", "--all"},
                                                                                       {"--name", "n", one},
                                                                                       {"--all", "--loop", "l"}}) {
        std::vector<std::string> arguments{"build", one, "-o", folder.file("")};
        arguments.insert(arguments.end(), wrong.begin(), wrong.end());
        EXPECT_EQ(grafverif(arguments).code, ExitCode::Input) << wrong.back();
    }
}

TEST(Outputs, AreWrittenIntoFoldersThatAreThere) {
    const Folder folder;
    const std::string file = folder.write("one.grafcet", chart("c") + loop("first", "c"));
    const std::string missing = folder.file("missing");
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"build", file, "-o", missing},
                                               {"build", file, "-o", missing + "/deeper"},
                                               {"uppaal", file, "-o", missing + "/l.xml"},
                                               {"check", file, "--junit", missing + "/r.xml"},
                                               {"check", file, "--trace-svg", missing + "/r.svg"},
                                               {"build", file, "-o", folder.file(""), "--depfile", missing + "/d"}}) {
        SCOPED_TRACE(arguments.back());
        const Result result = grafverif(arguments);
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_NE(result.err.find("or pass `--create-dirs` [missing-folder]"), std::string::npos) << result.err;
        EXPECT_EQ(result.out, "") << "reported before the work starts";
        EXPECT_EQ(folder.entries(), 1u);
    }
    EXPECT_EQ(grafverif({"uppaal", file, "-o", missing + "/deeper/l.xml", "--create-dirs"}).code, ExitCode::Done);
    EXPECT_TRUE(fs::exists(missing + "/deeper/l.xml"));
}

TEST(Outputs, RejectNamesOfFormatsThatAreNotWrittenWithRemedy) {
    const Folder folder;
    const std::string file = folder.write("one.grafcet", chart("c") + loop("first", "c"));
    const std::string x = folder.file("x");
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
        {{"draw", file, "-o", x + ".png"},
         "`" + x + ".png` would contain SVG, not PNG; write `" + x + ".svg` and convert it: `rsvg-convert -f png -o " +
             x + ".png " + x + ".svg`"},
        {{"draw", file, "--output", x + ".PDF"}, "rsvg-convert -f pdf"},
        {{"draw", file, "-o", x + ".html"}, ".html` would contain SVG, not HTML; write `" + x + ".svg` ["},
        {{"check", file, "--trace-svg", x + ".jpeg"}, ".jpeg` would contain SVG, not JPEG; write `"},
        {{"report", file, "-o", x + ".pdf"},
         ".pdf` would contain HTML, not PDF; write `" + x + ".html` and print it: `chromium --headless "},
        {{"report", file, "-o", x + ".svg"}, ".svg` would contain HTML, not SVG; write `" + x + ".html` ["},
        {{"faults", file, "--report", x + ".svg"}, ".svg` would contain HTML, not SVG; write `" + x + ".html` ["},
        {{"tune", file, "--report", x + ".pdf"}, ".pdf` would contain HTML, not PDF; write `"},
        {{"check", file, "--report", x + ".pdf"}, ".pdf` would contain HTML, not PDF; write `"},
        {{"replay", file, "--log", file, "--report", x + ".svg"}, ".svg` would contain HTML, not SVG; write `"},
        {{"equations", file, "-o", x + ".pdf"}, ".pdf` would contain text, not PDF; choose another name"}};
    for (const auto& [arguments, message] : cases) {
        SCOPED_TRACE(arguments.back());
        const Result result = grafverif(arguments);
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
        EXPECT_NE(result.err.find("[other-format]"), std::string::npos) << result.err;
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(folder.entries(), 1u);
    }
    EXPECT_EQ(grafverif({"draw", file, "-o", x + ".svg"}).code, ExitCode::Done);
    EXPECT_EQ(grafverif({"draw", file, "-o", x + ".drawing"}).code, ExitCode::Done);
}

// -- standard streams, for every command in the table -----------------------------------------------------------------

using Words = std::vector<std::string>;

const std::string violated =
    chart("c") +
    "closed_loop l {\n    controller c;\n    constant GAP = 1s;\n    environment E = push_button(OUT = x, GAP = GAP);\n"
    "    fault F of E: free(OUT = x);\n    property p: never X1;\n}\n";

/// Returns a call of the command on `file` that terminates.
Words call(const CliCommand& verb, const std::string& file, const Folder& folder) {
    Words words = {verb.name};
    if (accepts(verb, OptionGroup::File)) words.push_back(file);
    if (verb.name == "completion") words.emplace_back("bash");
    if (verb.least_operands > 1) words.push_back(folder.write("other.grafcet", violated));
    if (accepts(verb, OptionGroup::Bench)) words.insert(words.end(), {"--against", "cat", "--timeout", "1s"});
    if (accepts(verb, OptionGroup::Walk)) words.insert(words.end(), {"--random", "1"});
    if (accepts(verb, OptionGroup::OutputDirectory)) words.insert(words.end(), {"-o", folder.file("")});
    if (accepts(verb, OptionGroup::Mutants)) words.insert(words.end(), {"--limit", "1"});
    if (accepts(verb, OptionGroup::Tuning)) words.insert(words.end(), {"--over", "GAP=1s..2s"});
    if (accepts(verb, OptionGroup::Log))
        words.insert(words.end(), {"--log", folder.write("log.csv", "time,x,L\n0,0,0\n")});
    return words;
}

TEST(StandardInput, IsReadOrRejectedByNameInEveryCommandThatReadsAFile) {
    std::size_t reading = 0;
    for (const CliCommand& verb : all_commands()) {
        if (!accepts(verb, OptionGroup::File)) continue;
        for (const char* name : {"-", "/dev/stdin"}) {
            SCOPED_TRACE(verb.name + " " + name);
            const Folder folder;
            const Result result = grafverif(call(verb, name, folder), violated);
            reading += result.code != ExitCode::Input ? 1 : 0;
            const bool has_no_other = verb.name != "plc" && verb.name != "monitor" && verb.name != "serve" &&
                                      verb.name != "edit" && verb.name != "import";
            EXPECT_EQ(result.code != ExitCode::Input, has_no_other) << result.err;
            EXPECT_TRUE(result.code != ExitCode::Input || result.err.find("standard input") != std::string::npos ||
                        result.err.find("[nothing-to-import]") != std::string::npos)
                << result.err;
            EXPECT_TRUE(result.code == ExitCode::Input || !result.out.empty() || folder.entries() > 0) << result.err;
        }
    }
    EXPECT_GT(reading, 35U);
}

TEST(StandardInput, IsReadOnce) {
    const Folder folder;
    const std::string file = folder.write("one.grafcet", violated);
    for (const Words& words : std::vector<Words>{{"compare", "-", "-"},
                                                 {"check", "-", "/dev/stdin"},
                                                 {"simulate", "-"},
                                                 {"simulate", "-", "--script", "-"},
                                                 {"plc", "-"},
                                                 {"analyse", "-", "--exclusions", "-"},
                                                 {"st", "-", "--sequence", "/dev/stdin"}}) {
        const Result result = grafverif(words, violated);
        EXPECT_EQ(result.code, ExitCode::Input) << words[0];
        EXPECT_NE(result.err.find("cannot both be read from standard input;"), std::string::npos) << result.err;
    }
    EXPECT_NE(grafverif({"fmt", "-i", "-"}, violated).err.find("`--in-place` cannot rewrite standard input"),
              std::string::npos);
    EXPECT_EQ(grafverif({"simulate", file, "--script", "-"}, "wait 1s\n").code, ExitCode::Done);
}

/// A check first removes the report of an earlier run, but it must not remove other HTML files of the user.
TEST(ReportFiles, OtherHtmlPagesRemainIfTheCommandFails) {
    const Folder folder;
    const std::string file = folder.write("bad.grafcet", "grafcet");
    const std::string page = "<!DOCTYPE html>\n<p>a page of the user</p>\n";
    const std::string own = folder.write("own.html", page);
    EXPECT_EQ(grafverif({"check", file, "--report", own}).code, ExitCode::Input);
    EXPECT_EQ(folder.read("own.html"), page);
    const std::string old = folder.file("old.html");
    EXPECT_EQ(grafverif({"check", folder.write("one.grafcet", violated), "--report", old}).code, ExitCode::Verdict);
    EXPECT_TRUE(fs::exists(old));
    EXPECT_EQ(grafverif({"check", file, "--report", old}).code, ExitCode::Input);
    EXPECT_FALSE(fs::exists(old));
}

/// Returns the expected beginning of a document that the option writes. The result is empty if the beginning varies.
std::string beginning_of(const std::string& option) {
    if (option == "junit" || option == "openpsa") return "<?xml";
    if (option == "sarif") return "{\n";
    if (option == "trace-svg") return "<svg";
    if (option == "report") return "<!DOCTYPE html>";
    if (option == "trace-vcd") return "$comment";
    return option == "depfile" ? "x:" : "";
}

/// Calls each command with each option that names a file or folder. `look` receives the command, the option, its use,
/// and the call without the value, which is the last word of a call.
template <class Look>
void with_each_path_option(const Folder& folder, const std::string& file, const Look& look) {
    for (const CliCommand& verb : all_commands())
        for (const OptionText& option : option_texts(verb)) {
            if ((option.value != "FILE" && option.value != "DIR") || option.name == "include" ||
                option.name == "within")
                continue;
            SCOPED_TRACE(verb.name + " --" + option.name);
            const auto listed = std::ranges::find(path_options, option.name, &PathOption::name);
            ASSERT_NE(listed, path_options.end()) << "docs/reference/files.md must have rules for every path";
            Words words = call(verb, file, folder);
            if (accepts(verb, OptionGroup::Walk) && (option.name == "script" || option.name == "junit"))
                words.resize(2);
            if (accepts(verb, OptionGroup::Walk) && option.name == "junit")
                words.insert(words.end(), {"--script", folder.write("s.txt", "expect X0\n")});
            if (option.name == "log") words.resize(2);
            if (option.name == "depfile") words.insert(words.end(), {"--depfile-target", "x"});
            if (option.name == "output" && accepts(verb, OptionGroup::OutputDirectory)) words.resize(2);
            words.push_back("--" + option.name);
            look(verb, listed->use, words);
        }
}

TEST(StandardOutput, ReceivesTheDocumentOfEveryFileOptionOrTheOptionIsRejected) {
    const Folder folder;
    const std::string file = folder.write("one.grafcet", violated);
    std::size_t documents = 0;
    with_each_path_option(folder, file, [&](const CliCommand&, PathUse, Words words) {
        const std::string option = words.back().substr(2);
        words.emplace_back("-");
        const Result result = grafverif(words, option == "script" ? "wait 1s\n" : "nothing\n");
        EXPECT_FALSE(fs::exists("-"));
        const bool refused =
            result.err.find("standard input") != std::string::npos ||
            result.err.find("standard stream") != std::string::npos ||
            result.err.find("which `-` is not") != std::string::npos ||
            result.err.find("cannot both be written to standard output") != std::string::npos ||
            result.err.find("[nothing-to-import]") != std::string::npos ||
            (option == "properties" && result.err.find("[unexpected]") != std::string::npos);  // not a property file
        EXPECT_EQ(result.code == ExitCode::Input, refused) << result.err;
        if (refused) return;
        ++documents;
        EXPECT_FALSE(result.out.empty()) << result.err;
        EXPECT_TRUE(result.out.starts_with(beginning_of(option))) << result.out;
    });
    EXPECT_GT(documents, 25U);
}

TEST(Paths, InputsAreRegularFilesAndPipesNeverBlock) {
    const Folder folder;
    const std::string file = folder.write("one.grafcet", violated), pipe = folder.file("pipe");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::size_t refused = 0;
    with_each_path_option(folder, file, [&](const CliCommand&, PathUse use, Words words) {
        if (use != PathUse::Read && use != PathUse::Updated) return;
        words.push_back(pipe);
        const Result result = grafverif(words);
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_NE(result.err.find("the path is a pipe, not a file"), std::string::npos) << result.err;
        ++refused;
    });
    EXPECT_GE(refused, 5U);
}

TEST(Paths, NoOptionReplacesTheFileThatIsRead) {
    const Folder folder;
    const std::string file = folder.write("one.grafcet", violated);
    std::size_t refused = 0;
    with_each_path_option(folder, file, [&](const CliCommand& verb, PathUse use, Words words) {
        if (use == PathUse::Read || !accepts(verb, OptionGroup::File)) return;
        words.push_back(file);
        EXPECT_EQ(grafverif(words).code, ExitCode::Input);
        EXPECT_EQ(folder.read("one.grafcet"), violated);
        ++refused;
    });
    EXPECT_GT(refused, 25U);
}

TEST(StandardOutput, ContainsOnlyTheReportAndMessagesGoToStandardError) {
    const Folder folder;
    const std::string file = folder.write("one.grafcet", violated);
    const Result junit = grafverif({"check", file, "--junit", "-"});
    EXPECT_TRUE(junit.out.starts_with("<?xml") && junit.out.ends_with("</testsuites>\n")) << junit.out;
    EXPECT_NE(junit.err.find("p: violated"), std::string::npos) << junit.err;
    const Result drawn =
        grafverif({"simulate", file, "--script", folder.write("s.txt", "x = true\n"), "--trace-svg", "/dev/stdout"});
    EXPECT_TRUE(drawn.out.starts_with("<svg ") && drawn.out.ends_with("</svg>\n")) << drawn.out;
    for (const Words& options : std::vector<Words>{{"--junit", "-", "--sarif", "-"},
                                                   {"--format", "json", "--junit", "-"},
                                                   {"--json-lines", "--sarif", "/dev/stdout"}}) {
        Words words = {"check", file};
        words.insert(words.end(), options.begin(), options.end());
        EXPECT_NE(grafverif(words).err.find("cannot both be written to standard output;"), std::string::npos);
    }
}

/// The reader of the standard output may close the pipe early, as in `grafverif check ... | head -1`.
TEST(Reports, AreCompleteIfTheReaderOfStandardOutputIsGone) {
    const Folder folder;
    folder.write("one.grafcet", violated);
    folder.write("s.txt", "expect X0\n");
    for (const char* call :
         {"check --all one.grafcet one.grafcet --junit r.xml --sarif r.sarif", "check one.grafcet --trace-vcd t.vcd",
          "analyse one.grafcet --sarif r.sarif", "test one.grafcet --against cat --junit r.xml",
          "simulate one.grafcet --script s.txt --junit r.xml --trace-vcd t.vcd"}) {
        SCOPED_TRACE(call);
        for (const char* file : {"r.xml", "r.sarif", "t.vcd", "done"}) fs::remove(folder.file(file));
        printed("cd '" + folder.file("") + "' && { '" GRAFVERIF_PROGRAM "' " + call +
                "; echo >done; } 2>&1 | :; while [ ! -e done ]; do sleep 0.02; done");
        for (const char* report : {"r.xml", "r.sarif", "t.vcd"}) {
            if (std::string(call).find(report) == std::string::npos) continue;
            const std::string text = folder.read(report);
            EXPECT_FALSE(text.empty()) << report;
            EXPECT_EQ(text.find("the command did not complete"), std::string::npos) << report << text;
        }
    }
}

}  // namespace
}  // namespace grafverif::app
