// SPDX-License-Identifier: MIT
// Depfile: which files a result was made from, as Make, Ninja and CMake read it: `RESULT...: FILE...`, and for each file a rule
// of its own with nothing behind it, so that one which is gone makes the result anew instead of stopping the build.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/job.hpp"
#include "app/options.hpp"
#include "app/system/write_files.hpp"

namespace grafverif::app {

/// Where a name stands in a depfile: left or right of the colon.
enum class DepfileSide { Result, File };

/// `name` as `reader` (GNU make 4.3, Ninja 1.11, CMake 3.25, and later ones) takes it on that side; nothing: it has no
/// way to say that name.
std::optional<std::string> depfile_name(std::string_view name, DepfileSide side, DepfileReader reader);

/// The text of a depfile, of names that `reader` can say.
std::string depfile_text(const std::vector<std::string>& results, const std::vector<std::string>& files,
                         DepfileReader reader);

/// The depfile that the options ask for, of the files read so far, once in a job; nothing: none is asked for, there is
/// nothing that it could be about, or an error.
std::optional<OutputFile> depfile_of(const std::vector<OutputFile>& made, Job& job);

}  // namespace grafverif::app
