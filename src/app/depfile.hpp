// SPDX-License-Identifier: MIT
// Depfile: which files a result was made from, as Make and Ninja read it: `RESULT...: FILE...`, and for each file a rule
// of its own with nothing behind it, so that one which is gone makes the result anew instead of stopping the build.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/job.hpp"
#include "app/system/write_files.hpp"

namespace grafverif::app {

/// `name` as GNU make reads it in a rule: blanks, `#` and `:` behind a backslash, `$` twice, backslashes before one of
/// these and at the end doubled.
std::string make_name(std::string_view name);

/// The text of a depfile. Both hold no line breaks.
std::string depfile_text(const std::vector<std::string>& results, const std::vector<std::string>& files);

/// The depfile that the options ask for, of the files read so far, once in a job; nothing: none is asked for, there is
/// nothing that it could be about, or an error.
std::optional<OutputFile> depfile_of(const std::vector<OutputFile>& made, Job& job);

}  // namespace grafverif::app
