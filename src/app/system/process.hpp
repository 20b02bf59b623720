// SPDX-License-Identifier: MIT
// External programs: found on the PATH, run within limits, with their output kept in memory. No shell is involved:
// arguments are passed unchanged.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/descriptor.hpp"
#include "support/program.hpp"

namespace grafverif::app {

struct ProgramLimits {
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;           ///< cancellation flag: end the program
    std::size_t max_output = std::size_t{256} << 20U;  ///< bytes, for standard output and standard error each
    std::filesystem::path folder = {};                 ///< the program's current folder; empty: that of this process
};

/// The executable file called `name` in the first folder of the PATH that has one, as an absolute path. A name with a
/// slash is a path and is not searched for.
std::optional<std::filesystem::path> find_program(const std::string& name);

/// Runs `arguments`, of which the first is the path of the program, with `input` as its standard input. The program and
/// its descendants end with this call in any case. Throws std::system_error if it cannot be started.
ProgramResult run_program(const std::vector<std::string>& arguments, const std::string& input,
                          const ProgramLimits& limits);

/// A new folder for files that other programs read, removed by the destructor. The constructor also removes folders of
/// killed runs: their locks are free. Programs run in it and name its files without their path, whose characters
/// therefore do not matter. Throws std::system_error.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Writes the file `name`, replacing an existing one. Throws std::system_error.
    void write(const std::string& name, const std::string& content) const;

private:
    std::filesystem::path path_ = {};
    Descriptor lock_ = Descriptor();
};

}  // namespace grafverif::app
