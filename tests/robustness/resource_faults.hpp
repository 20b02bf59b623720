// SPDX-License-Identifier: MIT
// Refusals of memory and threads inside this process. Like the system, it asks the new-handler before an allocation
// fails, and repeats it if that returns.
#pragma once

#include <cstddef>
#include <cstdint>

namespace grafverif {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;  ///< sanitizers replace the same functions: nothing is refused
#else
inline constexpr bool sanitized = false;
#endif

/// Refuses one allocation of this thread while it exists, after so many.
class Refusal {
public:
    explicit Refusal(std::int64_t after);
    ~Refusal();
    Refusal(const Refusal&) = delete;
    Refusal& operator=(const Refusal&) = delete;
    /// How many are left until it is refused.
    std::int64_t left() const;
};

/// Allocations of this thread are neither limited nor counted down while it exists.
class Unlimited {
public:
    Unlimited();
    ~Unlimited();
    Unlimited(const Unlimited&) = delete;
    Unlimited& operator=(const Unlimited&) = delete;

private:
    bool before_;
};

/// Bytes that all threads may have beyond those that they have now.
void limit_heap(std::size_t bytes);
/// Ends this limit, and the refusals that are still to come in any thread.
void lift_limits();
/// The most bytes in use since the last call.
std::size_t peak_of_heap();
std::size_t heap_in_use();

/// Threads that this thread starts beyond so many are refused while it exists.
class FewThreads {
public:
    explicit FewThreads(int count);
    ~FewThreads();
    FewThreads(const FewThreads&) = delete;
    FewThreads& operator=(const FewThreads&) = delete;
};

}  // namespace grafverif
