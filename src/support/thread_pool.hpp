// SPDX-License-Identifier: MIT
// Thread pool: executes one parallel task at a time. The thread that owns the pool also performs part of the task.
//
// The threads start with the first task. The threads have small stacks and block all signals. If the system provides
// fewer threads than requested, the available threads perform all of the work.
#pragma once

#include <pthread.h>

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <vector>

namespace grafverif {

class ThreadPool {
public:
    /// `members` is the number of threads including the owner, which is member 0; 0 selects one thread per core.
    explicit ThreadPool(unsigned members);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    unsigned size() const { return members_; }
    /// Calls `work(member)` for every member in the thread of this member, and returns when all calls have ended.
    /// If several calls throw, rethrows the exception of the member with the lowest number.
    void share(const std::function<void(unsigned)>& work);

private:
    struct Start {
        ThreadPool* team = nullptr;
        unsigned member = 0;
    };
    static void* run(void* start);
    void serve(unsigned member);
    void work_as(unsigned member);
    void start();

    unsigned members_;
    std::vector<Start> starts_ = {};
    std::vector<pthread_t> threads_ = {};
    std::vector<std::exception_ptr> failures_ = {};
    const std::function<void(unsigned)>* work_ = nullptr;
    std::uint64_t round_ = 0;  // number of the current task; a member that has completed a task waits for the next one
    unsigned busy_ = 0;
    bool over_ = false;
    std::mutex mutex_ = {};
    std::condition_variable begin_ = {}, end_ = {};
};

}  // namespace grafverif
