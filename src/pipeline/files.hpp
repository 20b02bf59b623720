// SPDX-License-Identifier: MIT
// Files are read whole, with a bound; and what tells one file from another.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace grafverif {

inline constexpr std::uintmax_t largest_input = std::uintmax_t{256} << 20U;  ///< bytes

/// The content of the regular file at `path`, or nothing with the reason in `why`: missing, a folder, a pipe, a device,
/// unreadable, above `largest_input`. Never waits.
std::optional<std::string> content_of_file(const std::filesystem::path& path, std::string& why);

/// The number of the descriptor that `path` names as one of ours: `/dev/stdin`, `/dev/fd/3`, `/proc/self/fd/3`.
std::optional<int> own_descriptor(const std::filesystem::path& path);

/// What is read from `descriptor` or `in` to its end, as above; waits for who writes.
std::optional<std::string> read_descriptor(int descriptor, std::string& why);
std::optional<std::string> read_stream(std::istream& in, std::string& why);

/// Equal for all paths to one file, hard and symbolic links included; for a file that is not there yet, of paths to one
/// name in one folder. Empty where there is nothing to tell apart: pipes, devices, the unreachable.
std::string file_identity(const std::filesystem::path& path);
/// The same of what is there, whatever it is; empty: nothing is.
std::string identity_of_existing(const std::string& path);

/// The files below `folder` whose names end in `ending`, in order; hidden folders are left out, links to folders are not
/// followed; file systems of the kernel, such as /proc, are left out. At most `most` files and folders are looked at, in all calls
/// that share it; 0 is left where that was too few, or `stop` became true.
struct FilesBelow {
    std::vector<std::string> files = {}, folders = {};  ///< all folders that were looked into
};
FilesBelow files_below(const std::string& folder, std::string_view ending, std::size_t& most,
                       const std::atomic<bool>* stop = nullptr);

/// Which files a file may include: those below the folder of the main file, below the folder of its project, and below
/// folders that the user names. A chart does not decide which other files of the machine are read; the current folder has
/// no part in it. The folder of the project is the nearest above the main file, its own included, that holds `.git` or
/// `grafverif.project`. A folder that cannot be resolved, of a main file that is nowhere on the disk too, opens nothing.
class Reach {
public:
    /// `main`: the main file. `folders`: those that the user names.
    Reach(const std::filesystem::path& main, const std::vector<std::string>& folders);

    /// The content of the regular file at `path`, if it is in reach; else nothing, and `why`.
    std::optional<std::string> read(const std::string& path, std::string& why) const;

private:
    std::vector<std::filesystem::path> roots_ = {};  ///< links followed
};

}  // namespace grafverif
