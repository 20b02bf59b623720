// SPDX-License-Identifier: MIT
#include "check/portfolio.hpp"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "check/decomposition/interleaved.hpp"
#include "check/shares.hpp"
#include "ir/probes.hpp"

namespace grafverif {

namespace {

using Clock = std::chrono::steady_clock;

bool is_decided(const Verdict& verdict) { return verdict.outcome != Outcome::Unknown; }

/// Returns the text of a verdict, such as `holds (decided by pdr)`.
std::string verdict_text(const Verdict& verdict) {
    return std::string(word(verdict.outcome)) + (verdict.notes.empty() ? "" : " (" + verdict.notes.back() + ")");
}

class Portfolio {
public:
    Portfolio(const TransitionSystem& system, const PortfolioOptions& options)
        : system_(system),
          options_(options),
          decided_elsewhere_(system.properties.size()),
          joined_(options.alone == 0) {
        const std::unordered_set<std::string_view> requested(options.properties.begin(), options.properties.end());
        for (const Id<Property> id : system.properties.ids())
            if (requested.empty() || requested.contains(system.properties[id].name)) open_.insert(id.index);
    }

    PortfolioResult result() {
        if (options_.jobs == 1 || !in_threads()) in_sequence();
        if (memory_was_short()) guarded([this] { by_diagrams(options_.max_memory, options_.deadline); });
        if (failure_ && !open_.empty() && !is_faulty()) std::rethrow_exception(failure_);
        return joined();
    }

private:
    using Lock = std::unique_lock<std::mutex>;

    struct AtEnd {
        std::atomic<bool>& stop;
        ~AtEnd() { stop = true; }
    };

    // -- scheduling of the engines ------------------------------------------------------------------------------------

    /// Runs the engines in threads. Returns false if the thread of the symbolic engine cannot be started.
    bool in_threads() {
        threaded_ = true;
        const Deadline look = share_of(options_.deadline, 4);
        const auto joins = [&] { return worked_ >= options_.alone || is_over(look); };
        bool refused = false;
        {
            std::jthread diagrams, solvers;
            const AtEnd end{stop_};  // stops the engines before the destructors join their threads, even after an
                                     // exception
            if (!start(diagrams, [this] { by_diagrams(options_.max_memory / 4 * 3, options_.deadline); })) {
                threaded_ = false;
                return false;
            }
            wait(joins);
            if (join_solvers()) refused = !start(solvers, [this] { by_solvers(options_.deadline); });
            wait([] { return false; });
        }
        threaded_ = false;
        if (refused && can_continue()) guarded([this] { by_solvers(options_.deadline); });
        return true;
    }

    /// Returns true if the solvers (PDR and BMC) must be started in addition to the symbolic engine, and records this
    /// decision in `joined_`.
    bool join_solvers() {
        const Lock lock(mutex_);
        const bool joins = !stop_ && (working_ != 0 || memory_was_short());
        joined_ = joined_ || joins;
        return joins;
    }

    template <class Work>
    bool start(std::jthread& thread, Work work) {
        {
            const Lock lock(mutex_);
            ++working_;
        }
        try {
            thread = std::jthread([this, work] { guarded(work); });
            return true;
        } catch (const std::system_error&) {
            const Lock lock(mutex_);
            --working_;
            return false;
        }
    }

    /// Runs the engines sequentially: first each engine for a bounded time, and then each engine up to the deadline. If
    /// PortfolioOptions::alone is 0, the sequence starts with the solvers. The second run of an engine restarts its
    /// search.
    void in_sequence() {
        constexpr std::chrono::seconds look(1), longest(20);
        const auto at_most = [this](std::chrono::seconds time, std::size_t shares) {
            const Clock::time_point end = Clock::now() + time;
            return std::min(end, share_of(options_.deadline, shares).value_or(end));
        };
        if (options_.alone != 0) guarded([&] { by_diagrams(options_.max_memory, at_most(look, 4)); });
        if (options_.alone != 0 && !can_continue()) return;
        joined_ = true;
        guarded([&] { by_solvers(at_most(longest, 4)); });
        if (can_continue()) guarded([&] { by_diagrams(options_.max_memory, options_.deadline); });
        if (can_continue()) guarded([&] { by_solvers(options_.deadline); });
    }

