// SPDX-License-Identifier: MIT
#include "check/pdr/check.hpp"

#include <algorithm>
#include <new>
#include <unordered_set>
#include <utility>

#include "check/evidence.hpp"
#include "check/pdr/pdr.hpp"
#include "check/refusal.hpp"

namespace grafverif {

namespace pdr {

namespace {

using Literal = Gates::Literal;

/// Why this engine does not take a property; empty: it does.
std::string refusal(Pattern pattern) {
    const bool about_runs =
        pattern == Pattern::Inevitable || pattern == Pattern::LeadsTo || pattern == Pattern::AlwaysPossible;
    return about_runs ? "it is about runs, and this engine decides what is about states" : untimed_refusal(pattern);
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
        const std::unordered_set<std::string_view> asked(options_.properties.begin(), options_.properties.end());
        std::vector<Id<Property>> questions;
        for (const Id<Property> id : system_.properties.ids())
            if (asked.empty() || asked.contains(system_.properties[id].name)) questions.push_back(id);
        look_for_faults();
        std::size_t left = questions.size();
        for (const Id<Property> id : questions) {
            const Property& property = system_.properties[id];
            watch_.share(left--);
            const auto start = std::chrono::steady_clock::now();
            verdict_ = verdict_on(id, property);
            run_.reset();
            answer(property);
            verdict_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            result_.verdicts.push_back(std::move(verdict_));
            result_.runs.push_back(std::move(run_));
        }
        return std::move(result_);
    }

private:
    void unknown(Obstacle obstacle, std::string reason) {
        verdict_.outcome = Outcome::Unknown;
        verdict_.obstacle = obstacle;
        verdict_.reason = std::move(reason);
    }

    std::string words(Exhausted::Cause cause) const {
        if (cause == Exhausted::Cause::Stopped) return "stopped";
        return "the memory allowed, " + std::to_string(options_.max_memory >> 20U) + " MiB, is used up";
    }
    static Obstacle obstacle(Exhausted::Cause cause) {
        return cause == Exhausted::Cause::Stopped ? Obstacle::Stopped : Obstacle::Memory;
    }

    /// Whether a state with `bad` is reached. What says so and what says no has been checked, whatever was asked: on a fault
    /// or on what is settled other verdicts rest.
    Answer searched(Literal bad, const std::string& name) {
        const auto told = [&](std::size_t frames) {
            if (options_.progress) options_.progress({name, frames, watch_.bytes(), seconds()});
        };
        Answer answer = options_.reach ? options_.reach(circuit_, bad, watch_) : reach(circuit_, bad, watch_, told);
        if (answer.reached) {
            if (!gets_to(bad, answer.inputs))
                throw Unsound{"the run found for `" + name + "` is none: it does not get there"};
            return answer;
        }
        if (const std::string why = flaw(circuit_, bad, answer.invariant, watch_); !why.empty())
            throw Unsound{"the invariant found for `" + name + "` is none: " + why};
        return answer;
    }

    /// Whether the run has a state with `bad`; what follows the first of them is cut off.
    bool gets_to(Literal bad, std::vector<std::vector<bool>>& inputs) const {
        std::size_t states = 0, first = 0;
        run_through(circuit_, inputs, [&](const NodeValues& values) {
            ++states;
            if (first == 0 && value_of(values, bad)) first = states;
        });
        inputs.resize(first);
        return first != 0;
    }

    /// Something of ours that does not stand up.
    struct Unsound {
        std::string what = {};
    };

    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

    SystemRun run_of(const Answer& answer) const {
        SystemRun run;
        for (const std::vector<std::int64_t>& state : told_run(answer).states)
            run.states.push_back(symbol_values(flat_, state));
        return run;
    }
    ToldRun told_run(const Answer& answer) const { return {states_of(circuit_, answer.inputs), {}}; }

    // -- whether the system means something ------------------------------------------------------------------------

    /// Calls `work`; what it has not come to keeps every verdict from being given.
    template <class Work>
    void guarded(const Work& work) {
        try {
            work();
        } catch (const Exhausted& end) {
            obstacle_ = obstacle(end.cause);
            reason_ = words(end.cause);
        } catch (const std::bad_alloc&) {
            obstacle_ = Obstacle::Memory;
            reason_ = words(Exhausted::Cause::Memory);
        } catch (const Undecided& undecided) {
            obstacle_ = undecided.obstacle;
            reason_ = undecided.reason;
        } catch (const Unsound& unsound) {
            disbelieve(unsound.what);
        }
        if (obstacle_ == Obstacle::Stopped && !watch_.over()) reason_ = "its share of the time is over";
    }

