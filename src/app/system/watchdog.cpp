// SPDX-License-Identifier: MIT
// The thread of the watchdog allocates no memory, because memory may be exhausted. The thread acquires only the lock of
// the watchdog, because the run may hold any other lock.
#include "app/system/watchdog.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <limits>
#include <new>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/program.hpp"
#include "app/system/child.hpp"
#include "support/memory_reserve.hpp"

namespace grafverif::app {

namespace {

using namespace std::chrono_literals;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

/// Memory that is permitted in addition to the limit: code, libraries and buffers of the program.
constexpr std::uint64_t own_memory = std::uint64_t{32} << 20U;
/// Size of the reserve for reporting that memory is exhausted.
constexpr std::size_t reserve_size = std::size_t{2} << 20U;
constexpr std::size_t landing_size = std::size_t{1} << 20U;  ///< size of the reserve for allocations that must not fail
constexpr auto program_timeout = 3s, reader_timeout = 3s;
constexpr auto grace = 400ms, longest_grace = 60'000ms, poll_interval = 25ms;

std::atomic<std::int64_t> reporting_start = 0;  ///< steady-clock time at which printing of results began; 0: not yet
std::atomic<std::int64_t> reporting_cpu = 0;    ///< processor time in nanoseconds that was used before printing began
std::atomic<void*> reserve = nullptr, landing = nullptr;
thread_local bool is_reserving = false;

void write_completely(std::string_view text) {
    while (!text.empty()) {
        const ssize_t count = ::write(STDERR_FILENO, text.data(), text.size());
        if (count <= 0) return;
        text.remove_prefix(static_cast<std::size_t>(count));
    }
}

std::uint64_t with_margin(std::uint64_t allowed) {
    constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max();
    return allowed > most / 2 ? most : allowed + allowed / 10 + own_memory;
}

std::uint64_t number_in(const char* file) {
    std::array<char, 64> text = {};
    const int descriptor = ::open(file, O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return 0;
    const ssize_t count = ::read(descriptor, text.data(), text.size());
    ::close(descriptor);
    std::uint64_t number = 0;
    if (count > 0) std::from_chars(text.data(), text.data() + count, number);
    return number;
}

/// Returns the total memory of the computer, or the limit of the container if this limit is lower; 0 if both are
/// unknown.
std::uint64_t memory_of_machine() {
    const long pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGESIZE);
    const std::uint64_t machine =
        pages > 0 && page > 0 ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page) : 0;
    const std::uint64_t container = number_in("/sys/fs/cgroup/memory.max");
    return container != 0 && (machine == 0 || container < machine) ? container : machine;
}

/// Returns the size of the resident memory of this process in bytes, without file mappings; 0 if unknown.
std::uint64_t resident() {
    std::array<char, 128> text = {};
    const int descriptor = ::open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return 0;
    const ssize_t count = ::read(descriptor, text.data(), text.size() - 1);
    ::close(descriptor);
    std::array<std::uint64_t, 3> pages = {};  // three numbers of pages: size, resident, shared
    const char* at = text.data();
    const char* const end = text.data() + std::max<ssize_t>(count, 0);
    for (std::uint64_t& each : pages) {
        while (at != end && *at == ' ') ++at;
        at = std::from_chars(at, end, each).ptr;
    }
    return (pages[1] - std::min(pages[1], pages[2])) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void allow_memory(std::uint64_t bytes) {
    rlimit limit = {};
    if (sanitized || bytes == 0 || ::getrlimit(RLIMIT_DATA, &limit) != 0) return;
    limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_max);
    ::setrlimit(RLIMIT_DATA, &limit);
}

/// Returns the processor time of all threads in nanoseconds.
std::int64_t processor_time() {
    timespec now = {};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

/// Releases the reserved memory. Returns false if the memory was already released.
bool release_reserve(std::atomic<void*>& kept) {
    void* const memory = kept.exchange(nullptr);
    ::operator delete(memory);
    return memory != nullptr;
}

void no_memory() {
    if (is_reserving) throw std::bad_alloc();
    if (must_not_fail() && (release_reserve(landing) || release_reserve(reserve)))
        return;  // operator new then repeats the allocation
    release_reserve(reserve);
    throw std::bad_alloc();
}

/// Reserves memory, but does not access it. The limits count the memory that a process requests.
/// Accessing 3 MiB would take half as much processor time as the start of the program. Returns
/// false if the system refuses the memory.
bool keep(std::atomic<void*>& kept, std::size_t size) {
    if (kept != nullptr) return true;
    is_reserving = true;
    void* memory = ::operator new(size, std::nothrow);
    is_reserving = false;
    if (memory == nullptr) return false;
    memory = kept.exchange(memory);  // another thread may have stored its memory in `kept`
    ::operator delete(memory);
    return true;
}

[[noreturn]] void give_up() {
    ExitCode code = ExitCode::Failure;
    std::string_view why = "grafverif: internal error: exception in a context that cannot report it\n";
    try {
        if (const std::exception_ptr failure = std::current_exception()) std::rethrow_exception(failure);
    } catch (const std::bad_alloc&) {
        code = ExitCode::Unknown;
        why = "error: out of memory: the system refused an allocation [out-of-memory]\n";
    } catch (...) {
    }
    write_completely(why);
    ::_exit(static_cast<int>(code));
}

/// Accesses `pages` stack pages below the caller, page by page: a single large object would skip the guard page of a
/// small stack.
[[gnu::noinline]] void touch_stack(std::size_t pages) {  // NOLINT(misc-no-recursion)
    std::array<volatile char, 4096> page;
    page[0] = 0;
    if (pages > 0) touch_stack(pages - 1);
    page[1] = page[0];  // after the call, to prevent a tail call, which would use the same frame
}

/// Allocates stack memory now if the address space is limited; otherwise, a signal would end the
/// program if the stack cannot grow later.
void grow_stack() {
    rlimit addresses = {}, stack = {};
    if (::getrlimit(RLIMIT_AS, &addresses) != 0 || addresses.rlim_cur == RLIM_INFINITY) return;
    if (::getrlimit(RLIMIT_STACK, &stack) != 0) return;
    constexpr rlim_t most = rlim_t{2} << 20U;
    // The stack also contains arguments and environment, which use at most a quarter of it.
    touch_stack(std::min(most, stack.rlim_cur / 2) / 4096);
}

}  // namespace

void work_is_done() {
    reporting_cpu = processor_time();
    reporting_start = std::max<std::int64_t>(1, std::chrono::steady_clock::now().time_since_epoch().count());
}

void expect_memory_to_end() {
    grow_stack();
    keep_memory_back();
    std::set_new_handler(no_memory);
    std::set_terminate(give_up);
}

bool keep_memory_back() {
    const bool kept = keep(reserve, reserve_size);
    return keep(landing, landing_size) && kept;
}

MemoryUnbounded::MemoryUnbounded() {
    rlimit limit = {};
    if (sanitized || ::getrlimit(RLIMIT_DATA, &limit) != 0) return;
    before_ = std::exchange(limit.rlim_cur, limit.rlim_max);
    ::setrlimit(RLIMIT_DATA, &limit);
}

MemoryUnbounded::~MemoryUnbounded() {
    if (before_) allow_memory(*before_);
}

Watchdog::Watchdog(WatchdogOptions orders) : orders_(std::move(orders)) {
    reporting_start = 0;
    if (orders_.timeout) {
        margin_ = grace + std::min<std::chrono::milliseconds>(*orders_.timeout / 10, longest_grace);
        last_moment_ = Steady::now() + *orders_.timeout + margin_;
    }
    if (orders_.max_memory) allow_memory(with_margin(*orders_.max_memory));
    else allow_memory(memory_of_machine() / 10 * 9);

    sigset_t all, before;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before);  // signals are handled only by the threads of the run
    pthread_attr_t attributes;
    ::pthread_attr_init(&attributes);
    ::pthread_attr_setstacksize(&attributes, std::size_t{256} << 10U);
    const int failure = ::pthread_create(&thread_, &attributes, watch, this);
    ::pthread_attr_destroy(&attributes);
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
    if (failure != 0) throw std::system_error(failure, std::generic_category(), "cannot start the watchdog thread");
}

