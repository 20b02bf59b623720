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
    Json data = {};  ///< null if the tool has no data
};

/// Failure of a call that the client can correct, such as an error in a file. The failure becomes a result with
/// `isError`.
struct CallError {
    std::string text = {};
};

class ToolCall {
public:
    /// The time limit begins now. `arguments` conform to the table of the tool.
    ToolCall(const ServerEnvironment& environment, Json arguments, const std::atomic<bool>& stop);

    bool has(const char* name) const { return arguments_.contains(name); }
    std::string text(const char* name) const { return has(name) ? arguments_[name].get<std::string>() : std::string(); }
    std::int64_t number(const char* name, std::int64_t fallback) const {
        return has(name) ? arguments_[name].get<std::int64_t>() : fallback;
    }

    /// Returns the operand for the input: the path in `file`, or `-` for `text`, which the command then reads as
    /// standard input. Throws CallError if the call has both arguments or neither argument.
    std::string operand();
    /// Returns the file of the input after a call of `operand` or `content`; nothing if the input is `text`.
    const std::optional<std::filesystem::path>& file() const { return file_; }
    /// Returns the path in the argument as an absolute path without symbolic links. A relative argument refers to the
    /// first folder of the server that contains such a file. Throws CallError if the path is outside of the folders.
    std::filesystem::path located(const char* argument) const;
    /// As `located`, but in the form in which a command reads the path.
    std::string path(const char* argument) const;
    /// Returns the content of the input. Throws CallError if the input cannot be read or is larger than the maximum
    /// size of a message.
    std::string content();
    /// Appends `--option=value` for each given argument of this list: texts, choices, names (one option for each), and
    /// flags (without a value). Underscores of the name become dashes.
    void add_options(std::vector<std::string>& command, std::initializer_list<const char*> names) const;

    void set_input(std::string input) { input_ = std::move(input); }
    /// Executes a command within the limits of the call. Throws CallError if the command does not end normally, or if
    /// it ends with an internal error.
    ProgramResult execute(std::vector<std::string> command) const;
    /// Executes a command that prints JSON. If the command prints no JSON, throws CallError with the error messages of
    /// the command.
    Json execute_json(std::vector<std::string> command, int* exit_code = nullptr) const;
    /// Executes `grafverif lsp`, which has no option that limits the duration of the complete run.
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

/// Returns the text. A text of more than `most` bytes is cut at the end of a line, and a note states that it is
/// incomplete.
std::string shortened(std::string text, std::size_t most);
/// Copies the members with these names to `to`. Requires that `from` has all these members.
void copy_members(const Json& from, std::initializer_list<const char*> names, Json& to);
/// Returns at most `most` elements of the beginning of the list.
Json first_of(const Json& list, std::size_t most);

}  // namespace grafverif::mcp
