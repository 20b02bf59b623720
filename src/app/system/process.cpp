// SPDX-License-Identifier: MIT
// The standard input of an external program is an unnamed temporary file. Therefore this process
// need not write while the program runs, and a program that does not read its input does not cause
// a broken pipe.
#include "app/system/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "app/system/child.hpp"
#include "app/system/interrupt.hpp"
#include "app/system/watchdog.hpp"

namespace grafverif::app {

namespace fs = std::filesystem;

namespace {

/// Writes all of `text`. Throws std::system_error after an error.
void write_all(const Descriptor& to, std::string_view text) {
    while (!text.empty()) {
        const ssize_t count = ::write(to.number(), text.data(), text.size());
        if (count < 0 && errno != EINTR) fail(errno, "cannot write a temporary file");
        text.remove_prefix(count < 0 ? 0 : static_cast<std::size_t>(count));
    }
}

Descriptor file_of(const std::string& input) {
    Descriptor file(::memfd_create("input", MFD_CLOEXEC));
    if (!file.open()) fail(errno, "cannot create a temporary file");
    write_all(file, input);
    ::lseek(file.number(), 0, SEEK_SET);
    return file;
}

/// An output stream of the program, with the text that has been read from it.
struct Stream {
    Descriptor from = Descriptor();
    std::string text = {};

    /// Reads the available data, but stops as soon as `text` has more than `most` bytes. Each read adds at most 64 KiB,
    /// so `text` has at most `most` bytes plus 64 KiB.
    void take(std::size_t most) {
        std::array<char, 65536> buffer = {};
        while (from.open() && text.size() <= most) {
            const ssize_t count = ::read(from.number(), buffer.data(), buffer.size());
            if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
            else if (count == 0) from.close();
            else if (errno == EINTR) continue;
            else if (errno == EAGAIN || errno == EWOULDBLOCK) return;
            else from.close();
        }
    }
};

void wait_for_output(const Stream& out, const Stream& err, int milliseconds) {
    std::array<pollfd, 2> waited = {pollfd{out.from.number(), POLLIN, 0}, pollfd{err.from.number(), POLLIN, 0}};
    ::poll(waited.data(), waited.size(), milliseconds);  // a closed descriptor is negative, so that poll ignores it
}

}  // namespace

std::optional<fs::path> find_program(const std::string& name) {
    const auto executable = [](const fs::path& file) {
        std::error_code ignored;
        return fs::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0;
    };
    if (name.find('/') != std::string::npos) return executable(name) ? std::optional(fs::absolute(name)) : std::nullopt;
    const char* const path = std::getenv("PATH");
    for (std::string_view rest = path == nullptr ? "" : path; !rest.empty() && !name.empty();) {
        const std::string_view folder = rest.substr(0, rest.find(':'));
        rest.remove_prefix(std::min(folder.size() + 1, rest.size()));
        if (const fs::path file = fs::path(folder) / name; !folder.empty() && executable(file))
            return fs::absolute(file);
    }
    return {};
}

ProgramResult run_program(const std::vector<std::string>& arguments, const std::string& input,
                          const ProgramLimits& limits) {
    const Descriptor stdin_file = file_of(input);
    Pipe out_pipe = make_pipe(), err_pipe = make_pipe();
    set_nonblocking(out_pipe.read);
    set_nonblocking(err_pipe.read);
    Child child(arguments, {stdin_file.number(), out_pipe.write.number(), err_pipe.write.number()}, limits.folder);
    out_pipe.write.close();
    err_pipe.write.close();
    Stream out{std::move(out_pipe.read), {}}, err{std::move(err_pipe.read), {}};

    ProgramResult result;
    std::optional<ChildEnd> end;
    for (;;) {
        out.take(limits.max_output);
        err.take(limits.max_output);
        if (out.text.size() > limits.max_output || err.text.size() > limits.max_output)
            result.end = ProgramResult::End::TooMuchOutput;
        else if (limits.stop != nullptr && limits.stop->load()) result.end = ProgramResult::End::Stopped;
        else if (limits.deadline && std::chrono::steady_clock::now() >= *limits.deadline)
            result.end = ProgramResult::End::TimedOut;
        else if (!(end = child.ended())) {
            wait_for_output(out, err, out.from.open() || err.from.open() ? 10 : 1);
            continue;
        }
        break;
    }
    {
        const SignalBlocker whole;
        child.end();
        if (result.end == ProgramResult::End::Stopped) work_is_done();  // additional time to print results
    }
    out.take(limits.max_output);
    err.take(limits.max_output);
    if (end) {
        result.end = end->by_signal ? ProgramResult::End::Signalled : ProgramResult::End::Exited;
        result.status = end->status;
    }
    result.out = std::move(out.text);
    result.err = std::move(err.text);
    return result;
}

namespace {

/// Name of a file that is created in the temporary folder after the folder is locked; a folder
/// without this file belongs to another program.
constexpr const char* lock_mark = ".grafverif-run";
constexpr std::string_view folder_name = "grafverif-run-", random_part = "XXXXXX";

/// Locks the folder at `path` and returns it. The result is empty if another process holds the lock, or if `path` is
/// not a folder.
Descriptor locked_folder(const fs::path& path) {
    Descriptor folder(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    return folder.open() && ::flock(folder.number(), LOCK_EX | LOCK_NB) == 0 ? std::move(folder) : Descriptor();
}

/// Removes the temporary folders in `where` that killed runs of this user have left.
void remove_stale_folders(const fs::path& where) {
    std::error_code failure;
    for (auto entry = fs::directory_iterator(where, failure); !failure && entry != fs::directory_iterator();
         entry.increment(failure)) {
        const std::string name = entry->path().filename().string();
        if (!name.starts_with(folder_name) || name.size() != folder_name.size() + random_part.size()) continue;
        const Descriptor folder = locked_folder(entry->path());
        struct stat mark = {};
        const bool is_own = folder.open() && ::fstatat(folder.number(), lock_mark, &mark, AT_SYMLINK_NOFOLLOW) == 0 &&
                            mark.st_uid == ::geteuid();
        std::error_code ignored;
        if (is_own) fs::remove_all(entry->path(), ignored);
    }
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
    const fs::path where = fs::absolute(fs::temp_directory_path());
    remove_stale_folders(where);
    std::string pattern = (where / folder_name).string() + std::string(random_part);
    if (::mkdtemp(pattern.data()) == nullptr)
        fail(errno, fmt::format("cannot create a temporary folder in `{}`", where.string()));
    path_ = pattern;
    lock_ = locked_folder(path_);
    if (lock_.open()) write(lock_mark, "");
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

void TemporaryFolder::write(const std::string& name, const std::string& content) const {
    const Descriptor file(
        ::open((path_ / name).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, S_IRUSR | S_IWUSR));
    if (!file.open()) fail(errno, "cannot create a temporary file");
    write_all(file, content);
}

}  // namespace grafverif::app