    bool is_faulty() const { return symbolic_.fault || circuits_.fault; }
    bool is_stopped() const { return is_over(options_.deadline, options_.stop); }
    bool can_continue() const {
        return (!open_.empty() || decided_elsewhere_.empty()) && !is_faulty() && !is_stopped();
    }

    /// True if a property is undecided because the symbolic engine reached its memory limit, and this limit was less
    /// than PortfolioOptions::max_memory.
    bool memory_was_short() const {
        return most_memory_ < options_.max_memory && can_continue() &&
               std::ranges::any_of(symbolic_.verdicts, [this](const Verdict& verdict) {
                   return verdict.obstacle == UnknownReason::Memory && open_.contains(verdict.about.index);
               });
    }

    template <class Work>
    void guarded(const Work& work) {
        std::exception_ptr failure;
        try {
            work();
        } catch (...) {
            failure = std::current_exception();
        }
        const Lock lock(mutex_);
        if (failure) failure_ = failure;
        if (!threaded_) return;
        --working_;
        changed_.notify_all();
    }

    // -- the engines -------------------------------------------------------------------------------------------------

    /// Returns the cancellation flag of the engines: `stop_` if the engines run in threads, otherwise the flag of the
    /// caller. wait() sets `stop_` when the caller requests cancellation.
    const std::atomic<bool>* stop() const { return threaded_ ? &stop_ : options_.stop; }

    void report(const auto& change) {
        PortfolioProgress now;
        {
            const Lock lock(mutex_);
            change(progress_);
            now = progress_;
        }
        if (!threaded_ && options_.progress) options_.progress(now);
    }

    void by_diagrams(std::uint64_t memory, const Deadline& deadline) {
        SymbolicOptions options;
        options.properties = options_.properties;
        options.max_memory = most_memory_ = memory;
        options.deadline = deadline;
        options.stop = stop();
        options.worked = &worked_;
        options.witnesses = options_.witnesses;
        options.progress = [this](const SymbolicProgress& now) {
            report([&](PortfolioProgress& current) { current.symbolic = now; });
        };
        SymbolicResult found =
            options_.whole ? check_symbolic(system_, options) : check_symbolic_by_parts(system_, options);
        const Lock lock(mutex_);
        for (std::size_t i = 0; i < found.verdicts.size(); ++i) {
            if (joined_ && is_decided(found.verdicts[i])) found.verdicts[i].notes.emplace_back("decided by symbolic");
            take(found.verdicts[i], found.runs[i]);
        }
        symbolic_ = {std::move(found.verdicts), std::move(found.runs), std::move(found.fault), {}};
        if (symbolic_.fault) stop_ = true;
    }

