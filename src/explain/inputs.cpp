// SPDX-License-Identifier: MIT
#include "explain/inputs.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "explain/causes.hpp"
#include "ir/patterns.hpp"
#include "run/project.hpp"
#include "run/replay.hpp"

namespace grafverif {

namespace {

using System = TransitionSystem;
using Symbol = Id<System::Symbol>;
using ChoiceEvent = InputChange::ChoiceEvent;
using Values = std::vector<std::int64_t>;  // value of each variable of the flat system

/// Maximum number of steps by which a run is continued after its end. If no state is repeated within these steps, the
/// run is rejected.
constexpr std::size_t most_extra_steps = 1000;

/// Number of terms up to which the maximum number of steps is not reduced. For larger systems, this maximum is reduced,
/// because the cost of a step depends on the number of terms.
constexpr std::size_t few_terms = 1000;

/// A free variable of the module `main`.
struct Free {
    enum class What { Input, Time, Move };
    Symbol symbol = {};
    std::uint32_t variable = 0;  ///< index of the variable in the flat system
    What what = What::Move;
    std::int64_t rest = 0;
    Values recorded = {};          ///< value of the variable in each state of the run
    std::vector<bool> event = {};  ///< for each state of the run: true if the variable has an event in this state
};

/// Executes a flat system state by state, for given values of its free variables.
class Steps {
public:
    Steps(const System& system, const Property& property) : flat_(flattened(system)), property_(property) {
        for (const Id<Expr> operand : property.operands) operands_.push_back(flattened(system, flat_, operand));
        if (property.at_stable) settled_ = flattened(system, flat_, system.settled);
    }

    const FlatSystem& flat() const { return flat_; }

    /// Computes the values of all terms in a state.
    class TermValues {
    public:
        TermValues(const Steps& model, const Values& values)
            : model_(model), all_(evaluate_all(model.flat_.exprs, [&](const Expr& leaf) {
                  return values[static_cast<std::size_t>(leaf.value)];
              })) {}

        bool is(Id<Expr> term) const { return all_[term.index].value_or(0) != 0; }
        bool allowed() const {
            const auto so = [this](Id<Expr> term) { return is(term); };
            return std::ranges::all_of(model_.flat_.invariants, so) &&
                   std::ranges::all_of(model_.flat_.transitions, so);
        }
        bool good() const {
            if (model_.settled_.valid() && !is(model_.settled_)) return true;
            std::size_t holding = 0;
            for (const Id<Expr> operand : model_.operands_) {
                if (!all_[operand.index]) return false;
                if (is(operand)) ++holding;
            }
            return model_.property_.pattern == Pattern::Never ? holding == 0 : holding == 1;
        }
        /// Replaces `values` by the values after a step, except the values of free variables. Returns false if a value
        /// is undefined or out of range.
        bool step(Values& values) const {
            for (const Id<FlatSystem::Variable> id : model_.flat_.variables.ids()) {
                const FlatSystem::Variable& variable = model_.flat_.variables[id];
                if (!variable.next) continue;
                const auto next = all_[variable.next->index];
                if (!next || *next < variable.type.low || *next > variable.type.high) return false;
                values[id.index] = *next;
            }
            return true;
        }

    private:
        const Steps& model_;
        std::vector<std::optional<std::int64_t>> all_;
    };

    /// Computes the first state. `values` already contains the values of free variables.
    bool begin(Values& values) const {
        for (const Id<FlatSystem::Variable> id : flat_.variables.ids()) {
            const FlatSystem::Variable& variable = flat_.variables[id];
            if (!variable.initial) continue;
            const auto first = evaluate(flat_.exprs, *variable.initial,
                                        [&](const Expr& leaf) { return values[static_cast<std::size_t>(leaf.value)]; });
            if (!first) return false;
            values[id.index] = *first;
        }
        return true;
    }

private:
    FlatSystem flat_;
    const Property& property_;
    std::vector<Id<Expr>> operands_ = {};
    Id<Expr> settled_ = {};
};

class InputSearch {
public:
    InputSearch(const System& system, const Property& property, const SystemRun& run, std::size_t effort)
        : system_(system), run_(run), model_(system, property) {
        effort_ = std::max<std::size_t>(1, effort * few_terms / std::max(few_terms, model_.flat().exprs.size()));
    }

