// SPDX-License-Identifier: MIT
#include "pipeline/file_watcher.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <thread>

namespace grafverif {

namespace {

std::int64_t nanoseconds(const timespec& time) {
    return static_cast<std::int64_t>(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

}  // namespace

FileWatcher::FileStamp FileWatcher::stamp(const std::string& path) {
    struct stat status = {};
    if (::stat(path.c_str(), &status) != 0) return {};
    return {true,
            status.st_dev,
            status.st_ino,
            static_cast<std::uint64_t>(status.st_size),
            {nanoseconds(status.st_mtim), nanoseconds(status.st_ctim)}};
}

void FileWatcher::note(const std::string& path) { note(std::vector{path}); }

/// Records the time stamps of the files. If a file is written twice within a short time, its time stamp can be the same
/// after both writes. Therefore, if a file was changed less than 20 ms ago, the function waits (at most five times) and
/// reads the time stamps again.
void FileWatcher::note(const std::vector<std::string>& paths) {
    constexpr std::int64_t tick = 20'000'000;
    std::vector<FileStamp> seen(paths.size());
    for (int tries = 0;; ++tries) {
        std::ranges::transform(paths, seen.begin(), stamp);
        timespec now = {};
        ::clock_gettime(CLOCK_REALTIME, &now);
        std::int64_t youngest = tick;
        for (const FileStamp& each : seen)
            for (const std::int64_t time : each.times)
                if (const std::int64_t age = nanoseconds(now) - time; each.there && age >= 0)
                    youngest = std::min(youngest, age);
        if (youngest >= tick || tries == 5) break;
        std::this_thread::sleep_for(std::chrono::nanoseconds(tick - youngest));
    }
    for (std::size_t k = 0; k < paths.size(); ++k) {
        const auto [place, is_new] = seen_.try_emplace(paths[k], seen[k]);
        // If a recorded file has already changed, it gets an impossible time stamp, so that `changed` still reports the
        // file.
        if (!is_new && place->second != seen[k]) place->second.times = {-1, -1};
    }
}

bool FileWatcher::changed() const {
    return std::ranges::any_of(seen_, [](const auto& seen) { return stamp(seen.first) != seen.second; });
}

bool FileWatcher::missing() const {
    return std::ranges::any_of(seen_, [](const auto& seen) { return seen.second.there && !stamp(seen.first).there; });
}

std::vector<std::string> FileWatcher::changes() const {
    std::vector<std::string> changed;
    for (const auto& [path, seen] : seen_)
        if (stamp(path) != seen) changed.push_back(path);
    return changed;
}

}  // namespace grafverif
