// SPDX-License-Identifier: MIT
// ToolCall: one call of a tool, with its arguments, its limits, and the execution of commands within these limits.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mcp/server.hpp"
#include "pipeline/files.hpp"

namespace grafverif::mcp {

using Json = nlohmann::json;

struct ToolResult {
    std::string text = {};
    Json data = {};  ///< the result as data; null if the tool has no data
};

/// A failure of a call that the client can correct, such as an error in a file. The response to the call is a result
/// with the member `isError`.
struct CallError {
    std::string text = {};
};

class ToolCall {
public:
    /// Starts the time limit of the call. Requires that `arguments` have been checked against the table of the tool.
    ToolCall(const ServerEnvironment& environment, Json arguments, const std::atomic<bool>& stop);

    bool has(const char* name) const { return arguments_.contains(name); }
    std::string text(const char* name) const { return has(name) ? arguments_[name].get<std::string>() : std::string(); }
    std::int64_t number(const char* name, std::int64_t fallback) const {
        return has(name) ? arguments_[name].get<std::int64_t>() : fallback;
    }

    /// Returns the input operand of a command: the path in the argument `file`, or `-` if the call has the argument
    /// `text`, which the command then reads from standard input. Throws CallError if the call has both arguments or
    /// neither of them.
    std::string operand();
    /// Returns the input file; nothing if the input is the argument `text`. Requires an earlier call of `operand` or
    /// `content`.
    const std::optional<std::filesystem::path>& file() const { return file_; }
    /// Returns the path in the argument as an absolute path without symbolic links. A relative path refers to the first
    /// folder of the server that contains such a file. Throws CallError if the path is outside of the folders.
    std::filesystem::path located(const char* argument) const;
    /// Returns the same path as `located`, as a command-line argument.
    std::string path(const char* argument) const;
    /// Returns the content of the input. Throws CallError if the input cannot be read or is larger than the maximum
    /// size of a message.
    std::string content();
    /// Appends `--option=value` for each argument in `names` that the call has: for a text or choice, one option; for a
    /// list of names, one option per name; for a flag, an option without a value. Underscores in the name of the
    /// argument become dashes.
    void add_options(std::vector<std::string>& command, std::initializer_list<const char*> names) const;

    void set_input(std::string input) { input_ = std::move(input); }
    /// Executes a command within the limits of the call. Throws CallError if the command does not end normally, or if
    /// it ends with an internal error.
    ProgramResult execute(std::vector<std::string> command) const;
    /// Executes a command that prints JSON. If the command prints no JSON, throws CallError with the error messages of
    /// the command.
    Json execute_json(std::vector<std::string> command, int* exit_code = nullptr) const;
    /// Executes `grafverif lsp` within the limits of the call. A separate function is necessary, because `lsp` has no
    /// option that limits the duration of the complete run.
    ProgramResult execute_language_server(const std::string& messages) const;

    const ServerEnvironment& environment() const { return environment_; }

private:
    ProgramResult run(CommandRun command) const;

    const ServerEnvironment& environment_;
    Json arguments_;
    const std::atomic<bool>& stop_;
    std::chrono::steady_clock::time_point deadline_;
    PermittedFolders folders_;
    std::optional<std::filesystem::path> file_ = {};
    std::string input_ = {};
};

/// Returns `text`. A text with more than `most` bytes is cut at the end of a line, and a note states that the text is
/// incomplete.
std::string shortened(std::string text, std::size_t most);
/// Copies the members `names` of `from` to `to`. Requires that `from` has all these members.
void copy_members(const Json& from, std::initializer_list<const char*> names, Json& to);
/// Returns the first `most` elements of the list, or all elements if there are fewer.
Json first_of(const Json& list, std::size_t most);

}  // namespace grafverif::mcp
