// SPDX-License-Identifier: MIT
#include "robustness/resource_faults.hpp"

#include <dlfcn.h>
#include <malloc.h>
#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <limits>
#include <new>
#include <utility>

namespace {

/// Number of allocations of this thread that succeed before one is refused; negative: none is refused.
thread_local std::int64_t allocations_left = -1;
thread_local int threads_left = -1;  ///< number of threads that this thread may start; negative: unlimited
thread_local bool unlimited = false;
std::atomic<bool> lifted = false;

std::atomic<std::size_t> in_use = 0, peak = 0, limit = std::numeric_limits<std::size_t>::max();

}  // namespace

namespace grafverif {

Refusal::Refusal(std::int64_t after) {
    lifted = false;
    allocations_left = after;
}
Refusal::~Refusal() { allocations_left = -1; }
std::int64_t Refusal::left() const { return allocations_left; }

Unlimited::Unlimited() : before_(std::exchange(unlimited, true)) {}
Unlimited::~Unlimited() { unlimited = before_; }

void limit_heap(std::size_t bytes) {
    lifted = false;
    limit = in_use + bytes;
}
void lift_limits() { lifted = true; }
std::size_t peak_of_heap() { return peak.exchange(in_use); }
std::size_t heap_in_use() { return in_use; }

FewThreads::FewThreads(int count) { threads_left = count; }
FewThreads::~FewThreads() { threads_left = -1; }

}  // namespace grafverif

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
namespace {

void* allocated(std::size_t size) {
    const bool limited = !unlimited && !lifted;
    if (limited && allocations_left >= 0 && allocations_left-- == 0) return nullptr;
    if (limited && in_use + size > limit) return nullptr;
    void* const memory = std::malloc(std::max<std::size_t>(size, 1));
    if (memory == nullptr) return nullptr;
    const std::size_t now = in_use += ::malloc_usable_size(memory);
    for (std::size_t most = peak; now > most && !peak.compare_exchange_weak(most, now);) {
    }
    return memory;
}

void released(void* memory) {
    if (memory != nullptr) in_use -= ::malloc_usable_size(memory);
    std::free(memory);
}

}  // namespace

// This function is not inlined, because GCC would warn about `free` of a pointer from `operator new`.
[[gnu::noinline]] void* operator new(std::size_t size) {
    for (;;) {
        if (void* const memory = allocated(size)) return memory;
        const std::new_handler handler = std::get_new_handler();
        if (handler == nullptr) throw std::bad_alloc();
        handler();
    }
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { released(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { released(memory); }

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*work)(void*),
                              void* argument) noexcept {
    using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
    static const auto create = reinterpret_cast<Create>(::dlsym(RTLD_NEXT, "pthread_create"));
    if (threads_left == 0) return EAGAIN;
    if (threads_left > 0) --threads_left;
    return create(thread, attributes, work, argument);
}
#endif