Watchdog::~Watchdog() {
    {
        const std::lock_guard lock(mutex_);  // if the watchdog is ending the run, waits until the run has ended
        done_ = true;
    }
    over_.notify_one();
    ::pthread_join(thread_, nullptr);
}

void* Watchdog::watch(void* guard) {
    static_cast<Watchdog*>(guard)->watch();
    return nullptr;
}

void Watchdog::watch() {
    std::unique_lock lock(mutex_);
    while (!over_.wait_for(lock, poll_interval, [this] { return done_; }))
        if (const std::string* const why = reason()) end(*why);
}

const std::string* Watchdog::reason() {
    const Steady::time_point now = Steady::now();
    if (!interrupted_ && interrupt_.requested()) interrupted_ = now;
    // Results may be printed after the time limit. The additional time for printing is measured in processor time, so
    // that neither a slow reader nor a loaded computer truncates the results. After Ctrl-C, the run ends at the latest
    // after reader_timeout, even if the reader of the output reads nothing.
    const std::chrono::nanoseconds used(reporting_start == 0 ? 0 : processor_time() - reporting_cpu);
    const Steady::time_point start(Steady::duration(reporting_start.load()));
    const auto waited = interrupted_ ? now - std::max(*interrupted_, start) : Steady::duration(0);
    if (interrupted_ && waited >= grace && (reporting_start == 0 || used >= grace || waited >= reader_timeout))
        return &orders_.interrupted;
    const bool printed = reporting_start == 0 || used >= margin_;
    if (last_moment_ && now >= *last_moment_ && printed) return &orders_.timed_out;
    constexpr std::uint64_t times = sanitized ? 4 : 1;
    if (orders_.max_memory && resident() > times * with_margin(*orders_.max_memory)) return &orders_.out_of_memory;
    return nullptr;
}

/// Files that are being written are completed first. The watchdog waits for started programs to end: the thread that
/// runs a program observes the same limits and ends the program and its descendants.
void Watchdog::end(const std::string& why) {
    if (!ending_) ending_ = Steady::now();
    if (children_run() && Steady::now() - *ending_ < program_timeout) return;
    if (!SignalBlocker::none_from_now_on()) return;
    kill_children_at_once();
    write_completely(why);
    ::_exit(static_cast<int>(ExitCode::Unknown));
}

}  // namespace grafverif::app
