// SPDX-License-Identifier: MIT
// Depfile: the files that a result was made from, as Make, Ninja and CMake read it: `RESULT...: FILE...`, followed by
// an empty rule for each file, so that a deleted file causes the result to be rebuilt instead of stopping the build.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/command_context.hpp"
#include "app/options.hpp"
#include "app/system/write_files.hpp"

namespace grafverif::app {

/// Position of a name in a depfile: left or right of the colon.
enum class DepfileSide { Result, File };

/// `name` as `reader` (GNU make 4.3, Ninja 1.11, CMake 3.25 and later versions) expects it on that side; nothing if the
/// reader cannot represent the name.
std::optional<std::string> depfile_name(std::string_view name, DepfileSide side, DepfileReader reader);

/// The text of a depfile. Requires names that `reader` can represent.
std::string depfile_text(const std::vector<std::string>& results, const std::vector<std::string>& files,
                         DepfileReader reader);

/// The depfile that the options request, from the files read so far, at most once per job. Nothing if none is
/// requested, if no result was made, or after an error.
std::optional<OutputFile> depfile_of(const std::vector<OutputFile>& made, CommandContext& job);

}  // namespace grafverif::app