    InputChange result(const StopRequested& stopped) {
        if (!find_free() || !again()) return {};
        untimely_ = untimely(project(system_, run_)).has_value();
        InputChange found{.events = events()};
        const SmallestSet smallest =
            smallest_set(found.events.size(), stopped, [&](const std::vector<std::size_t>& chosen) {
                std::vector<ChoiceEvent> left_out = chosen_from_the_end(found.events, chosen);
                auto made = without(left_out);
                if (effort_ == 0) return Attempt::Spent;
                if (!made) return Attempt::DoesNot;
                SystemRun run = system_run(model_.flat(), *made);
                if (!untimely_ && untimely(project(system_, run))) return Attempt::DoesNot;
                found.left_out = std::move(left_out);
                found.run = std::move(run);
                return Attempt::Does;
            });
        found.tried = smallest.tried;
        found.exhausted = smallest.exhausted;
        return found;
    }

private:
    std::size_t length() const { return run_.states.size(); }

    /// Finds the free variables. Returns true if every free variable is an input, a timer output or the order of
    /// controllers, and the run contains its values.
    bool find_free() {
        std::map<std::uint32_t, Symbol> symbols;  // symbol of each variable of the flat system
        for (std::uint32_t index = 0; index < model_.flat().symbols.size(); ++index) {
            const Expr& value = model_.flat().exprs[model_.flat().symbols[index]];
            if (value.op == Op::Variable) symbols.emplace(static_cast<std::uint32_t>(value.value), Symbol{index});
        }
        for (const Id<FlatSystem::Variable> id : model_.flat().variables.ids()) {
            const FlatSystem::Variable& variable = model_.flat().variables[id];
            if (variable.choice || (variable.next && !variable.initial)) return false;
            if (variable.next) continue;
            if (!symbols.contains(id.index)) return false;
            Free each{.symbol = symbols.at(id.index), .variable = id.index};
            each.rest = std::clamp<std::int64_t>(0, variable.type.low, variable.type.high);
            for (const auto& state : run_.states) each.recorded.push_back(state[each.symbol.index]);
            const bool may_be_mover = system_.controllers.size() > 1 && variable.type.boolean;
            if (!determine_role(each) && !may_be_mover) return false;
            free_.push_back(std::move(each));
        }
        return true;
    }

    /// Determines the role of the variable in the controllers. Returns true if the variable has a role.
    bool determine_role(Free& free) const {
        for (const System::Controller& controller : system_.controllers) {
            for (const System::Named& input : controller.words.inputs)
                if (input.variable == free.symbol) free.what = Free::What::Input;
            for (const auto& timer : controller.words.timers)
                if (timer.end == free.symbol) free.what = Free::What::Time;
        }
        for (std::size_t state = 0; state < length(); ++state) {
            const std::int64_t now = free.recorded[state], before = state == 0 ? free.rest : free.recorded[state - 1];
            const bool changes = free.what == Free::What::Time ? now > before : now != before;
            free.event.push_back(changes && free.what != Free::What::Move);
        }
        return free.what != Free::What::Move;
    }

    std::vector<ChoiceEvent> events() const {
        std::vector<ChoiceEvent> found;
        for (std::size_t state = 0; state < length(); ++state)
            for (const Free& free : free_)
                if (free.event[state]) found.push_back({free.symbol, state});
        return found;
    }

    /// Re-executes the original run and stores the result. Returns true if the result is the same run and has a bad
    /// state, that is, a state that violates the property.
    bool again() {
        Values values(model_.flat().variables.size());
        for (std::size_t state = 0; state < length(); ++state) {
            for (const Free& free : free_) values[free.variable] = free.recorded[state];
            if (state == 0 && !model_.begin(values)) return false;
            const Steps::TermValues seen(model_, values);
            if (symbol_values(model_.flat(), values) != run_.states[state] || !seen.allowed()) return false;
            if (!bad_ && !seen.good()) bad_ = state;
            states_.push_back(values);
            if (state + 1 < length() && !seen.step(values)) return false;
        }
        return bad_.has_value();
    }

    /// Sets the values of free variables in a state of the run without the events `left_out`. If the event of a
    /// variable is omitted, the variable keeps its previous value.
    void set_free(const std::vector<ChoiceEvent>& left_out, std::size_t state, const Values& before,
                  Values& values) const {
        for (const Free& free : free_) {
            std::int64_t& now = values[free.variable];
            const bool changes = free.event[state] && !is_in(left_out, free, state);
            const std::int64_t kept = state == 0 ? free.rest : before[free.variable];
            switch (free.what) {
            case Free::What::Move: now = free.recorded[state]; break;
            case Free::What::Input: now = changes ? free.recorded[state] : kept; break;
            case Free::What::Time: now = time_reported(left_out, free, state); break;
            }
        }
    }

