// SPDX-License-Identifier: MIT
// Child: a program that we have started, with all that it starts: what leaves its process group, or its session, is
// adopted by us when its parent ends (PR_SET_CHILD_SUBREAPER) and ends with it. While several run at once, what they
// left behind ends with the last of them. Children that we had before the first are not ours to end.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace grafverif::app {

struct ChildStreams {
    int input = 0, output = 1, error = 2;  ///< descriptors that become its standard streams
};

/// How a program ended.
struct ChildEnd {
    bool by_signal = false;
    int status = 0;  ///< the signal, or the exit code
};

class Child {
public:
    /// Starts the program at the path `arguments[0]` in `folder` (empty: in ours), in a process group named by its id,
    /// with no signal blocked or ignored that we block or ignore. Throws std::system_error.
    Child(const std::vector<std::string>& arguments, const ChildStreams& streams,
          const std::filesystem::path& folder = {});
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    /// Ends what is still running, at once.
    ~Child() { end(); }

    /// How it ended, once it has; does not wait.
    std::optional<ChildEnd> ended();
    /// To it and its process group.
    void send(int signal) const;
    /// Ends what is still running, at once.
    void end();

private:
    pid_t pid_ = 0;
    bool over_ = false;
    std::optional<ChildEnd> ended_ = {};
};

/// Whether a program runs that nobody has begun to end. Waits for nothing.
bool children_run() noexcept;

/// Ends the process groups of all programs that run now. For a signal handler that ends us: waits for nothing.
void kill_children_at_once() noexcept;

}  // namespace grafverif::app
