// SPDX-License-Identifier: MIT
// Reads complete files with a size limit, and determines the identity of files.
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

/// The number of the descriptor that `path` names as one of this process: `/dev/stdin`, `/dev/fd/3`, `/proc/self/fd/3`.
std::optional<int> own_descriptor(const std::filesystem::path& path);

/// Reads `descriptor` or `in` to its end, with the same limit; may block.
std::optional<std::string> read_descriptor(int descriptor, std::string& why);
std::optional<std::string> read_stream(std::istream& in, std::string& why);

/// Equal for all paths to one file, including hard and symbolic links; for a missing file, for all paths to one name in
/// one folder. Empty for files without identity: pipes, devices, inaccessible files.
std::string file_identity(const std::filesystem::path& path);
/// The identity of an existing file of any type; empty if there is none.
std::string identity_of_existing(const std::string& path);

/// The files below `folder` whose names end in `ending`, in order. Hidden folders and file systems of the kernel, such
/// as /proc, are skipped; links to folders are not followed. Visits at most `most` files and folders, in all calls that
/// share it; 0 remains if that was not enough, or if `stop` became true.
struct FilesBelow {
    std::vector<std::string> files = {}, folders = {};  ///< all folders visited
};
FilesBelow files_below(const std::string& folder, std::string_view ending, std::size_t& most,
                       const std::atomic<bool>* stop = nullptr);

/// The files that a file may include: those below the folder of the main file, below the folder of its project, and
/// below folders that the user names. So a chart cannot cause arbitrary files to be read; the current folder is
/// irrelevant. The folder of the project is the nearest ancestor folder of the main file that contains `.git` or
/// `grafverif.project`. A folder that cannot be resolved, as for a main file that is not on disk, permits nothing.
class Reach {
public:
    /// `main`: the main file. `folders`: those that the user names.
    Reach(const std::filesystem::path& main, const std::vector<std::string>& folders);

    /// The content of the regular file at `path`, if it may be included; otherwise nothing, and the reason in `why`.
    std::optional<std::string> read(const std::string& path, std::string& why) const;

private:
    std::vector<std::filesystem::path> roots_ = {};  ///< with links resolved
};

}  // namespace grafverif
