// SPDX-License-Identifier: MIT
#include "pipeline/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/magic.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <istream>
#include <string_view>
#include <system_error>
#include <utility>

#include "pipeline/descriptor.hpp"

namespace grafverif {

namespace fs = std::filesystem;

namespace {

std::string reason(int error) {
    if (error == ENOENT || error == ENOTDIR) return "no such file";
    return std::generic_category().message(error);
}

/// Returns a text for messages that states the type of a file, for example `the path is a folder`. Requires that the
/// file is not a regular file.
std::string_view kind_of(mode_t mode) {
    if (S_ISDIR(mode)) return "the path is a folder";
    if (S_ISFIFO(mode)) return "the path is a pipe, not a file";
    if (S_ISSOCK(mode)) return "the path is a socket, not a file";
    return "the path is a device, not a file";
}

constexpr std::size_t block_size = std::size_t{1} << 20U;

std::string too_large(std::uintmax_t most) { return fmt::format("the file is larger than {} MiB", most >> 20U); }

constexpr const char* outside_text = "the file is outside the permitted folders";

std::string device_and_node(const struct stat& status) { return fmt::format("{}:{}", status.st_dev, status.st_ino); }

}  // namespace

Descriptor open_regular(const fs::path& path, std::string& why) {
    struct stat status = {};
    if (::stat(path.c_str(), &status) != 0) return why = reason(errno), Descriptor();
    if (!S_ISREG(status.st_mode))
        return why = kind_of(status.st_mode), Descriptor();  // opening a device may have side effects
    Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK));
    if (!file.open() || ::fstat(file.number(), &status) != 0) return why = reason(errno), Descriptor();
    if (!S_ISREG(status.st_mode)) return why = kind_of(status.st_mode), Descriptor();
    return file;
}

std::optional<std::string> content_of_file(const fs::path& path, std::string& why, std::uintmax_t most) {
    const Descriptor file = open_regular(path, why);
    return file.open() ? read_descriptor(file.number(), why, most) : std::nullopt;
}

std::optional<int> own_descriptor(const fs::path& path) {
    const std::string text = path.lexically_normal().string();
    if (text == "/dev/stdin") return STDIN_FILENO;
    if (text == "/dev/stdout") return STDOUT_FILENO;
    if (text == "/dev/stderr") return STDERR_FILENO;
    for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
        if (!text.starts_with(folder)) continue;
        int number = 0;
        const char* const last = text.data() + text.size();
        const auto [end, failure] = std::from_chars(text.data() + folder.size(), last, number);
        if (failure == std::errc() && end == last && number >= 0) return number;
    }
    return {};
}

std::optional<std::string> read_descriptor(int descriptor, std::string& why, std::uintmax_t most) {
    std::string content, block(block_size, '\0');
    for (;;) {
        const ssize_t count = ::read(descriptor, block.data(), block.size());
        if (count == 0) return content;
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return why = reason(errno), std::nullopt;
        content.append(block, 0, static_cast<std::size_t>(count));
        if (content.size() > most) return why = too_large(most), std::nullopt;
    }
}

std::optional<std::string> read_stream(std::istream& in, std::string& why) {
    std::string content, block(block_size, '\0');
    while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0) {
        content.append(block, 0, static_cast<std::size_t>(in.gcount()));
        if (content.size() > largest_input) return why = too_large(largest_input), std::nullopt;
    }
    return content;
}

std::string file_identity(const fs::path& path) {
    struct stat status = {};
    if (::stat(path.c_str(), &status) == 0) return S_ISREG(status.st_mode) ? device_and_node(status) : std::string();
    std::error_code failure;
    fs::path place = path;
    for (int links = 0; links < 40 && fs::is_symlink(fs::symlink_status(place, failure)); ++links) {
        const fs::path target = fs::read_symlink(place, failure);
        place = target.is_absolute() ? target : place.parent_path() / target;
    }
    const fs::path folder = place.has_parent_path() ? place.parent_path() : ".";
    if (::stat(folder.c_str(), &status) == 0) return device_and_node(status) + "/" + place.filename().string();
    return fs::weakly_canonical(place, failure).string();
}

namespace {

std::optional<fs::path> project_of(fs::path folder) {
    for (;; folder = folder.parent_path()) {
        std::error_code ignored;
        for (const char* mark : {".git", "grafverif.project"})
            if (fs::exists(folder / mark, ignored)) return folder;
        if (!folder.has_relative_path()) return {};
    }
}

bool is_below(const fs::path& file, const fs::path& root) {
    return std::mismatch(root.begin(), root.end(), file.begin(), file.end()).first == root.end();
}

}  // namespace

std::string identity_of_existing(const std::string& path) {
    struct stat status = {};
    return ::stat(path.c_str(), &status) == 0 ? device_and_node(status) : std::string();
}

