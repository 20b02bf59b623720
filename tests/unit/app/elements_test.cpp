// SPDX-License-Identifier: MIT
// Checks the table of elements and stages in docs/reference/language-elements.md. Each entry is tested on a chart that
// contains the most difficult case of its element. `x` means that the stage supports the chart and
// gives the result that the chart declares. `-` means that the stage rejects the element by name,
// or prints a message and omits the parts that read the element. An empty entry means that the
// element is irrelevant to the stage.
#include <gtest/gtest.h>

#include <functional>

#include "run_program.hpp"

namespace grafverif::app {
namespace {

using Cells = std::vector<std::string>;

std::string chart_of(const std::string& element) {
    return (root / "tests/unit/app/elements" / (element + ".grafcet")).string();
}

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Returns the rows of the table. The first column of each row is the name of its chart.
std::vector<Cells> matrix() {
    std::vector<Cells> rows;
    std::istringstream page(text_of(root / "docs/reference/language-elements.md"));
    bool inside = false;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("| element |")) inside = true;
        if (!inside) continue;
        if (!line.starts_with('|')) break;
        Cells cells;
        std::istringstream rest(line.substr(1));
        for (std::string cell; std::getline(rest, cell, '|');) {
            const std::size_t begin = cell.find_first_not_of(' ');
            cells.push_back(begin == std::string::npos ? ""
                                                       : cell.substr(begin, cell.find_last_not_of(' ') - begin + 1));
        }
        rows.push_back(std::move(cells));
    }
    return rows;
}

/// Returns the name of the linked chart: `steps` for `[steps, initial steps](tests/unit/app/elements/steps.grafcet)`.
std::string element_of(const std::string& cell) {
    const std::size_t begin = cell.rfind('/') + 1;
    return cell.substr(begin, cell.rfind(".grafcet") - begin);
}

Result both(const Result& one, const Result& other) {
    return {one.code == ExitCode::Done ? other.code : one.code, one.out + other.out, one.err + other.err};
}

Result formatted(const std::string& file) {
    Result result = grafverif({"fmt", file});
    EXPECT_EQ(result.out, text_of(file));
    return result;
}

Result checked(const std::string& file, const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"check", file};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return grafverif(arguments);
}

Result untimed(const std::string& file) {
    return both(checked(file, {"--untimed", "--plant", "constraints"}),
                checked(file, {"--untimed", "--plant", "automata"}));
}

/// Runs `automaton` and `testgen`; the interpreter executes a test sequence before `testgen` writes it.
Result automaton(const std::string& file) { return both(grafverif({"automaton", file}), grafverif({"testgen", file})); }

struct Stage {
    std::string column = {};
    std::function<Result(const std::string&)> run = {};
};

const std::vector<Stage>& stages() {
    static const std::vector<Stage> all = {
        {"text, fmt", formatted},
        {"draw",
         [](const std::string& file) {
             return grafverif({"draw", file});
         }},
        {"equations",
         [](const std::string& file) {
             return grafverif({"equations", file});
         }},
        {"UPPAAL",
         [](const std::string& file) {
             return grafverif({"uppaal", file});
         }},
        {"NuSMV",
         [](const std::string& file) {
             return both(grafverif({"nusmv", file}), grafverif({"nusmv", file, "--plant", "automata"}));
         }},
        {"timed engine",
         [](const std::string& file) {
             return checked(file, {"--engine", "timed"});
         }},
        {"symbolic engine", untimed},
        {"automaton", automaton},
        {"simulate",
         [](const std::string& file) {
             return grafverif({"simulate", file, "--random", "1", "--steps", "40"});
         }},
        {"ST",
         [](const std::string& file) {
             return grafverif({"st", file});
         }},
        {"analyse",
         [](const std::string& file) {
             return grafverif({"analyse", file});
         }},
    };
    return all;
}

TEST(Elements, AreSupportedByTheStagesInTheTable) {
    const std::vector<Cells> rows = matrix();
    ASSERT_GT(rows.size(), 2U);
    ASSERT_EQ(rows.front().size(), stages().size() + 1);
    for (std::size_t k = 0; k < stages().size(); ++k) EXPECT_EQ(rows.front()[k + 1], stages()[k].column);
    for (std::size_t row = 2; row < rows.size(); ++row) {
        const std::string element = element_of(rows[row].front());
        ASSERT_TRUE(fs::exists(chart_of(element))) << rows[row].front();
        for (std::size_t k = 0; k < stages().size(); ++k) {
            const std::string& cell = rows[row][k + 1];
            if (cell.empty()) continue;
            SCOPED_TRACE(element + ": " + stages()[k].column);
            const Result result = stages()[k].run(chart_of(element));
            const bool left_out = result.err.find("[not-expressible]") != std::string::npos;
            const bool analysed = stages()[k].column == "analyse" && result.code == ExitCode::Verdict;
            if (cell == "x") {
                EXPECT_TRUE(result.code == ExitCode::Done || analysed) << result.out << result.err;
                EXPECT_FALSE(left_out) << result.err;
                EXPECT_FALSE(result.out.empty());
            } else {
                EXPECT_EQ(cell, "-");
                EXPECT_TRUE(left_out || result.code == ExitCode::Input) << result.out << result.err;
            }
        }
    }
}

TEST(Elements, HaveARowEach) {
    std::size_t files = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(root / "tests/unit/app/elements")) ++files;
    EXPECT_EQ(files + 2, matrix().size());
}

}  // namespace
}  // namespace grafverif::app
