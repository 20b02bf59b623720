// SPDX-License-Identifier: MIT
// Checks that the keywords of editors, in editors/words.json, equal those of grammars/grafcet.ll. The tests in
// tests/editors test highlighting with the syntax engines of the editors.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>

#include "repository/files.hpp"

namespace grafverif::repository {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::set<std::string> matches_of(const std::string& text, const std::regex& pattern) {
    std::set<std::string> found;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
        found.insert((*match)[1]);
    return found;
}

std::set<std::string> words_of_table() {
    std::set<std::string> words;
    const json table = json::parse(text_of(root / "editors/words.json"));
    for (const auto& [category, list] : table.items())
        for (const std::string word : list) EXPECT_TRUE(words.insert(word).second) << word << " occurs twice";
    return words;
}

TEST(Editors, KnowTheKeywordsOfTheLexer) {
    const std::set<std::string> lexer =
        matches_of(text_of(root / "grammars/grafcet.ll"), std::regex("\n\"([a-z_]+)\" +return lexer\\.word"));
    EXPECT_GT(lexer.size(), 60U);
    EXPECT_EQ(words_of_table(), lexer);
}

TEST(Editors, NameEachWordInBothGrammars) {
    for (const char* name : {"editors/vscode/syntaxes/grafcet.tmLanguage.json", "editors/vim/syntax/grafcet.vim"}) {
        std::string text = text_of(root / name);
        text = std::regex_replace(text, std::regex(R"(\\+[bs])"), " ");  // removes the escapes of `\bleads\s+to\b`
        const std::set<std::string> known = matches_of(text, std::regex("([A-Za-z_]+)"));
        for (const std::string& word : words_of_table()) EXPECT_TRUE(known.contains(word)) << word << " in " << name;
    }
}

/// Returns the text that VS Code inserts for a snippet with unchanged fields.
std::string expanded(std::string text) {
    std::map<std::string, std::string> fields;
    const std::regex field(R"(\$\{(\d+)(?::([^{}$]*)|\|([^,|]*)[^}]*)\})");
    for (std::smatch match; std::regex_search(text, match, field);) {
        fields[match[1]] = match[2].matched ? match[2].str() : match[3].str();
        text = match.prefix().str() + fields[match[1]] + match.suffix().str();
    }
    for (std::smatch match; std::regex_search(text, match, std::regex(R"(\$(\d+))"));)
        text = match.prefix().str() + fields[match[1]] + match.suffix().str();
    return text;
}

/// Returns a file that contains `text` in a place where the syntax permits it.
std::string in_place(const std::string& text) {
    if (std::regex_search(text, std::regex("^(//|grafcet|component|closed_loop)"))) return text;
    if (text.starts_with("property")) return "closed_loop l {\n" + text + "\n}";
    if (text.find(":=") != std::string::npos) return "grafcet g {\nstep 9 {\n" + text + "\n}\n}";
    return "grafcet g {\n" + text + "\n}";
}

TEST(Editors, WriteSnippetsThatTheParserAccepts) {
    const fs::path file = fs::temp_directory_path() / "grafverif-snippet.grafcet";
    const json snippets = json::parse(text_of(root / "editors/vscode/snippets/grafcet.json"));
    for (const auto& [name, snippet] : snippets.items()) {
        std::string body;
        if (snippet["body"].is_string()) body = snippet["body"];
        else
            for (const std::string line : snippet["body"]) body += line + '\n';
        std::ofstream(file) << in_place(expanded(body));
        const std::string command = GRAFVERIF_PROGRAM " fmt '" + file.string() + "' >/dev/null";
        EXPECT_EQ(std::system(command.c_str()), 0) << name << '\n' << text_of(file);
    }
    fs::remove(file);
}

TEST(Editors, HaveTheVersionOfTheProgram) {
    const std::string project = text_of(root / "CMakeLists.txt");
    const auto versions = matches_of(project, std::regex(R"(project\(grafverif VERSION ([0-9.]+))"));
    ASSERT_EQ(versions.size(), 1U);
    for (const char* name : {"package.json", "package-lock.json"})
        EXPECT_EQ(json::parse(text_of(root / "editors/vscode" / name))["version"], *versions.begin()) << name;
}

}  // namespace
}  // namespace grafverif::repository
