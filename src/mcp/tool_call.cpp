// SPDX-License-Identifier: MIT
#include "mcp/tool_call.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace grafverif::mcp {

namespace {

using std::chrono::milliseconds;

/// Time that a command may use beyond its limit to print its results (see app/system/watchdog.hpp) and to start.
constexpr milliseconds time_to_print{3000};

}  // namespace

ToolCall::ToolCall(const ServerEnvironment& environment, Json arguments, const std::atomic<bool>& stop)
    : environment_(environment), arguments_(std::move(arguments)), stop_(stop), folders_(environment.folders) {
    const std::int64_t timeout = number("timeout", environment.default_timeout_s());
    deadline_ = std::chrono::steady_clock::now() + std::chrono::seconds(timeout);
}

std::string ToolCall::operand() {
    if (has("file") == has("text")) throw CallError{"pass either `file` or `text`"};
    if (has("file")) return operand_for(file_.emplace(located("file")));
    input_ = text("text");
    return "-";
}

std::filesystem::path ToolCall::located(const char* argument) const {
    std::string why;
    auto file = folders_.located(text(argument), why);
    if (!file) throw CallError{fmt::format("cannot read `{}`: {}", text(argument), why)};
    return std::move(*file);
}

std::string ToolCall::path(const char* argument) const { return operand_for(located(argument)); }

std::string ToolCall::content() {
    operand();
    if (!file_) return input_;
    std::string why;
    auto found = folders_.read(*file_, why, largest_message);
    if (!found) throw CallError{fmt::format("cannot read `{}`: {}", text("file"), why)};
    return std::move(*found);
}

void ToolCall::add_options(std::vector<std::string>& command, std::initializer_list<const char*> names) const {
    for (const char* const name : names) {
        if (!has(name)) continue;
        std::string option = std::string("--") + name;
        std::ranges::replace(option, '_', '-');
        const Json& value = arguments_[name];
        const auto add = [&](const Json& each) { command.push_back(option + "=" + each.get<std::string>()); };
        if (value.is_boolean() && value.get<bool>()) command.push_back(option);
        else if (value.is_string()) add(value);
        else if (value.is_array()) std::ranges::for_each(value, add);
    }
}

ProgramResult ToolCall::run(CommandRun command) const {
    for (const std::string& folder : environment_.folders) command.arguments.push_back("--within=" + folder);
    const auto memory = number("max_memory", environment_.default_memory_mib());
    command.arguments.push_back(fmt::format("--max-memory={}M", memory));
    command.arguments.emplace_back("--color=never");
    command.deadline = deadline_ + (deadline_ - std::chrono::steady_clock::now()) / 10 + time_to_print;
    command.stop = &stop_;
    ProgramResult result = environment_.execute(command);
    if (const std::string reason = ended_by(result); !reason.empty())
        throw CallError{fmt::format("the command did not end normally: {}", reason)};
    constexpr int internal_error = 4;
    if (result.status == internal_error) throw CallError{"internal error of grafverif:\n" + result.err};
    return result;
}

ProgramResult ToolCall::execute(std::vector<std::string> command) const {
    const auto left = std::chrono::duration_cast<milliseconds>(deadline_ - std::chrono::steady_clock::now());
    if (left.count() <= 0) throw CallError{"the time limit of the call was reached; increase `timeout`"};
    command.push_back(fmt::format("--timeout={}ms", left.count()));
    return run({.arguments = std::move(command), .input = input_});
}

ProgramResult ToolCall::execute_language_server(const std::string& messages) const {
    return run({.arguments = {"lsp"}, .input = messages});
}

Json ToolCall::execute_json(std::vector<std::string> command, int* exit_code) const {
    const ProgramResult result = execute(std::move(command));
    if (exit_code != nullptr) *exit_code = result.status;
    Json found = Json::parse(result.out, nullptr, false);
    if (found.is_discarded()) throw CallError{result.err.empty() ? "the command printed no result" : result.err};
    return found;
}

std::string shortened(std::string text, std::size_t most) {
    if (text.size() <= most) return text;
    const std::size_t end = text.rfind('\n', most);
    const std::size_t kept = end == std::string::npos ? 0 : end + 1;
    const auto omitted = std::ranges::count(text.begin() + static_cast<std::ptrdiff_t>(kept), text.end(), '\n') + 1;
    text.resize(kept);
    return text + fmt::format("... ({} more lines)\n", omitted);
}

void copy_members(const Json& from, std::initializer_list<const char*> names, Json& to) {
    for (const char* const name : names) to[name] = from.at(name);
}

Json first_of(const Json& list, std::size_t most) {
    Json first = Json::array();
    for (const Json& each : list) {
        if (first.size() == most) break;
        first.push_back(each);
    }
    return first;
}

}  // namespace grafverif::mcp
