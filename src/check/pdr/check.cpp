// SPDX-License-Identifier: MIT
#include "check/pdr/check.hpp"

#include <algorithm>
#include <new>
#include <unordered_set>
#include <utility>

#include "check/evidence.hpp"
#include "check/pdr/equal_latches.hpp"
#include "check/pdr/pdr.hpp"
#include "check/pdr/unrolling.hpp"
#include "check/unsupported.hpp"
#include "ir/patterns.hpp"
#include "ir/probes.hpp"
#include "support/element_of.hpp"

namespace grafverif {

namespace pdr {

namespace {

/// Returns the reason why this engine does not support a property, or an empty string if the engine supports it.
std::string refusal(Pattern pattern) {
    const bool about_runs = is_liveness(pattern) || pattern == Pattern::AlwaysPossible;
    return about_runs ? "this engine decides only properties of states, not of runs" : unsupported_reason(pattern);
}

class Check {
public:
    Check(const TransitionSystem& system, const PdrOptions& options)
        : system_(system),
          options_(options),
          flat_(flattened(system)),
          circuit_(circuit_of(system, flat_).circuit),
          watch_({options.max_memory, options.deadline, options.stop}) {}

    PdrResult result() {
        const std::unordered_set<std::string_view> requested(options_.properties.begin(), options_.properties.end());
        find_faults();
        for (const Id<Property> id : system_.properties.ids())
            if (requested.empty() || requested.contains(system_.properties[id].name)) add_query(id);
        switch (options_.method) {
        case PdrOptions::Method::Pdr: by_pdr({}); break;
        case PdrOptions::Method::Bmc: by_bmc({}); break;
        case PdrOptions::Method::Alternating: interleaved_steps(); break;
        }
        for (PropertyQuery& question : questions_) {
            result_.verdicts.push_back(std::move(question.verdict));
            result_.runs.push_back(std::move(question.run));
        }
        return std::move(result_);
    }

private:
    using Clock = std::chrono::steady_clock;

    static constexpr auto none = static_cast<std::size_t>(-1);

    struct PropertyQuery {
        const Property& property;
        Verdict verdict = {};
        std::optional<SystemRun> run = {};
        /// Null if the query requires no search.
        const Circuit::Target* target = nullptr;
        /// `bad` is proved to be false in the first `cleared` states of every run.
        std::size_t cleared = 0;
        /// `has_value` is true if the operands are proved to have values in every reachable state.
        bool open = true, has_value = false;
        /// True if another engine has decided the query; may be null.
        const std::atomic<bool>* decided_elsewhere = nullptr;
        /// Continues an interrupted PDR search; empty without such a search.
        std::function<PdrAnswer()> search = {};

        bool is_open() const { return open && (decided_elsewhere == nullptr || !decided_elsewhere->load()); }
        bool is_reachability() const { return property.pattern == Pattern::Reachable; }
    };

    /// Adds a query. Queries that require no search are decided immediately.
    void add_query(Id<Property> id) {
        const Property& property = system_.properties[id];
        PropertyQuery& question = questions_.emplace_back(PropertyQuery{property, verdict_on(id, property)});
        if (const std::string why = refusal(property.pattern); !why.empty())
            return give_up(question, UnknownReason::Unsupported, why);
        if (is_probe(property) && options_.method == PdrOptions::Method::Bmc)  // BMC cannot prove that a property holds
            return give_up(question, UnknownReason::Unsupported,
                           "BMC cannot prove the property, so its vacuity is not examined");
        if (fault_obstacle_ != UnknownReason::None) return give_up(question, fault_obstacle_, fault_reason_);
        question.target = &element_of(circuit_.targets, id, &Circuit::Target::about);
        if (options_.decided_elsewhere != nullptr)
            question.decided_elsewhere = &(*options_.decided_elsewhere)[id.index];
    }

    void give_up(PropertyQuery& question, UnknownReason obstacle, std::string reason) {
        question.open = false;
        question.search = nullptr;
        question.run.reset();
        set_unknown(question.verdict, obstacle, std::move(reason));
    }

    std::string words(Exhausted::Cause cause) const {
        if (cause == Exhausted::Cause::Stopped) return "stopped";
        return memory_limit_reached(options_.max_memory);
    }
    static UnknownReason obstacle(Exhausted::Cause cause) {
        return cause == Exhausted::Cause::Stopped ? UnknownReason::Stopped : UnknownReason::Memory;
    }