    /// Returns the value of a timer output in a state. If an expiry is omitted, the value is 0 until the next expiry.
    std::int64_t time_reported(const std::vector<ChoiceEvent>& left_out, const Free& free, std::size_t state) const {
        for (std::size_t k = state + 1; k-- > 0;)
            if (free.event[k]) return is_in(left_out, free, k) ? 0 : free.recorded[state];
        return free.recorded[state];
    }

    static bool is_in(const std::vector<ChoiceEvent>& left_out, const Free& free, std::size_t state) {
        return std::ranges::find(left_out, ChoiceEvent{free.symbol, state}) != left_out.end();
    }

    /// Returns the run without the events `left_out`. Returns nothing if the result is not a valid run or violates the
    /// property in some state.
    std::optional<FlatRun> without(const std::vector<ChoiceEvent>& left_out) {
        const std::size_t from = left_out.front().state;
        if (*bad_ < from) {
            if (effort_ > 0) --effort_;
            return {};
        }
        FlatRun made{{states_.begin(), states_.begin() + static_cast<std::ptrdiff_t>(from)}, {}};
        Values values = states_[from];
        for (std::size_t state = from; state < length(); ++state) {
            set_free(left_out, state, state == 0 ? values : made.states.back(), values);
            if (state == 0 && !model_.begin(values)) return {};
            if (!go_on(made, values)) return {};
        }
        return for_ever(made, std::move(values)) ? std::optional(std::move(made)) : std::nullopt;
    }

    /// Adds `values` as a state, and computes the next state. Returns false if the run is not valid or the state is
    /// bad.
    bool go_on(FlatRun& made, Values& values) {
        if (effort_ == 0) return false;
        --effort_;
        const Steps::TermValues seen(model_, values);
        if (!seen.allowed() || !seen.good()) return false;
        made.states.push_back(values);
        return seen.step(values);
    }

    bool for_ever(FlatRun& made, Values values) {
        for (const Free& free : free_)
            if (free.what == Free::What::Move) values[free.variable] = 1;
        std::map<Values, std::size_t> index_of;
        for (std::size_t k = 0; k < most_extra_steps; ++k) {
            const auto [known, is_new] = index_of.emplace(values, made.states.size());
            if (!is_new) {
                made.loop = known->second;
                return true;
            }
            if (!go_on(made, values)) return false;
        }
        return false;
    }

    const System& system_;
    const SystemRun& run_;
    Steps model_;
    std::size_t effort_ = 0;
    std::vector<Free> free_ = {};
    std::vector<Values> states_ = {};
    std::optional<std::size_t> bad_ = {};  ///< index of the first state of the run that violates the property
    bool untimely_ = false;                ///< true if no plant can produce the original run (run/replay.hpp)
};

}  // namespace

InputChange fewest_input_changes(const System& system, const Property& property, const SystemRun& run,
                                 std::size_t effort, const StopRequested& stopped) {
    if (!is_about_all_states(property.pattern) || run.states.empty()) return {};
    return InputSearch(system, property, run, effort).result(stopped);
}

namespace {

/// Returns the index of the first event, from `first` on, at which the timer expires in `chart_run`. The event can be
/// later than `last` if the step of the timer becomes active later. If the timer does not expire, returns `last`.
std::size_t event_of(const ChartRun& chart_run, Id<ChartRun::Timer> timer, std::size_t first, std::size_t last) {
    for (std::size_t moment = first; moment < chart_run.moments.size(); ++moment)
        if (chart_run.moments[moment].timer == timer) return moment;
    return last;
}

}  // namespace

void mark(const System& system, const std::vector<ChoiceEvent>& left_out, ChartRun& chart_run) {
    const std::vector<std::size_t> moments = events_of_states(chart_run);
    for (const ChoiceEvent& event : left_out) {
        const std::size_t last = moments[event.state], first = event.state == 0 ? 0 : moments[event.state - 1] + 1;
        std::optional<ChartRun::Counterfactual> known;
        for (const Id<ChartRun::Controller> id : chart_run.controllers.ids()) {
            const auto& words = system.controllers[id.index].words;
            const ChartRun::Controller& controller = chart_run.controllers[id];
            for (std::size_t k = 0; k < words.inputs.size(); ++k)
                if (words.inputs[k].variable == event.symbol) known = {last, controller.inputs[k], {}};
            for (std::size_t k = 0; k < words.timers.size(); ++k)
                if (words.timers[k].end == event.symbol)
                    known = {event_of(chart_run, controller.timers[k], first, last), {}, controller.timers[k]};
        }
        if (known) chart_run.counterfactual_values.push_back(*known);
    }
    std::ranges::stable_sort(chart_run.counterfactual_values, {}, &ChartRun::Counterfactual::moment);
}

}  // namespace grafverif
