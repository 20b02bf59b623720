// SPDX-License-Identifier: MIT
// Checks the examples in the documents against the program. Each `$ ...` line of a console block is run and its output
// is compared; a line `...` matches any lines. Each grafcet block must be canonical text. For a closed loop in such a
// block, `check` must find that each property holds, unless the property is declared `expected violated`. Commands find
// the grafcet blocks of their page as files, which are named after the last chart, component or loop in the block.
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <regex>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "repository/files.hpp"

namespace grafverif::repository {
namespace {

namespace fs = std::filesystem;

const fs::path program = GRAFVERIF_PROGRAM;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

struct Block {
    std::string language = {};  ///< the word after the opening fence
    std::vector<std::string> lines = {};
    std::size_t line = 0;  ///< the line of the opening fence, from 1
};

std::vector<Block> blocks_of(const fs::path& document) {
    std::vector<Block> blocks;
    bool inside = false;
    std::size_t number = 0;
    for (const std::string& line : lines_of(text_of(document))) {
        ++number;
        if (line.starts_with("```")) {
            if (!inside) blocks.push_back({line.substr(3), {}, number});
            inside = !inside;
        } else if (inside) {
            blocks.back().lines.push_back(line);
        }
    }
    return blocks;
}

std::vector<fs::path> documents() {
    std::vector<fs::path> found = {root / "README.md", root / "CONTRIBUTING.md"};
    for (const char* folder : {"docs", "samples"})
        for (const auto& entry : fs::recursive_directory_iterator(root / folder))
            if (entry.path().extension() == ".md") found.push_back(entry.path());
    std::ranges::sort(found);
    return found;
}

std::string written(const Block& block) {
    std::string text;
    for (const std::string& line : block.lines) text += line + '\n';
    return text;
}

/// Returns the name of the last declaration of the block.
std::string name_of(const Block& block) {
    static const std::regex pattern("(?:^|\n)(?:grafcet|component|closed_loop) (\\w+)");
    const std::string text = written(block);
    std::string name = "block";
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) name = (*match)[1];
    return name;
}

/// A folder in which the documents' commands run. The folder contains the documents, the samples
/// and the templates at the same relative paths as in the repository.
class Workplace {
public:
    Workplace() {
        std::string pattern = (fs::temp_directory_path() / "grafverif-docs-XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
        for (const char* name : {"bench", "docs", "samples", "templates"})
            fs::create_directory_symlink(root / name, folder_ / name);
    }
    Workplace(const Workplace&) = delete;
    Workplace& operator=(const Workplace&) = delete;
    ~Workplace() { fs::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

    /// Applies a `diff` block. The first line of the block names the file; the lines marked ` ` and
    /// `-` are replaced by the lines marked ` ` and `+`. Returns false if the file does not contain
    /// the former lines.
    bool apply(const Block& block) const {
        std::string from, to;
        for (const std::string& line : std::span(block.lines).subspan(1)) {
            if (!line.starts_with('+')) from += line.substr(std::min<std::size_t>(1, line.size())) + '\n';
            if (!line.starts_with('-')) to += line.substr(std::min<std::size_t>(1, line.size())) + '\n';
        }
        const std::string name = block.lines.front().substr(4);
        std::string text = text_of(folder_ / name);
        const std::size_t at = text.find(from);
        if (at == std::string::npos) return false;
        write(name, text.replace(at, from.size(), to));
        return true;
    }

    /// Returns both output streams of `command`, which a shell runs in the folder.
    std::string output_of(const std::string& command) const {
        const std::string line = "cd '" + folder_.string() + "' && PATH='" + program.parent_path().string() +
                                 "':$PATH; { " + command + "; } 2>&1";
        const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(line.c_str(), "r"), ::pclose);
        std::string text;
        std::array<char, 4096> buffer = {};
        for (std::size_t got = 0; (got = std::fread(buffer.data(), 1, buffer.size(), pipe.get())) > 0;)
            text.append(buffer.data(), got);
        return text;
    }

private:
    fs::path folder_ = {};
};

/// True if `actual` matches `expected`; a line `...` of `expected` matches any number of lines.
bool matches(const std::vector<std::string>& expected, std::size_t e, const std::vector<std::string>& actual,
             std::size_t a) {
    if (e == expected.size()) return a == actual.size();
    if (expected[e] == "...") {
        for (std::size_t next = a; next <= actual.size(); ++next)
            if (matches(expected, e + 1, actual, next)) return true;
        return false;
    }
    return a < actual.size() && expected[e] == actual[a] && matches(expected, e + 1, actual, a + 1);
}

/// Runs the commands of a console block and compares their output; returns their number.
std::size_t run_commands(const fs::path& document, const Block& block, const Workplace& workplace) {
    std::size_t commands = 0;
    for (std::size_t i = 0; i < block.lines.size(); ++commands) {
        const std::string command = block.lines[i].starts_with("$ ") ? block.lines[i].substr(2) : "";
        std::vector<std::string> expected;
        for (++i; i < block.lines.size() && !block.lines[i].starts_with("$ "); ++i) expected.push_back(block.lines[i]);
        EXPECT_NE(command, "") << document << ':' << block.line << ": a console block begins with `$ `";
        const std::string output = workplace.output_of(command);
        EXPECT_TRUE(matches(expected, 0, lines_of(output), 0))
            << document << ':' << block.line << ": `" << command << "` prints\n"
            << output;
    }
    return commands;
}

/// True for a tutorial, which runs from beginning to end in one folder: `grafcet` blocks are written and `diff` blocks
/// are applied there.
bool is_tutorial(const fs::path& document) { return document.parent_path().filename() == "tutorials"; }

std::size_t run_tutorial(const fs::path& document) {
    const Workplace workplace;
    std::size_t commands = 0;
    for (const Block& block : blocks_of(document)) {
        if (block.language == "grafcet") workplace.write(name_of(block) + ".grafcet", written(block));
        if (block.language == "diff") {
            EXPECT_TRUE(workplace.apply(block)) << document << ':' << block.line;
        }
        if (block.language == "console") commands += run_commands(document, block, workplace);
    }
    return commands;
}

TEST(Documents, ShowTheRealOutputOfTheirCommands) {
    std::size_t commands = 0;
    for (const fs::path& document : documents()) {
        if (is_tutorial(document)) {
            commands += run_tutorial(document);
            continue;
        }
        const std::vector<Block> blocks = blocks_of(document);
        for (const Block& block : blocks) {
            if (block.language != "console") continue;
            const Workplace workplace;
            for (const Block& shown : blocks)
                if (shown.language == "grafcet") workplace.write(name_of(shown) + ".grafcet", written(shown));
            commands += run_commands(document, block, workplace);
        }
    }
    EXPECT_GT(commands, 30u);
}

void run_failing_example() { run_commands("page.md", Block{"console", {"$ echo right", "wrong"}, 7}, Workplace{}); }

TEST(Documents, FailIfTheOutputOfACommandDiffers) {
    EXPECT_NONFATAL_FAILURE(run_failing_example(), "\"page.md\":7: `echo right` prints\nright\n");
}

TEST(Documents, ShowCanonicalText) {
    std::size_t charts = 0;
    for (const fs::path& document : documents()) {
        for (const Block& block : blocks_of(document)) {
            if (!block.language.starts_with("grafcet")) continue;
            ++charts;
            std::string text = written(block);
            if (block.language != "grafcet") {  // a block `grafcet closed_loop` is the content of a closed loop
                text = "closed_loop page {\n";
                for (const std::string& line : block.lines) text += (line.empty() ? "" : "    ") + line + '\n';
                text += "}\n";
            }
            const Workplace workplace;
            workplace.write("block.grafcet", text);
            EXPECT_EQ(workplace.output_of("grafverif fmt block.grafcet"), text) << document << ':' << block.line;
        }
    }
    EXPECT_GT(charts, 15u);
}

TEST(Documents, StateTheVerdictsThatCheckFinds) {
    std::size_t loops = 0;
    for (const fs::path& document : documents()) {
        for (const Block& block : blocks_of(document)) {
            const std::string text = written(block);
            if (block.language != "grafcet" || text.find("closed_loop ") == std::string::npos || is_tutorial(document))
                continue;
            ++loops;
            const Workplace workplace;
            workplace.write("block.grafcet", text);
            const std::string printed = workplace.output_of("grafverif check --all block.grafcet && echo as claimed");
            EXPECT_TRUE(printed.ends_with("as claimed\n")) << document << ':' << block.line << '\n' << printed;
        }
    }
    EXPECT_GE(loops, 4u);
}

TEST(Documents, ShowTheProgramThatTheTestsBuildAgainstTheInstalledLibrary) {
    const std::string source = text_of(root / "tests/repository/consumer/main.cpp");
    std::size_t shown = 0;
    for (const Block& block : blocks_of(root / "docs/how-to/cpp.md")) {
        if (block.language != "cpp") continue;
        EXPECT_TRUE(source.ends_with(written(block))) << written(block);
        ++shown;
    }
    EXPECT_EQ(shown, 1U);
}

TEST(Documents, ShowEachSampleAsItIsDrawn) {
    std::size_t charts = 0;
    for (const auto& entry : fs::recursive_directory_iterator(root / "samples")) {
        if (entry.path().extension() != ".grafcet") continue;
        if (text_of(entry.path()).find("\ngrafcet ") == std::string::npos) continue;  // a loop of a PLC program
        const fs::path drawing = fs::path(entry.path()).replace_extension(".svg");
        EXPECT_EQ(text_of(drawing), Workplace().output_of("grafverif draw " + entry.path().string()))
            << "docs/pictures.sh updates " << drawing;
        EXPECT_NE(text_of(entry.path().parent_path() / "README.md").find("](" + drawing.filename().string() + ")"),
                  std::string::npos)
            << drawing;
        ++charts;
    }
    EXPECT_GE(charts, 7U);
}

TEST(Documents, HaveTheirCommandsInConsoleBlocks) {
    for (const fs::path& document : documents())
        for (const std::string& line : lines_of(text_of(document)))
            EXPECT_FALSE(line.starts_with("    $ ")) << document << ": `" << line << "` is not in a console block";
}

TEST(Documents, NameOnlyFilesThatExist) {
    for (const fs::path& document : documents()) {
        const std::string text = text_of(document);
        for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](", at + 1)) {
            const std::size_t end = text.find(')', at);
            std::string target = text.substr(at + 2, end - at - 2);
            target = target.substr(0, target.find('#'));
            if (target.empty() || target.find("://") != std::string::npos) continue;
            EXPECT_TRUE(fs::exists(document.parent_path() / target)) << document << " has a broken link to " << target;
        }
    }
}

TEST(Help, EveryCommandHasHelpWithExamples) {
    const Workplace workplace;
    const std::string overview = workplace.output_of("grafverif --help");
    for (const char* verb : {"build", "uppaal", "nusmv", "equations", "components", "fmt", "plc", "test", "st"}) {
        EXPECT_NE(overview.find(std::string("\n  ") + verb), std::string::npos) << verb;
        const std::string help = workplace.output_of(std::string("grafverif ") + verb + " --help");
        EXPECT_TRUE(help.starts_with(std::string("Usage: grafverif ") + verb)) << help;
        EXPECT_NE(help.find("Examples:\n  grafverif "), std::string::npos) << help;
    }
}

}  // namespace
}  // namespace grafverif::repository