    /// Searches for a reachable state in which `bad` is true. The result is a trace or an invariant. The function
    /// validates every result, including results about faults and quiescence, because the verdicts of properties depend
    /// on them. `interrupted` may be null. If `*interrupted` contains an interrupted search, the function continues
    /// this search. If the search is interrupted again, the function stores it in `*interrupted`.
    PdrAnswer searched(Literal bad, const std::string& name, std::function<PdrAnswer()>* interrupted = nullptr) {
        const auto report_frames = [this, &name](std::size_t frames) {
            if (options_.progress) options_.progress({name, frames, watch_.bytes(), seconds()});
        };
        std::function<PdrAnswer()> search = interrupted != nullptr ? *interrupted : nullptr;
        if (options_.reach) search = [&] { return options_.reach(circuit_, bad, watch_); };
        else if (!search)
            search = search_for(circuit_, bad, watch_, report_frames, {[this]() -> const std::vector<Cube>& {
                                    if (!pairs_) pairs_.emplace(circuit_, watch_, options_.pairs);
                                    const std::vector<Cube>& cubes = pairs_->cubes();
                                    if (options_.pairs != nullptr && options_.pairs->empty())
                                        *options_.pairs = pairs_->named_cubes();
                                    return cubes;
                                }});
        if (interrupted != nullptr) *interrupted = search;
        PdrAnswer answer = search();
        if (interrupted != nullptr) *interrupted = nullptr;
        if (answer.reached) {
            if (!reaches(bad, answer.inputs))
                throw UnsoundResult{"the trace for `" + name + "` is invalid: it does not reach the target state"};
            return answer;
        }
        if (const std::string why = flaw(circuit_, bad, answer.invariant, watch_); !why.empty())
            throw UnsoundResult{"the invariant for `" + name + "` is invalid: " + why};
        return answer;
    }

    /// True if `bad` is true in some state of the run. Removes all states after the first state in which `bad` is true.
    /// If there is no such state, removes all states.
    bool reaches(Literal bad, std::vector<std::vector<bool>>& inputs) const {
        std::size_t states = 0, first = 0;
        run_through(circuit_, inputs, [&](const NodeValues& values) {
            ++states;
            if (first == 0 && value_of(values, bad)) first = states;
        });
        inputs.resize(first);
        return first != 0;
    }

    /// Thrown if the validation of an engine's result fails.
    struct UnsoundResult {
        std::string what = {};
    };

    double seconds() const { return seconds_since(start_); }
    static double seconds_since(Clock::time_point start) {
        return std::chrono::duration<double>(Clock::now() - start).count();
    }

    SystemRun run_of(const PdrAnswer& answer) const {
        SystemRun run;
        for (const std::vector<std::int64_t>& state : external_trace(answer).states)
            run.states.push_back(symbol_values(flat_, state));
        return run;
    }
    ExternalTrace external_trace(const PdrAnswer& answer) const { return {states_of(circuit_, answer.inputs), {}}; }

    // -- validity of the system ------------------------------------------------------------------------------------

    /// Calls `work`. If `work` reaches a limit or has an invalid result, stores the reason in `obstacle_` and
    /// `reason_`, and leaves open queries undecided.
    template <class Work>
    void guarded(const Work& work) {
        obstacle_ = UnknownReason::None;
        try {
            work();
        } catch (const Exhausted& end) {
            obstacle_ = obstacle(end.cause);
            reason_ = words(end.cause);
        } catch (const std::bad_alloc&) {
            unrolling_.reset();  // after an exception, these objects may be incomplete
            equal_latches_.reset();
            obstacle_ = UnknownReason::Memory;
            reason_ = words(Exhausted::Cause::Memory);
        } catch (const Undecided& undecided) {
            obstacle_ = undecided.obstacle;
            reason_ = undecided.reason;
        } catch (const UnsoundResult& unsound) {
            disbelieve(unsound.what);
        }
        if (obstacle_ == UnknownReason::Stopped && !watch_.over())
            reason_ = "the share of the time limit for this property is used up";
    }

    /// Records that the result of an engine is invalid. An invalid result of an internal engine is reported as an
    /// internal failure; an invalid result of an external program is only rejected.
    void disbelieve(const std::string& what) {
        if (!options_.reach) result_.failures.push_back(what);
        obstacle_ = options_.reach ? UnknownReason::Disagrees : UnknownReason::Failed;
        reason_ = options_.reach ? std::string(word(UnknownReason::Disagrees)) + ": " + what
                                 : "the result of the engine is invalid";
    }

