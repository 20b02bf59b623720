// SPDX-License-Identifier: MIT
// CallRunner: executes calls in worker threads. The calls start in the order of submission.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace grafverif::mcp {

struct Work {
    std::atomic<bool> stop = false;  ///< cancellation flag; a call that is cancelled before its start is not executed
    std::function<void(const std::atomic<bool>& stop)> run = {};
};

class CallRunner {
public:
    CallRunner(std::size_t most_running, std::size_t most_waiting);
    /// Cancels all calls and joins the threads.
    ~CallRunner();
    CallRunner(const CallRunner&) = delete;
    CallRunner& operator=(const CallRunner&) = delete;

    /// Adds a call. Returns false if too many calls are waiting. Throws std::system_error if no thread can be started.
    bool submit(std::shared_ptr<Work> work);

private:
    void execute();

    std::size_t most_running_, most_waiting_;
    std::mutex mutex_ = {};
    std::condition_variable wake_ = {};
    std::deque<std::shared_ptr<Work>> waiting_ = {};
    std::vector<std::shared_ptr<Work>> running_ = {};
    bool over_ = false;
    std::vector<std::thread> threads_ = {};
};

}  // namespace grafverif::mcp