namespace {

/// True for a virtual folder of the kernel, such as `/proc`. Files in a virtual folder can change at any time, and
/// their size may be unbounded.
bool is_made_up(const fs::path& folder) {
    constexpr std::array made_up = {PROC_SUPER_MAGIC, SYSFS_MAGIC,        DEBUGFS_MAGIC,
                                    TRACEFS_MAGIC,    CGROUP_SUPER_MAGIC, CGROUP2_SUPER_MAGIC};
    struct statfs status = {};
    return ::statfs(folder.c_str(), &status) == 0 && std::ranges::find(made_up, status.f_type) != made_up.end();
}

}  // namespace

FilesBelow files_below(const std::string& folder, std::string_view ending, std::size_t& most,
                       const std::atomic<bool>* stop) {
    FilesBelow found;
    std::vector<fs::path> open = {folder};
    while (!open.empty() && most > 0) {
        const fs::path place = std::move(open.back());
        open.pop_back();
        if (stop != nullptr && *stop) most = 0;
        if (most == 0 || is_made_up(place)) continue;
        found.folders.push_back(place.string());
        std::error_code failure;
        for (fs::directory_iterator entry(place, failure), end; !failure && entry != end; entry.increment(failure)) {
            if (--most == 0) break;
            const std::string name = entry->path().filename().string();
            std::error_code ignored;
            if (entry->is_directory(ignored) && !entry->is_symlink(ignored)) {
                if (!name.starts_with('.')) open.push_back(entry->path());
            } else if (name.ends_with(ending)) {
                found.files.push_back(entry->path().string());
            }
        }
    }
    std::ranges::sort(found.files);
    return found;
}

PermittedFolders::PermittedFolders(const std::vector<std::string>& folders) : restricted_(!folders.empty()) {
    for (const std::string& folder : folders) {
        std::error_code failure;
        fs::path resolved = fs::canonical(folder, failure);
        if (!failure) folders_.push_back(std::move(resolved));
    }
}

std::optional<fs::path> PermittedFolders::resolved(const fs::path& path, std::string& why) const {
    if (!restricted_) return path;
    std::error_code failure;
    fs::path file = fs::absolute(path, failure);
    // Two passes are required. For example, if `missing` does not exist and `link` is a symbolic link, the first pass
    // turns `missing/../link` into `link`, and the second pass returns the target of `link`.
    for (int pass = 0; pass < 2 && !failure; ++pass) file = fs::weakly_canonical(file, failure);
    const bool is_resolved = !failure && !fs::is_symlink(fs::symlink_status(file, failure));
    if (is_resolved && std::ranges::any_of(folders_, [&](const fs::path& folder) { return is_below(file, folder); }))
        return file;
    why = outside_text;
    return {};
}

std::optional<fs::path> PermittedFolders::located(const fs::path& path, std::string& why) const {
    std::optional<fs::path> first;
    if (folders_.empty()) why = outside_text;
    for (const fs::path& folder : folders_) {
        const auto file = resolved(folder / path, why);  // if `path` is absolute, the result of `/` is `path`
        std::error_code failure;
        if (file && fs::exists(*file, failure)) return file;
        if (!first) first = file;
    }
    return first;
}

std::optional<std::string> PermittedFolders::read(const fs::path& path, std::string& why, std::uintmax_t most) const {
    const auto file = resolved(path, why);
    if (!file) return {};
    if (restricted_ && is_made_up(file->parent_path()))
        return why = "the file is a virtual file of the kernel", std::nullopt;
    return content_of_file(*file, why, most);
}

std::string operand_for(const fs::path& file) {
    std::error_code failure;
    const fs::path here = fs::current_path(failure);
    const fs::path relative = failure ? fs::path() : file.lexically_relative(here);
    if (relative.empty() || *relative.begin() == "..") return file.string();
    return relative.string().starts_with('-') ? "./" + relative.string() : relative.string();
}

Reach::Reach(const fs::path& main, const std::vector<std::string>& folders, PermittedFolders within)
    : within_(std::move(within)) {
    const auto add = [this](const fs::path& folder) {
        std::error_code failure;
        const fs::path full = fs::absolute(folder.empty() ? "." : folder, failure);
        fs::path resolved = failure ? fs::path() : fs::weakly_canonical(full, failure);
        if (!failure) roots_.push_back(std::move(resolved));  // a folder that cannot be resolved permits no files
        return !failure;
    };
    if (add(main.parent_path()))
        if (auto project = project_of(roots_.front())) roots_.push_back(std::move(*project));
    for (const std::string& folder : folders) add(folder);
}

std::optional<std::string> Reach::read(const std::string& path, std::string& why) const {
    const auto permitted = within_.resolved(path, why);
    if (!permitted) return {};
    std::error_code failure;
    const fs::path file = fs::canonical(*permitted, failure);
    if (!failure && std::ranges::none_of(roots_, [&](const fs::path& root) { return is_below(file, root); })) {
        why =
            "the file is outside the folder of the main file and outside the folder of its project (which contains "
            "`.git` or `grafverif.project`); pass the folder of the file with `-I DIR`";
        return {};
    }
    return content_of_file(failure ? *permitted : file, why);
}

}  // namespace grafverif
