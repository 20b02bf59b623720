// SPDX-License-Identifier: MIT
// Tests `--property` of commands that write a model, which must contain exactly the selected properties.
#include <gtest/gtest.h>

#include <algorithm>

#include "run_program.hpp"

namespace grafverif::app {
namespace {

const std::string asked_of =
    "grafcet lamp_control {\n    input BUTTON;\n    output LAMP;\n    initial step 0;\n    step 1 { LAMP; }\n"
    "    transition t0: 0 -> 1 when BUTTON;\n    transition t1: 1 -> 0 when !BUTTON;\n}\n"
    "closed_loop room {\n    controller lamp_control;\n    environment Button = push_button(OUT = BUTTON);\n"
    "    property apples: never X0 && X1;\n    property pears: LAMP at most 2 times;\n"
    "    property plums: BUTTON precedes LAMP;\n    property cherries: reachable LAMP;\n}\n";

/// Returns the properties whose names occur in a text.
std::vector<std::string> named(const std::string& text) {
    std::vector<std::string> found;
    for (const char* name : {"apples", "pears", "plums", "cherries"})
        if (text.find(name) != std::string::npos) found.emplace_back(name);
    return found;
}

TEST(SelectedProperties, PropertiesAloneAreInAModelThatIsWritten) {
    const Folder folder;
    const std::string file = folder.write("room.grafcet", asked_of);
    using Words = std::vector<std::string>;
    struct Case {
        Words verb = {};
        Words known = {};  ///< the properties in the model without the option `--property`
    };
    for (const Case& one : {Case{{"uppaal"}, {"apples", "pears", "plums", "cherries"}},
                            Case{{"pins"}, {"apples", "pears", "plums", "cherries"}},
                            Case{{"nusmv", "--plant", "automata"}, {"apples", "pears", "plums", "cherries"}},
                            Case{{"nusmv"}, {"apples", "cherries"}}, Case{{"aiger"}, {"apples", "cherries"}},
                            Case{{"btor2"}, {"apples", "cherries"}}}) {
        SCOPED_TRACE(one.verb.front());
        Words arguments = one.verb;
        arguments.push_back(file);
        const std::string whole = grafverif(arguments).out;
        for (const std::string& property : one.known) {
            Words narrowed = arguments;
            narrowed.insert(narrowed.end(), {"--property", property});
            const Result result = grafverif(narrowed);
            EXPECT_EQ(result.code, ExitCode::Done) << result.err;
            EXPECT_EQ(named(result.out), Words{property});
            EXPECT_NE(result.out, whole);
        }
        for (const std::string& property : one.known)
            EXPECT_TRUE(std::ranges::count(named(whole), property) == 1) << property;
        Words two = arguments;
        two.insert(two.end(), {"--property", "cherries", "--property", "apples"});
        EXPECT_EQ(named(grafverif(two).out), (Words{"apples", "cherries"}));
        arguments.insert(arguments.end(), {"--property", "apple"});
        const Result wrong = grafverif(arguments);
        EXPECT_EQ(wrong.code, ExitCode::Input);
        EXPECT_NE(wrong.err.find("did you mean `apples`?"), std::string::npos) << wrong.err;
        EXPECT_EQ(wrong.out, "");
    }
}

TEST(SelectedProperties, EveryUntimedModelWarnsAboutASelectedPropertyThatItCannotExpress) {
    const Folder folder;
    std::string text = asked_of;
    text.insert(text.rfind('}'), "    property grapes: never X0 && Button in idle;\n");
    const std::string file = folder.write("room.grafcet", text);
    for (const char* verb : {"nusmv", "aiger", "btor2"}) {
        SCOPED_TRACE(verb);
        const Result result = grafverif({verb, file, "--property", "grapes"});
        EXPECT_EQ(result.code, ExitCode::Done);
        EXPECT_NE(result.err.find("property `grapes` is omitted from the "), std::string::npos) << result.err;
        EXPECT_NE(result.err.find("[not-expressible]"), std::string::npos) << result.err;
        EXPECT_EQ(result.out.find("reachable.X"), std::string::npos) << "only requested properties are written";
        EXPECT_EQ(result.out.find("grapes") == std::string::npos, verb == std::string("aiger"))
            << "AIGER does not list omitted properties";
    }
}

TEST(SelectedProperties, OnlySelectedPropertiesAreBuilt) {
    const Folder folder;
    const std::string file = folder.write("room.grafcet", asked_of), out = folder.file("out");
    for (const char* property : {"pears", "cherries"}) {
        const Result result = grafverif({"build", file, "-o", out, "--create-dirs", "--property", property});
        ASSERT_EQ(result.code, ExitCode::Done) << result.err;
        for (const char* model : {"out/room.xml", "out/room.q"})
            EXPECT_EQ(named(folder.read(model)), std::vector<std::string>{property}) << model;
    }
    EXPECT_EQ(named(folder.read("out/room.smv")), std::vector<std::string>{"cherries"});
    EXPECT_EQ(grafverif({"build", file, "-o", out, "--property", "nobody"}).code, ExitCode::Input);
}

TEST(SelectedProperties, AChartAloneHasNoPropertyToAskFor) {
    const Folder folder;
    const std::string file = folder.write("room.grafcet", asked_of);
    for (const char* verb : {"nusmv", "aiger", "btor2"}) {
        const Result result = grafverif({verb, file, "--chart", "lamp_control", "--property", "apples"});
        EXPECT_EQ(result.code, ExitCode::Input) << verb;
        EXPECT_EQ(result.out, "") << verb;
    }
}

}  // namespace
}  // namespace grafverif::app
