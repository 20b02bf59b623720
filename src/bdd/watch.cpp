// SPDX-License-Identifier: MIT
#include "bdd/watch.hpp"

#include <chrono>

namespace grafverif::bdd {

void Watch::look() {
    done_ = work();
    left_ = steps_per_look;
    if (done_ >= limits_.work || (limits_.stop != nullptr && limits_.stop->load(std::memory_order_relaxed)) ||
        (limits_.deadline && std::chrono::steady_clock::now() >= *limits_.deadline))
        throw BddExhausted(BddExhausted::Cause::Stopped);
}

}  // namespace grafverif::bdd
