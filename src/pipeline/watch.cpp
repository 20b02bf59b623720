// SPDX-License-Identifier: MIT
#include "pipeline/watch.hpp"

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

Watch::Stamp Watch::stamp(const std::string& path) {
    struct stat status = {};
    if (::stat(path.c_str(), &status) != 0) return {};
    return {true,
            status.st_dev,
            status.st_ino,
            static_cast<std::uint64_t>(status.st_size),
            {nanoseconds(status.st_mtim), nanoseconds(status.st_ctim)}};
}

/// A file that has just been written may be written again without its time changing: it is given a moment first.
void Watch::note(const std::string& path) {
    constexpr std::int64_t tick = 20'000'000;
    Stamp seen = stamp(path);
    for (int tries = 0; tries < 5 && seen.there; ++tries) {
        timespec now = {};
        ::clock_gettime(CLOCK_REALTIME, &now);
        std::int64_t youngest = tick;
        for (const std::int64_t time : seen.times)
            if (const std::int64_t age = nanoseconds(now) - time; age >= 0) youngest = std::min(youngest, age);
        if (youngest >= tick) break;
        std::this_thread::sleep_for(std::chrono::nanoseconds(tick - youngest));
        seen = stamp(path);
    }
    const auto [place, is_new] = seen_.try_emplace(path, seen);
    if (!is_new && place->second != seen) place->second.times = {-1, -1};  // noted before, and changed since
}

bool Watch::changed() const {
    return std::ranges::any_of(seen_, [](const auto& seen) { return stamp(seen.first) != seen.second; });
}

bool Watch::missing() const {
    return std::ranges::any_of(seen_, [](const auto& seen) { return seen.second.there && !stamp(seen.first).there; });
}

std::vector<std::string> Watch::changes() const {
    std::vector<std::string> changed;
    for (const auto& [path, seen] : seen_)
        if (stamp(path) != seen) changed.push_back(path);
    return changed;
}

}  // namespace grafverif
