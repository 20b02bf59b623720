// SPDX-License-Identifier: MIT
// `mcp`: the server of the Model Context Protocol, which an assistant starts.
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <mutex>
#include <optional>
#include <ostream>
#include <sstream>
#include <system_error>

#include "app/commands.hpp"
#include "app/system/cancellable_input.hpp"
#include "app/system/interrupt.hpp"
#include "app/system/process.hpp"
#include "app/system/watchdog.hpp"
#include "mcp/server.hpp"
#include "support/messages.hpp"

namespace grafverif::app {

namespace {

/// Maximum size of the output of a command in bytes.
constexpr std::size_t largest_output = std::size_t{16} << 20U;

/// Executes a command in a separate process. The process is ended at the deadline or when `stop` is set.
ProgramResult execute_separately(const grafverif::mcp::CommandRun& run) {
    std::vector<std::string> words = {"/proc/self/exe"};
    words.insert(words.end(), run.arguments.begin(), run.arguments.end());
    return run_program(words, run.input, {run.deadline, run.stop, largest_output, {}});
}

/// Executes a command in this process; used if the process also executes other code (see
/// Streams::alone).
ProgramResult execute_here(const grafverif::mcp::CommandRun& run) {
    std::istringstream in(run.input);
    std::ostringstream out, err;
    const ExitCode code = app::run(run.arguments, {in, out, err});
    return {ProgramResult::End::Exited, static_cast<int>(code), std::move(out).str(), std::move(err).str()};
}

/// Returns the absolute paths of the given folders, or nothing after an error.
std::optional<std::vector<std::string>> folders_of(CommandContext& job) {
    const std::vector<std::string> here = {"."};
    std::vector<std::string> folders;
    for (const std::string& folder : job.options.operands.empty() ? here : job.options.operands) {
        std::error_code failure;
        const std::filesystem::path resolved = std::filesystem::canonical(folder, failure);
        if (failure || !std::filesystem::is_directory(resolved, failure))
            job.diagnostics.add(messages::cannot_read(folder, "the folder does not exist"));
        else folders.push_back(resolved.string());
    }
    if (job.diagnostics.has_errors()) return {};
    return folders;
}

}  // namespace

ExitCode mcp(CommandContext& job, const Streams& streams) {
    const auto folders = folders_of(job);
    if (!folders) return ExitCode::Input;
    grafverif::mcp::ServerEnvironment environment;
    environment.version = GRAFVERIF_VERSION;
    environment.folders = *folders;
    if (const auto timeout = job.options.response_timeout_ms)
        environment.longest_call_s = std::max<std::int64_t>(1, static_cast<std::int64_t>(*timeout / 1000));
    if (const auto memory = job.options.max_memory)
        environment.largest_call_mib = std::max<std::int64_t>(16, static_cast<std::int64_t>(*memory >> 20U));
    const grafverif::mcp::Send send = [&](std::string_view bytes) {
        streams.out << bytes << std::flush;
        return streams.out.good();
    };
    if (!streams.alone) {
        std::mutex one;  // only one command at a time, because all commands of a process share its signal handlers
        environment.execute = [&one](const grafverif::mcp::CommandRun& run) {
            const std::lock_guard hold(one);
            return execute_here(run);
        };
        grafverif::mcp::converse(receive_from(streams.in), send, environment);
        return ExitCode::Done;
    }
    std::signal(SIGPIPE, SIG_IGN);  // if the client disappears, writing fails, and the running calls are cancelled
    const Interrupt interrupt;
    const CancellableInput input(interrupt.requested());
    environment.execute = execute_separately;
    environment.keep_memory_back = [] { app::keep_memory_back(); };
    environment.hang_up = [&] { input.stop(); };
    grafverif::mcp::converse([&](std::span<char> buffer) { return input.receive(buffer); }, send, environment);
    return interrupt.requested() ? ExitCode::Unknown : ExitCode::Done;
}

CliCommand mcp_usage() {
    return {
        "mcp",
        "[FOLDER...]",
        0,
        any_number - 1,
        "run a server for AI assistants: read, draw, check, explain, simulate, analyse, compare, tune, find faults, "
        "complete",
        "Implements the Model Context Protocol (2024-11-05, 2025-03-26, 2025-06-18) on standard input and output,\n"
        "for programs that start this server (docs/how-to/mcp.md describes the setup). Only files below the\n"
        "FOLDERs are read (default: the current folder), and no file is written. A separate process with a time\n"
        "limit and a memory limit executes each call of a tool. --max-memory limits the memory of the server, and is\n"
        "the largest memory limit that a call can request (default: 8192M). The server exits when the client closes\n"
        "standard input.",
        {"grafverif mcp", "grafverif mcp charts templates --timeout 2min"},
        {OptionGroup::Mcp}};
}

}  // namespace grafverif::app
