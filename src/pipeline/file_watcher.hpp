// SPDX-License-Identifier: MIT
// File watcher: detects changes of files after they were read. The watcher compares the size, two times and the
// identity of each file. Therefore the watcher detects that a file is written in place, replaced by another file with
// the same name, deleted, or restored. The two times are the modification time and the time of the last status change
// (`ctime`): programs can set back the modification time, but not `ctime`.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace grafverif {

class FileWatcher {
public:
    /// Records a file that is about to be read.
    void note(const std::string& path);
    void note(const std::vector<std::string>& paths);
    /// Forgets all files.
    void clear() { seen_.clear(); }
    /// True if a recorded file has changed.
    bool changed() const;
    /// True if a recorded file has been deleted.
    bool missing() const;
    /// Returns the files that have changed.
    std::vector<std::string> changes() const;
    std::size_t size() const { return seen_.size(); }

private:
    struct FileStamp {
        bool there = false;
        std::uint64_t device = 0, file = 0, size = 0;
        std::array<std::int64_t, 2> times = {};  ///< times of modification and status change; nanoseconds since 1970
        bool operator==(const FileStamp&) const = default;
    };
    static FileStamp stamp(const std::string& path);

    std::map<std::string, FileStamp> seen_ = {};
};

}  // namespace grafverif
