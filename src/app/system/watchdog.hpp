// SPDX-License-Identifier: MIT
// Watchdog: enforces `--timeout`, `--max-memory` and Ctrl-C for every command and every input.
//
// Engines poll these limits and end in time with their results so far. Other stages do not, because they are fast on
// hand-written charts or because they wait for input. The watchdog ends such a stage: after a grace period it reports
// the reason and ends the process with exit code 3. So the limits hold within a tenth plus half a second.
//
// Memory: the process requests at most the permitted amount from the system (RLIMIT_DATA). A larger allocation fails,
// wherever it occurs, and is reported like any other error. Without --max-memory the limit is the memory of the
// machine: an error is better than being killed. If the system does not count (and under sanitizers, which allocate
// memory themselves), the watchdog checks the resident memory.
#pragma once

#include <pthread.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "app/system/interrupt.hpp"

namespace grafverif::app {

/// The limits of a run, and the messages written to standard error when the watchdog ends it: complete lines.
struct WatchdogOptions {
    std::optional<std::chrono::milliseconds> timeout = {};
    std::optional<std::uint64_t> max_memory = {};  ///< bytes
    std::string timed_out = {}, interrupted = {}, out_of_memory = {};
};

class Watchdog {
public:
    /// Requires that this process may be ended. Throws std::system_error if the thread cannot be started.
    explicit Watchdog(WatchdogOptions orders);
    ~Watchdog();
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;

private:
    static void* watch(void* guard);
    void watch();
    /// The message for a limit that is exceeded now; null: none.
    const std::string* reason();
    void end(const std::string& why);

    using Steady = std::chrono::steady_clock;
    WatchdogOptions orders_;
    Interrupt interrupt_ = {};
    std::chrono::milliseconds margin_ = {};
    std::optional<Steady::time_point> last_moment_ = {}, interrupted_ = {}, ending_ = {};
    pthread_t thread_ = {};
    std::mutex mutex_ = {};
    std::condition_variable over_ = {};
    bool done_ = false;
};

/// From now on results are printed: after the time limit this may use a tenth plus half a second of processor time.
void work_is_done();

/// Prepares the process for exhausted memory; call once, before anything else. Reserves memory for the message, and for
/// the stack, so that its growth does not raise a signal.
void expect_memory_to_end();

/// Reserves the memory again after a handled failure of an allocation. False if the system refuses it.
bool keep_memory_back();

/// While one exists, started programs inherit the original memory limit, not the reduced one of this process.
class MemoryUnbounded {
public:
    MemoryUnbounded();
    ~MemoryUnbounded();
    MemoryUnbounded(const MemoryUnbounded&) = delete;
    MemoryUnbounded& operator=(const MemoryUnbounded&) = delete;

private:
    std::optional<std::uint64_t> before_ = {};
};

}  // namespace grafverif::app
