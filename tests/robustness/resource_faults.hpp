// SPDX-License-Identifier: MIT
// Simulates that the operating system refuses memory and threads to this process. As in the standard library, a refused
// allocation calls the new-handler before it fails, and is repeated if the handler returns.
#pragma once

#include <cstddef>
#include <cstdint>

namespace grafverif {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;  ///< nothing is refused, because sanitizers replace the same functions
#else
inline constexpr bool sanitized = false;
#endif

/// During the lifetime of the object, refuses one allocation of this thread, after `after` successful allocations.
class Refusal {
public:
    explicit Refusal(std::int64_t after);
    ~Refusal();
    Refusal(const Refusal&) = delete;
    Refusal& operator=(const Refusal&) = delete;
    /// Returns the number of allocations until one is refused.
    std::int64_t left() const;
};

/// Exempts the allocations of this thread from limits and counters during the lifetime of the object.
class Unlimited {
public:
    Unlimited();
    ~Unlimited();
    Unlimited(const Unlimited&) = delete;
    Unlimited& operator=(const Unlimited&) = delete;

private:
    bool before_;
};

/// Limits the heap of all threads to its current size plus `bytes`.
void limit_heap(std::size_t bytes);
/// Removes the limit of limit_heap and all refusals that are still pending in any thread.
void lift_limits();
/// Returns the maximum number of bytes in use since the previous call.
std::size_t peak_of_heap();
std::size_t heap_in_use();

/// During the lifetime of the object, allows this thread to start only `count` threads.
class FewThreads {
public:
    explicit FewThreads(int count);
    ~FewThreads();
    FewThreads(const FewThreads&) = delete;
    FewThreads& operator=(const FewThreads&) = delete;
};

}  // namespace grafverif