    void find_faults() {
        guarded([this] {
            if (!starts()) result_.fault = SystemFault{SystemFault::Kind::NoInitialState, {}, {}};
            else find_leaks();
        });
        fault_obstacle_ = result_.fault ? UnknownReason::Faulty : obstacle_;
        fault_reason_ = result_.fault ? "model error; see above" : reason_;
    }

    bool starts() {
        Solver solver(circuit_, watch_);
        const int first = solver.fresh();
        solver.all_false_under(first);
        const int possible = solver.of(circuit_.possible);
        return solver.solve(std::vector{first, possible});
    }

    /// Determines whether a reachable step can assign a variable a value outside its range. If the initial values are
    /// in their ranges and no step leaves a range, all values stay in their ranges (induction). If some step leaves a
    /// range, a search determines whether this step is reachable.
    void find_leaks() {
        Solver solver(circuit_, watch_);
        const int in_range = circuit_.leaks.empty() ? 0 : solver.of(circuit_.in_range);
        for (const Circuit::Leak& leak : circuit_.leaks) {
            const int bad = solver.of(leak.bad);
            if (!solver.solve(std::vector{in_range, bad})) continue;
            const std::string& name = flat_.variables[leak.variable].name;
            if (const PdrAnswer answer = searched(leak.bad, name); answer.reached) {
                result_.fault = SystemFault{SystemFault::Kind::OutOfRange, name, run_of(answer)};
                return;
            }
        }
    }

    // -- properties --------------------------------------------------------------------------------------------------

    bool any_open() const { return std::ranges::any_of(questions_, &PropertyQuery::is_open); }

    /// False if the query is a vacuity probe of a property whose check has ended with an outcome other than Holds.
    bool matters(const PropertyQuery& question) const {
        if (!is_probe(question.property)) return true;
        const auto of = std::ranges::find(questions_, probed_by(question.property),
                                          [](const PropertyQuery& each) { return each.property.name; });
        return of == questions_.end() || of->open || of->verdict.outcome == Outcome::Holds;
    }

    /// Decides the queries sequentially by PDR. The time limit of each query is `time`, or the query's share of the
    /// remaining time if `time` is nullopt. If `time` is given, undecided queries remain open.
    void by_pdr(std::optional<Clock::duration> time) {
        auto left = static_cast<std::size_t>(std::ranges::count_if(questions_, &PropertyQuery::is_open));
        for (PropertyQuery& question : questions_) {
            if (!matters(question))
                give_up(question, UnknownReason::Stopped, "the property is violated, so its vacuity is not examined");
            if (!question.is_open()) question.search = nullptr;
            if (!question.is_open()) continue;
            const auto start = Clock::now();
            if (time) watch_.limit(*time);
            else watch_.share(left--);
            watch_.end_with(question.decided_elsewhere);
            guarded([&] {
                if (watch_.over()) throw Exhausted{Exhausted::Cause::Stopped};
                decide(question);
            });
            question.verdict.seconds += seconds_since(start);
            conclude(question, "pdr", time.has_value());
        }
    }

    /// Updates a query after PDR or BMC has worked on the query. If `later` is true, and PDR or BMC ended only because
    /// its time for this query was over, the query remains open.
    void conclude(PropertyQuery& question, const char* by, bool later) {
        if (obstacle_ == UnknownReason::None) {
            if (options_.method != PdrOptions::Method::Alternating || question.verdict.outcome == Outcome::Unknown)
                return;
            question.verdict.notes.push_back(std::string("decided by ") + by);
            if (options_.answered) options_.answered(question.verdict, question.run);
        } else if (!later || obstacle_ != UnknownReason::Stopped || watch_.over()) {
            give_up(question, obstacle_, bmc_progress_text(question));
        }
    }

    /// Alternates PDR and BMC. An interrupted PDR search loses its open proof obligations. Therefore, if there are few
    /// queries, the first round of each query is longer.
    void interleaved_steps() {
        constexpr std::ptrdiff_t few = 8;
        const auto open = std::max<std::ptrdiff_t>(1, std::ranges::count_if(questions_, &PropertyQuery::is_open));
        for (Clock::duration time = options_.first_step_of * std::max<std::ptrdiff_t>(1, few / open); any_open();
             time *= 4) {
            const auto start = Clock::now();
            by_pdr(time);
            // BMC gets a third of the time of PDR, because PDR also finds violations.
            by_bmc(std::max<Clock::duration>(time, Clock::now() - start) / 3);
        }
    }

