// SPDX-License-Identifier: MIT
// What comes of running another program. Only `app` runs programs; who needs one is handed a function that does.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace grafverif {

struct ProgramResult {
    enum class End {
        Exited,         ///< by itself; `status` is its exit code
        Signalled,      ///< ended by signal number `status`
        TimedOut,       ///< ended by us, at the deadline
        Stopped,        ///< ended by us, because the user asked
        TooMuchOutput,  ///< ended by us, having written more than allowed
    };
    End end = End::Exited;
    int status = 0;
    std::string out = {}, err = {};  ///< standard output and standard error, as far as it came

    bool operator==(const ProgramResult&) const = default;
};

/// How a program was ended from without; empty: it ended by itself.
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

/// Runs a program with `arguments`, the first one being the program itself, and waits for its end.
using RunProgram = std::function<ProgramResult(const std::vector<std::string>& arguments)>;

}  // namespace grafverif
