// SPDX-License-Identifier: MIT
#include "run/recording/recording_check.hpp"

#include <algorithm>
#include <cassert>
#include <span>
#include <unordered_map>

#include "run/scanner.hpp"

namespace grafverif {

namespace {

constexpr std::uint64_t most_reactions = 1'000'000;  ///< maximum number of reactions for one sample
constexpr std::size_t most_successors = 40'000;      ///< maximum number of successors of a hypothesis
constexpr std::uint64_t poll_interval = 1'024;       ///< reactions between two calls of `stopped`

}  // namespace

/// Finds all successors of a hypothesis: its possible next instants.
class RecordingCheck::Expansion {
public:
    Expansion(RecordingCheck& check, const Hypothesis& from, std::vector<Hypothesis>& successors)
        : check_(check), from_(from), successors_(successors), jitter_(check.settings_.jitter) {}

    enum class Result { Waits, Ends, Continues };

    /// Returns Waits if the next instant may be later than `known_`, so that more samples are needed. Returns Ends if
    /// the hypothesis has no successor.
    Result run() {
        std::optional<Zone> next = check_.zone_of_next(from_);
        if (!next) return Result::Ends;
        Zone& zone = *next;
        now_ = zone.size() - 1;
        if (zone.upper(now_) > check_.known_) return Result::Waits;
        collect_running();
        rise_over_.resize(check_.elements_.size());
        fall_over_.resize(check_.elements_.size());
        used_ = from_.used;
        if (from_.history) choose_elapsed(0, zone, false);
        else if (zone.constrain(0, now_, jitter_ - check_.begin_)) choose_inputs(0, zone, true);
        return continued_ ? Result::Continues : Result::Ends;
    }

private:
    struct Running {
        std::size_t element = 0, start = 0;
        Ticks duration = 0;
        bool is_fall = false;
    };

    Ticks ticks(std::int64_t milliseconds) const { return milliseconds * check_.settings_.ticks_per_ms; }

    void collect_running() {
        for (std::size_t k = 0; k < check_.elements_.size(); ++k) {
            const TimedElement& element = check_.elements_[k];
            if (from_.rise[k] != 0) running_.push_back({k, from_.rise[k], ticks(element.rise_ms), false});
            if (from_.fall[k] != 0) running_.push_back({k, from_.fall[k], ticks(element.fall_ms), true});
        }
    }

    /// Chooses which running delays have elapsed at the next instant, from index `k` on. `caused` is true if one of the
    /// delays before index `k` was chosen as elapsed, so that the instant has a cause.
    void choose_elapsed(std::size_t k, const Zone& zone, bool caused) {
        if (check_.limit_ != Limit::None) return;
        if (k == running_.size()) return choose_inputs(0, zone, caused);
        const Running& running = running_[k];
        Zone running_on = zone;
        if (running_on.constrain(now_, running.start, running.duration - 1)) choose_elapsed(k + 1, running_on, caused);
        Zone over = zone;
        if (!over.constrain(running.start, now_, -running.duration)) return;
        std::vector<bool>& flags = running.is_fall ? fall_over_ : rise_over_;
        flags[running.element] = true;
        choose_elapsed(k + 1, over, true);
        flags[running.element] = false;
    }

    /// Chooses, for each input from signal `k` on, the number of its changes that the instant observes.
    void choose_inputs(std::size_t k, const Zone& zone, bool caused) {
        if (check_.limit_ != Limit::None) return;
        if (k == check_.signals_.size()) {
            if (caused) react(zone);
            return;
        }
        choose_inputs(k + 1, zone, caused);
        const Signal& signal = check_.signals_[k];
        if (!signal.input) return;
        Zone seen = zone;
        for (const Change* change = signal.at(used_[k]); change != nullptr; change = signal.at(used_[k])) {
            if (!seen.constrain(change->clock, now_, jitter_ - change->time)) break;
            ++used_[k];
            choose_inputs(k + 1, seen, true);
        }
        used_[k] = from_.used[k];
    }