    void decide(PropertyQuery& question) {
        const Property& property = question.property;
        if (has_no_value(question)) return;
        const auto start = Clock::now();
        const bool interleaved_steps = options_.method == PdrOptions::Method::Alternating;
        std::optional<PdrAnswer> known = proved_by_equal_latches(question.target->bad);
        PdrAnswer answer =
            known ? std::move(*known)
                  : searched(question.target->bad, property.name, interleaved_steps ? &question.search : nullptr);
        if (answer.reached) {
            if (!options_.reach && !is_probe(property)) shorten(question, answer, Clock::now() - start);
            return reached(question, answer);
        }
        // is_settled() throws if its search is interrupted; the query then remains open.
        if (!question.is_reachability() && property.at_stable) is_settled();
        close(question, question.is_reachability() ? Outcome::Violated : Outcome::Holds);
        if (options_.proved && !is_probe(property))
            options_.proved(property.name, circuit_, question.target->bad, answer.invariant);
        question.verdict.notes.push_back("proved by an inductive invariant of " +
                                         std::to_string(answer.invariant.size()) +
                                         (answer.invariant.size() == 1 ? " clause" : " clauses") + ", checked by " +
                                         (options_.reach ? "a solver" : "a second solver"));
        if (!question.is_reachability() && property.at_stable) mark_vacuous(question.verdict);
    }

    std::optional<PdrAnswer> proved_by_equal_latches(Literal bad) {
        if (!options_.equal_latches) return {};
        if (!equal_latches_) equal_latches_.emplace(circuit_, watch_);
        const std::vector<Cube>& cubes = equal_latches_->cubes();
        if (!flaw(circuit_, bad, cubes, watch_).empty()) return {};
        return PdrAnswer{.invariant = cubes};
    }

    bool has_no_value(PropertyQuery& question) {
        const Literal undefined = question.target->undefined;
        question.has_value =
            question.has_value || undefined == Gates::no || !searched(undefined, question.property.name).reached;
        if (question.has_value) return false;
        give_up(question, UnknownReason::Faulty,
                "the condition of the property divides by zero in some reachable state");
        return true;
    }

    void close(PropertyQuery& question, Outcome outcome) {
        question.open = false;
        question.verdict.outcome = outcome;
    }

    /// Validates the run in `answer` by evaluating the terms of the system, and stores the run and the verdict in the
    /// query.
    void reached(PropertyQuery& question, const PdrAnswer& answer) {
        if (const std::string why = doubt(system_, flat_, question.property, external_trace(answer)); !why.empty())
            throw UnsoundResult{"the trace for `" + question.property.name + "` is invalid: " + why};
        question.run = run_of(answer);
        if (options_.shown && !is_probe(question.property))
            options_.shown(question.property.name, circuit_, question.target->bad, answer.inputs);
        close(question, question.is_reachability() ? Outcome::Holds : Outcome::Violated);
        if (options_.reach) return;
        question.verdict.notes.emplace_back(question.cleared + 1 >= answer.inputs.size() ? "no shorter trace exists"
                                                                                         : "a shorter trace may exist");
    }

    // -- bounded model checking --------------------------------------------------------------------------------------

    /// Searches for a run that is shorter than the run in `answer`. The time limit is `took`, the time of the search
    /// for the run in `answer`, plus PdrOptions::shorten_for.
    void shorten(PropertyQuery& question, PdrAnswer& answer, Clock::duration took) {
        watch_.limit(took + options_.shorten_for);
        try {
            while (question.cleared + 1 < answer.inputs.size())
                if (std::optional<RunInputs> shorter = next_step(question)) answer.inputs = std::move(*shorter);
        } catch (const Exhausted& end) {
            if (end.cause == Exhausted::Cause::Memory) unrolling_.reset();
        } catch (const std::bad_alloc&) {
            unrolling_.reset();
        }
    }

