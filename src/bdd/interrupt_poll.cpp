// SPDX-License-Identifier: MIT
#include "bdd/interrupt_poll.hpp"

#include <chrono>
#include <utility>

namespace grafverif::bdd {

void InterruptPoll::look() {
    const std::uint64_t before = std::exchange(done_, work());
    left_ = steps_per_poll;
    if (limits_.worked != nullptr) limits_.worked->fetch_add(done_ - before, std::memory_order_relaxed);
    if (done_ >= limits_.work || (limits_.stop != nullptr && limits_.stop->load(std::memory_order_relaxed)) ||
        (limits_.deadline && std::chrono::steady_clock::now() >= *limits_.deadline))
        throw BddExhausted(BddExhausted::Cause::Stopped);
}

}  // namespace grafverif::bdd
