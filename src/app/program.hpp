// SPDX-License-Identifier: MIT
// The program as a function. Arguments, streams and exit code are explicit, so that tests can execute it in their
// process.
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "app/system/screen.hpp"

namespace grafverif::app {

/// Exit codes. If several codes apply, the precedence is Failure, Input, Verdict, Unknown.
enum class ExitCode {
    Done = 0,     ///< completed, and every verdict is as expected
    Verdict = 1,  ///< a verdict is unexpected
    Input = 2,    ///< error in the input or in the usage
    Unknown = 3,  ///< a verdict is unknown, or the run was stopped by a limit of time or memory or by Ctrl-C
    Failure = 4,  ///< internal failure
};

/// Returns the code with the higher precedence.
ExitCode worse(ExitCode one, ExitCode other);

/// The standard streams and the properties of their terminals. Control characters in documents are removed before they
/// reach a terminal.
struct Streams {
    std::istream& in;
    std::ostream& out;
    std::ostream& err;
    /// True if the process executes only this program, which may then limit and end the process.
    bool alone = false;
    Screen out_screen = {}, err_screen = {};
    bool typed = false;  ///< true if `in` is a terminal, and `out` is a terminal that can overwrite a line

    /// Stream for outputs with the name `-`; null selects `out`. `documents_screen` has the
    /// properties of the terminal of this stream.
    std::ostream* documents = nullptr;
    Screen documents_screen = {};
};

struct CliCommand;

/// Returns all commands, in the order of --help.
std::vector<CliCommand> all_commands();

/// Returns the error message for an unknown command. The message suggests the most similar command.
std::string unknown_command(const std::string& name);

/// Executes `grafverif ARGUMENTS`. The arguments do not include the program's name.
ExitCode run(std::span<const std::string> arguments, const Streams& streams);

}  // namespace grafverif::app
