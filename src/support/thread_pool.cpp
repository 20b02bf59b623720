// SPDX-License-Identifier: MIT
#include "support/thread_pool.hpp"

#include <csignal>
#include <thread>
#include <utility>

namespace grafverif {

namespace {

constexpr std::size_t stack_bytes = std::size_t{512} << 10U;

}  // namespace

ThreadPool::ThreadPool(unsigned members)
    : members_(members != 0 ? members : std::max(1U, std::thread::hardware_concurrency())) {}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard lock(mutex_);
        over_ = true;
    }
    begin_.notify_all();
    for (const pthread_t thread : threads_) ::pthread_join(thread, nullptr);
}

void* ThreadPool::run(void* start) {
    const Start& is = *static_cast<const Start*>(start);
    is.team->serve(is.member);
    return nullptr;
}

/// Starts the threads. If the system refuses to start a thread, the pool consists of the threads that were started.
void ThreadPool::start() {
    starts_.reserve(members_);
    threads_.reserve(members_);
    sigset_t all, before;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before);
    pthread_attr_t attributes;
    ::pthread_attr_init(&attributes);
    ::pthread_attr_setstacksize(&attributes, stack_bytes);
    for (unsigned member = 1; member < members_; ++member) {
        pthread_t thread = {};
        starts_.push_back({this, member});
        if (::pthread_create(&thread, &attributes, run, &starts_.back()) != 0) break;
        threads_.push_back(thread);
    }
    ::pthread_attr_destroy(&attributes);
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
    members_ = static_cast<unsigned>(threads_.size()) + 1;
    failures_.resize(members_);
}

void ThreadPool::work_as(unsigned member) {
    try {
        (*work_)(member);
    } catch (...) {
        failures_[member] = std::current_exception();
    }
}

void ThreadPool::serve(unsigned member) {
    std::unique_lock lock(mutex_);
    for (std::uint64_t done = 0;;) {
        begin_.wait(lock, [&] { return over_ || round_ != done; });
        if (over_) return;
        done = round_;
        lock.unlock();
        work_as(member);
        lock.lock();
        if (--busy_ == 0) end_.notify_one();
    }
}

void ThreadPool::share(const std::function<void(unsigned)>& work) {
    if (failures_.empty()) start();
    if (members_ == 1) return work(0);
    {
        const std::lock_guard lock(mutex_);
        work_ = &work;
        busy_ = members_ - 1;
        ++round_;
    }
    begin_.notify_all();
    work_as(0);
    {
        std::unique_lock lock(mutex_);
        end_.wait(lock, [&] { return busy_ == 0; });
    }
    std::exception_ptr first;
    for (std::exception_ptr& failure : failures_) {
        const std::exception_ptr thrown = std::exchange(failure, nullptr);
        if (thrown && !first) first = thrown;
    }
    if (first) std::rethrow_exception(first);
}

}  // namespace grafverif
