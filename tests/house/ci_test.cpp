// SPDX-License-Identifier: MIT
// What runs in continuous integration runs here: the steps of the action, the scripts of the template, the entries of the
// hooks, by a shell, on charts with and without faults.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "house/files.hpp"

namespace grafverif::house {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const fs::path& file) {
    std::vector<std::string> lines;
    std::istringstream in(text_of(file));
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::size_t indent(const std::string& line) { return std::min(line.find_first_not_of(' '), line.size()); }

/// The value behind `key` in `line`, or nothing.
std::string value(const std::string& line, const std::string& key) {
    const std::size_t at = line.find(key);
    return at == std::string::npos ? "" : line.substr(at + key.size());
}

/// A project with these charts in a folder of its own, and a shell in it.
class Project {
public:
    explicit Project(const std::map<std::string, std::string>& charts) {
        std::string pattern = (fs::temp_directory_path() / "grafverif-ci-XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
        for (const auto& [name, text] : charts) {
            fs::create_directories((folder_ / name).parent_path());
            std::ofstream(folder_ / name) << text;
        }
    }
    Project(const Project&) = delete;
    Project& operator=(const Project&) = delete;
    ~Project() { fs::remove_all(folder_); }

    /// The exit code of `script`, run as GitHub runs `shell: bash`.
    int run(const std::string& script, const std::map<std::string, std::string>& environment = {}) {
        std::ofstream(folder_ / "step.sh") << script;
        std::string command = "cd '" + folder_.string() + "' && PATH='" +
                              fs::path(GRAFVERIF_PROGRAM).parent_path().string() + "':\"$PATH\"";
        for (const auto& [name, what] : environment) command += " " + name + "='" + what + "'";
        command += " bash --noprofile --norc -eo pipefail step.sh 2>&1";
        const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), nullptr_close);
        output.clear();
        std::array<char, 4096> buffer = {};
        for (std::size_t got = 0; (got = std::fread(buffer.data(), 1, buffer.size(), pipe.get())) > 0;)
            output.append(buffer.data(), got);
        const int status = ::pclose(pipe.get());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    std::string read(const std::string& name) const {
        return fs::exists(folder_ / name) ? text_of(folder_ / name) : "";
    }

    std::string output = {};

private:
    static int nullptr_close(FILE*) { return 0; }  // closed by hand, for its status
    fs::path folder_ = {};
};

const std::string gate = text_of(root / "samples/integration/gate.grafcet"),
                  controller = text_of(root / "samples/integration/gate_controller.grafcet");
const std::map<std::string, std::string> good = {{"charts/gate.grafcet", gate},
                                                 {"charts/gate_controller.grafcet", controller}};

std::map<std::string, std::string> faulty() {
    std::string wrong = controller;
    wrong.replace(wrong.find("{ SHUT; }"), 9, "{ SHUT; OPEN; }");
    wrong.replace(wrong.find("    step 2;"), 11, "  step 2;");
    return {{"charts/gate.grafcet", gate}, {"charts/gate_controller.grafcet", wrong}};
}

/// A step of the action: `env` with the inputs as given, or as they are by themselves.
struct Step {
    std::string name = {}, script = {};
    std::map<std::string, std::string> environment = {};
};

std::vector<Step> steps_of_action() {
    std::map<std::string, std::string> inputs;
    std::vector<Step> steps;
    std::string input;
    std::size_t block = 0;  // the indent of the `run: |` that we are in
    for (const std::string& line : lines_of(root / "action.yml")) {
        if (block != 0 && (line.empty() || indent(line) > block)) {
            steps.back().script += (line.size() > block + 2 ? line.substr(block + 2) : "") + "\n";
            continue;
        }
        block = 0;
        if (steps.empty() && indent(line) == 2 && line.ends_with(':')) input = line.substr(2, line.size() - 3);
        if (std::string given = value(line, "default: "); steps.empty() && !given.empty()) {
            if (given.front() == '"') given = given.substr(1, given.size() - 2);
            inputs[input] = given;
        }
        if (line.starts_with("    - name: ")) steps.push_back({value(line, "- name: "), "", {}});
        if (line.ends_with("run: |")) block = indent(line);
        if (const std::string what = value(line, ": ${{ inputs."); !what.empty())
            steps.back().environment[line.substr(indent(line), line.find(':') - indent(line))] =
                inputs.at(what.substr(0, what.find(' ')));
    }
    return steps;
}

TEST(Ci, StepsOfTheActionPassOnGoodChartsAndFailOnFaultyOnes) {
    const std::vector<Step> steps = steps_of_action();
    ASSERT_EQ(steps.size(), 4u);
    Project fine(good), wrong(faulty());
    for (const Step& step : steps) {
        SCOPED_TRACE(step.name + "\n" + step.script);
        ASSERT_NE(step.script, "");
        EXPECT_EQ(fine.run(step.script, step.environment), 0) << fine.output;
        if (step.name.starts_with("Build") || step.name.starts_with("What can go wrong")) continue;
        EXPECT_EQ(wrong.run(step.script, step.environment), 1) << wrong.output;
    }
    EXPECT_NE(wrong.read("grafverif.junit.xml").find("violated (charts/gate.grafcet:"), std::string::npos);
    EXPECT_NE(wrong.read("grafverif.sarif").find("\"codeFlows\""), std::string::npos);
    EXPECT_NE(fine.read("analyse.sarif").find("\"results\""), std::string::npos);
    Project none({});
    EXPECT_NE(none.run(steps.back().script, steps.back().environment), 0) << "no chart is no success";
}

TEST(Ci, ScriptsOfTheTemplatePassOnGoodChartsAndFailOnFaultyOnes) {
    std::string before;
    std::map<std::string, std::string> variables, jobs;
    std::string job;
    for (const std::string& line : lines_of(root / "ci/grafverif.gitlab-ci.yml")) {
        if (indent(line) == 0 && line.ends_with(':')) job = line.substr(0, line.size() - 1);
        const std::string command = line.starts_with("    - ") ? line.substr(6) + "\n" : "";
        if (job == ".grafverif") before += command;
        else if (!command.empty()) jobs[job] += command;
        if (job == "variables" && indent(line) == 2) {
            const std::string given = value(line, ": ");
            variables[line.substr(2, line.find(':') - 2)] = given.substr(1, given.size() - 2);
        }
    }
    ASSERT_EQ(jobs.size(), 3u);
    Project fine(good), wrong(faulty());
    for (const auto& [name, script] : jobs) {
        SCOPED_TRACE(name);
        EXPECT_EQ(fine.run(before + script, variables), 0) << fine.output;
        const int expected = name == "grafverif-analyse" ? 0 : 1;
        EXPECT_EQ(wrong.run(before + script, variables), expected) << wrong.output;
    }
    EXPECT_NE(wrong.read("grafverif.junit.xml").find("<failure"), std::string::npos);
}

TEST(Ci, HooksTakeTheFilesOfACommit) {
    std::size_t hooks = 0;
    Project fine(good), wrong(faulty());
    for (const std::string& line : lines_of(root / ".pre-commit-hooks.yaml")) {
        const std::string entry = value(line, "  entry: ");
        if (entry.empty()) continue;
        ++hooks;
        const std::string command = entry + " charts/gate.grafcet charts/gate_controller.grafcet\n";
        EXPECT_EQ(fine.run(command), 0) << command << fine.output;
        const bool finds = entry.find("analyse") == std::string::npos;
        EXPECT_EQ(wrong.run(command), finds ? 1 : 0) << command << wrong.output;
    }
    EXPECT_EQ(hooks, 3u);
}

}  // namespace
}  // namespace grafverif::house
