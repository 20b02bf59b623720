// SPDX-License-Identifier: MIT
#include "mcp/call_runner.hpp"

#include <utility>

namespace grafverif::mcp {

CallRunner::CallRunner(std::size_t most_running, std::size_t most_waiting)
    : most_running_(most_running), most_waiting_(most_waiting) {
    running_.reserve(most_running);  // reserved, so that no worker thread allocates memory for this list
}

CallRunner::~CallRunner() {
    {
        const std::lock_guard hold(mutex_);
        over_ = true;
        waiting_.clear();
        for (const std::shared_ptr<Work>& work : running_) work->stop = true;
    }
    wake_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

bool CallRunner::submit(std::shared_ptr<Work> work) {
    const std::lock_guard hold(mutex_);
    std::erase_if(waiting_, [](const std::shared_ptr<Work>& each) { return each->stop.load(); });
    if (waiting_.size() >= most_waiting_) return false;
    if (running_.size() + waiting_.size() >= threads_.size() && threads_.size() < most_running_)
        threads_.emplace_back([this] { execute(); });
    waiting_.push_back(std::move(work));
    wake_.notify_one();
    return true;
}

void CallRunner::execute() {
    for (;;) {
        std::shared_ptr<Work> work;
        {
            std::unique_lock hold(mutex_);
            wake_.wait(hold, [this] { return over_ || !waiting_.empty(); });
            if (over_) return;
            work = std::move(waiting_.front());
            waiting_.pop_front();
            running_.push_back(work);
        }
        if (!work->stop) work->run(work->stop);
        const std::lock_guard hold(mutex_);
        std::erase(running_, work);
    }
}

}  // namespace grafverif::mcp
