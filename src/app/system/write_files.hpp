// SPDX-License-Identifier: MIT
// Files are written whole or not at all. What is promised, and by what means:
//
//   a file    Whoever looks sees the old content or the new one, never a part: the new one is written to a draft of an
//             unpredictable name in the same folder, flushed to the disk, and renamed.
//   a set     After an error nothing has changed: what was renamed already is renamed back. SIGINT, SIGTERM and SIGHUP
//             wait until the set is written. Who cannot put us off - SIGKILL, a loss of power - can leave a set of which
//             some files are new and others old, each of them whole: POSIX renames one file at a time.
//   two runs  take turns at a folder (flock on it), so that one whole set remains. Where the file system has no such
//             locks they do not, and drafts of killed runs stay; elsewhere the next run in that folder removes them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace grafverif::app {

struct OutputFile {
    std::filesystem::path path = {};
    std::string content = {};
};

/// Writes the set, as promised above. Symbolic links stay, and what they lead to is written, also where that is missing.
/// Missing folders are made. Permissions of a file stay; one that may not be written is none that is replaced. Pipes,
/// devices and descriptors of ours are written to in the end, one after the other, and promise nothing. Throws
/// std::system_error.
void write_files(const std::vector<OutputFile>& files);

}  // namespace grafverif::app
