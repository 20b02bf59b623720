// SPDX-License-Identifier: MIT
#include "check/together.hpp"

#include <array>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "check/parts/by_turns.hpp"
#include "ir/probes.hpp"

namespace grafverif {

namespace {

bool is_decided(const Verdict& verdict) { return verdict.outcome != Outcome::Unknown; }

/// `holds (decided by pdr)`
std::string said(const Verdict& verdict) {
    return std::string(word(verdict.outcome)) + " (" + verdict.notes.back() + ")";
}

class Together {
public:
    Together(const TransitionSystem& system, const TogetherOptions& options)
        : system_(system), options_(options), moot_(system.properties.size()) {
        const std::unordered_set<std::string_view> asked(options.properties.begin(), options.properties.end());
        for (const Id<Property> id : system.properties.ids())
            if (asked.empty() || asked.contains(system.properties[id].name)) open_.insert(id.index);
    }

    PdrResult result() {
        {
            std::array<std::jthread, 2> engines;
            const AtEnd end{stop_};  // stops the engines before they are joined, also after exceptions
            engines[0] = std::jthread([this] { guarded([this] { by_diagrams(); }); });
            engines[1] = std::jthread([this] { guarded([this] { by_solvers(); }); });
            wait();
        }
        if (failure_) std::rethrow_exception(failure_);
        return joined();
    }

private:
    using Lock = std::unique_lock<std::mutex>;

    struct AtEnd {
        std::atomic<bool>& stop;
        ~AtEnd() { stop = true; }
    };

    template <class Work>
    void guarded(const Work& work) {
        std::exception_ptr failure;
        try {
            work();
        } catch (...) {
            failure = std::current_exception();
            stop_ = true;
        }
        const Lock lock(mutex_);
        if (failure) failure_ = failure;
        --working_;
        changed_.notify_all();
    }

    // -- the engines, one per thread ---------------------------------------------------------------------------------

    void by_diagrams() {
        SymbolicOptions options;
        options.properties = options_.properties;
        options.max_memory = options_.max_memory / 2;
        options.deadline = options_.deadline;
        options.stop = &stop_;
        options.witnesses = options_.witnesses;
        options.progress = [this](const SymbolicProgress& now) {
            const Lock lock(mutex_);
            told_.symbolic = now;
        };
        SymbolicResult found =
            options_.whole ? check_symbolic(system_, options) : check_symbolic_by_parts(system_, options);
        const Lock lock(mutex_);
        for (std::size_t i = 0; i < found.verdicts.size(); ++i) {
            if (is_decided(found.verdicts[i])) found.verdicts[i].notes.emplace_back("decided by symbolic");
            take(found.verdicts[i], found.runs[i]);
        }
        symbolic_ = {std::move(found.verdicts), std::move(found.runs), std::move(found.fault), {}};
        if (symbolic_.fault) stop_ = true;
    }

    void by_solvers() {
        PdrOptions options;
        options.method = PdrOptions::Method::InTurns;
        options.equal_latches = options_.equal_latches;
        options.properties = options_.properties;
        options.max_memory = options_.max_memory;
        options.deadline = options_.deadline;
        options.stop = &stop_;
        options.moot = &moot_;
        options.progress = [this](const PdrProgress& now) {
            const Lock lock(mutex_);
            told_.pdr = now;
        };
        options.answered = [this](const Verdict& verdict, const std::optional<SystemRun>& run) {
            const Lock lock(mutex_);
            take(verdict, run);
        };
        PdrResult found = check_pdr(system_, options);
        const Lock lock(mutex_);
        circuits_ = std::move(found);
        if (circuits_.fault) stop_ = true;
    }

    /// Keeps the first verdict; a later one that contradicts it is an internal failure.
    void take(const Verdict& verdict, const std::optional<SystemRun>& run) {
        if (!is_decided(verdict)) return;
        const auto [place, fresh] = first_.try_emplace(verdict.about.index, verdict, run);
        Verdict& first = place->second.first;
        if (fresh) {
            settle(verdict.about);
            for (const Id<Property> id : system_.properties.ids())  // the vacuity of a violated property is not needed
                if (verdict.outcome == Outcome::Violated && probed_by(system_.properties[id]) == verdict.property)
                    settle(id);
            if (open_.empty()) stop_ = true;
        } else if (is_decided(first) && first.outcome != verdict.outcome) {
            failures_.push_back("the engines disagree on `" + verdict.property + "`: " + said(first) + ", " +
                                said(verdict));
            first = verdict_on(verdict.about, system_.properties[verdict.about]);
            first.obstacle = Obstacle::Failed;
            first.reason = "this engine failed";
            place->second.second.reset();
        }
    }

    void settle(Id<Property> about) {
        moot_[about.index] = true;
        open_.erase(about.index);
    }

    // -- the caller's thread -----------------------------------------------------------------------------------------

    /// Waits for both engines, forwards cancellation by the caller, and reports progress.
    void wait() {
        Lock lock(mutex_);
        while (working_ != 0) {
            changed_.wait_for(lock, std::chrono::milliseconds(20));
            if (options_.stop != nullptr && options_.stop->load()) stop_ = true;
            if (!options_.progress) continue;
            const TogetherProgress now = told_;
            lock.unlock();
            options_.progress(now);
            lock.lock();
        }
    }

    PdrResult joined() {
        failures_.insert(failures_.end(), circuits_.failures.begin(), circuits_.failures.end());
        const bool faulty = symbolic_.fault || circuits_.fault;
        PdrResult result = std::move(!symbolic_.fault && circuits_.fault ? circuits_ : symbolic_);
        result.failures = std::move(failures_);
        if (faulty) return result;
        for (std::size_t i = 0; i < result.verdicts.size(); ++i)
            if (const auto found = first_.find(result.verdicts[i].about.index); found != first_.end())
                std::tie(result.verdicts[i], result.runs[i]) = std::move(found->second);
            else add_reason(result.verdicts[i], circuits_.verdicts[i]);
        return result;
    }

    /// Adds the reason of the other engine, if it supports the property.
    static void add_reason(Verdict& verdict, const Verdict& other) {
        if (verdict.obstacle == Obstacle::Unsupported || other.obstacle == Obstacle::Unsupported) return;
        verdict.reason = "symbolic: " + verdict.reason + "; pdr and bmc: " + other.reason;
        if (other.obstacle == Obstacle::Stopped) verdict.obstacle = Obstacle::Stopped;
    }

    const TransitionSystem& system_;
    const TogetherOptions& options_;
    std::atomic<bool> stop_ = false;
    std::vector<std::atomic<bool>> moot_;  ///< per property of the system

    std::mutex mutex_ = {};  ///< protects the following members
    std::condition_variable changed_ = {};
    std::size_t working_ = 2;
    std::unordered_set<std::uint32_t> open_ = {};
    std::unordered_map<std::uint32_t, std::pair<Verdict, std::optional<SystemRun>>> first_ = {};
    PdrResult symbolic_ = {}, circuits_ = {};
    TogetherProgress told_ = {};
    std::vector<std::string> failures_ = {};
    std::exception_ptr failure_ = {};
};

}  // namespace

PdrResult check_together(const TransitionSystem& system, const TogetherOptions& options) {
    return Together(system, options).result();
}

}  // namespace grafverif
