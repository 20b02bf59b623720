// SPDX-License-Identifier: MIT
#include "app/reach.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>

#include "app/files.hpp"

namespace grafverif::app {

namespace fs = std::filesystem;

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
    return ::stat(path.c_str(), &status) == 0 ? fmt::format("{}:{}", status.st_dev, status.st_ino) : std::string();
}

Reach::Reach(const fs::path& main, const std::vector<std::string>& folders) {
    roots_.push_back(fs::weakly_canonical(fs::absolute(main).parent_path()));
    if (auto project = project_of(roots_.front())) roots_.push_back(std::move(*project));
    for (const std::string& folder : folders) roots_.push_back(fs::weakly_canonical(fs::absolute(folder)));
}

std::optional<std::string> Reach::read(const std::string& path, std::string& why) const {
    std::error_code failure;
    const fs::path file = fs::canonical(path, failure);
    if (!failure && std::ranges::none_of(roots_, [&](const fs::path& root) { return is_below(file, root); })) {
        why = "it lies neither below the folder of the main file nor below that of its project, which `.git` or `grafverif.project` "
              "marks; let it be read with `-I FOLDER`";
        return {};
    }
    return read_file(failure ? fs::path(path) : file, why);
}

}  // namespace grafverif::app
