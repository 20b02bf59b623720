// SPDX-License-Identifier: MIT
// `lsp`: the language server, which an editor starts.
#include <signal.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <thread>
#include <vector>

#include "app/commands.hpp"
#include "app/serve/live_page.hpp"
#include "app/system/cancellable_input.hpp"
#include "app/system/interrupt.hpp"
#include "app/system/process.hpp"
#include "app/system/watchdog.hpp"
#include "lsp/server.hpp"

namespace grafverif::app {

namespace {

bool is_alive(std::int64_t process) {
    return process <= 0 || ::kill(static_cast<pid_t>(process), 0) == 0 || errno != ESRCH;
}

/// Runs one page of `serve` for each requested file, until the language server ends.
class Pages {
public:
    explicit Pages(const Options& options) : options_(options) {}
    ~Pages() {
        stop_ = true;
        for (std::thread& thread : threads_) thread.join();
    }
    Pages(const Pages&) = delete;
    Pages& operator=(const Pages&) = delete;

    std::string address(const std::string& path) {
        if (const auto known = pages_.find(path); known != pages_.end()) return known->second->address();
        Options options = options_;
        options.operands = {path};
        auto page = std::make_unique<LivePage>(options);
        LivePage& shown = *page;
        const auto kept = pages_.emplace(path, std::move(page)).first;
        try {
            threads_.emplace_back([this, &shown] { shown.run(stop_); });
        } catch (...) {
            pages_.erase(kept);  // the page cannot respond, because its thread was not started
            throw;
        }
        return shown.address();
    }

private:
    const Options& options_;
    std::atomic<bool> stop_ = false;
    std::map<std::string, std::unique_ptr<LivePage>> pages_ = {};
    std::vector<std::thread> threads_ = {};
};

/// A temporary folder for files that other programs display.
class DisplayFolder {
public:
    std::string keep(const std::string& name, const std::string& text) {
        if (!folder_) folder_.emplace();
        folder_->write(name, text);
        return (folder_->path() / name).string();
    }

private:
    std::optional<TemporaryFolder> folder_ = {};
};

/// LSP 3.17, "Exit Notification": the exit code is 0 only if `shutdown` preceded `exit`.
ExitCode code_of(grafverif::lsp::Ending ending) {
    return ending == grafverif::lsp::Ending::Requested ? ExitCode::Done : ExitCode::Verdict;
}

}  // namespace

ExitCode lsp(CommandContext& job, const Streams& streams) {
    grafverif::lsp::ServerEnvironment surroundings;
    surroundings.version = GRAFVERIF_VERSION;
    surroundings.include_folders = job.options.include_folders;
    surroundings.within = job.options.within;
    if (job.options.response_timeout_ms)
        surroundings.response_timeout = std::chrono::milliseconds(*job.options.response_timeout_ms);
    const grafverif::lsp::Send send = [&](std::string_view bytes) { streams.out << bytes << std::flush; };
    if (!streams.alone) return code_of(grafverif::lsp::converse(receive_from(streams.in), send, surroundings));
    const Interrupt interrupt;
    const CancellableInput input(interrupt.requested());
    Pages pages(job.options);
    DisplayFolder shelf;
    surroundings.is_alive = is_alive;
    surroundings.simulator = [&](const std::string& path) { return pages.address(path); };
    surroundings.keep = [&](const std::string& name, const std::string& text) { return shelf.keep(name, text); };
    surroundings.keep_memory_back = [] { app::keep_memory_back(); };
    surroundings.hang_up = [&] { input.stop(); };
    const auto ending =
        grafverif::lsp::converse([&](std::span<char> buffer) { return input.receive(buffer); }, send, surroundings);
    return interrupt.requested() ? ExitCode::Unknown : code_of(ending);
}

CliCommand lsp_usage() {
    return {"lsp",
            "",
            0,
            0,
            "run a language server for editors: diagnostics, navigation, completion, verdicts",
            "Implements the Language Server Protocol 3.17 on standard input and output, for editors that start this\n"
            "server (docs/how-to/language-server.md describes the setup). The text of a document that is open in the\n"
            "editor is used instead of the file on disk, also when another file includes the document. The server\n"
            "writes only temporary files that other programs display. It exits when the editor requests this, or\n"
            "when the editor terminates.",
            {"grafverif lsp"},
            {OptionGroup::Within, OptionGroup::Lsp}};
}

}  // namespace grafverif::app
