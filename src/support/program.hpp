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

/// Runs a program with `arguments`, the first one being the program itself, and waits for its end.
using RunProgram = std::function<ProgramResult(const std::vector<std::string>& arguments)>;

}  // namespace grafverif
