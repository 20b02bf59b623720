// SPDX-License-Identifier: MIT
// Writes files completely or not at all. The guarantees, and their implementation, are:
//
//   a file    A reader reads the old content or the new content, never a part. The new content is written to a draft
//             with an unpredictable name in the same folder, flushed to the disk, and renamed.
//   a set     After an error nothing has changed: renamed files are renamed back. SIGINT, SIGTERM and SIGHUP are
//             postponed until the set is written. SIGKILL or a loss of power cannot be postponed and can leave a set
//             of which some files are new and others old, although each file is complete: POSIX renames one file at a
//             time.
//   two runs  A lock (flock) on each folder serializes the runs, so that one complete set remains. If the file system
//             has no such locks, the runs are not serialized, and drafts of killed runs remain. With locks, the next
//             run in the folder removes these drafts.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace grafverif::app {

struct OutputFile {
    std::filesystem::path path = {};
    std::string content = {};
    unsigned mode = 0666;  ///< permissions of a new file, before the umask

    /// If given, the file is replaced only if it is missing or has this content; otherwise the error is ESTALE. The
    /// content is compared directly before the file is replaced, while this process holds the lock on the folder.
    std::optional<std::string> replaces = {};
};

/// Writes the set of files with the guarantees above. Symbolic links are kept, and their targets are written, even if
/// they do not exist. Missing folders are created. The permissions of a file are kept. A file without write permission
/// is not replaced. Pipes, devices and descriptors of this process are written last, sequentially and without
/// guarantees. Throws std::system_error if a file cannot be written.
void write_files(const std::vector<OutputFile>& files);

}  // namespace grafverif::app
