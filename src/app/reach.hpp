// SPDX-License-Identifier: MIT
// Reach: which files a file may include. A chart does not decide which other files of the machine are read: those below
// the folder of the main file, below the folder of its project, and below folders that the user names. The current
// folder has no part in it. The folder of the project is the nearest above the main file, its own included, that holds
// `.git` or `grafverif.project`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace grafverif::app {

/// What tells the file at `path` from others (see file_identity); empty: nothing is there.
std::string identity_of_existing(const std::string& path);

class Reach {
public:
    /// `main`: the main file. `folders`: those of `-I`.
    Reach(const std::filesystem::path& main, const std::vector<std::string>& folders);

    /// The content of the regular file at `path`, if it is in reach; else nothing, and `why`.
    std::optional<std::string> read(const std::string& path, std::string& why) const;

private:
    std::vector<std::filesystem::path> roots_ = {};   ///< links followed
};

}  // namespace grafverif::app
