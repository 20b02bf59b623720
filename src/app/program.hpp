// SPDX-License-Identifier: MIT
// The program as a function: arguments, streams and exit code are explicit, so that tests run it in-process.
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "app/system/screen.hpp"

namespace grafverif::app {

/// Exit codes. If several apply, the order of precedence is Failure, Input, Verdict, Unknown.
enum class ExitCode {
    Done = 0,     ///< completed, every verdict as expected
    Verdict = 1,  ///< an unexpected verdict
    Input = 2,    ///< error in the input or usage
    Unknown = 3,  ///< an unknown verdict, or stopped by a limit of time or memory or by Ctrl-C
    Failure = 4,  ///< an internal failure
};

/// The combined code of two runs, by this precedence.
ExitCode worse(ExitCode one, ExitCode other);

/// The standard streams, the properties of their terminals (control characters in documents are removed before they
/// reach a terminal), and whether this process runs nothing besides the program.
struct Streams {
    std::istream& in;
    std::ostream& out;
    std::ostream& err;
    bool alone = false;  ///< the program owns the process: it may limit and end it
    Screen out_screen = {}, err_screen = {};
    bool typed = false;  ///< a user types `in` at a terminal, on which `out` is shown
    /// The stream of outputs called `-`, and the properties of its terminal, if it is not `out`.
    std::ostream* documents = nullptr;
    Screen documents_screen = {};
};

struct CliCommand;

/// All commands, in the order of --help.
std::vector<CliCommand> all_commands();

/// Message that the command does not exist, with the most similar one.
std::string unknown_command(const std::string& name);

/// Runs `grafverif ARGUMENTS`; the arguments do not include the program's name.
ExitCode run(std::span<const std::string> arguments, const Streams& streams);

}  // namespace grafverif::app