    void react(const Zone& zone) {
        if (++check_.reactions_of_sample_ > most_reactions) check_.limit_ = Limit::Reactions;
        if (check_.reactions_of_sample_ % poll_interval == 0) check_.poll();
        Hypothesis next = from_;
        next.zone = zone;
        next.used = used_;
        for (std::size_t k = 0; k < used_.size(); ++k)
            if (check_.signals_[k].input && used_[k] != from_.used[k])
                next.inputs[check_.signals_[k].variable.index] = check_.signals_[k].at(used_[k] - 1)->value;
        const auto reaction = check_.reactions_.react(from_.state, next.inputs, rise_over_, fall_over_);
        if (!reaction->problem.empty()) return note_problem(zone, reaction->problem);
        next.state = reaction->after;
        for (std::size_t k = 0; k < check_.elements_.size(); ++k) {
            const Timing& timing = next.state->timing[k];
            if (reaction->rise_starts[k] || !rises(timing)) next.rise[k] = rises(timing) ? now_ : 0;
            if (reaction->fall_starts[k] || !falls(timing)) next.fall[k] = falls(timing) ? now_ : 0;
        }
        next.history = instant(next, reaction);
        write_outputs(0, std::move(next));
    }

    /// Notes a model error of the instant if each change that this instant does not observe can still be observed by a
    /// later instant.
    void note_problem(Zone zone, const std::string& problem) const {
        if (!check_.problem_.empty()) return;
        for (std::size_t k = 0; k < check_.signals_.size(); ++k)
            if (const Change* const unseen = check_.signals_[k].at(used_[k]);
                check_.signals_[k].input && unseen != nullptr)
                if (!zone.constrain(now_, unseen->clock, unseen->time + jitter_ - 1)) return;
        check_.problem_ = problem;
        check_.problem_time_ = time_of_instant(zone);
    }

    /// Matches the changes of the outputs at the instant `now_` with recorded changes, starting with signal `k`. Calls
    /// `finish` for each possible matching.
    void write_outputs(std::size_t k, Hypothesis next) {
        if (check_.limit_ != Limit::None) return;
        if (k == check_.signals_.size()) return finish(std::move(next));
        const Signal& signal = check_.signals_[k];
        const std::int64_t value = next.state->outputs[signal.variable.index];
        if (signal.input || value == from_.state->outputs[signal.variable.index])
            return write_outputs(k + 1, std::move(next));
        const std::size_t first = next.hidden[k] != 0 ? next.hidden[k] : now_;
        if (value == next.visible[k]) {  // the recording shows none of the changes since `first`
            next.hidden[k] = 0;
            return write_outputs(k + 1, std::move(next));
        }
        const Change* const recorded = signal.at(next.used[k]);
        if (recorded == nullptr || recorded->value != value) {
            next.hidden[k] = first;
            return write_outputs(k + 1, std::move(next));
        }
        Hypothesis hidden = next;
        hidden.hidden[k] = first;
        if (hidden.zone.constrain(first, recorded->clock, recorded->time - jitter_ - 1))
            write_outputs(k + 1, std::move(hidden));
        if (!next.zone.constrain(recorded->clock, first, jitter_ - recorded->time)) return;
        next.hidden[k] = 0;
        next.visible[k] = value;
        ++next.used[k];
        write_outputs(k + 1, std::move(next));
    }

    /// Keeps only the instants to which the hypothesis still refers, in a canonical order.
    void finish(Hypothesis next) {
        std::vector<std::size_t> kept = {0, now_};
        for (std::size_t k = 0; k < check_.settings_.clocks.size(); ++k) kept.push_back(first_clock + k);
        for (std::vector<std::size_t>* const list : {&next.rise, &next.fall, &next.hidden})
            for (std::size_t& variable : *list) {
                if (variable == 0) continue;
                const auto found = std::ranges::find(kept, variable);
                const auto place = static_cast<std::size_t>(found - kept.begin());
                if (found == kept.end()) kept.push_back(variable);
                variable = place;
            }
        next.zone = next.zone.projection(kept);
        std::vector<Ticks> typical;
        for (const std::size_t variable : kept)
            typical.push_back(variable == now_ ? next.history->time : from_.typical[variable]);
        next.typical = std::move(typical);
        successors_.push_back(std::move(next));
        continued_ = true;
        if (successors_.size() > most_successors) check_.limit_ = Limit::Orders;
    }

    std::shared_ptr<Instant> instant(const Hypothesis& next, const std::shared_ptr<const Reaction>& reaction) const {
        auto made = std::make_shared<Instant>();
        made->previous = from_.history;
        made->reaction = reaction;
        made->inputs = next.inputs;
        made->number = from_.history ? from_.history->number + 1 : 0;
        made->time = time_of_instant(next.zone);
        const std::uint64_t stored = check_.settings_.shown_instants;
        if (made->number % stored == 0) {
            Instant* oldest = made.get();
            for (std::uint64_t k = 0; k < stored && oldest != nullptr; ++k) oldest = oldest->previous.get();
            if (oldest != nullptr) oldest->previous.reset();
        }
        return made;
    }

