// SPDX-License-Identifier: MIT
// Checks that includes respect the layers of the modules. Link dependencies alone do not ensure this.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "repository/files.hpp"

namespace grafverif::repository {
namespace {

namespace fs = std::filesystem;

const std::map<std::string, int> levels = {
    {"certify", 0}, {"support", 0},  {"ir", 1},      {"syntax", 2},  {"run", 2},      {"bdd", 2},  {"circuit", 2},
    {"read", 3},    {"derive", 3},   {"plant", 3},   {"compose", 3}, {"schedule", 3}, {"emit", 3}, {"check", 3},
    {"compare", 3}, {"conform", 3},  {"analyse", 3}, {"explain", 3}, {"report", 3},   {"draw", 3}, {"simulate", 4},
    {"rpc", 4},     {"pipeline", 5}, {"page", 6},    {"lsp", 6},     {"mcp", 6},      {"edit", 7}, {"app", 8},
};

struct Inclusion {
    fs::path file = {};
    std::string module_name = {};
    std::string header = {};  ///< the text between the quotes or brackets
};

std::vector<fs::path> sources(const std::vector<fs::path>& folders) {
    std::vector<fs::path> found;
    for (const fs::path& folder : folders)
        for (const auto& entry : fs::recursive_directory_iterator(root / folder))
            if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp") found.push_back(entry.path());
    std::ranges::sort(found);
    return found;
}

/// Returns the module of `file`: its first folder below src or include/grafverif. The public API belongs to the
/// pipeline.
std::string module_of(const fs::path& file) {
    if (file == root / "include/grafverif/grafverif.hpp") return "pipeline";
    for (const char* base : {"src", "include/grafverif"}) {
        const fs::path below = fs::relative(file, root / base);
        if (*below.begin() != ".." && below.has_parent_path()) return below.begin()->string();
    }
    return "";
}

std::vector<Inclusion> inclusions() {
    static const std::regex pattern(R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"])re");
    std::vector<Inclusion> found;
    for (const fs::path& file : sources({"include", "src"})) {
        std::istringstream lines(text_of(file));
        for (std::string line; std::getline(lines, line);) {
            std::smatch match;
            if (std::regex_search(line, match, pattern)) found.push_back({file, module_of(file), match[1]});
        }
    }
    return found;
}

/// Returns the module of a header of the project, and an empty string for any other header.
std::string module_of_header(const std::string& header) {
    const fs::path path(header);
    if (header == "grafverif/grafverif.hpp") return "pipeline";
    if (header.starts_with("grafverif/")) return std::next(path.begin())->string();
    const std::string first = path.begin()->string();
    return levels.contains(first) && path.has_parent_path() ? first : "";
}

TEST(Layering, EveryFolderIsAModuleWithALayer) {
    for (const fs::path& file : sources({"include/grafverif", "src"}))
        EXPECT_TRUE(levels.contains(module_of(file))) << file;
}

TEST(Layering, NoModuleIncludesAHigherModuleOrAnotherCommand) {
    const std::vector<Inclusion> all = inclusions();
    ASSERT_GT(all.size(), 100u);
    for (const Inclusion& inclusion : all) {
        const std::string target = module_of_header(inclusion.header);
        if (target.empty() || target == inclusion.module_name) continue;
        ASSERT_TRUE(levels.contains(target)) << inclusion.file << " includes " << inclusion.header;
        EXPECT_LT(levels.at(target), levels.at(inclusion.module_name))
            << inclusion.file << " includes " << inclusion.header;
    }
}

TEST(Layering, DrawingIsUpToDate) {
    const fs::path drawn = fs::temp_directory_path() / "grafverif-modules.svg";
    ASSERT_EQ(
        std::system(("'" + (root / "docs/module_dependencies.sh").string() + "' >'" + drawn.string() + "'").c_str()),
        0);
    EXPECT_EQ(text_of(drawn), text_of(root / "docs/module_dependencies.svg"))
        << "run docs/module_dependencies.sh >docs/module_dependencies.svg";
    fs::remove(drawn);
}

TEST(Layering, EveryPathNamedByTheArchitecturePageExists) {
    const std::string page = text_of(root / "docs/explanation/architecture.md");
    static const std::regex pattern(R"(`([a-z]+/[a-z_/]*(\.cpp|\.sh)?)`)");
    std::size_t named = 0;
    for (std::sregex_iterator place(page.begin(), page.end(), pattern), end; place != end; ++place, ++named) {
        const std::string path = (*place)[1];
        EXPECT_TRUE(fs::exists(root / path) || fs::exists(root / "src" / path)) << path;
    }
    EXPECT_GT(named, 12U);
}

TEST(Layering, ThirdPartyLibrariesStayInTheirModules) {
    struct Rule {
        std::string prefix = {};
        std::set<std::string> places = {};  ///< modules, or folders of modules
    };
    const std::vector<Rule> rules = {
        {"pugixml", {"read", "emit/uppaal"}},
        {"yaml-cpp", {"read/program"}},
        {"boost/multiprecision", {"bdd"}},
        {"boost/program_options", {"app"}},
        {"cadical", {"check/pdr"}},
        {"histedit", {"app/system/line_editor"}},
        {"unicode", {"support"}},
        {"boost/asio", {"app/serve"}},
        {"boost/beast", {"app/serve"}},
        {"gtest", {}},
    };
    for (const Inclusion& inclusion : inclusions()) {
        for (const Rule& rule : rules) {
            if (!inclusion.header.starts_with(rule.prefix)) continue;
            const std::string place = fs::relative(inclusion.file, root / "src").string();
            const bool allowed = std::ranges::any_of(rule.places, [&](const std::string& where) {
                return inclusion.module_name == where || place.starts_with(where);
            });
            EXPECT_TRUE(allowed) << inclusion.file << " includes " << inclusion.header;
        }
    }
}

TEST(Layering, PublicHeadersNameNoThirdParty) {
    for (const Inclusion& inclusion : inclusions()) {
        if (inclusion.file.string().find("/include/grafverif/") == std::string::npos) continue;
        const bool is_own = inclusion.header.starts_with("grafverif/");
        const bool standard =
            inclusion.header.find('/') == std::string::npos && inclusion.header.find('.') == std::string::npos;
        EXPECT_TRUE(is_own || standard) << inclusion.file << " includes " << inclusion.header;
    }
}

TEST(Layering, OnlyTheAppUsesProcessStreamsAndOnlyThePipelineAlsoReadsFiles) {
    static const std::regex streams(R"(std::c(in|out|err)\b|\bgetenv\b)"),
        files(R"(std::(i|o)?fstream|std::filesystem(?!::path)|[^\w]::open\()");
    for (const fs::path& file : sources({"include/grafverif", "src"})) {
        if (module_of(file) == "certify") continue;  // a separate program
        EXPECT_EQ(text_of(file).find("#include <fstream>"), std::string::npos) << file << " must not include <fstream>";
        if (module_of(file) == "app") continue;
        EXPECT_FALSE(std::regex_search(text_of(file), streams)) << file;
        EXPECT_TRUE(file.parent_path() == root / "src/pipeline" || !std::regex_search(text_of(file), files)) << file;
    }
}

TEST(Repository, EveryFileBeginsWithItsLicence) {
    for (const fs::path& file : sources({"include", "src", "tests"}))
        EXPECT_TRUE(text_of(file).starts_with("// SPDX-License-Identifier: MIT\n")) << file;
}

TEST(Repository, SourcesAreFormatted) {
    const std::string formatter = "clang-format-14";  // other versions of clang-format break lines differently
    if (std::system((formatter + " --version >/dev/null 2>&1").c_str()) != 0)
        GTEST_SKIP() << formatter << " is not installed";
    std::string command = "cd '" + root.string() + "' && " + formatter + " --dry-run --Werror";
    for (const fs::path& file : sources({"include", "src", "tests", "bench"}))
        command += " '" + fs::relative(file, root).string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << "run clang-format-14 -i on the files listed above";
}

TEST(Repository, NoSourceIsTooLong) {
    for (const fs::path& file : sources({"include", "src"})) {
        const std::string text = text_of(file);
        EXPECT_LE(std::ranges::count(text, '\n'), 500) << file << ": the file is too long; split it by topic";
    }
}

TEST(Repository, NoFolderHoldsMoreThanTwentySources) {
    std::map<fs::path, int> count;
    for (const fs::path& file : sources({"src"}))
        if (file.extension() == ".cpp") ++count[file.parent_path()];
    for (const auto& [folder, files] : count)
        EXPECT_LE(files, 20) << folder << ": too many files; move related files into a separate folder";
}

TEST(Repository, ThePublicApiIsSmall) {
    std::ptrdiff_t headers = 0, lines = 0;
    for (const fs::path& file : sources({"include"})) {
        std::istringstream text(text_of(file));
        for (std::string line; std::getline(text, line);) {
            const std::size_t begin = line.find_first_not_of(' ');
            if (begin != std::string::npos && line.compare(begin, 2, "//") != 0)
                ++lines;  // documentation is not counted
        }
        ++headers;
    }
    EXPECT_LE(headers, 45);
    EXPECT_LE(lines, 2135);
}

TEST(Repository, EveryPublicHeaderIsInstalled) {
    const std::string listed = text_of(root / "include" / "CMakeLists.txt");
    for (const fs::path& file : sources({"include"})) {
        const std::string name = fs::relative(file, root / "include").string();
        EXPECT_NE(listed.find(name), std::string::npos) << name << " is missing in include/CMakeLists.txt";
    }
}

}  // namespace
}  // namespace grafverif::repository