    /// Of ours a failure; a program is not believed.
    void disbelieve(const std::string& what) {
        if (!options_.reach) result_.failures.push_back(what);
        obstacle_ = options_.reach ? Obstacle::Disagrees : Obstacle::Failed;
        reason_ = options_.reach ? std::string(word(Obstacle::Disagrees)) + ": " + what : "this engine failed";
    }

    void look_for_faults() {
        guarded([this] {
            if (!starts()) result_.fault = SystemFault{SystemFault::Kind::NoInitialState, {}, {}};
            else look_for_leaks();
        });
        fault_obstacle_ = result_.fault ? Obstacle::Faulty : obstacle_;
        fault_reason_ = result_.fault ? "the model breaks off; see its fault" : reason_;
    }

    bool starts() {
        Solver solver(circuit_, watch_);
        const int first = solver.fresh();
        solver.all_false_under(first);
        const int possible = solver.of(circuit_.possible);
        return solver.solve(std::vector{first, possible});
    }

    /// Where all values are in range and no step leads out, they stay so. Of the steps that might, as far as that goes, it
    /// takes a search.
    void look_for_leaks() {
        Solver solver(circuit_, watch_);
        const int in_range = circuit_.leaks.empty() ? 0 : solver.of(circuit_.in_range);
        for (const Circuit::Leak& leak : circuit_.leaks) {
            const int bad = solver.of(leak.bad);
            if (!solver.solve(std::vector{in_range, bad})) continue;
            const std::string& name = flat_.variables[leak.variable].name;
            if (const Answer answer = searched(leak.bad, name); answer.reached) {
                result_.fault = SystemFault{SystemFault::Kind::OutOfRange, name, run_of(answer)};
                return;
            }
        }
    }

    // -- properties --------------------------------------------------------------------------------------------------

    void answer(const Property& property) {
        if (const std::string why = refusal(property.pattern); !why.empty()) return unknown(Obstacle::Unsupported, why);
        if (fault_obstacle_ != Obstacle::None) return unknown(fault_obstacle_, fault_reason_);
        if (watch_.over()) return unknown(Obstacle::Stopped, "stopped");
        obstacle_ = Obstacle::None;
        const auto target = std::ranges::find(circuit_.targets, verdict_.about, &Circuit::Target::about);
        guarded([&] { decide(property, *target); });
        if (obstacle_ == Obstacle::None) return;
        unknown(obstacle_, reason_);
        run_.reset();
    }

    void decide(const Property& property, const Circuit::Target& target) {
        if (target.undefined != Gates::no && searched(target.undefined, property.name).reached)
            return unknown(Obstacle::Faulty, "its condition divides by zero in some reachable state");
        const Answer answer = searched(target.bad, property.name);
        const bool wanted = property.pattern == Pattern::Reachable;
        verdict_.outcome = answer.reached == wanted ? Outcome::Holds : Outcome::Violated;
        if (answer.reached) {
            if (const std::string why = doubt(system_, flat_, property, told_run(answer)); !why.empty())
                throw Unsound{"the run found for `" + property.name + "` is none: " + why};
            run_ = run_of(answer);
        } else {
            verdict_.notes.push_back("an inductive invariant of " + std::to_string(answer.invariant.size()) +
                                     (answer.invariant.size() == 1 ? " clause" : " clauses") +
                                     " shows it, checked by " + (options_.reach ? "a solver" : "a second solver"));
            if (!wanted && property.at_stable) mark_vacuous();
        }
    }

    void mark_vacuous() {
        if (!settled_) settled_ = searched(circuit_.settled, "settled").reached;
        if (*settled_) return;
        verdict_.vacuous = true;
        verdict_.notes.emplace_back("no state is ever settled");
    }

    const TransitionSystem& system_;
    const PdrOptions& options_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    FlatSystem flat_;
    Circuit circuit_;
    Watch watch_;
    PdrResult result_ = {};
    Verdict verdict_ = {};
    std::optional<SystemRun> run_ = {};
    Obstacle obstacle_ = Obstacle::None;  ///< met by the question at hand
    std::string reason_ = {};
    Obstacle fault_obstacle_ = Obstacle::None;  ///< met by every question
    std::string fault_reason_ = {};
    std::optional<bool> settled_ = {};  ///< whether some state is settled
};

}  // namespace

}  // namespace pdr

PdrResult check_pdr(const TransitionSystem& system, const PdrOptions& options) {
    return pdr::Check(system, options).result();
}

}  // namespace grafverif
