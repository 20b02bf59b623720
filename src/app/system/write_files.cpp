// SPDX-License-Identifier: MIT
// Drafts and backups exist only while the lock on their folder is held. Therefore a draft or backup that the holder of
// the lock finds is a remnant of a killed run.
#include "app/system/write_files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <deque>
#include <optional>
#include <string_view>
#include <system_error>
#include <thread>
#include <tuple>

#include "app/system/interrupt.hpp"
#include "pipeline/descriptor.hpp"
#include "pipeline/files.hpp"

namespace grafverif::app {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void cannot_write(const fs::path& path, int error = errno) {
    fail(error, fmt::format("cannot write `{}`", path.string()));
}

void write_all(const Descriptor& to, std::string_view text, const fs::path& path) {
    while (!text.empty()) {
        const ssize_t count = ::write(to.number(), text.data(), text.size());
        if (count < 0 && errno != EINTR) cannot_write(path);
        text.remove_prefix(count < 0 ? 0 : static_cast<std::size_t>(count));
    }
}

/// Flushes the file to the disk. Ignores a file that does not support flushing, such as a pipe.
void flush(const Descriptor& file, const fs::path& path) {
    if (::fsync(file.number()) != 0 && errno != EINVAL && errno != ENOTSUP && errno != EROFS && errno != EBADF)
        cannot_write(path);
}

// -- the names of drafts ---------------------------------------------------------------------------------------------

constexpr std::string_view draft_begin = ".grafverif-", draft_end = ".part";
constexpr std::size_t random_digits = 16;

std::string draft_name() {
    std::uint64_t number = 0;
    if (::getrandom(&number, sizeof number, 0) != sizeof number) fail(errno, "the system provides no random numbers");
    return fmt::format("{}{:0{}x}{}", draft_begin, number, random_digits, draft_end);
}

bool is_draft_name(std::string_view name) {
    if (!name.starts_with(draft_begin) || !name.ends_with(draft_end)) return false;
    if (name.size() != draft_begin.size() + random_digits + draft_end.size()) return false;
    return name.substr(draft_begin.size(), random_digits).find_first_not_of("0123456789abcdef") ==
           std::string_view::npos;
}

// -- folders ---------------------------------------------------------------------------------------------------------

struct Folder {
    fs::path path = {};
    Descriptor open = Descriptor();
    dev_t device = 0;
    ino_t node = 0;
};

/// Opens a folder. A folder that may be entered but not read is neither locked nor flushed.
Folder opened(const fs::path& path, const fs::path& file) {
    Folder folder{path.empty() ? "." : path};
    constexpr int how = O_DIRECTORY | O_CLOEXEC;
    folder.open = Descriptor(::open(folder.path.c_str(), O_RDONLY | how));
    if (!folder.open.open() && errno == EACCES) folder.open = Descriptor(::open(folder.path.c_str(), O_PATH | how));
    struct stat status = {};
    if (!folder.open.open() || ::fstat(folder.open.number(), &status) != 0) cannot_write(file);
    folder.device = status.st_dev;
    folder.node = status.st_ino;
    return folder;
}

void remove_litter(const Folder& folder) {
    std::error_code failure;
    for (auto entry = fs::directory_iterator(folder.path, failure); !failure && entry != fs::directory_iterator();
         entry.increment(failure)) {
        const std::string name = entry->path().filename().string();
        struct stat status = {};
        if (is_draft_name(name) && ::fstatat(folder.open.number(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 &&
            S_ISREG(status.st_mode))
            ::unlinkat(folder.open.number(), name.c_str(), 0);
    }
}

/// Waits for the lock on the folder. While this process holds the lock, no other run uses drafts in the folder.
void lock(const Folder& folder) {
    constexpr std::chrono::seconds longest_wait{60};
    constexpr std::chrono::milliseconds nap{3};
    for (const auto end = std::chrono::steady_clock::now() + longest_wait;
         ::flock(folder.open.number(), LOCK_EX | LOCK_NB) != 0;) {
        if (errno != EWOULDBLOCK && errno != EINTR) return;  // the file system has no folder locks
        if (std::chrono::steady_clock::now() > end)
            fail(ETIMEDOUT, fmt::format("another process has locked the folder `{}`", folder.path.string()));
        std::this_thread::sleep_for(nap);
    }
    remove_litter(folder);
}

// -- a set of files --------------------------------------------------------------------------------------------------

/// Returns `path` with symbolic links resolved in its last component, even if the target does not exist.
fs::path followed(const fs::path& path) {
    fs::path place = path;
    for (int links = 0; links < 40; ++links) {
        struct stat status = {};
        if (::lstat(place.c_str(), &status) != 0 || !S_ISLNK(status.st_mode)) return place;
        const fs::path target = fs::read_symlink(place);
        place = target.is_absolute() ? target : place.parent_path() / target;
    }
    cannot_write(path, ELOOP);
}

/// A set of files to write. If one file cannot be written, the changes of all files are undone.
class FileSet {
public:
    FileSet() = default;
    FileSet(const FileSet&) = delete;
    FileSet& operator=(const FileSet&) = delete;
    ~FileSet() {
        std::error_code ignored;
        for (auto made = made_.rbegin(); made != made_.rend(); ++made) fs::remove(*made, ignored);
    }

    void add(const OutputFile& file) {
        make_folder(file.path.parent_path());
        const fs::path place = followed(file.path);
        if (!place.has_filename() || place.filename() == "." || place.filename() == "..")
            cannot_write(file.path, EISDIR);
        files_.push_back({&file, folder_of(place, file.path), place.filename().string(), {}, {}, false});
        const One& added = files_.back();
        for (const One& other : files_)
            if (&other != &added && other.folder == added.folder && other.name == added.name)
                cannot_write(file.path, EEXIST);
    }

    /// Locks every folder in an order that is the same for every run, so that no deadlock is possible.
    void wait_for_turn() {
        std::vector<Folder*> in_order;
        for (Folder& folder : folders_) in_order.push_back(&folder);
        std::ranges::sort(in_order, {}, [](const Folder* folder) { return std::tuple(folder->device, folder->node); });
        for (const Folder* folder : in_order) lock(*folder);
    }

    void write() {
        try {
            for (One& one : files_) draft(one);
            // A single file also needs a backup, because flushing its folder can fail after the file is renamed.
            for (One& one : files_) back_up(one);
            for (One& one : files_) rename(one);
            for (const Folder& folder : folders_) flush(folder.open, folder.path);
            for (const fs::path& made : made_) flush(opened(made.parent_path(), made).open, made);
        } catch (...) {
            for (auto one = files_.rbegin(); one != files_.rend(); ++one) undo(*one);
            throw;
        }
        made_.clear();
        for (const One& one : files_)
            if (!one.backup.empty()) ::unlinkat(one.folder->open.number(), one.backup.c_str(), 0);
    }

private:
    struct One {
        const OutputFile* file = nullptr;
        const Folder* folder = nullptr;
        std::string name = {};
        std::string draft = {}, backup = {};  ///< file names of the draft and the backup, while they exist
        bool renamed = false;
    };

    void make_folder(const fs::path& folder) {
        struct stat status = {};
        if (folder.empty() || ::stat(folder.c_str(), &status) == 0) return;
        make_folder(folder.parent_path());
        if (::mkdir(folder.c_str(), 0777) == 0) made_.push_back(folder);
        else if (errno != EEXIST) cannot_write(folder);
    }

    const Folder* folder_of(const fs::path& place, const fs::path& file) {
        Folder found = opened(place.parent_path(), file);
        for (const Folder& folder : folders_)
            if (folder.device == found.device && folder.node == found.node) return &folder;
        return &folders_.emplace_back(std::move(found));
    }

    /// Creates a file in the folder of `one`. Stores the name of the file in `name` as soon as the file exists.
    static Descriptor created(const One& one, mode_t mode, std::string& name) {
        constexpr int attempts = 8;
        for (int k = 0; k < attempts; ++k) {
            const std::string tried = draft_name();
            Descriptor file(::openat(one.folder->open.number(), tried.c_str(),
                                     O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode));
            if (file.open()) return name = tried, std::move(file);
            if (errno != EEXIST) break;
        }
        cannot_write(one.file->path);
    }

    /// Stores the status of the existing file in `status`. Returns false if the file does not exist.
    static bool is_there(const One& one, struct stat& status) {
        if (::fstatat(one.folder->open.number(), one.name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0) return true;
        if (errno != ENOENT) cannot_write(one.file->path);
        return false;
    }

    static void draft(One& one) {
        struct stat old = {};
        const bool replaces = is_there(one, old);
        if (replaces && S_ISDIR(old.st_mode)) cannot_write(one.file->path, EISDIR);
        if (replaces && ::faccessat(one.folder->open.number(), one.name.c_str(), W_OK, AT_EACCESS) != 0)
            cannot_write(one.file->path);
        const Descriptor file = created(one, replaces ? S_IRUSR | S_IWUSR : one.file->mode, one.draft);
        if (replaces) {
            // Only a process of root may change the owner; for other users, the call may fail, and
            // the failure is ignored.
            [[maybe_unused]] const int may_fail = ::fchown(file.number(), old.st_uid, old.st_gid);
            if (::fchmod(file.number(), old.st_mode & 0777U) != 0) cannot_write(one.file->path);
        }
        write_all(file, one.file->content, one.file->path);
        flush(file, one.file->path);
    }

    /// Creates a hard link to a file that will be replaced or, if the file system does not support links, a copy.
    static void back_up(One& one) {
        struct stat old = {};
        if (!is_there(one, old)) return;
        const int folder = one.folder->open.number();
        std::string name = draft_name();
        if (::linkat(folder, one.name.c_str(), folder, name.c_str(), 0) == 0) {
            one.backup = std::move(name);
            return;
        }
        const Descriptor from(::openat(folder, one.name.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC));
        std::string why;
        const auto content = from.open() ? read_descriptor(from.number(), why) : std::nullopt;
        if (!content) cannot_write(one.file->path);
        const Descriptor copy = created(one, old.st_mode & 0777U, one.backup);
        write_all(copy, *content, one.file->path);
        flush(copy, one.file->path);
    }

    /// True if the existing file does not have the content that may be replaced.
    static bool has_other_content(const One& one) {
        struct stat status = {};
        if (!one.file->replaces || !is_there(one, status)) return false;
        const Descriptor file(
            ::openat(one.folder->open.number(), one.name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
        std::string why;
        const auto content =
            file.open() ? read_descriptor(file.number(), why, one.file->replaces->size()) : std::nullopt;
        return content != one.file->replaces;
    }

    static void rename(One& one) {
        const int folder = one.folder->open.number();
        if (has_other_content(one)) cannot_write(one.file->path, ESTALE);
        if (::renameat(folder, one.draft.c_str(), folder, one.name.c_str()) != 0) cannot_write(one.file->path);
        one.draft.clear();
        one.renamed = true;
    }

    static void undo(One& one) {
        const int folder = one.folder->open.number();
        if (!one.draft.empty()) ::unlinkat(folder, one.draft.c_str(), 0);
        if (one.renamed && one.backup.empty()) ::unlinkat(folder, one.name.c_str(), 0);
        else if (one.renamed) ::renameat(folder, one.backup.c_str(), folder, one.name.c_str());
        else if (!one.backup.empty()) ::unlinkat(folder, one.backup.c_str(), 0);
    }

    std::deque<Folder> folders_ = {};  // a deque, because its elements stay at their addresses
    std::deque<One> files_ = {};
    std::vector<fs::path> made_ = {};
};

/// Writes to a pipe, a device, or a descriptor of this process.
void write_through(const OutputFile& file) {
    const auto own = own_descriptor(file.path);
    const Descriptor open(own ? ::dup(*own) : ::open(file.path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
    if (!open.open()) cannot_write(file.path);
    write_all(open, file.content, file.path);
}

bool is_written_through(const OutputFile& file) {
    struct stat status = {};
    if (own_descriptor(file.path)) return true;
    return ::stat(file.path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

}  // namespace

void write_files(const std::vector<OutputFile>& files) {
    FileSet set;
    std::vector<const OutputFile*> streams;
    for (const OutputFile& file : files) {
        if (is_written_through(file)) streams.push_back(&file);
        else set.add(file);
    }
    set.wait_for_turn();
    {
        const SignalBlocker whole;
        set.write();
    }
    for (const OutputFile* file : streams) write_through(*file);
}

}  // namespace grafverif::app
