// SPDX-License-Identifier: MIT
// `watch`: executes another command, and executes it again whenever its inputs change. Each execution is a separate
// process, so that a crash of the command does not end this process. The process of `watch` first
// reads the inputs and then polls them.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <ostream>
#include <system_error>
#include <thread>

#include "app/commands.hpp"
#include "app/outputs.hpp"
#include "app/system/child.hpp"
#include "app/system/interrupt.hpp"
#include "pipeline/descriptor.hpp"
#include "pipeline/file_watcher.hpp"
#include "support/printable.hpp"

namespace grafverif::app {

namespace {

using namespace std::chrono_literals;
using std::chrono::steady_clock;

constexpr auto poll_interval = 50ms;
constexpr auto run_timeout = 1s;   ///< time for the command to end after a request to terminate
constexpr auto save_timeout = 1s;  ///< maximum time between deletion and replacement of a file by an editor
constexpr int closed_pipe = 128 + SIGPIPE;

/// The watched command with its arguments.
struct Command {
    CliCommand verb = {};
    std::vector<std::string> words = {};
    Options options = {};
    std::string error_text = {};
};

Command command_of(const std::vector<std::string>& words) {
    constexpr std::array endless = {"watch", "serve", "edit", "lsp", "simulate"};
    Command command{{}, words, {}, {}};
    const std::vector<CliCommand> verbs = all_commands();
    const auto found = std::ranges::find(verbs, words[0], &CliCommand::name);
    if (found == verbs.end()) return command.error_text = unknown_command(words[0]), command;
    command.verb = *found;
    if (!accepts(command.verb, OptionGroup::File) || std::ranges::find(endless, words[0]) != endless.end())
        return command.error_text =
                   fmt::format("`watch` cannot run `{}`; use a command that reads a file and terminates", words[0]),
               command;
    const ParsedOptions parsed = parse_options(command.verb, std::span(words).subspan(1));
    command.error_text = parsed.error_text;
    if (!parsed.options) return command;
    command.options = *parsed.options;
    std::vector<std::string> files = command.options.operands;
    for (const NamedPath& one : named_paths(command.options))
        if (one.use == PathUse::Read) files.push_back(one.path);
    for (const std::string& file : files)
        if (names_input(file)) command.error_text = "standard input cannot be watched; pass a file name";
    return command;
}

/// Records all inputs of the command. Errors in the inputs are ignored here, because the command reports them.
void note(const Command& command, FileWatcher& seen) {
    CommandContext job{.options = command.options};
    job.watch = &seen;
    for (const auto& [name, place, use] : path_options) {
        if (use != PathUse::Read) (job.options.*place).reset();  // only the executions of the command write files
        else if (const auto& file = job.options.*place) seen.note(*file);
    }
    for (const std::string& file : command.options.operands) {
        try {
            read_model(file, job);
        } catch (const std::bad_alloc&) {
        } catch (const std::system_error&) {
        }
    }
}

/// Returns how the execution ended, or nothing if a change or Ctrl-C ended it.
std::optional<ChildEnd> run_once(const Command& command, const FileWatcher& seen,
                                 const std::atomic<bool>& end_requested) {
    const Descriptor nothing(::open("/dev/null", O_RDONLY | O_CLOEXEC));
    std::vector<std::string> words = {"/proc/self/exe"};
    words.insert(words.end(), command.words.begin(), command.words.end());
    Child child(words, {nothing.number(), STDOUT_FILENO, STDERR_FILENO});
    auto last_poll = steady_clock::now();
    while (!child.ended() && !end_requested) {
        std::this_thread::sleep_for(5ms);
        if (steady_clock::now() - last_poll < poll_interval) continue;
        last_poll = steady_clock::now();
        if (seen.changed()) break;
    }
    if (child.ended()) return child.ended();
    child.send(SIGTERM);
    for (const auto end = steady_clock::now() + run_timeout; !child.ended() && steady_clock::now() < end;)
        std::this_thread::sleep_for(5ms);
    return {};
}

/// Waits for a change and then, if an editor has moved a file away, at most `save_timeout` until
/// the file exists again.
void wait_for_change(const FileWatcher& seen, const std::atomic<bool>& end_requested) {
    while (!end_requested && !seen.changed()) std::this_thread::sleep_for(poll_interval);
    for (const auto end = steady_clock::now() + save_timeout;
         !end_requested && seen.missing() && steady_clock::now() < end;)
        std::this_thread::sleep_for(poll_interval);
}

}  // namespace

ExitCode watch(CommandContext& job, const Streams& streams) {
    const Command command = command_of(job.options.operands);
    if (!command.error_text.empty()) {
        streams.err << fmt::format("grafverif: error: {}; see `grafverif watch --help`\n",
                                   printable(command.error_text));
        return ExitCode::Input;
    }
    if (command.options.help) return print_help(command.verb, streams.out), ExitCode::Done;
    const Interrupt interrupt;
    const auto print = [&](const std::string& words) {
        if (!job.options.quiet) streams.err << "watch: " << printable(words) << '\n' << std::flush;
    };
    for (;;) {
        FileWatcher seen;
        note(command, seen);
        const auto end = run_once(command, seen, interrupt.requested());
        // The command ended because the reader of standard output has closed the pipe.
        if (end && !end->by_signal && end->status == closed_pipe) return ExitCode::Done;
        if (end)
            print(fmt::format("{} {}; watching {} file{}, press Ctrl-C to stop",
                              end->by_signal ? "terminated by signal" : "exit code", end->status, seen.size(),
                              seen.size() == 1 ? "" : "s"));
        wait_for_change(seen, interrupt.requested());
        if (interrupt.requested()) return ExitCode::Done;
        const std::vector<std::string> changes = seen.changes();
        print((changes.empty() ? "a file" : changes.front()) + " has changed");
    }
}

CliCommand watch_usage() {
    return {
        "watch",
        "COMMAND ARGUMENT...",
        2,
        any_number - 1,
        "rerun a command whenever one of its input files changes",
        "Runs `grafverif COMMAND ARGUMENT...`, and reruns it when a file that it reads changes: FILE, included files, "
        "tables.\n"
        "A change during a run terminates the run and starts a new one. COMMAND must terminate, so `serve`, `edit`,\n"
        "`lsp` and `simulate` are not supported.\n"
        "Options of `watch` precede COMMAND; `-q` omits its status lines on standard error. Ctrl-C stops `watch` "
        "with exit code 0.",
        {"grafverif watch check station.grafcet", "grafverif watch check station.grafcet --property safe --junit r.xml",
         "grafverif watch -q draw station.grafcet -o station.svg"},
        {OptionGroup::Command}};
}

}  // namespace grafverif::app