    void by_solvers(const Deadline& deadline) {
        if (options_.first && !std::exchange(has_tried_first_, true)) {
            const std::vector<Verdict> found = options_.first(stop());
            const Lock lock(mutex_);
            for (const Verdict& verdict : found) take(verdict, {});
        }
        PdrOptions options;
        options.method = PdrOptions::Method::Alternating;
        options.equal_latches = options_.equal_latches;
        options.properties = options_.properties;
        options.max_memory = options_.max_memory;
        options.deadline = deadline;
        options.stop = stop();
        options.decided_elsewhere = &decided_elsewhere_;
        options.progress = [this](const PdrProgress& now) {
            report([&](PortfolioProgress& current) { current.pdr = now; });
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

    /// Stores the first verdict on a property. If a later verdict contradicts the first verdict, records an internal
    /// failure and makes the verdict unknown.
    void take(const Verdict& verdict, const std::optional<SystemRun>& run) {
        if (!is_decided(verdict)) return;
        const auto [place, fresh] = first_.try_emplace(verdict.about.index, verdict, run);
        Verdict& first = place->second.first;
        if (fresh) {
            settle(verdict.about);
            // A violated property cannot hold vacuously. Its vacuity probes are not needed.
            for (const Id<Property> id : system_.properties.ids())
                if (verdict.outcome == Outcome::Violated && probed_by(system_.properties[id]) == verdict.property)
                    settle(id);
            if (open_.empty()) stop_ = true;
        } else if (is_decided(first) && first.outcome != verdict.outcome) {
            failures_.push_back("the engines disagree on `" + verdict.property + "`: " + verdict_text(first) + ", " +
                                verdict_text(verdict));
            first = verdict_on(verdict.about, system_.properties[verdict.about]);
            set_unknown(first, UnknownReason::Failed, "the engines returned contradictory verdicts");
            place->second.second.reset();
        }
    }

    void settle(Id<Property> about) {
        decided_elsewhere_[about.index] = true;
        open_.erase(about.index);
    }

    // -- the caller's thread -----------------------------------------------------------------------------------------

    /// Waits until all engine threads have ended or `over()` is true. While waiting, sets `stop_` if the caller cancels
    /// the check, and reports progress.
    template <class Over>
    void wait(const Over& over) {
        Lock lock(mutex_);
        while (working_ != 0 && !over()) {
            changed_.wait_for(lock, std::chrono::milliseconds(20));
            if (options_.stop != nullptr && options_.stop->load()) stop_ = true;
            if (!options_.progress) continue;
            const PortfolioProgress now = progress_;
            lock.unlock();
            options_.progress(now);
            lock.lock();
        }
    }

    PortfolioResult joined() {
        failures_.insert(failures_.end(), circuits_.failures.begin(), circuits_.failures.end());
        const bool by_circuits = !symbolic_.fault && (circuits_.fault || symbolic_.verdicts.empty());
        PortfolioResult result{std::move(by_circuits ? circuits_ : symbolic_), !joined_};
        result.failures = std::move(failures_);
        if (result.fault) return result;
        for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
            Verdict& verdict = result.verdicts[i];
            if (const auto found = first_.find(verdict.about.index); found != first_.end())
                std::tie(verdict, result.runs[i]) = std::move(found->second);
            else if (!by_circuits && i < circuits_.verdicts.size()) add_reason(verdict, circuits_.verdicts[i]);
        }
        return result;
    }

    /// Adds the reason of `other`, an unknown verdict of PDR and BMC, to the reason of `verdict`, the unknown verdict
    /// of the symbolic engine. If one of the engines does not support the property, `verdict` is unchanged.
    static void add_reason(Verdict& verdict, const Verdict& other) {
        if (verdict.obstacle == UnknownReason::Unsupported || other.obstacle == UnknownReason::Unsupported) return;
        verdict.reason = "symbolic: " + verdict.reason + "; pdr and bmc: " + other.reason;
        if (other.obstacle == UnknownReason::Stopped) verdict.obstacle = UnknownReason::Stopped;
    }

    const TransitionSystem& system_;
    const PortfolioOptions& options_;
    std::atomic<bool> stop_ = false;
    std::atomic<std::uint64_t> worked_ = 0;  ///< number of steps that operations on decision diagrams have taken
    std::vector<std::atomic<bool>>
        decided_elsewhere_;  ///< for each property of the system: true if its verdict is no longer needed
    bool threaded_ = false;  ///< true if the engines run in threads; changes only while no engine thread is running

    /// Memory limit of the last run of the symbolic engine; read only when this run has ended.
    std::uint64_t most_memory_ = 0;
    bool has_tried_first_ = false;

    std::mutex mutex_ = {};  ///< protects the following members
    std::condition_variable changed_ = {};
    std::size_t working_ = 0;
    bool joined_;  ///< true if the solvers run in addition to the symbolic engine
    std::unordered_set<std::uint32_t> open_ = {};
    std::unordered_map<std::uint32_t, std::pair<Verdict, std::optional<SystemRun>>> first_ = {};
    PdrResult symbolic_ = {}, circuits_ = {};
    PortfolioProgress progress_ = {};
    std::vector<std::string> failures_ = {};
    std::exception_ptr failure_ = {};
};

}  // namespace

PortfolioResult check_together(const TransitionSystem& system, const PortfolioOptions& options) {
    return Portfolio(system, options).result();
}

}  // namespace grafverif