    /// Searches for a run of `question.cleared` steps to a bad state. If no such run exists, increments
    /// `question.cleared` and returns nullopt.
    std::optional<RunInputs> next_step(PropertyQuery& question) {
        if (!unrolling_) unrolling_.emplace(circuit_, watch_);
        std::optional<RunInputs> found = unrolling_->run_to(question.target->bad, question.cleared);
        if (found && !reaches(question.target->bad, *found))
            throw UnsoundResult{"the trace for `" + question.property.name +
                                "` is invalid: it does not reach the target state"};
        if (!found) ++question.cleared;
        return found;
    }

    /// Searches for runs of increasing length for all open queries by BMC. If `time` is given, queries that are
    /// undecided after this time remain open.
    void by_bmc(std::optional<Clock::duration> time) {
        if (without_bmc_) return;
        if (!time) refuse_undefined_values();
        const auto end = Clock::now() + time.value_or(Clock::duration::zero());
        std::size_t reported = none;
        while (PropertyQuery* question = least_searched()) {
            if (options_.progress && reported != question->cleared)
                options_.progress({{}, reported = question->cleared, watch_.bytes(), seconds()});
            if (time) watch_.limit(end - Clock::now());
            watch_.end_with(question->decided_elsewhere);
            obstacle_ = UnknownReason::Bound;
            if (question->cleared <= options_.max_steps.value_or(none))
                guarded([&] {
                    if (auto inputs = next_step(*question))
                        reached(*question, {.reached = true, .inputs = std::move(*inputs)});
                });
            question->verdict.seconds = seconds();
            if (time && obstacle_ == UnknownReason::Memory) {  // a later PDR search may need less memory
                unrolling_.reset();
                without_bmc_ = true;
                return;
            }
            conclude(*question, "bmc", time.has_value());
            if (time && Clock::now() >= end) return;
        }
    }

    void refuse_undefined_values() {
        for (PropertyQuery& question : questions_) {
            if (!question.is_open()) continue;
            guarded([&] { has_no_value(question); });
            if (obstacle_ != UnknownReason::None) give_up(question, obstacle_, reason_);
        }
    }

    /// Returns the open query with the smallest length of searched runs, among the queries whose operands are proved to
    /// have values. Returns null if there is no such query.
    PropertyQuery* least_searched() {
        PropertyQuery* least = nullptr;
        for (PropertyQuery& question : questions_)
            if (question.is_open() && question.has_value && (least == nullptr || question.cleared < least->cleared))
                least = &question;
        return least;
    }

    /// Returns a text for the verdict: the reason why the search ended without a result, and the maximum length of the
    /// runs that BMC has searched.
    std::string bmc_progress_text(const PropertyQuery& question) const {
        std::string words = obstacle_ == UnknownReason::Bound ? "" : reason_;
        if (question.cleared == 0) return words;
        const std::size_t steps = question.cleared - 1;
        return words + (words.empty() ? "" : "; ") + "no run of up to " + std::to_string(steps) +
               (steps == 1 ? " step" : " steps") +
               (question.is_reachability() ? " satisfies the property" : " violates the property");
    }

    /// True if some reachable state is quiescent.
    bool is_settled() {
        if (!settled_) settled_ = searched(circuit_.settled, "settled").reached;
        return *settled_;
    }

    void mark_vacuous(Verdict& verdict) {
        if (is_settled()) return;
        verdict.vacuous = true;
        verdict.notes.emplace_back("no state is quiescent");
    }

    const TransitionSystem& system_;
    const PdrOptions& options_;
    Clock::time_point start_ = Clock::now();
    FlatSystem flat_;
    Circuit circuit_;
    LimitMonitor watch_;
    PdrResult result_ = {};
    std::vector<PropertyQuery> questions_ = {};
    std::optional<Unrolling> unrolling_ = {};
    std::optional<EqualLatches> equal_latches_ = {};
    std::optional<LatchPairs> pairs_ = {};          ///< stored searches refer to the result of `pairs_`
    bool without_bmc_ = false;                      ///< true if there is not enough memory for BMC
    UnknownReason obstacle_ = UnknownReason::None;  ///< reason why the last call of `guarded` ended without a result
    std::string reason_ = {};
    UnknownReason fault_obstacle_ = UnknownReason::None;  ///< reason why the search for faults ended
    std::string fault_reason_ = {};
    std::optional<bool> settled_ = {};  ///< true if some reachable state is quiescent; empty if unknown
};

}  // namespace

}  // namespace pdr

PdrResult check_pdr(const TransitionSystem& system, const PdrOptions& options) {
    return pdr::Check(system, options).result();
}

}  // namespace grafverif
