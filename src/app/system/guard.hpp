// SPDX-License-Identifier: MIT
// Guard: `--timeout`, `--max-memory` and Ctrl-C are kept by every verb, whatever its input.
//
// Engines look at these bounds themselves and end in time with what is known. A stage that does not, because it is
// quick on charts that people write or because it waits for somebody, is ended by the guard: after a grace it tells why
// and ends the process with exit code 3. So the bounds are kept within a tenth and half a second.
//
// Memory: the process asks the system for no more than is allowed (RLIMIT_DATA), so that the allocation that would be
// too large fails, wherever it happens, and what fails can be told like any other error. Without --max-memory the bound
// is what the machine has: better to fail than to be killed. Where the system does not count (and under sanitizers,
// which take memory of their own) the guard looks at what is resident.
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

/// What a run was promised, and what is written to standard error when the guard ends it: whole lines.
struct GuardOrders {
    std::optional<std::chrono::milliseconds> timeout = {};
    std::optional<std::uint64_t> max_memory = {};  ///< bytes
    std::string timed_out = {}, interrupted = {}, out_of_memory = {};
};

class Guard {
public:
    /// Only where the process is ours to end. Throws std::system_error if its thread cannot be started.
    explicit Guard(GuardOrders orders);
    ~Guard();
    Guard(const Guard&) = delete;
    Guard& operator=(const Guard&) = delete;

private:
    static void* watch(void* guard);
    void watch();
    /// What ends the run by now; null: nothing.
    const std::string* reason();
    void end(const std::string& why);

    using Steady = std::chrono::steady_clock;
    GuardOrders orders_;
    Interrupt interrupt_ = {};
    std::chrono::milliseconds margin_ = {};
    std::optional<Steady::time_point> last_moment_ = {}, interrupted_ = {}, ending_ = {};
    pthread_t thread_ = {};
    std::mutex mutex_ = {};
    std::condition_variable over_ = {};
    bool done_ = false;
};

/// From here on, what a run found is printed: after the time limit that may take a tenth and half a second of processor
/// time.
void work_is_done();

/// Prepares the process, once and first of all, for a system that has no memory left: something is kept back to tell it
/// with, and no place that cannot fail ends in a signal.
void expect_memory_to_end();

/// While one exists, programs that are started have the memory that we had, not what is allowed to us.
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
