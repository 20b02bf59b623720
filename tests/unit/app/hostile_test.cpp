// SPDX-License-Identifier: MIT
// Tests strings with terminal control sequences or markup, in all places that external input can reach, with every
// command and every output format. Output for terminals must contain no control sequences. Output for programs must be
// read back unchanged.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "run_program.hpp"

namespace grafverif::app {
namespace {

using Json = nlohmann::json;

const std::vector<std::string> hostile_strings = {"\x1B[31mred\x1B[0m",
                                                  "\x1B]0;title\x07",
                                                  "over\rwritten",
                                                  "back\x08\x08",
                                                  "del\x7F",
                                                  "\x01\x02",
                                                  "\xC2\x9B"
                                                  "31m",
                                                  "\xC2\x85next",
                                                  "\xE2\x80\xAE"
                                                  "drow",
                                                  "\xE2\x81\xA6isolated",
                                                  "\xE2\x80\x8F",
                                                  "\xD8\x9C",
                                                  "\xE2\x80\xA8line",
                                                  "tab\there",
                                                  "\xEF\xBB\xBF",
                                                  "\xFF\xFE",
                                                  "\xC3",
                                                  "\xED\xA0\x80",
                                                  "\xC0\xAF",
                                                  "\xF5\x80\x80\x80",
                                                  "</text><script>",
                                                  "]]>&amp;",
                                                  "--> %s {} {0}",
                                                  "*/ *) (*",
                                                  "'$(id)`",
                                                  "\\u001b[31m",
                                                  "\xE6\xBC\xA2\xE5\xAD\x97",
                                                  "e\xCC\x81",
                                                  "two\nlines",
                                                  "quote\"d"};

/// Returns all hostile strings, joined in groups of three.
std::vector<std::string> mixtures() {
    std::vector<std::string> joined;
    for (std::size_t k = 0; k < hostile_strings.size(); ++k) {
        if (k % 3 == 0) joined.emplace_back();
        joined.back() += hostile_strings[k];
    }
    return joined;
}

/// Returns a description of the first control sequence in a text, or an empty string. The function is written
/// independently of the function under test.
std::string dirt(const std::string& text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = [&](std::size_t k) {
            return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0U;
        };
        if ((byte(0) < 0x20 && text[i] != '\n' && text[i] != '\t') || byte(0) == 0x7F)
            return "control at " + std::to_string(i);
        if (byte(0) == 0xC2 && byte(1) < 0xA0) return "C1 at " + std::to_string(i);
        if (byte(0) == 0xD8 && byte(1) == 0x9C) return "ALM";
        if (byte(0) == 0xE2 && byte(1) == 0x80 &&
            (byte(2) == 0x8E || byte(2) == 0x8F || (byte(2) >= 0xA8 && byte(2) <= 0xAE)))
            return "direction";
        if (byte(0) == 0xE2 && byte(1) == 0x81 && byte(2) >= 0xA6 && byte(2) <= 0xA9) return "isolate";
    }
    try {
        static_cast<void>(Json(text).dump());
    } catch (const Json::type_error&) {
        return "not UTF-8";
    }
    return {};
}

Result on_a_terminal(const std::vector<std::string>& arguments, const std::string& input = "") {
    std::istringstream in(input);
    std::ostringstream out, err;
    const ExitCode code = run(arguments, {in, out, err, false, {.terminal = true}});
    return {code, out.str(), err.str()};
}

/// Checks that the command does not end with an internal error and prints no control sequences. Checks the same for a
/// report that is written into a pipe.
void expect_clean(const std::vector<std::string>& arguments, const std::string& input = "", bool report = true) {
    std::string command_line;
    for (const std::string& argument : arguments) command_line += argument + " ";
    SCOPED_TRACE(Json(command_line).dump(-1, ' ', true, Json::error_handler_t::replace));
    for (const bool terminal : {true, false}) {
        if (!terminal && !report) continue;
        const Result result = terminal ? on_a_terminal(arguments, input) : grafverif(arguments, input);
        EXPECT_NE(result.code, ExitCode::Failure)
            << Json(result.err).dump(-1, ' ', true, Json::error_handler_t::replace);
        EXPECT_EQ(dirt(result.out), "") << Json(result.out).dump(-1, ' ', true, Json::error_handler_t::replace);
        EXPECT_EQ(dirt(result.err), "") << Json(result.err).dump(-1, ' ', true, Json::error_handler_t::replace);
    }
}

const std::vector<std::vector<std::string>> verbs = {{"check"},
                                                     {"check", "--untimed"},
                                                     {"check", "--format", "json"},
                                                     {"analyse"},
                                                     {"analyse", "--format", "json"},
                                                     {"analyse", "--format", "sarif"},
                                                     {"simulate", "--random", "1", "--steps", "5"},
                                                     {"draw"},
                                                     {"report"},
                                                     {"report", "--date", "a day"},
                                                     {"equations"},
                                                     {"equations", "--format", "latex"},
                                                     {"equations", "--format", "json"},
                                                     {"automaton"},
                                                     {"automaton", "--format", "json"},
                                                     {"automaton", "--format", "dot"},
                                                     {"automaton", "--format", "svg"},
                                                     {"mealy"},
                                                     {"mealy", "--format", "json"},
                                                     {"testgen"},
                                                     {"testgen", "--format", "json"},
                                                     {"testgen", "--format", "st"},
                                                     {"testgen", "--format", "xml"},
                                                     {"st"},
                                                     {"st", "--format", "text"},
                                                     {"nusmv"},
                                                     {"nusmv", "--plant", "automata"},
                                                     {"uppaal"},
                                                     {"pins"},
                                                     {"plc"},
                                                     {"fmt"},
                                                     {"fmt", "--check"},
                                                     {"import"},
                                                     {"test", "--against", "true"},
                                                     {"check", "--diagnostics", "json"}};

/// Returns a loop with `text` in every place that may contain arbitrary text.
std::string loop_with(const std::string& text) {
    return "// " + text +
           "\ngrafcet g { input a; output o; initial step 0; step 1 { o; }\n    transition t0: 0 -> 1 when a;\n    "
           "transition t1: 1 -> 0 when !a;\n"
           "    transition t2: 1 -> 0 when a && !a;\n    accept transition-never-fired \"" +
           text +
           "\";\n}\n"
           "closed_loop w { controller g; environment A = push_button(OUT = a);\n    property p \"" +
           text + "\": never X1;\n    property q \"" + text + "\": always X0 || X1;\n}\n";
}

bool fits_a_text(const std::string& text) { return text.find_first_of("\"\n") == std::string::npos; }

TEST(Hostile, TextsAndFileNamesAreCleanInEveryCommand) {
    const Folder folder;
    for (const std::string& text : mixtures()) {
        std::string name = text + ".grafcet";
        std::ranges::replace(name, '/', '_');
        const std::string file = folder.write(name, loop_with(fits_a_text(text) ? text : "plain"));
        const std::string broken = folder.write("broken" + name, loop_with("plain") + text);
        for (const std::vector<std::string>& verb : verbs) {
            std::vector<std::string> arguments = verb;
            arguments.insert(arguments.begin() + 1, file);
            expect_clean(arguments, "0\n1\n", verb[0] != "fmt");
            if (verb.size() == 1 || verb.back() == "json") {
                arguments[1] = broken;
                expect_clean(arguments);
            }
        }
        expect_clean({"build", file, "-o", folder.file("out"), "--create-dirs"});
        expect_clean({"build", file, "-o", folder.file("out" + name), "--create-dirs", "--format", "json"});
        expect_clean({"equations", folder.write("includes.grafcet", "include \"" + text + "\";\n")});
    }
}

TEST(Hostile, WordsOfTheCommandLine) {
    for (const std::string& text : hostile_strings)
        for (const std::vector<std::string>& arguments :
             std::vector<std::vector<std::string>>{{text},
                                                   {"check", station, text},
                                                   {"check", station, "--property", text},
                                                   {"check", station, "--" + text},
                                                   {"check", station, "--timeout", text},
                                                   {"equations", station, "--chart", text},
                                                   {"check", station, "--loop", text},
                                                   {"components", text},
                                                   {"equations", text},
                                                   {"equations", station, "-I", text},
                                                   {"equations", station, "-o", "/dev/null/" + text},
                                                   {"st", station, "--sequence", text}})
            expect_clean(arguments);
}

TEST(Hostile, OutputOfOtherProgramsIsClean) {
    const Folder folder;
    const Path path(folder.file("") + ":/usr/bin:/bin");
    const std::string two_tanks = (root / "samples/tanks/tanks.grafcet").string(),
                      scans = (root / "samples/tanks/table2.csv").string();
    for (const std::string& text : mixtures()) {
        folder.write("words", text);
        for (const char* name : {"verifyta", "nuXmv"})
            fs::permissions(folder.write(name, "#!/bin/sh\ncat '" + folder.file("words") + "'; cat '" +
                                                   folder.file("words") + "' >&2; exit 1\n"),
                            fs::perms::owner_all);
        for (const std::vector<std::string>& options :
             {std::vector<std::string>{}, {"--junit", folder.file("report.xml"), "--format", "json"}})
            for (std::vector<std::string> arguments : std::vector<std::vector<std::string>>{
                     {"check", station, "--engine", "verifyta"},
                     {"check", station, "--engine", "nuXmv"},
                     {"test", two_tanks, "--sequence", scans, "--against",
                      "cat '" + folder.file("words") + "'; cat '" + folder.file("words") + "' >&2"},
                     {"test", two_tanks, "--sequence", scans, "--against",
                      "while read x; do cat '" + folder.file("words") + "'; echo; done", "--timeout", "200ms"}}) {
                arguments.insert(arguments.end(), options.begin(), options.end());
                expect_clean(arguments);
                if (!options.empty()) {
                    pugi::xml_document report;
                    EXPECT_TRUE(report.load_string(folder.read("report.xml").c_str()));
                    EXPECT_EQ(dirt(folder.read("report.xml")), "");
                }
            }
    }
}

TEST(Hostile, TablesAndScripts) {
    const Folder folder;
    const std::string two_tanks = (root / "samples/tanks/tanks.grafcet").string(), table = folder.file("table.csv");
    const std::string head = "sequence,step,wait,cycles,s,h1,h2,l1,l2,V1,V2,W1,W2,situation\n1,1,,2,0,0,0,1,1,0,0,0,0,";
    for (const std::string& text : mixtures()) {
        folder.write("table.csv", head + "\"" + (fits_a_text(text) ? text : "two\nlines") + "\"\n");
        expect_clean({"st", two_tanks, "--sequence", table, "--format", "text"});
        expect_clean({"st", two_tanks, "--sequence", table});
        expect_clean({"test", two_tanks, "--sequence", table, "--against", "echo 0,0,0,1"});
        expect_clean({"test", two_tanks, "--sequence", table, "--against", "echo 0,0,0,1", "--format", "json"});
        folder.write("table.csv", text + "," + head + text);
        expect_clean({"test", two_tanks, "--sequence", table, "--against", "true"});
        folder.write("pairs.csv", "variable1,variable2,reason\nh1," + text + "," + text + "\n");
        expect_clean({"analyse", two_tanks, "--exclusions", folder.file("pairs.csv")});
        expect_clean({"simulate", two_tanks, "--script", folder.write("script", text + "\n")});
        expect_clean({"simulate", two_tanks}, text + "\n" + text + " = 1\n");
        expect_clean({"plc", two_tanks}, text + "\nwait " + text + "\n");
        expect_clean({"import", folder.write("a.xml", "<" + text + " name='" + text + "'><b/></" + text + ">")});
        expect_clean({"import",
                      folder.write("a.xml", "<Grafcet name=\"" + text + "\"><step name=\"" + text + "\"/></Grafcet>")});
        expect_clean({"check", folder.write("a.txt", "PROGRAM p (* " + text + " *) INITIAL_STEP " + text +
                                                         ": END_STEP END_PROGRAM")});
    }
}

TEST(Hostile, NoCommentOfATestEndsEarly) {
    const Folder folder;
    const std::string two_tanks = (root / "samples/tanks/tanks.grafcet").string();
    const std::string head = "sequence,step,wait,cycles,s,h1,h2,l1,l2,V1,V2,W1,W2,situation\n1,1,,2,0,0,0,1,1,0,0,0,0,";
    const std::string text = grafverif({"st", two_tanks, "--sequence",
                                        folder.write("table.csv", head + "*) EVIL := TRUE; (*\n"), "--format", "text"})
                                 .out;
    ASSERT_NE(text.find("EVIL"), std::string::npos);
    EXPECT_NE(text.find("* ) EVIL := TRUE; ( *"), std::string::npos) << text;
}

TEST(Hostile, DocumentsAreReadBackWhole) {
    const Folder folder;
    for (const std::string& text : hostile_strings) {
        if (!fits_a_text(text) || dirt(text) == "not UTF-8") continue;
        const std::string file = folder.write("loop.grafcet", loop_with(text));
        const Result checked = grafverif({"check", file, "--format", "json", "--junit", folder.file("r.xml"),
                                          "--trace-svg", folder.file("t.svg"), "--trace-vcd", folder.file("t.vcd")});
        ASSERT_EQ(checked.code, ExitCode::Verdict) << checked.err;
        EXPECT_EQ(Json::parse(checked.out)["properties"][0]["text"], text);
        for (const char* name : {"r.xml", "t.svg"}) {
            pugi::xml_document document;
            EXPECT_TRUE(document.load_file(folder.file(name).c_str())) << name;
            EXPECT_EQ(dirt(folder.read(name)), "") << name;
        }
        EXPECT_EQ(dirt(folder.read("t.vcd")), "");
        EXPECT_TRUE(Json::accept(grafverif({"analyse", file, "--format", "sarif"}).out));
        ASSERT_EQ(grafverif({"build", file, "-o", folder.file("out"), "--create-dirs"}).code, ExitCode::Done);
        for (const char* name : {"out/w.xml", "out/w.q", "out/w.smv"}) EXPECT_EQ(dirt(folder.read(name)), "") << name;
        EXPECT_EQ(grafverif({"fmt", folder.write("again.grafcet", grafverif({"fmt", file}).out), "--check"}).code,
                  ExitCode::Done);
    }
}

}  // namespace
}  // namespace grafverif::app
