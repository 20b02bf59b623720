// SPDX-License-Identifier: MIT
// Team: threads that share one piece of work after another with the thread that owns them.
//
// They start with the first work that is shared, and have small stacks and no signals. Where the system gives fewer
// threads than asked for, those that there are do it all.
#pragma once

#include <pthread.h>

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <vector>

namespace grafverif {

class Team {
public:
    /// `members` (at least 1) with the owner, who is member 0; 0: as many as the machine has cores for us.
    explicit Team(unsigned members);
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    unsigned size() const { return members_; }
    /// Calls `work(member)` for every member, each in its thread, and returns when all are done. Throws what one threw,
    /// that of the first member who did.
    void share(const std::function<void(unsigned)>& work);

private:
    struct Start {
        Team* team = nullptr;
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
    std::uint64_t round_ = 0;  // of work; who has done it waits for the next
    unsigned busy_ = 0;
    bool over_ = false;
    std::mutex mutex_ = {};
    std::condition_variable begin_ = {}, end_ = {};
};

}  // namespace grafverif