    Ticks time_of_instant(const Zone& zone) const {
        return std::clamp(cause_time(zone), zone.lower(now_), zone.upper(now_));
    }

    /// Returns the time of the latest event that the instant observes, which is the time of the instant if the
    /// controller reacts immediately.
    Ticks cause_time(const Zone& zone) const {
        Ticks time = from_.history ? from_.typical[last] : check_.begin_;
        for (const Running& running : running_)
            if ((running.is_fall ? fall_over_ : rise_over_)[running.element])
                time = std::max(time, from_.typical[running.start] + running.duration);
        for (std::size_t k = 0; k < used_.size(); ++k)
            if (used_[k] != from_.used[k]) {
                const Change& change = *check_.signals_[k].at(used_[k] - 1);
                const Ticks earlier = std::clamp(Ticks{0}, zone.lower(change.clock), zone.upper(change.clock));
                time = std::max(time, change.time + earlier);
            }
        return time;
    }

    RecordingCheck& check_;
    const Hypothesis& from_;
    std::vector<Hypothesis>& successors_;
    Ticks jitter_;
    std::size_t now_ = 0;
    std::vector<Running> running_ = {};
    std::vector<bool> rise_over_ = {}, fall_over_ = {};
    std::vector<std::uint64_t> used_ = {};
    bool continued_ = false;
};

RecordingCheck::RecordingCheck(const Chart& chart, const std::vector<Id<Chart::Variable>>& outputs,
                               RecordingSettings settings)
    : source_(chart),
      settings_(settings),
      reactions_(chart, settings_.table_bytes),
      elements_(timed_elements(chart)),
      signal_of_(chart.variables.size()) {
    for (const Id<Chart::Variable> id : variables_of_kind(chart, Chart::VariableKind::Input))
        signals_.push_back({.variable = id, .input = true});
    for (const Id<Chart::Variable> id : outputs)
        signals_.push_back({.variable = id, .last = chart.variables[id].initial});
    for (std::size_t k = 0; k < signals_.size(); ++k) {
        const std::size_t variable = signals_[k].variable.index;
        signal_of_[variable] = k + 1;
        const std::size_t clock = settings_.clocks.empty() ? 0 : settings_.clock_of[variable];
        if (clock != 0) signals_[k].clock = first_clock + clock - 1;
    }
    for (const Ticks bound : settings_.clocks) largest_offset_ = std::max(largest_offset_, bound);
}

bool RecordingCheck::add(const RecordedSample& sample) {
    if (!begun_) begin(sample);
    else if (sample.time > now_) pass(sample.time);
    if (!hypotheses_.empty()) record(sample);
    return !hypotheses_.empty();
}

bool RecordingCheck::pass(Ticks time) {
    now_ = time;
    known_ = now_ - settings_.jitter - largest_offset_ - 1;
    if (!hypotheses_.empty()) advance();
    return !hypotheses_.empty();
}

void RecordingCheck::begin(const RecordedSample& sample) {
    begun_ = true;
    begin_ = now_ = sample.time;
    Hypothesis power_on{.state = reactions_.initial(), .inputs = std::vector<std::int64_t>(source_.variables.size())};
    for (const auto& [variable, value, line] : sample.values) {
        if (source_.variables[variable].kind != Chart::VariableKind::Input) continue;
        power_on.inputs[variable.index] = value;
        signals_[signal_of_[variable.index] - 1].last = value;
    }
    power_on.used.resize(signals_.size());
    for (const Signal& signal : signals_) power_on.visible.push_back(signal.last);
    power_on.hidden.resize(signals_.size());
    power_on.rise.resize(elements_.size());
    power_on.fall.resize(elements_.size());
    power_on.zone.assign(power_on.zone.add(), begin_ - settings_.jitter - 1);
    power_on.typical = {0, begin_};
    for (const Ticks bound : settings_.clocks) {
        const std::size_t clock = power_on.zone.add();
        [[maybe_unused]] const bool possible =
            power_on.zone.constrain(clock, 0, bound) && power_on.zone.constrain(0, clock, bound);
        assert(possible);
        power_on.typical.push_back(0);
    }
    hypotheses_ = {std::move(power_on)};
}

void RecordingCheck::record(const RecordedSample& sample) {
    lines_.emplace_back(sample.time, sample.line);
    for (const auto& [variable, value, line] : sample.values) {
        const std::size_t place = signal_of_[variable.index];
        if (place == 0 || signals_[place - 1].last == value) continue;
        Signal& signal = signals_[place - 1];
        signal.last = value;
        signal.changes.push_back({sample.time, value, line, sample.time == begin_ ? 0 : signal.clock});
    }
}

/// Expands the hypotheses, in the order of the number of their instants, until each of them needs further samples.
void RecordingCheck::advance() {
    std::vector<Hypothesis> waiting, open = std::move(hypotheses_);
    hypotheses_.clear();
    reactions_of_sample_ = 0;
    while (!open.empty()) {
        std::vector<Hypothesis> successors;
        for (Hypothesis& hypothesis : open) {
            switch (Expansion(*this, hypothesis, successors).run()) {
            case Expansion::Result::Waits: waiting.push_back(std::move(hypothesis)); break;
            case Expansion::Result::Ends: end(hypothesis); break;
            case Expansion::Result::Continues: break;
            }
            if (limit_ != Limit::None) return;
        }
        reduce(successors);
        open = std::move(successors);
        if (limit_ != Limit::None) return;
        if (open.size() + waiting.size() <= settings_.most_hypotheses) continue;
        reduce(waiting);
        if (open.size() + waiting.size() <= settings_.most_hypotheses) continue;
        limit_ = Limit::Orders;
        return;
    }
    reduce(waiting);
    if (waiting.size() > settings_.most_hypotheses) limit_ = Limit::Orders;
    if (limit_ != Limit::None) return;
    hypotheses_ = std::move(waiting);
    drop_used_changes();
}

/// Notes the output with which the hypothesis contradicts the recording, if this hypothesis explains a longer part of
/// the recording than all other hypotheses so far.
void RecordingCheck::end(const Hypothesis& hypothesis) {
    const Ticks jitter = settings_.jitter;
    const auto latest = [&](const Change& change) {
        return change.time + hypothesis.zone.upper(change.clock) + jitter;
    };
    // Earliest deadline of a delay or an input change. If this deadline precedes the deadline of the output, the output
    // does not end the hypothesis: another hypothesis observes the delay or input change together with an earlier
    // event.
    Ticks other = Zone::unbounded;
    for (std::size_t k = 0; k < elements_.size(); ++k) {
        const auto deadline = [&](std::size_t start, std::int64_t milliseconds) {
            if (start == 0) return;
            other = std::min(other, hypothesis.zone.upper(start) + milliseconds * settings_.ticks_per_ms + jitter);
        };
        deadline(hypothesis.rise[k], elements_[k].rise_ms);
        deadline(hypothesis.fall[k], elements_[k].fall_ms);
    }
    End end{.deadline = Zone::unbounded};
    for (std::size_t k = 0; k < signals_.size(); ++k) {
        const Change* const next = signals_[k].at(hypothesis.used[k]);
        if (signals_[k].input) {
            if (next != nullptr) other = std::min(other, latest(*next));
            continue;
        }
        const std::size_t hidden = hypothesis.hidden[k];
        if (hidden != 0 && hypothesis.zone.upper(hidden) + 2 * jitter < end.deadline)
            end = {hypothesis.zone.upper(hidden) + 2 * jitter, k, true, {}, {}};
        if (next != nullptr && latest(*next) < end.deadline) end = {latest(*next), k, false, {}, *next};
    }
    if (end.deadline == Zone::unbounded || (end_ && (other < end.deadline || end.deadline <= end_->deadline))) return;
    end.hypothesis = hypothesis;
    end_ = std::move(end);
}

std::optional<Zone> RecordingCheck::zone_of_next(const Hypothesis& from) const {
    const Ticks jitter = settings_.jitter;
    Zone zone = from.zone;
    const std::size_t now = zone.add();
    if (!zone.constrain(last, now, -1) || (!from.history && !zone.constrain(now, 0, begin_ + jitter))) return {};
    for (std::size_t k = 0; k < signals_.size(); ++k) {
        if (const Change* const next = signals_[k].at(from.used[k]); next != nullptr) {
            if (!zone.constrain(now, next->clock, next->time + jitter)) return {};
            if (next->clock != 0 && !zone.constrain(0, next->clock, next->time - begin_ - 1)) return {};
        }
        if (from.hidden[k] != 0 && !zone.constrain(now, from.hidden[k], 2 * jitter)) return {};
    }
    for (std::size_t k = 0; k < elements_.size(); ++k) {
        const auto latest = [&](std::size_t start, std::int64_t milliseconds) {
            return start == 0 || zone.constrain(now, start, milliseconds * settings_.ticks_per_ms + jitter);
        };
        if (!latest(from.rise[k], elements_[k].rise_ms) || !latest(from.fall[k], elements_[k].fall_ms)) return {};
    }
    return zone;
}

/// Removes the bounds of the last instant from the zone if they do not restrict the next instant.
void RecordingCheck::relax(Hypothesis& hypothesis) const {
    for (const auto* const list : {&hypothesis.rise, &hypothesis.fall, &hypothesis.hidden})
        if (std::ranges::find(*list, last) != list->end()) return;
    Ticks next = now_;
    for (std::size_t k = 0; k < signals_.size(); ++k) {
        if (!signals_[k].input) continue;
        const Change* const change = signals_[k].at(hypothesis.used[k]);
        const Ticks recorded = change != nullptr ? change->time : now_;
        const std::size_t clock = change != nullptr ? change->clock : signals_[k].clock;
        next = std::min(next, recorded + hypothesis.zone.lower(clock));
    }
    next -= settings_.jitter;
    // If the next instant observes a change of an input, it is not before `next`; otherwise, it observes that a delay
    // has elapsed after the last instant.
    if (hypothesis.zone.upper(last) < next) hypothesis.zone.assign(last, begin_ - settings_.jitter - 1);
}

void RecordingCheck::poll() {
    if (settings_.stopped && settings_.stopped()) limit_ = Limit::Stopped;
}

/// Joins with `hypothesis` each hypothesis at an index in `same` of `list` for which the union of the zones is a zone.
/// Removes the indices of the joined hypotheses from `same`, clears their `state`, and returns their number. The
/// history of `hypothesis` does not change: its run of the chart leads to the same state with the same changes.
std::size_t RecordingCheck::join(Hypothesis& hypothesis, std::vector<std::size_t>& same,
                                 std::vector<Hypothesis>& list) {
    const std::size_t before = same.size();
    for (std::size_t k = 0; k < same.size();) {
        auto zone = list[same[k]].zone.joined(hypothesis.zone);
        if (!zone) {
            ++k;
            continue;
        }
        hypothesis.zone = std::move(*zone);
        list[same[k]].state.reset();
        same.erase(same.begin() + static_cast<std::ptrdiff_t>(k));
        k = 0;
    }
    return before - same.size();
}

/// Removes each hypothesis whose timings are included in the timings of another hypothesis. Ends early if too many
/// hypotheses remain.
void RecordingCheck::reduce(std::vector<Hypothesis>& hypotheses) {
    if (hypotheses.size() < 2) return;
    std::unordered_map<std::string, std::vector<std::size_t>> kept;
    std::vector<Hypothesis> result;
    std::size_t joined = 0;  // number of elements of `result` that were joined with a later element
    for (Hypothesis& hypothesis : hypotheses) {
        if (hypothesis.history) relax(hypothesis);
        std::string key;
        append_number(key, reinterpret_cast<std::uintptr_t>(hypothesis.state.get()));
        for (const std::uint64_t position : hypothesis.used) append_number(key, position);
        for (const auto* const list : {&hypothesis.rise, &hypothesis.fall, &hypothesis.hidden})
            for (const std::size_t variable : *list) append_number(key, variable);
        std::vector<std::size_t>& same = kept[key];
        const auto is_known = [&](std::size_t other) { return result[other].zone.includes(hypothesis.zone); };
        if (std::ranges::any_of(same, is_known)) continue;
        if (!settings_.clocks.empty()) joined += join(hypothesis, same, result);
        same.push_back(result.size());
        result.push_back(std::move(hypothesis));
        if (result.size() - joined > settings_.most_hypotheses) break;
        if (result.size() % poll_interval == 0) poll();
        if (limit_ != Limit::None) break;
    }
    std::erase_if(result, [](const Hypothesis& hypothesis) { return hypothesis.state == nullptr; });
    hypotheses = std::move(result);
}

void RecordingCheck::drop_used_changes() {
    if (hypotheses_.empty()) return;
    while (lines_.size() > 1 && lines_[1].first < known_ - 4 * settings_.jitter - largest_offset_) lines_.pop_front();
    for (std::size_t k = 0; k < signals_.size(); ++k) {
        Signal& signal = signals_[k];
        if (signal.changes.empty()) continue;
        std::uint64_t used = hypotheses_.front().used[k];
        for (const Hypothesis& hypothesis : hypotheses_) used = std::min(used, hypothesis.used[k]);
        for (; signal.first < used; ++signal.first) signal.changes.pop_front();
    }
}

}  // namespace grafverif
