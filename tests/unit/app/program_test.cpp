// SPDX-License-Identifier: MIT
#include "app/program.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "run_program.hpp"

namespace grafverif::app {
namespace {

TEST(Program, PrintsItsDescriptionAndVersion) {
    EXPECT_EQ(grafverif({"--version"}).out, "grafverif " GRAFVERIF_VERSION "\n");
    const Result help = grafverif({"--help"});
    EXPECT_EQ(help.code, ExitCode::Done);
    EXPECT_NE(help.out.find("Usage: grafverif COMMAND"), std::string::npos);
}

TEST(Program, RejectsWrongUsageWithExitCodeTwo) {
    struct Case {
        std::vector<std::string> arguments;
        std::string error_text;
    };
    for (const Case& c : std::vector<Case>{
             {{}, "missing command"},
             {{"frobnicate"}, "unknown command `frobnicate`"},
             {{"build"}, "`FILE...` is missing"},
             {{"uppaal", station, "second"}, "unexpected argument `second`; remove it"},
             {{"build", station, "--grain", "coarse"},
              "invalid value `coarse` of `--grain`; use one of `phased`, `atomic`"},
             {{"equations", station, "--format", "pdf"}, "invalid value `pdf` of `--format`"},
             {{"nusmv", station, "--plant", "none", "--fairness"}, "`--fairness` requires `--plant automata`; add it"},
             {{"nusmv", station, "--time", "discrete", "--schedule", "sequenced"},
              "`--time discrete` requires `--schedule interleaved`; remove the other schedule"},
             {{"build", station, "--frob"}, "unknown option `--frob`"},
             {{"uppaal", station, "-o"}, "the required argument for option '--output' is missing"},
         }) {
        SCOPED_TRACE(c.error_text);
        const Result result = grafverif(c.arguments);
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_NE(result.err.find(c.error_text), std::string::npos) << result.err;
        EXPECT_NE(result.err.find("--help`"), std::string::npos);
        EXPECT_EQ(result.out, "");
    }
}

TEST(Program, AcceptsFormerOptionNamesWithWarning) {
    struct Case {
        std::string former, name;
        std::vector<std::string> arguments;
    };
    for (const auto& [former, name, arguments] : std::vector<Case>{
             {"--whole", "--monolithic", {"check", "missing", "--whole"}},
             {"--without", "--ablate", {"check", "missing", "--without=flags"}},
             {"--go-on", "--keep-going", {"test", "missing", "--against", "false", "--go-on"}},
             {"--each-mode", "--all-modes", {"compare", "missing", "missing", "--each-mode"}},
             {"--each", "--mutant-timeout", {"mutate", "missing", "--each", "1s"}},
             {"--create", "--create-dirs", {"uppaal", "missing", "--create"}},
             {"--depfile-form",
              "--depfile-format",
              {"uppaal", "missing", "-o", "l.xml", "--depfile", "d", "--depfile-form", "ninja"}},
         }) {
        SCOPED_TRACE(former);
        const std::string warning = "`" + former + "` is deprecated; use `" + name + "` [deprecated-option]";
        const Result result = grafverif(arguments);
        EXPECT_TRUE(result.err.starts_with("warning: " + warning)) << result.err;
        EXPECT_NE(result.err.find("[cannot-read]"), std::string::npos) << "the option is accepted: " << result.err;
        std::vector<std::string> current = arguments;
        for (std::string& argument : current)
            if (argument == former || argument.starts_with(former + "=")) argument.replace(0, former.size(), name);
        EXPECT_EQ(grafverif(current).err, result.err.substr(result.err.find('\n') + 1));
        EXPECT_EQ(grafverif({arguments[0], "--help"}).out.find(former + " "), std::string::npos);
    }
    EXPECT_EQ(grafverif({"check", station, "--list", "--whole", "--quiet"}).err, "");
    EXPECT_EQ(grafverif({"check", station, "--list", "--whole", "--monolithic"}).code, ExitCode::Input);
}

TEST(Build, WritesTheProjectItsQueriesAndTheNusmvModel) {
    const Folder folder;
    const Result result = grafverif({"build", station, "-o", folder.file("out"), "--create-dirs"});
    EXPECT_EQ(result.code, ExitCode::Done) << result.err;
    EXPECT_TRUE(folder.read("out/station.xml").starts_with("<?xml"));
    EXPECT_NE(folder.read("out/station.q").find("-->"), std::string::npos);
    EXPECT_NE(folder.read("out/station.smv").find("MODULE main"), std::string::npos);
    for (const char* name : {"station.xml", "station.q", "station.smv"})
        EXPECT_NE(result.out.find(name), std::string::npos);
    EXPECT_EQ(folder.entries(), 4u);
}

TEST(Build, WarnsOfPropertiesThatATargetCannotExpress) {
    const Folder folder;
    const Result result = grafverif({"build", station, "-o", folder.file("out"), "--create-dirs"});
    EXPECT_NE(result.err.find("property `no_timelock` is omitted from the UPPAAL model"), std::string::npos)
        << result.err;
    EXPECT_NE(result.err.find("property `no_deadlock` is omitted from the NuSMV model"), std::string::npos)
        << result.err;
    EXPECT_NE(result.err.find("[not-expressible]"), std::string::npos);
    EXPECT_EQ(grafverif({"build", station, "-o", folder.file("out"), "--create-dirs", "--quiet"}).err, "");
}

TEST(Build, ListsItsFilesAsJson) {
    const Folder folder;
    const Result result = grafverif(
        {"build", station, "-o", folder.file("out"), "--create-dirs", "--format", "json", "--target", "uppaal"});
    const auto files = nlohmann::json::parse(result.out)["files"];
    ASSERT_EQ(files.size(), 2u);
    EXPECT_EQ(files[0]["path"], folder.file("out/station.xml"));
    EXPECT_EQ(files[0]["bytes"], folder.read("out/station.xml").size());
}

TEST(Build, IsDeterministic) {
    const Folder folder;
    grafverif({"build", station, "-o", folder.file("one"), "--create-dirs"});
    grafverif({"build", station, "-o", folder.file("two"), "--create-dirs"});
    for (const char* name : {"station.xml", "station.q", "station.smv"}) {
        EXPECT_FALSE(folder.read(std::string("one/") + name).empty());
        EXPECT_EQ(folder.read(std::string("one/") + name), folder.read(std::string("two/") + name));
    }
}

TEST(Build, WritesNothingIfTheInputHasErrors) {
    const Folder folder;
    const std::string broken = folder.write("broken.grafcet", "grafcet a { input x; step 1; }\n");
    const Result result = grafverif({"build", broken, "-o", folder.file("out"), "--create-dirs"});
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_NE(result.err.find("[no-initial-step]"), std::string::npos) << result.err;
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(Build, KeepsExistingOutputsOnError) {
    const Folder folder;
    ASSERT_EQ(grafverif({"build", station, "-o", folder.file("out"), "--create-dirs"}).code, ExitCode::Done);
    const std::string before = folder.read("out/station.xml");
    fs::remove(folder.file("out/station.q"));
    fs::create_directory(folder.file("out/station.q"));  // a folder cannot be overwritten
    const Result result = grafverif({"build", station, "-o", folder.file("out"), "--create-dirs", "--grain", "atomic"});
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_EQ(folder.read("out/station.xml"), before);
    EXPECT_EQ(folder.entries(), 4u) << "a draft remains";
}

TEST(Build, AcceptsOnlyAClosedLoop) {
    const Folder folder;
    const std::string chart = folder.write("lone.grafcet",
                                           "grafcet a { input x; output L; initial step 0; step 1 { L; }\n"
                                           "transition t: 0 -> 1 when x; transition u: 1 -> 0 when !x; }\n");
    const Result result = grafverif({"build", chart, "-o", folder.file("out"), "--create-dirs"});
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_NE(result.err.find("[no-closed-loop]"), std::string::npos) << result.err;
    EXPECT_EQ(grafverif({"nusmv", chart}).code, ExitCode::Done);
}

TEST(Build, ReportsAMissingFileAndAFolder) {
    const Folder folder;
    for (const std::string& path : {folder.file("nowhere.grafcet"), folder.file("")}) {
        const Result result = grafverif({"build", path});
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_NE(result.err.find("[cannot-read]"), std::string::npos) << result.err;
    }
}

TEST(Include, ReachesBelowTheMainFileOnly) {
    const Folder folder;
    const std::string chart =
        "grafcet a { input x; output L; initial step 0; step 1 { L; } transition t: 0 -> 1 when x; transition u: 1 -> "
        "0 when !x; }\n";
    fs::create_directories(folder.file("main/parts"));
    folder.write("main/parts/a.grafcet", chart);
    folder.write("outside.grafcet", chart);
    EXPECT_EQ(grafverif({"nusmv", folder.write("main/in.grafcet", "include \"parts/a.grafcet\";\n")}).code,
              ExitCode::Done);
    const Result result = grafverif({"nusmv", folder.write("main/out.grafcet", "include \"../outside.grafcet\";\n")});
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_NE(result.err.find("outside the folder of the main file"), std::string::npos) << result.err;
}

TEST(Diagnostics, ComeAsJsonOnRequest) {
    const Folder folder;
    const std::string broken = folder.write("broken.grafcet", "grafcet a { input x; step 1; }\n");
    const Result result = grafverif({"build", broken, "--diagnostics", "json"});
    const auto parsed = nlohmann::json::parse(result.err);
    ASSERT_FALSE(parsed.empty());
    EXPECT_EQ(parsed[0]["file"], broken);
    EXPECT_EQ(parsed[0]["severity"], "error");
}

TEST(Choice, NamesTheCandidatesIfAFileHasSeveral) {
    const Folder folder;
    const std::string chart =
        "{ input x; output L; initial step 0; step 1 { L; } transition t: 0 -> 1 when x; transition u: 1 -> 0 when !x; "
        "}\n";
    const std::string two = folder.write("two.grafcet", "grafcet first " + chart + "grafcet second " + chart);
    const Result result = grafverif({"equations", two});
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_NE(result.err.find("`first`, `second`"), std::string::npos) << result.err;
    EXPECT_EQ(grafverif({"equations", two, "--chart", "second"}).code, ExitCode::Done);
    EXPECT_NE(grafverif({"equations", two, "--chart", "third"}).err.find("`third`"), std::string::npos);
}

TEST(Components, AreListedAndShown) {
    const Result list = grafverif({"components"});
    EXPECT_EQ(list.code, ExitCode::Done);
    EXPECT_NE(list.out.find("cylinder_5_3 "), std::string::npos);
    EXPECT_NE(grafverif({"components", "cylinder_5_3"}).out.find("component cylinder_5_3("), std::string::npos);
    const Result unknown = grafverif({"components", "cylinder_5_4"});
    EXPECT_EQ(unknown.code, ExitCode::Input);
    EXPECT_NE(unknown.err.find("cylinder_5_3"), std::string::npos);
    const auto json = nlohmann::json::parse(grafverif({"components", "push_button", "--format", "json"}).out);
    EXPECT_EQ(json["name"], "push_button");
}

TEST(Fmt, RewritesInPlaceAndChecks) {
    const Folder folder;
    const std::string file = folder.write("a.grafcet",
                                          "grafcet a{input x;output L;initial step 0;step 1{L;}\n"
                                          "transition t:0->1 when x;transition u:1->0 when not x;}");
    EXPECT_EQ(grafverif({"fmt", file, "--check"}).code, ExitCode::Verdict);
    const std::string printed = grafverif({"fmt", file}).out;
    EXPECT_EQ(grafverif({"fmt", file, "-i"}).code, ExitCode::Done);
    EXPECT_EQ(folder.read("a.grafcet"), printed);
    EXPECT_EQ(grafverif({"fmt", file, "--check"}).code, ExitCode::Done);
}

}  // namespace
}  // namespace grafverif::app
