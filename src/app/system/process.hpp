// SPDX-License-Identifier: MIT
// External programs: searched for on the PATH, executed within limits, with their output stored in memory. No shell is
// involved: arguments are passed unchanged.
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
    const std::atomic<bool>* stop = nullptr;           ///< cancellation flag, which ends the program
    std::size_t max_output = std::size_t{256} << 20U;  ///< limit in bytes for standard output and for standard error
    std::filesystem::path folder = {};  ///< the program's current folder; if empty, the current folder of this process
};

/// Returns the absolute path of the executable file called `name` in the first folder of the PATH that contains such a
/// file. A name with a slash is a path and is not searched for.
std::optional<std::filesystem::path> find_program(const std::string& name);

/// Executes `arguments`, the first of which is the path of the program, with `input` as its standard input. When the
/// function returns, the program and all its descendants have ended. Throws std::system_error if the program cannot be
/// started.
ProgramResult run_program(const std::vector<std::string>& arguments, const std::string& input,
                          const ProgramLimits& limits);

/// A new folder for files that other programs read. The destructor removes the folder. The
/// constructor also removes the folders of killed runs, which it recognizes by their free locks.
/// The folder is the current folder of the programs, which name its files without their path;
/// therefore the path may contain any characters. Throws std::system_error if the folder cannot be
/// created.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Writes the file `name`, replacing an existing file. Throws std::system_error if the file cannot be written.
    void write(const std::string& name, const std::string& content) const;

private:
    std::filesystem::path path_ = {};
    Descriptor lock_ = Descriptor();
};

}  // namespace grafverif::app
