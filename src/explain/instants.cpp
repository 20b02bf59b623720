// SPDX-License-Identifier: MIT
#include "explain/instants.hpp"

#include <algorithm>
#include <utility>

#include "run/interpreter.hpp"

namespace grafverif {

namespace {

class Instants {
public:
    Instants(const Chart& chart, ExecutionMode mode, const ChartRun& run, std::size_t effort)
        : chart_(chart), mode_(mode), run_(run), effort_(effort) {
        std::size_t place = 0;  // index among the inputs of the controller
        for (const Id<Chart::Variable> id : chart.variables.ids())
            if (chart.variables[id].kind == Chart::VariableKind::Input)
                inputs_.emplace_back(id, run.controllers.begin()->inputs[place++]);
        for (std::size_t moment = 1; moment < run.moments.size(); ++moment)
            if (instants_.empty() || !same(instants_.back(), moment)) instants_.push_back(moment);
    }

    InstantChange result(const StopRequested& stopped) {
        const std::vector<ChartRun::Counterfactual> events = all_events();
        InstantChange found{.events = events.size()};
        if (ends({})) return found;
        const SmallestSet smallest = smallest_set(events.size(), stopped, [&](const std::vector<std::size_t>& chosen) {
            std::vector<ChartRun::Counterfactual> left_out = chosen_from_the_end(events, chosen);
            const bool so = ends(left_out);
            if (effort_ == 0) return Attempt::Spent;
            if (so) found.left_out = std::move(left_out);
            return so ? Attempt::Does : Attempt::DoesNot;
        });
        found.tried = smallest.tried;
        found.exhausted = smallest.exhausted;
        return found;
    }

private:
    using Input = std::pair<Id<Chart::Variable>, Id<ChartRun::Signal>>;

    std::int64_t value_at(const Input& input, std::size_t moment) const {
        return run_.moments[moment].after.values[input.second.index];
    }

    bool same(std::size_t left, std::size_t right) const {
        return run_.moments[left].after.time_ms == run_.moments[right].after.time_ms &&
               std::ranges::all_of(inputs_,
                                   [&](const Input& each) { return value_at(each, left) == value_at(each, right); });
    }

    std::int64_t rest(const Input& input) const {
        const Type& type = chart_.variables[input.first].type;
        return std::clamp<std::int64_t>(0, type.low, type.high);
    }

    bool changes(const Input& input, std::size_t instant) const {
        return value_at(input, instants_[instant]) !=
               (instant == 0 ? rest(input) : value_at(input, instants_[instant - 1]));
    }

    std::vector<ChartRun::Counterfactual> all_events() const {
        std::vector<ChartRun::Counterfactual> found;
        for (std::size_t instant = 0; instant < instants_.size(); ++instant)
            for (const Input& input : inputs_)
                if (changes(input, instant)) found.push_back({instants_[instant], input.second, {}});
        return found;
    }

    /// True if each instant of the run without the input changes `left_out` ends.
    bool ends(const std::vector<ChartRun::Counterfactual>& left_out) {
        State state = power_on(chart_);
        std::vector<std::int64_t> values(chart_.variables.size());
        for (const Input& input : inputs_) values[input.first.index] = rest(input);
        std::int64_t now = 0;
        for (std::size_t instant = 0; instant < instants_.size(); ++instant) {
            const std::size_t moment = instants_[instant];
            for (const Input& input : inputs_)
                if (changes(input, instant) &&
                    std::ranges::find(left_out, ChartRun::Counterfactual{moment, input.second, {}}) == left_out.end())
                    values[input.first.index] = value_at(input, moment);
            const std::int64_t before = std::exchange(now, run_.moments[moment].after.time_ms);
            if (instant > 0) state = pass_time(std::move(state), now - before);
            Cycle done = cycle(chart_, state, values, mode_);
            effort_ -= std::min(effort_, done.fired.size() + 1);
            if (done.race || done.fault || !done.endless.empty() || done.gave_up || effort_ == 0) return false;
            state = std::move(done.state);
        }
        return true;
    }

    const Chart& chart_;
    ExecutionMode mode_;
    const ChartRun& run_;
    std::size_t effort_;
    std::vector<Input> inputs_ = {};
    std::vector<std::size_t> instants_ = {};  ///< first event of each instant
};

}  // namespace

InstantChange fewest_changes(const Chart& chart, ExecutionMode mode, const ChartRun& run, std::size_t effort,
                             const StopRequested& stopped) {
    return Instants(chart, mode, run, effort).result(stopped);
}

}  // namespace grafverif
