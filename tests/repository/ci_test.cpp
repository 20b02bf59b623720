// SPDX-License-Identifier: MIT
// Executes the parts of continuous integration in a shell, on charts with and without faults: the steps of the action,
// the scripts of the template, and the entries of the hooks.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "repository/files.hpp"

namespace grafverif::repository {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const fs::path& file) {
    std::vector<std::string> lines;
    std::istringstream in(text_of(file));
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::size_t indent(const std::string& line) { return std::min(line.find_first_not_of(' '), line.size()); }

/// Returns the value after `key` in `line`, or an empty string.
std::string value(const std::string& line, const std::string& key) {
    const std::size_t at = line.find(key);
    return at == std::string::npos ? "" : line.substr(at + key.size());
}

/// A project with the given charts in a separate folder, and a shell that runs in this folder.
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

    /// Returns the exit code of `script`, which runs as GitHub runs `shell: bash`.
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
    bool has(const std::string& name) const { return fs::exists(folder_ / name); }
    std::string read(const std::string& name) const {
        return fs::exists(folder_ / name) ? text_of(folder_ / name) : "";
    }

    std::string output = {};

private:
    static int nullptr_close(FILE*) { return 0; }  // the caller closes the stream itself to get the status
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

/// A step of the action as a shell script. The environment of the step contains the default values
/// of the inputs.
struct Step {
    std::string name = {}, script = {};
    std::map<std::string, std::string> environment = {};
};

std::vector<Step> steps_of_action() {
    std::map<std::string, std::string> inputs;
    std::vector<Step> steps;
    std::string input;
    std::size_t block = 0;  // the indentation of the current `run: |`
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
    ASSERT_EQ(steps.size(), 5u);
    Project fine(good), wrong(faulty());
    for (const Step& step : steps) {
        SCOPED_TRACE(step.name + "\n" + step.script);
        ASSERT_NE(step.script, "");
        EXPECT_EQ(fine.run(step.script, step.environment), 0) << fine.output;
        if (step.script.find("grafverif fmt") == std::string::npos && step.name != "Properties") continue;
        EXPECT_EQ(wrong.run(step.script, step.environment), 1) << wrong.output;
    }
    EXPECT_NE(wrong.read("grafverif.junit.xml").find("violated (charts/gate.grafcet:"), std::string::npos);
    EXPECT_NE(wrong.read("grafverif.sarif").find("\"codeFlows\""), std::string::npos);
    EXPECT_NE(fine.read("analyse.sarif").find("\"results\""), std::string::npos);
    Project none({});
    EXPECT_NE(none.run(steps.back().script, steps.back().environment), 0) << "the step must fail if there is no chart";
}

TEST(Ci, AMisspeltStepOfTheActionIsAnError) {
    const Step step = steps_of_action().front();
    const std::map<std::string, std::string> files = {{"check", ""}};
    for (const char* fine : {"check", "fmt analyse check", " check\n fmt"}) {
        Project in(files);
        EXPECT_EQ(in.run(step.script, {{"STEPS", fine}}), 0) << fine;
    }
    for (const char* wrong : {"", " ", "chek", "fmt chek", "fmt,check", "*"}) {
        Project in(files);
        EXPECT_EQ(in.run(step.script, {{"STEPS", wrong}}), 2) << wrong;
        EXPECT_NE(in.output.find("choose from fmt, analyse, check"), std::string::npos) << in.output;
    }
}

/// Returns the lines of a log that GitHub would interpret as commands: those that begin with `::`, or contain `##[`,
/// unless commands are stopped.
std::vector<std::string> workflow_commands(const std::string& log) {
    std::vector<std::string> obeyed;
    std::istringstream in(log);
    std::string token;
    for (std::string line; std::getline(in, line);) {
        const std::string text = line.substr(indent(line));
        if (!token.empty()) {
            if (text == "::" + token + "::") token.clear();
        } else if (const std::string stop = "::stop-commands::"; text.starts_with(stop)) {
            token = text.substr(stop.size());
        } else if (text.starts_with("::") || text.find("##[") != std::string::npos) {
            obeyed.push_back(line);
        }
    }
    if (!token.empty()) obeyed.emplace_back("commands remain stopped");
    return obeyed;
}

TEST(Ci, LinesOfChartsDoNotBecomeWorkflowCommands) {
    const std::string line = "    ::error::from a chart ##[error]\n";
    EXPECT_EQ(workflow_commands(line).size(), 1u);
    std::size_t quoted = 0;
    std::set<std::string> tokens;
    for (const Step& step : steps_of_action()) {
        const std::map<std::string, std::string> files = {{"broken.grafcet", "grafcet g {\n" + line}};
        Project project(files);
        project.run(step.script, step.environment);
        EXPECT_EQ(workflow_commands(project.output), std::vector<std::string>{}) << project.output;
        quoted += project.output.find("::error::from a chart") != std::string::npos ? 1U : 0U;
        if (const std::size_t at = project.output.find("::stop-commands::"); at != std::string::npos)
            tokens.insert(project.output.substr(at, project.output.find('\n', at) - at));
    }
    EXPECT_EQ(quoted, 3u) << "each step that reads charts prints the line";
    EXPECT_EQ(tokens.size(), 3u) << "no token is used twice";
}

/// The scripts of the template for GitLab, by job.
struct Template {
    std::map<std::string, std::string> variables = {}, jobs = {};
};

Template scripts_of_template() {
    std::string before, job;
    Template read;
    auto& [variables, jobs] = read;
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
    for (auto& [name, script] : jobs) script = before + script;
    return read;
}

TEST(Ci, ScriptsOfTheTemplatePassOnGoodChartsAndFailOnFaultyOnes) {
    const auto [variables, jobs] = scripts_of_template();
    ASSERT_EQ(jobs.size(), 3u);
    Project fine(good), wrong(faulty());
    for (const auto& [name, script] : jobs) {
        SCOPED_TRACE(name);
        EXPECT_EQ(fine.run(script, variables), 0) << fine.output;
        const int expected = name == "grafverif-analyse" ? 0 : 1;
        EXPECT_EQ(wrong.run(script, variables), expected) << wrong.output;
    }
    EXPECT_NE(wrong.read("grafverif.junit.xml").find("<failure"), std::string::npos);
}

std::vector<std::string> entries_of_hooks() {
    std::vector<std::string> entries;
    for (const std::string& line : lines_of(root / ".pre-commit-hooks.yaml"))
        if (std::string entry = value(line, "  entry: "); !entry.empty()) entries.push_back(std::move(entry));
    return entries;
}

TEST(Ci, HooksTakeTheFilesOfACommit) {
    Project fine(good), wrong(faulty());
    const std::vector<std::string> entries = entries_of_hooks();
    EXPECT_EQ(entries.size(), 3u);
    for (const std::string& entry : entries) {
        const std::string command = entry + " charts/gate.grafcet charts/gate_controller.grafcet\n";
        EXPECT_EQ(fine.run(command), 0) << command << fine.output;
        const bool finds = entry.find("analyse") == std::string::npos;
        EXPECT_EQ(wrong.run(command), finds ? 1 : 0) << command << wrong.output;
    }
}

TEST(Ci, NamesOfFilesAreNeverOptions) {
    const std::string lamp = text_of(root / "samples/integration/lamp.grafcet");
    const std::string command = "--engine-command=touch PWNED;true #.grafcet", output = "--sarif=kept.grafcet";
    const std::map<std::string, std::string> files = {{command, lamp}, {output, lamp}, {"kept.grafcet", lamp}};
    const auto expect_inert = [&](const std::string& script, const std::map<std::string, std::string>& variables) {
        SCOPED_TRACE(script);
        Project project(files);
        EXPECT_EQ(project.run(script, variables), 0) << project.output;
        EXPECT_FALSE(project.has("PWNED")) << "a name was executed as a command";
        EXPECT_EQ(project.read("kept.grafcet"), lamp) << "a name was used as an option";
    };
    for (const Step& step : steps_of_action()) expect_inert(step.script, step.environment);
    const auto [variables, jobs] = scripts_of_template();
    for (const auto& [name, script] : jobs) expect_inert(script, variables);
    for (const std::string& entry : entries_of_hooks())
        expect_inert(entry + " '" + command + "' '" + output + "' kept.grafcet\n", {});
}

}  // namespace
}  // namespace grafverif::repository
