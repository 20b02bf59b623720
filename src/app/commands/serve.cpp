// SPDX-License-Identifier: MIT
// `serve`: a page on this computer that shows the current file, checks it after every save, and simulates it.
// `edit`: a page that also edits the file.
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <system_error>

#include "app/commands.hpp"
#include "app/outputs.hpp"
#include "app/serve/edited_file.hpp"
#include "app/serve/live_page.hpp"
#include "app/system/interrupt.hpp"
#include "app/system/process.hpp"
#include "pipeline/files.hpp"
#include "read/formats.hpp"
#include "support/messages.hpp"
#include "support/printable.hpp"
#include "syntax/language/readable.hpp"

namespace grafverif::app {

namespace {

/// Opens `page` in the user's browser, which continues after this program has ended.
void open_in_browser(const std::filesystem::path& page, const Streams& streams) {
    std::string program = "xdg-open", operand = page.string();
    char* arguments[] = {program.data(), operand.data(), nullptr};
    posix_spawn_file_actions_t quiet;
    ::posix_spawn_file_actions_init(&quiet);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        ::posix_spawn_file_actions_addopen(&quiet, stream, "/dev/null", O_RDWR, 0);
    posix_spawnattr_t apart;
    ::posix_spawnattr_init(&apart);
    ::posix_spawnattr_setflags(&apart, POSIX_SPAWN_SETSID);
    pid_t child = 0;
    const int failure = ::posix_spawnp(&child, program.c_str(), &quiet, &apart, arguments, environ);
    ::posix_spawn_file_actions_destroy(&quiet);
    ::posix_spawnattr_destroy(&apart);
    if (failure != 0) streams.err << "note: `xdg-open` is not installed; open the address in a browser\n";
}

/// Returns a page that redirects to `address`. The browser opens this page instead of `address`: other users can read
/// the command line of the browser, so the command line must not contain the token.
std::string redirect_to(const std::string& address) {
    return fmt::format(
        "<!doctype html>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"refresh\" content=\"0; url={0}\"><title>grafverif</title>\n<a href=\"{0}\">grafverif</a>\n",
        address);
}

/// Returns the content of a file that can be watched, otherwise reports an error.
std::optional<std::string> watched_content(const std::string& path, CommandContext& job) {
    std::string why;
    std::optional<std::string> content;
    if (path == "-" || own_descriptor(path)) why = "standard input cannot be watched; pass a file name";
    else content = content_of_file(path, why);
    if (!content) job.diagnostics.add(messages::cannot_read(path, why));
    return content;
}

/// Returns the content of the file if it can be served, otherwise reports an error.
std::optional<std::string> served_content(CommandContext& job) {
    const std::string& path = job.options.operands[0];
    std::optional<std::string> content = watched_content(path, job);
    if (job.options.property_file) {
        watched_content(*job.options.property_file, job);
        if (content && format_of(*content) == FileFormat::Grafcet)
            job.diagnostics.add(messages::cannot_read(
                path,
                "with `--properties`, the file must be a PLC program; declare the properties of a chart in a loop"));
    }
    const std::uint64_t port = job.options.port;
    if (port > 65535) job.diagnostics.add(messages::cannot_listen(port, "the largest port number is 65535"));
    return job.diagnostics.has_errors() ? std::nullopt : content;
}

/// True if `content` is a text that a page can edit: the input language in UTF-8. Reports an error if the result is
/// false.
bool can_be_edited(const std::string& content, CommandContext& job) {
    const std::string& path = job.options.operands[0];
    const Id<Source> source = job.sources.add({path, content});
    const FileFormat format = format_of(content);
    std::string why = edit_obstacle(content);
    if (format != FileFormat::Grafcet && format != FileFormat::Unknown)
        why = "only the input language can be edited; convert the file with `grafverif import`";
    else if (!is_readable({source, 0, static_cast<std::uint32_t>(content.size())}, job.sources, job.diagnostics))
        return false;
    if (!why.empty()) job.diagnostics.add(messages::cannot_read(path, why));
    return why.empty();
}

/// Serves the file until the user stops the program. If `edited` is given, the page can change the file.
ExitCode serve_page(CommandContext& job, const Streams& streams, const std::optional<std::string>& edited) {
    const Interrupt interrupt;
    std::unique_ptr<LivePage> page;
    try {
        page = std::make_unique<LivePage>(job.options, edited);
    } catch (const std::system_error& failure) {
        if (failure.code() == std::errc::resource_unavailable_try_again) throw;  // a thread could not be started
        const bool in_use = failure.code() == std::errc::address_in_use;
        job.diagnostics.add(messages::cannot_listen(
            job.options.port, in_use ? "another program uses this port" : failure.code().message()));
        return ExitCode::Input;
    }
    const std::string address = page->address();
    streams.out << fmt::format(
                       "{}: {}\n"
                       "Press Ctrl-C to stop.\n",
                       printable(job.options.operands[0]), address)
                << std::flush;
    // Only this user can read the folder. The folder is removed only when the server ends, because the browser may open
    // the file late.
    std::optional<TemporaryFolder> folder;
    if (job.options.open) {
        folder.emplace();
        folder->write("open.html", redirect_to(address));
        open_in_browser(folder->path() / "open.html", streams);
    }
    page->run(interrupt.requested());
    if (const std::string unsaved = page->unsaved(); !unsaved.empty())
        streams.err << fmt::format(
            "note: changes that are not saved are in `{}`; the next `grafverif edit` restores them\n",
            printable(unsaved));
    if (const std::string loss = page->loss(); !loss.empty())
        streams.err << fmt::format("warning: changes were not saved: {}\n", printable(loss));
    return ExitCode::Done;
}

}  // namespace

ExitCode serve(CommandContext& job, const Streams& streams) {
    return served_content(job) ? serve_page(job, streams, {}) : ExitCode::Input;
}

ExitCode edit(CommandContext& job, const Streams& streams) {
    const std::optional<std::string> content = served_content(job);
    return content && can_be_edited(*content, job) ? serve_page(job, streams, content) : ExitCode::Input;
}

CliCommand edit_usage() {
    return {
        "edit",
        "FILE",
        1,
        1,
        "edit a chart on its drawing in the browser",
        "Prints a local address at which the browser shows FILE as a drawing and as text. Operations on the drawing\n"
        "change the text; comments and layout are kept. Verdicts and the simulator are updated after each change.\n"
        "The page can be opened only on this machine, and only with the token in the address. FILE is written only on\n"
        "request, and a change by another program is overwritten only after confirmation. Changes that are not saved\n"
        "are kept in the file .FILE.unsaved. Ctrl-C stops the server.",
        {"grafverif edit press.grafcet --open", "grafverif edit station.grafcet --port 8060"},
        {OptionGroup::Serve, OptionGroup::Constants, OptionGroup::Mode, OptionGroup::Grain}};
}

CliCommand serve_usage() {
    return {
        "serve",
        "FILE",
        1,
        1,
        "show a file in the browser while editing: drawings, verdicts, simulator",
        "Prints a local address at which the browser shows the current state of FILE: diagnostics, charts, verdicts, "
        "and an\n"
        "interactive simulator. The page is updated when FILE or an included file is saved. The page can be opened "
        "only on\n"
        "this machine, and only with the token in the address. Nothing is written, except a temporary file with "
        "--open. Ctrl-C stops the server. With --properties FILE, the page shows a PLC program and its verdicts.",
        {"grafverif serve samples/oven_door/oven_door.grafcet", "grafverif serve station.grafcet --port 8060 --open",
         "grafverif serve docs/drive.st --properties docs/drive.yaml"},
        {OptionGroup::Serve, OptionGroup::ProgramProperties, OptionGroup::Constants, OptionGroup::Mode,
         OptionGroup::Grain}};
}

}  // namespace grafverif::app
