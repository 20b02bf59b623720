// SPDX-License-Identifier: MIT
#include "pipeline/variants/in_parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace grafverif {

unsigned thread_count(unsigned jobs) { return jobs == 0 ? std::max(1U, std::thread::hardware_concurrency()) : jobs; }

void in_parallel(std::size_t count, unsigned jobs, const std::function<bool()>& stopped,
                 const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::exception_ptr failure;
    const auto run_calls = [&] {
        try {
            for (std::size_t k = next++; k < count && !stopped(); k = next++) work(k);
        } catch (...) {
            const std::lock_guard lock(mutex);
            failure = std::current_exception();
            next = count;
        }
    };
    {
        std::vector<std::jthread> threads;
        try {
            for (std::size_t k = 0; k < std::min<std::size_t>(thread_count(jobs), count); ++k)
                threads.emplace_back(run_calls);
        } catch (const std::system_error&) {
            if (threads.empty()) run_calls();
        }
    }
    if (failure) std::rethrow_exception(failure);
}

}  // namespace grafverif
