// SPDX-License-Identifier: MIT
// Outputs of a run against its inputs and each other: no file is both, and no two outputs are one file. What the options
// name is known before there is any work, and is refused then.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/job.hpp"
#include "app/program.hpp"
#include "app/system/write_files.hpp"

namespace grafverif::app {

/// Whether `path` is standard input or output, under any of its names: `-`, `/dev/stdin`.
bool names_input(const std::string& path);
bool names_output(const std::string& path);

/// Whether a report or the like goes to standard output, where what is said to people has no place then.
bool reports_on_output(const Options& options);
/// Whether files are to be there in the end, even if nobody reads standard output any more.
bool writes_files(const Options& options);

/// The files that the options name as outputs are different ones; false after an error.
bool outputs_differ(Job& job);
/// No output is named after a format that `verb` does not write (`draw -o x.png`); false after an error.
bool formats_are_written(std::string_view verb, Job& job);
/// Their folders are there, or may be made; false after an error. `folder`: what `-o` names is a folder.
bool folders_are_there(bool folder, Job& job);

/// Notes that the file at `path` is read in this run; false after an error: it is to be written too.
bool note_input(const std::string& path, Job& job);

/// Writes the set (see write_files), the depfile first if one is asked for; `-` and standard output and error by another
/// name go to the streams. False after an error: one of the files is an input, or is there twice.
bool write_outputs(const std::vector<OutputFile>& files, Job& job, const Streams& streams);

}  // namespace grafverif::app
