// SPDX-License-Identifier: MIT
// Checks that no file is both input and output of a command, and that no two outputs are the same file. Paths that the
// options name are checked before any work begins.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/command_context.hpp"
#include "app/program.hpp"
#include "app/system/write_files.hpp"

namespace grafverif::app {

/// True if `path` is standard input or output under any of its names: `-`, `/dev/stdin`.
bool names_input(const std::string& path);
bool names_output(const std::string& path);

/// True if a report or similar document is written to standard output, so that other messages must be written
/// elsewhere.
bool reports_on_output(const Options& options);
/// True if files must be written even if the reader of standard output has closed the pipe.
bool writes_files(const Options& options);

/// Checks that the options name distinct files as outputs. Returns false after an error.
bool outputs_differ(CommandContext& job);
/// Checks that no output has the extension of a format that the command does not write, as in `draw -o x.png`. Returns
/// false after an error.
bool formats_are_written(std::string_view verb, CommandContext& job);
/// Checks that the folders of the outputs exist or may be created. Returns false after an error. `folder` is true if
/// `-o` names a folder.
bool folders_are_there(bool folder, CommandContext& job);

/// Records that the command reads the file at `path`. Returns false after an error: the file is also an output.
bool note_input(const std::string& path, CommandContext& job);

/// Writes the set of files (see write_files), preceded by the depfile if a depfile is requested. `-` and other names of
/// standard output and error denote the streams. Returns false after an error: one of the files is an input, or occurs
/// twice.
bool write_outputs(const std::vector<OutputFile>& files, CommandContext& job, const Streams& streams);

}  // namespace grafverif::app
