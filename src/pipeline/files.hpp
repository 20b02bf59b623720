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

#include "pipeline/descriptor.hpp"

namespace grafverif {

inline constexpr std::uintmax_t largest_input = std::uintmax_t{256} << 20U;  ///< maximum size of an input file in bytes

/// Opens the regular file at `path` for reading. The descriptor is not open if the file is missing, unreadable or not a
/// regular file (folder, pipe, device); `why` then has the reason. Never blocks.
Descriptor open_regular(const std::filesystem::path& path, std::string& why);

/// Returns the content of the regular file at `path`. The result is empty if the file is missing, unreadable, larger
/// than `most` bytes, or not a regular file (folder, pipe, device); `why` then has the reason. Never blocks.
std::optional<std::string> content_of_file(const std::filesystem::path& path, std::string& why,
                                           std::uintmax_t most = largest_input);

/// Returns the number of a descriptor of this process if `path` is a name for one: `/dev/stdin`, `/dev/fd/3`,
/// `/proc/self/fd/3`.
std::optional<int> own_descriptor(const std::filesystem::path& path);

/// Reads `descriptor` or `in` to the end. The result is empty if reading fails or the data exceed the size limit
/// (`most` bytes; `largest_input` for `in`); `why` then has the reason. May block.
std::optional<std::string> read_descriptor(int descriptor, std::string& why, std::uintmax_t most = largest_input);
std::optional<std::string> read_stream(std::istream& in, std::string& why);

/// Returns an identity that is equal for all paths to one file, including hard and symbolic links. For a missing file,
/// the identity is equal for all paths that denote the same name in the same folder. The identity is empty for pipes,
/// devices and inaccessible files.
std::string file_identity(const std::filesystem::path& path);
/// Returns the identity of an existing file of any type, or an empty string if no file exists at `path`.
std::string identity_of_existing(const std::string& path);

/// The result of files_below.
struct FilesBelow {
    std::vector<std::string> files = {}, folders = {};  ///< the files found, and all visited folders
};
/// Searches `folder` and its subfolders for files with names that end in `ending`, and returns the files in
/// alphabetical order. Hidden folders and file systems of the kernel, such as /proc, are skipped; links to folders are
/// not followed. `most` is the maximum number of files and folders to visit; each visit decrements it. If the maximum
/// is reached, or if `stop` becomes true, `most` is 0 after the call.
FilesBelow files_below(const std::string& folder, std::string_view ending, std::size_t& most,
                       const std::atomic<bool>* stop = nullptr);

/// The folders to which the option `--within` restricts the reading of files. Symbolic links are resolved before a path
/// is compared with the folders. If the list of folders is empty, reading is not restricted. A folder that does not
/// exist permits no files.
class PermittedFolders {
public:
    explicit PermittedFolders(const std::vector<std::string>& folders = {});

    /// Returns `path` with resolved links, or unchanged if reading is not restricted. The result is empty if the path
    /// is outside of the folders; `why` then has the reason, which does not depend on the existence of the file.
    std::optional<std::filesystem::path> resolved(const std::filesystem::path& path, std::string& why) const;
    /// Same as `resolved`, but a relative path refers to the first permitted folder that contains a file with this
    /// path.
    std::optional<std::filesystem::path> located(const std::filesystem::path& path, std::string& why) const;
    /// Returns the content of the regular file at `path`. The result is empty if the file is outside of the folders, if
    /// it has more than `most` bytes, or if it cannot be read; `why` then has the reason.
    std::optional<std::string> read(const std::filesystem::path& path, std::string& why,
                                    std::uintmax_t most = largest_input) const;

private:
    bool restricted_ = false;
    std::vector<std::filesystem::path> folders_ = {};  ///< with resolved links
};

/// Returns `file` relative to the current folder if it is below this folder, otherwise unchanged. The result does not
/// begin with `-`, so that no command mistakes it for an option or for standard input.
std::string operand_for(const std::filesystem::path& file);

/// The files that source files may include: all files below the folder of the main file, below the folder of the
/// project of the main file, and below folders given by the user. This restriction prevents a chart from reading
/// arbitrary files. The restriction does not depend on the current folder. The folder of the project is the nearest
/// ancestor folder of the main file that contains `.git` or `grafverif.project`. A folder that cannot be resolved, for
/// example because the main file is not on disk, permits no files.
class Reach {
public:
    /// `main` is the main file; `folders` are given by the user. Only files below the folders `within` may be included.
    Reach(const std::filesystem::path& main, const std::vector<std::string>& folders,
          PermittedFolders within = PermittedFolders());

    /// Returns the content of the regular file at `path` if it may be included. If the file may not be included or
    /// cannot be read, the result is empty, and `why` has the reason.
    std::optional<std::string> read(const std::string& path, std::string& why) const;

private:
    std::vector<std::filesystem::path> roots_ = {};  ///< permitted folders, with resolved links
    PermittedFolders within_;
};

}  // namespace grafverif
