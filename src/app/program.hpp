// SPDX-License-Identifier: MIT
// The program as a function: arguments in, streams in and out, exit code back; so that tests run it in-process.
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "app/system/screen.hpp"

namespace grafverif::app {

/// Exit codes; where several apply: Failure before Input before Verdict before Unknown.
enum class ExitCode {
    Done = 0,     ///< done, every verdict as expected
    Verdict = 1,  ///< a verdict against expectation
    Input = 2,    ///< input or usage wrong
    Unknown = 3,  ///< a verdict unknown, or stopped: by a bound of time or memory, or by Ctrl-C
    Failure = 4,  ///< a failure on our side
};

/// That of two runs, by the order above.
ExitCode worse(ExitCode one, ExitCode other);

/// The standard streams, what a person sees of them (documents are made clean on the way to a terminal), and whether
/// nobody else runs in this process.
struct Streams {
    std::istream& in;
    std::ostream& out;
    std::ostream& err;
    bool alone = false;  ///< the process is ours: it may be bounded, and ended
    Screen out_screen = {}, err_screen = {};
    bool typed = false;  ///< a person types `in` at a terminal, on which `out` is shown
    /// Where outputs called `-` go, and what a person sees of it, if that is not `out`.
    std::ostream* documents = nullptr;
    Screen documents_screen = {};
};

struct Verb;

/// All verbs, in the order of --help.
std::vector<Verb> all_verbs();

/// That there is no such verb, and which one may be meant.
std::string no_such_verb(const std::string& name);

/// Runs `grafverif ARGUMENTS`, the program's name left out.
ExitCode run(std::span<const std::string> arguments, const Streams& streams);

}  // namespace grafverif::app
