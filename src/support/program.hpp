// SPDX-License-Identifier: MIT
// The result of running an external program. Only the module `app` runs programs; other modules receive a RunProgram
// function.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace grafverif {

struct ProgramResult {
    enum class End {
        Exited,         ///< the program ended normally; `status` is its exit code
        Signalled,      ///< signal number `status` ended the program
        TimedOut,       ///< grafverif ended the program at the deadline
        Stopped,        ///< grafverif ended the program at the user's request
        TooMuchOutput,  ///< grafverif ended the program because its output exceeded the limit
    };
    End end = End::Exited;
    int status = 0;
    std::string out = {}, err = {};  ///< standard output and standard error, up to the end of the program

    bool operator==(const ProgramResult&) const = default;
};

/// Returns the reason why a program did not end normally; empty if it ended normally.
inline std::string ended_by(const ProgramResult& program_result) {
    switch (program_result.end) {
    case ProgramResult::End::TimedOut: return "stopped at the time limit";
    case ProgramResult::End::Stopped: return "stopped";
    case ProgramResult::End::TooMuchOutput: return "the output of the program is too large";
    case ProgramResult::End::Signalled:
        return "the program was terminated by signal " + std::to_string(program_result.status);
    case ProgramResult::End::Exited: break;
    }
    return {};
}

/// Runs a program and waits for its end. The first element of `arguments` is the program.
using RunProgram = std::function<ProgramResult(const std::vector<std::string>& arguments)>;

}  // namespace grafverif
