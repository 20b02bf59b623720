// SPDX-License-Identifier: MIT
// Watchdog: enforces `--timeout`, `--max-memory` and Ctrl-C for every command and every input.
//
// Engines poll the limits and end in time with the results found so far. Other stages do not poll
// the limits, because they are fast for hand-written charts or because they wait for input. The
// watchdog ends a stage that does not poll the limits: after a grace period it reports the reason
// and ends the process with exit code 3. Therefore the time limit is exceeded by at most a tenth of
// the limit plus half a second, unless files are being written or an external program must be
// ended.
//
// Memory: the process requests at most the permitted amount from the system (RLIMIT_DATA). A larger allocation fails,
// wherever it occurs, and is reported like any other error. Without --max-memory, the limit is nine tenths of the
// memory of the computer or container: an error message is better than termination by the system.
// If the system does not enforce the memory limit, and under sanitizers, which allocate memory
// themselves, the watchdog checks the resident memory.
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

/// The limits of a run and the messages of the watchdog. Each message is a complete line; one of them is written to
/// standard error when the watchdog ends the run.
struct WatchdogOptions {
    std::optional<std::chrono::milliseconds> timeout = {};
    std::optional<std::uint64_t> max_memory = {};  ///< memory limit in bytes
    std::string timed_out = {}, interrupted = {}, out_of_memory = {};
};

class Watchdog {
public:
    /// Starts the watchdog. Requires that this process may be ended. Throws std::system_error if the thread cannot be
    /// started.
    explicit Watchdog(WatchdogOptions orders);
    ~Watchdog();
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;

private:
    static void* watch(void* guard);
    void watch();
    /// Returns the message for a limit that is currently exceeded, or null if no limit is exceeded.
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

/// Notifies the watchdog that the program begins to print results. After the time limit, printing may use a tenth of
/// the limit plus half a second of processor time.
void work_is_done();

/// Prepares the process for exhausted memory. Call this function once, before any other function. The function reserves
/// memory for the message and for the stack, so that growth of the stack does not raise a signal.
void expect_memory_to_end();

/// Reserves the memory again after a failed allocation was handled. Returns false if the system refuses the allocation.
bool keep_memory_back();

/// While an object exists, started programs inherit the original memory limit, not the reduced limit of this process.
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
