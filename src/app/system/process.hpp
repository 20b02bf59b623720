// SPDX-License-Identifier: MIT
// Other programs: found on the PATH, run within limits, their output kept in memory. No shell takes part: arguments
// reach the program as they are.
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
    const std::atomic<bool>* stop = nullptr;           ///< set by somebody else: end the program
    std::size_t max_output = std::size_t{256} << 20U;  ///< bytes, of standard output and of standard error
    std::filesystem::path folder = {};                 ///< where the program runs; empty: where we do
};

/// The executable file called `name` in the first folder of the PATH that has one, as an absolute path. A name with a
/// slash is a path and is looked for nowhere else.
std::optional<std::filesystem::path> find_program(const std::string& name);

/// Runs `arguments`, the first one being the path of the program, with `input` as its standard input. The program and
/// what it has started end with this call, whatever the outcome. Throws std::system_error if it cannot be started.
ProgramResult run_program(const std::vector<std::string>& arguments, const std::string& input,
                          const ProgramLimits& limits);

/// A new folder for files that other programs read; gone with the object. Those of runs that were killed are removed
/// on the way: nobody holds their lock. Programs run in it and name its files without their path, whatever that holds.
/// Throws std::system_error.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Writes the file `name`, in place of one that was there. Throws std::system_error.
    void write(const std::string& name, const std::string& content) const;

private:
    std::filesystem::path path_ = {};
    Descriptor lock_ = Descriptor();
};

}  // namespace grafverif::app
