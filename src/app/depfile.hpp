// SPDX-License-Identifier: MIT
// Depfile: lists the input files of a result in the form that Make, Ninja and CMake read: `RESULT...: FILE...`. An
// empty rule for each file follows, so that a deleted file causes the result to be rebuilt instead of stopping the
// build.
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

/// Returns `name` in the form that `reader` (GNU make 4.3, Ninja 1.11, CMake 3.25 and later versions) expects on the
/// given side of the colon; empty if the reader cannot represent the name.
std::optional<std::string> depfile_name(std::string_view name, DepfileSide side, DepfileReader reader);

/// Returns the text of a depfile. Requires names that `reader` can represent.
std::string depfile_text(const std::vector<std::string>& results, const std::vector<std::string>& files,
                         DepfileReader reader);

/// Returns the depfile that the options request, with the files read so far, at most once per context. The returned
/// value is empty if no depfile is requested, if the command has no result, or after an error.
std::optional<OutputFile> depfile_of(const std::vector<OutputFile>& made, CommandContext& job);

}  // namespace grafverif::app
