// SPDX-License-Identifier: MIT
#include "app/system/child.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <mutex>
#include <set>
#include <string_view>

#include "app/system/interrupt.hpp"
#include "pipeline/descriptor.hpp"

extern char** environ;

namespace grafverif::app {

namespace fs = std::filesystem;

namespace {

/// The running child processes, in a form that a signal handler can read. If more child processes run than the array
/// has elements, the array contains only some of them.
std::array<std::atomic<pid_t>, 64> running = {};
static_assert(std::atomic<pid_t>::is_always_lock_free);

void register_child(pid_t pid) {
    for (std::atomic<pid_t>& slot : running) {
        pid_t none = 0;
        if (slot.compare_exchange_strong(none, pid)) return;
    }
}

void unregister_child(pid_t pid) {
    for (std::atomic<pid_t>& slot : running) {
        pid_t listed = pid;
        if (slot.compare_exchange_strong(listed, 0)) return;
    }
}

/// Returns the parent of the process `pid`, or 0 if it is unknown. The format of /proc/PID/stat is `PID (NAME) STATE
/// PARENT ...`, where NAME is arbitrary.
pid_t parent_of(std::string_view pid) {
    const Descriptor file(::open(("/proc/" + std::string(pid) + "/stat").c_str(), O_RDONLY | O_CLOEXEC));
    std::string line(1024, '\0');
    line.resize(static_cast<std::size_t>(std::max<ssize_t>(0, ::read(file.number(), line.data(), line.size()))));
    const std::size_t end = line.rfind(") ");
    if (end == std::string::npos || end + 4 >= line.size()) return 0;
    pid_t parent = 0;
    std::from_chars(line.data() + end + 4, line.data() + line.size(), parent);
    return parent;
}

std::set<pid_t> our_children() {
    std::set<pid_t> found;
    siginfo_t info = {};
    if (::waitid(P_ALL, 0, &info, WEXITED | WNOHANG | WNOWAIT) != 0 && errno == ECHILD) return found;
    std::error_code failure;
    for (auto entry = fs::directory_iterator("/proc", failure); !failure && entry != fs::directory_iterator();
         entry.increment(failure)) {
        const std::string name = entry->path().filename().string();
        pid_t pid = 0;
        const auto [end, problem] = std::from_chars(name.data(), name.data() + name.size(), pid);
        if (problem == std::errc() && end == name.data() + name.size() && parent_of(name) == ::getpid())
            found.insert(pid);
    }
    return found;
}

void reap(pid_t pid) {
    while (::waitpid(pid, nullptr, 0) < 0 && errno == EINTR) {
    }
}

/// State that all running children share. While a child runs, this process is a subreaper: it adopts the descendants of
/// its children when their parents end.
class ChildRegistry {
public:
    void begin() {
        const std::lock_guard hold(mutex_);
        if (members_++ != 0) return;
        ::prctl(PR_GET_CHILD_SUBREAPER, &adopted_before_);
        ::prctl(PR_SET_CHILD_SUBREAPER, 1);
        known_children_ = our_children();
    }

    void end() {
        const std::lock_guard hold(mutex_);
        if (--members_ != 0) return;
        end_adopted();
        ::prctl(PR_SET_CHILD_SUBREAPER, static_cast<unsigned long>(adopted_before_));
    }

private:
    /// Ends adopted processes. When an adopted process ends, this process adopts its children, and the next iteration
    /// ends these children. Ignores processes that this process has no permission to end.
    void end_adopted() {
        constexpr int most_rounds = 1000;
        for (int round = 0; round < most_rounds; ++round) {
            bool found = false;
            for (const pid_t pid : our_children()) {
                if (known_children_.contains(pid)) continue;
                found = true;
                if (::getpgid(pid) == pid) ::kill(-pid, SIGKILL);
                if (::kill(pid, SIGKILL) == 0) reap(pid);
                else known_children_.insert(pid);
            }
            if (!found) return;
        }
    }

    std::mutex mutex_ = {};
    std::size_t members_ = 0;
    int adopted_before_ = 0;
    std::set<pid_t> known_children_ = {};
};

ChildRegistry& child_registry() {
    static ChildRegistry instance;
    return instance;
}

pid_t spawn(const std::vector<std::string>& arguments, const ChildStreams& streams, const fs::path& folder) {
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
    posix_spawn_file_actions_adddup2(&actions, streams.input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, streams.output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, streams.error, STDERR_FILENO);
    if (!folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    sigset_t none, handled;
    sigemptyset(&none);
    sigemptyset(&handled);
    for (const int signal : {SIGPIPE, SIGINT, SIGTERM, SIGHUP}) sigaddset(&handled, signal);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &handled);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    posix_spawnattr_setpgroup(&attributes, 0);
    std::vector<std::string> copies = arguments;
    std::vector<char*> pointers;
    for (std::string& argument : copies) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    pid_t child = 0;
    const int failure = posix_spawn(&child, pointers[0], &actions, &attributes, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (failure != 0) fail(failure, "cannot run `" + arguments.front() + "`");
    return child;
}

}  // namespace

Child::Child(const std::vector<std::string>& arguments, const ChildStreams& streams, const fs::path& folder) {
    child_registry().begin();
    try {
        pid_ = spawn(arguments, streams, folder);
    } catch (...) {
        child_registry().end();
        throw;
    }
    register_child(pid_);
}

std::optional<ChildEnd> Child::ended() {
    siginfo_t info = {};
    if (!over_ && !ended_ && ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
        info.si_pid == pid_)
        ended_ = ChildEnd{info.si_code != CLD_EXITED, info.si_status};
    return ended_;
}

void Child::send(int signal) const {
    if (!over_) ::kill(-pid_, signal);
}

/// Kills the child and reaps it. The system does not reuse the process id before the child is reaped, and no signal is
/// sent to this id afterwards.
void Child::end() {
    if (over_) return;
    const SignalBlocker whole;  // an interruption in this section would leave processes running
    ::kill(-pid_, SIGKILL);
    unregister_child(pid_);
    reap(pid_);
    over_ = true;
    child_registry().end();
}

bool children_run() noexcept {
    return std::ranges::any_of(running, [](const std::atomic<pid_t>& slot) { return slot.load() != 0; });
}

void kill_children_at_once() noexcept {
    for (const std::atomic<pid_t>& slot : running)
        if (const pid_t pid = slot.load(); pid != 0) ::kill(-pid, SIGKILL);
}

}  // namespace grafverif::app
