// SPDX-License-Identifier: MIT
// Files: read whole with a bound, written whole or not at all.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace grafverif::app {

inline constexpr std::uintmax_t largest_input = std::uintmax_t{256} << 20U;   ///< bytes

/// The content of `path`, or nothing with the reason in `why`: missing, a directory, unreadable, above `largest_input`.
std::optional<std::string> read_file(const std::filesystem::path& path, std::string& why);

struct OutputFile {
    std::filesystem::path path = {};
    std::string content = {};
};

/// Writes every file or none: each is first written beside its place and moved there once all are written. Missing
/// folders of the paths are made. Throws std::filesystem::filesystem_error or std::system_error; then no file that
/// was there before has changed and nothing new remains.
void write_files(const std::vector<OutputFile>& files);

}  // namespace grafverif::app
