// SPDX-License-Identifier: MIT
// Watch: whether files have changed since they were read. It looks at size, times and identity, so it notices a file that
// is written in place, replaced by another of its name, gone, or there again. The time of writing can be set to what it
// was; that of the last change cannot.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace grafverif {

class Watch {
public:
    /// The file at `path` is about to be read.
    void note(const std::string& path);
    void note(const std::vector<std::string>& paths);
    /// Forgets all files.
    void clear() { seen_.clear(); }
    /// Whether a noted file is not what it was.
    bool changed() const;
    /// Whether one that was there is gone.
    bool missing() const;
    /// Those that are not what they were.
    std::vector<std::string> changes() const;
    std::size_t size() const { return seen_.size(); }

private:
    struct Stamp {
        bool there = false;
        std::uint64_t device = 0, file = 0, size = 0;
        std::array<std::int64_t, 2> times = {};  ///< written, changed; nanoseconds since 1970
        bool operator==(const Stamp&) const = default;
    };
    static Stamp stamp(const std::string& path);

    std::map<std::string, Stamp> seen_ = {};
};

}  // namespace grafverif
