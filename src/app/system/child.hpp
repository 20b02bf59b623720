// SPDX-License-Identifier: MIT
// Child: a started program with all its descendants. A descendant that leaves its process group or session is adopted
// when its parent ends (PR_SET_CHILD_SUBREAPER), and is ended together with the child. While several children run,
// adopted descendants are ended together with the last of these children. Child processes that existed before the first
// Child object are not ended.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace grafverif::app {

struct ChildStreams {
    int input = 0, output = 1, error = 2;  ///< descriptors that become the standard streams of the program
};

/// The way in which a program ended.
struct ChildEnd {
    bool by_signal = false;
    int status = 0;  ///< the signal, or the exit code
};

class Child {
public:
    /// Starts the program at the path `arguments[0]` in `folder` (empty: the current folder). The program runs in a
    /// process group whose number is the process id of the program, without the signal mask and the ignored signals of
    /// this process. Throws std::system_error if the program cannot be started.
    Child(const std::vector<std::string>& arguments, const ChildStreams& streams,
          const std::filesystem::path& folder = {});
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    /// Kills all processes of the child that still run.
    ~Child() { end(); }

    /// Returns how the program ended, if it has ended. Does not wait.
    std::optional<ChildEnd> ended();
    /// Sends a signal to the program and its process group.
    void send(int signal) const;
    /// Kills all processes of the child that still run.
    void end();

private:
    pid_t pid_ = 0;
    bool over_ = false;
    std::optional<ChildEnd> ended_ = {};
};

/// True if at least one started program is running and is not being ended. Does not wait.
bool children_run() noexcept;

/// Kills the process groups of all running programs. Signal handlers that end this process call this function. The
/// function does not wait for the end of the programs.
void kill_children_at_once() noexcept;

}  // namespace grafverif::app
