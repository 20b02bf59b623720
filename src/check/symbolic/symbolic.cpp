// SPDX-License-Identifier: MIT
#include <algorithm>
#include <new>
#include <string_view>
#include <unordered_set>

#include "check/symbolic/check.hpp"

namespace grafverif {

namespace symbolic {

Check::Check(const TransitionSystem& system, const SymbolicOptions& options)
    : options_(options),
      flat_(flattened(system)),
      space_(
          {.memory = options.max_memory, .deadline = options.deadline, .stop = options.stop, .worked = options.worked}),
      questions_(system, flat_) {
    const std::unordered_set<std::string_view> requested(options.properties.begin(), options.properties.end());
    for (const Id<Property> id : system.properties.ids())
        if (requested.empty() || requested.contains(system.properties[id].name)) questions_.add_query(id);
}

SymbolicResult Check::result() {
    try {
        model_.emplace(flat_, space_, options_.by_kind);
        search();
        result_.fault = fault();
    } catch (const BddExhausted& exhausted) {
        note(exhausted);
    } catch (const std::bad_alloc&) {
        note(BddExhausted(BddExhausted::Cause::Memory));
    }
    if (!result_.fault && search_.obstacle == UnknownReason::None) count_states();
    if (result_.fault) search_ = {.obstacle = UnknownReason::Faulty, .reason = "model error; see above"};
    answer();
    result_.bytes = std::max(result_.bytes, space_.bytes());
    result_.seconds = seconds();
    for (Verdict& verdict : result_.verdicts) {
        verdict.states = result_.states;
        verdict.seconds = result_.seconds;
    }
    return std::move(result_);
}

Bdd Check::meaning(const TransitionSystem& system, Id<Expr> term) {
    const Id<Expr> here = flattened(system, flat_, term);
    BddTerms terms = model_->terms();
    return terms(here).bits.front();
}

double Check::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void Check::note(const BddExhausted& exhausted) {
    const std::string after = " after " + std::to_string(search_.rings.each.size()) + " steps of the exploration";
    if (exhausted.cause() == BddExhausted::Cause::Stopped) {
        search_.obstacle = UnknownReason::Stopped;
        search_.reason = "stopped" + after;
    } else {
        search_.obstacle = UnknownReason::Memory;
        search_.reason = memory_limit_reached(options_.max_memory) + after;
    }
}

void Check::count_states() {
    try {
        result_.states = count(search_.reached, model_->state_bits());
    } catch (const BddExhausted&) {  // the memory limit is reached: the number of states remains unknown
    }
}

void Check::search() {
    const StateSpace& model = *model_;
    const std::uint64_t enough = space_.work() + options_.one_by_one;
    // A step that assigns a variable a value outside its range does not lead to a state, and the search ends at such a
    // step. Therefore, before the successors of a ring (the states at one depth) are used, the ring is checked for such
    // steps.
    bool leaks = false;
    const auto keep_going = [&](bool kinds) {
        return [&, kinds](std::size_t depth) {
            search_.reached = search_.rings.reached;
            leaks = leaks || model.leak(search_.rings.each.back());
            if (leaks) return false;
            result_.bytes = std::max(result_.bytes, space_.bytes());
            if (options_.progress) options_.progress({depth, space_.bytes(), seconds()});
            return !kinds || space_.work() < enough;
        };
    };
    search_.witnesses = options_.witnesses;
    search_.rings.add(model.initial());
    if (grow(model, search_.rings, model.invariant(), {}, keep_going(model.has_clusters())) && !leaks) {
        const Bdd closure = model.closure(search_.reached);
        // The closure may contain assignments that violate a range or an invariant, and successors of these
        // assignments, to which no run leads. In this case, the closure is not used.
        if ((closure & ~model.invariant()).is_false() && !model.leak(closure)) search_.reached = closure;
        else grow(model, search_.rings, model.invariant(), {}, keep_going(false));
    }
    result_.depth = search_.rings.each.empty() ? 0 : search_.rings.each.size() - 1;
}

std::optional<SystemFault> Check::fault() {
    const StateSpace& model = *model_;
    using enum SystemFault::Kind;
    if (search_.reached.is_false()) return SystemFault{NoInitialState, {}, {}};
    const auto path_to = [&](const Bdd& states) {
        return system_run(flat_, run_of(model, {shortest_trace(model, search_, states), {}, {}}));
    };
    if (const auto some = model.leak(search_.reached)) {
        (void)shortest_trace(model, search_, some->states);
        // Examines the rings in order of their distance from the initial states, and reports the first step that
        // assigns a value outside the range of its variable. States after such a step do not belong to a run.
        for (const Bdd& ring : search_.rings.each)
            if (const auto leak = model.leak(ring))
                return SystemFault{OutOfRange, flat_.variables[leak->variable].name, path_to(leak->states)};
    }
    const Bdd stuck = search_.reached & ~model.preimage(search_.reached);
    if (!stuck.is_false()) return SystemFault{DeadEnd, {}, path_to(stuck)};
    return {};
}

void Check::answer() {
    for (QueryResult& found : questions_.answers(model_ ? &*model_ : nullptr, search_, options_)) {
        result_.verdicts.push_back(std::move(found.verdict));
        result_.runs.push_back(found.run ? std::optional(system_run(flat_, *found.run)) : std::nullopt);
        runs_.push_back(std::move(found.run));
    }
}

}  // namespace symbolic

SymbolicResult check_symbolic(const TransitionSystem& system, const SymbolicOptions& options) {
    return symbolic::Check(system, options).result();
}

}  // namespace grafverif
