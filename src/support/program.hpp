// SPDX-License-Identifier: MIT
// Result of running another program. Only `app` runs programs; other modules receive a function that does.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace grafverif {

struct ProgramResult {
    enum class End {
        Exited,         ///< normally; `status` is its exit code
        Signalled,      ///< ended by signal number `status`
        TimedOut,       ///< ended by grafverif at the deadline
        Stopped,        ///< ended by grafverif at the user's request
        TooMuchOutput,  ///< ended by grafverif because its output exceeded the limit
    };
    End end = End::Exited;
    int status = 0;
    std::string out = {}, err = {};  ///< standard output and standard error, complete or up to the end of the program

    bool operator==(const ProgramResult&) const = default;
};

/// Describes why a program did not exit normally; empty if it did.
inline std::string ended_by(const ProgramResult& said) {
    switch (said.end) {
    case ProgramResult::End::TimedOut: return "stopped at the time limit";
    case ProgramResult::End::Stopped: return "stopped";
    case ProgramResult::End::TooMuchOutput: return "the program wrote more than is read";
    case ProgramResult::End::Signalled: return "the program was ended by signal " + std::to_string(said.status);
    case ProgramResult::End::Exited: break;
    }
    return {};
}

/// Runs a program and waits for its end. The first of `arguments` is the program.
using RunProgram = std::function<ProgramResult(const std::vector<std::string>& arguments)>;

}  // namespace grafverif
