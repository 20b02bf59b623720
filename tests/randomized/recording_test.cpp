// SPDX-License-Identifier: MIT
// Randomized tests: RecordingCheck accepts a recording if and only if it has an admissible timing, also with unknown
// offsets of clocks. An independent implementation executes the equations of the chart with concrete times. For short
// recordings, it tries all times and all orders, and checks the outputs by the definition. Long recordings are written
// with random delays.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "derive/derive.hpp"
#include "run/recording/recording_check.hpp"
#include "run/scanner.hpp"
#include "support/random_chart.hpp"
#include "support/run_equations.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

struct TimedValue {
    Ticks time = 0;
    std::int64_t value = 0;
};
/// Values of a variable: `value` applies from `time` on. The times of a recorded variable are distinct.
using History = std::vector<TimedValue>;

struct Recording {
    Ticks begin = 0, end = 0, jitter = 0;
    std::map<std::size_t, History> inputs = {}, outputs = {};  ///< by variable; the first entry is at `begin`
};

std::int64_t value_at(const History& history, Ticks time) {
    std::int64_t value = history.front().value;
    for (const TimedValue& entry : history)
        if (entry.time <= time) value = entry.value;
    return value;
}

/// Replaces durations by 1, 2, ... milliseconds.
Chart with_short_times(Chart chart) {
    const auto shorten = [](std::int64_t& duration) { duration = (duration + 499) / 500; };
    for (Chart::TimeCondition& timed : chart.time_conditions) {
        shorten(timed.rise_ms);
        shorten(timed.fall_ms);
    }
    for (Chart::ContinuousAction& action : chart.continuous) {
        shorten(action.delay_ms);
        shorten(action.limit_ms);
    }
    return chart;
}

/// True if `recorded` can be the recording of an output that the chart changes as in `changes`, up
/// to time `known`.
bool is_recordable(const History& recorded, const History& changes, std::int64_t initial, const Recording& recording,
                   Ticks known) {
    const Ticks last = known - recording.jitter;
    const auto agrees = [&](Ticks from, Ticks to, std::int64_t value) {
        for (Ticks time = std::max(from, recording.begin); time < to && time <= last; ++time)
            if (value_at(recorded, time) != value) return false;
        return true;
    };
    // Times at which the changes up to the current one can be recorded.
    std::vector<Ticks> possible = {recording.begin - 3 * recording.jitter - 1};
    std::int64_t value = initial;
    for (const TimedValue& change : changes) {
        std::vector<Ticks> next;
        for (Ticks time = change.time - recording.jitter; time <= change.time + recording.jitter; ++time)
            if (std::ranges::any_of(possible,
                                    [&](Ticks before) { return before <= time && agrees(before, time, value); }))
                next.push_back(time);
        possible = std::move(next);
        value = change.value;
    }
    return std::ranges::any_of(possible, [&](Ticks before) { return agrees(before, last + 1, value); });
}

/// The execution of the chart with a timing, up to an instant.
struct Execution {
    EquationsState state = {};
    Ticks last = 0;  ///< time of the last instant
    std::vector<std::int64_t> values = {};
    std::map<std::size_t, std::size_t> seen = {};  ///< for each input: number of observed entries
    std::map<std::size_t, History> changes = {};   ///< for each output
};

/// Executes the equations of a chart with concrete times.
class Timings {
public:
    Timings(const Chart& chart, const Equations& equations, const Recording& recording)
        : chart_(chart), equations_(equations), recording_(recording) {}

    Execution initial() const {
        Execution timing{.state = power_on(equations_),
                         .values = std::vector<std::int64_t>(equations_.variables.size())};
        for (const auto& [input, history] : recording_.inputs) {
            timing.values[input] = history.front().value;
            timing.seen[input] = 1;
        }
        for (const auto& [output, history] : recording_.outputs) timing.changes[output] = {};
        return timing;
    }

    /// True if a duration of a timer elapses after the last instant, up to `time - late`.
    bool elapses(const Execution& timing, Ticks time, Ticks late) const {
        if (!timing.state.started) return false;
        const Ticks passed = time - timing.last;
        std::size_t k = 0;
        for (const Equations::Timer& timer : equations_.timers) {
            const EquationsTiming& at = timing.state.timing[k++];
            for (const auto& [age, duration] :
                 {std::pair(at.risen, timer.rise_ms), std::pair(at.fallen, timer.fall_ms)})
                if (age >= 0 && age < duration && age + passed >= duration + late) return true;
        }
        return false;
    }

    /// Appends an instant that observes `seen`. Returns false if the cycle ends with a fault or never becomes stable.
    bool append(Execution& timing, Ticks time, const std::map<std::size_t, std::size_t>& seen) const {
        if (timing.state.started) timing.state = pass_time(std::move(timing.state), time - timing.last);
        timing.seen = seen;
        for (const auto& [input, count] : seen) timing.values[input] = recording_.inputs.at(input)[count - 1].value;
        const std::vector<std::int64_t> before = timing.state.started ? timing.state.outputs : initial_outputs();
        EquationsCycle result = cycle(equations_, timing.state, timing.values, ExecutionMode::StabilitySearch);
        if (result.race || result.conflict || result.no_value || result.out_of_range || result.endless) return false;
        timing.state = std::move(result.state);
        timing.last = time;
        for (auto& [output, changes] : timing.changes)
            if (timing.state.outputs[output] != before[output]) changes.push_back({time, timing.state.outputs[output]});
        return true;
    }

    std::vector<std::int64_t> initial_outputs() const {
        std::vector<std::int64_t> values;
        for (const Chart::Variable& variable : chart_.variables) values.push_back(variable.initial);
        return values;
    }

    bool are_recordable(const Execution& timing, Ticks known) const {
        return std::ranges::all_of(timing.changes, [&](const auto& entry) {
            return is_recordable(recording_.outputs.at(entry.first), entry.second,
                                 chart_.variables[{static_cast<std::uint32_t>(entry.first)}].initial, recording_,
                                 known);
        });
    }

    const Recording& recording() const { return recording_; }

private:
    const Chart& chart_;
    const Equations& equations_;
    const Recording& recording_;
};

/// Searches for an admissible timing by trying all of them.
class Search {
public:
    explicit Search(const Timings& timings) : timings_(timings), recording_(timings.recording()) {}

    bool found() { return explore(timings_.initial(), recording_.begin - recording_.jitter); }
    bool met_fault() const { return met_fault_; }
    bool is_too_long() const { return instants_ > 1'500; }

private:
    bool explore(const Execution& timing, Ticks time) {
        const Ticks known = recording_.end - recording_.jitter - 1;
        if (time > known) return timings_.are_recordable(timing, known);
        if (is_too_long() || !timings_.are_recordable(timing, time - 1)) return false;
        std::map<std::size_t, std::size_t> seen = timing.seen;
        if (is_in_time(timing, seen, time) && explore(timing, time + 1)) return true;
        return choose(timing, time, seen, seen.begin());
    }

    /// True if no instant is necessary at `time`.
    bool is_in_time(const Execution& timing, const std::map<std::size_t, std::size_t>& seen, Ticks time) const {
        if (!timing.state.started && time >= recording_.begin + recording_.jitter) return false;
        return inputs_in_time(seen, time) && !timings_.elapses(timing, time, recording_.jitter);
    }
    bool inputs_in_time(const std::map<std::size_t, std::size_t>& seen, Ticks time) const {
        return std::ranges::all_of(seen, [&](const auto& entry) {
            const History& history = recording_.inputs.at(entry.first);
            return entry.second == history.size() || history[entry.second].time + recording_.jitter > time;
        });
    }

    bool choose(const Execution& timing, Ticks time, std::map<std::size_t, std::size_t>& seen,
                std::map<std::size_t, std::size_t>::iterator input) {
        if (input == seen.end()) {
            const bool caused = !timing.state.started || seen != timing.seen || timings_.elapses(timing, time, 0);
            if (!caused || !inputs_in_time(seen, time)) return false;
            Execution next = timing;
            ++instants_;
            if (!timings_.append(next, time, seen)) return met_fault_ = true, false;
            return explore(next, time + 1);
        }
        const History& history = recording_.inputs.at(input->first);
        const std::size_t before = input->second;
        bool result = false;
        for (; !result; ++input->second) {
            const auto rest = std::next(input);
            result = choose(timing, time, seen, rest);
            if (input->second == history.size() || history[input->second].time - recording_.jitter > time) break;
        }
        input->second = before;
        return result;
    }

    const Timings& timings_;
    const Recording& recording_;
    bool met_fault_ = false;
    int instants_ = 0;
};

History random_history(const Chart::Variable& variable, Ticks begin, Ticks end, Ticks longest, Random& random) {
    const auto value = [&] { return random_number(random, variable.type.low, variable.type.high); };
    History history = {{begin, value()}};
    for (Ticks time = begin + random_number(random, 1, longest); time < end; time += random_number(random, 1, longest))
        if (const std::int64_t next = value(); next != history.back().value) history.push_back({time, next});
    return history;
}

/// Chooses a random admissible timing, and records its outputs with random delays. Returns nothing if the chart has a
/// fault.
std::optional<Execution> random_timing(const Timings& timings, Random& random) {
    const Recording& recording = timings.recording();
    const auto delay = [&](Ticks least) { return random_number(random, least, recording.jitter); };
    std::map<std::size_t, std::vector<Ticks>> times;  // time at which the controller observes each change
    for (const auto& [input, history] : recording.inputs) {
        Ticks earliest = recording.begin - recording.jitter;
        for (const TimedValue& change : history)
            times[input].push_back(earliest = std::max(earliest, change.time + delay(-recording.jitter)));
    }
    Execution timing = timings.initial();
    Ticks power_on = recording.begin + delay(-recording.jitter), time = power_on;
    while (time < recording.end + recording.jitter) {
        std::map<std::size_t, std::size_t> seen = timing.seen;
        for (auto& [input, count] : seen)
            while (count < times[input].size() && times[input][count] <= time) ++count;
        if (!timings.append(timing, time, seen)) return {};
        Ticks next = recording.end + recording.jitter;
        for (const auto& [input, count] : seen)
            if (count < times[input].size()) next = std::min(next, times[input][count]);
        for (Ticks elapsed = time + 1; elapsed < next; ++elapsed)
            if (timings.elapses(timing, elapsed, 0)) next = std::min(next, elapsed + delay(0));
        time = std::max(next, time + 1);
    }
    return timing;
}

History recorded(const History& changes, std::int64_t initial, const Recording& recording, Random& random) {
    History history = {{recording.begin, initial}};
    Ticks earliest = recording.begin - 2 * recording.jitter;
    for (const TimedValue& change : changes) {
        earliest = std::max(earliest, change.time + random_number(random, -recording.jitter, recording.jitter));
        if (earliest > recording.begin && earliest > history.back().time) history.push_back({earliest, change.value});
        else history.back().value = change.value;
    }
    return history;
}

/// Changes one recorded output at random.
void damage(std::map<std::size_t, History>& outputs, const Chart& chart, Random& random) {
    auto output = outputs.begin();
    std::advance(output, random_number(random, 0, static_cast<std::int64_t>(outputs.size()) - 1));
    History& history = output->second;
    const Type type = chart.variables[{static_cast<std::uint32_t>(output->first)}].type;
    const auto place =
        static_cast<std::size_t>(random_number(random, 0, static_cast<std::int64_t>(history.size()) - 1));
    if (chance(random, 30)) history[place].value = random_number(random, type.low, type.high);
    else if (place > 0 && chance(random, 30)) history.erase(history.begin() + static_cast<std::ptrdiff_t>(place));
    else if (place > 0) {
        const Ticks latest = place + 1 < history.size() ? history[place + 1].time - 1 : history[place].time + 4;
        history[place].time = random_number(random, history[place - 1].time + 1, latest);
    }
}

RecordingVerdict checked(const Chart& chart, const Recording& recording, RecordingSettings settings = {}) {
    std::vector<Id<Chart::Variable>> outputs;
    for (const auto& [output, history] : recording.outputs) outputs.push_back({static_cast<std::uint32_t>(output)});
    settings.jitter = recording.jitter;
    settings.ticks_per_ms = 1;
    RecordingCheck check(chart, outputs, settings);
    for (Ticks time = recording.begin; time <= recording.end; ++time) {
        RecordedSample sample{time, static_cast<std::uint64_t>(time), {}};
        for (const auto* const variables : {&recording.inputs, &recording.outputs})
            for (const auto& [variable, history] : *variables)
                if (time == recording.begin || value_at(history, time) != value_at(history, time - 1))
                    sample.values.push_back(
                        {{static_cast<std::uint32_t>(variable)}, value_at(history, time), sample.line});
        if (sample.values.empty() && time < recording.end) continue;
        if (!check.add(sample)) break;
    }
    return check.verdict();
}

std::string text_of(const RecordingVerdict& verdict) {
    std::ostringstream out;
    out << word(verdict.kind) << ' ' << verdict.reason << '\n';
    if (const auto& end = verdict.deviation) {
        out << end->output << " at " << end->time_us << " us is " << end->recorded << ", allowed " << end->allowed
            << " in " << end->situation << '\n';
        for (const ChartRun::Event& event : verdict.run.moments) {
            out << "instant at " << event.after.time_ms << ':';
            for (const std::int64_t value : event.after.values) out << ' ' << value;
            out << '\n';
        }
    }
    return std::move(out).str();
}

std::string text_of(const Recording& recording) {
    std::ostringstream out;
    out << "jitter " << recording.jitter << ", " << recording.begin << " to " << recording.end << '\n';
    for (const auto* const variables : {&recording.inputs, &recording.outputs})
        for (const auto& [variable, history] : *variables) {
            out << "variable " << variable << ':';
            for (const TimedValue& entry : history) out << ' ' << entry.time << '=' << entry.value;
            out << '\n';
        }
    return std::move(out).str();
}

struct Case {
    Chart chart = {};
    Equations equations = {};
    Recording recording = {};
};

/// Returns a chart with the inputs of a recording, or nothing if derive rejects the chart.
std::optional<Case> random_case(Random& random, Ticks jitter, Ticks length, Ticks longest) {
    Case made{.chart = random_chart(random)};
    if (length < 100) made.chart = with_short_times(std::move(made.chart));
    Diagnostics diagnostics;
    auto equations = derive(made.chart, diagnostics);
    if (!equations) return {};
    made.equations = std::move(*equations);
    made.recording = {.begin = 10, .end = 10 + length, .jitter = jitter};
    for (const Id<Chart::Variable> id : variables_of_kind(made.chart, Chart::VariableKind::Input))
        made.recording.inputs[id.index] = random_history(made.chart.variables[id], 10, 10 + length, longest, random);
    for (const Id<Chart::Variable> id : variables_of_kind(made.chart, Chart::VariableKind::Output))
        made.recording.outputs[id.index] = {};
    return made;
}

bool record_outputs(Case& made, Random& random) {
    const auto timing = random_timing(Timings(made.chart, made.equations, made.recording), random);
    if (!timing || timing->changes.empty()) return false;
    for (const auto& [output, changes] : timing->changes)
        made.recording.outputs[output] = recorded(
            changes, made.chart.variables[{static_cast<std::uint32_t>(output)}].initial, made.recording, random);
    return true;
}

TEST(RandomizedRecording, ConformsIfAndOnlyIfATimingIsAdmissible) {
    int conforming = 0, deviating = 0, faults = 0, limited = 0;
    for (int seed = 1; seed <= test_size(6'000); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        auto made = random_case(random, random_number(random, 0, 2), 12, 9);
        if (!made || !record_outputs(*made, random)) continue;
        const bool damaged = chance(random, 70);
        if (damaged) damage(made->recording.outputs, made->chart, random);
        const Timings timings(made->chart, made->equations, made->recording);
        Search search(timings);
        const bool expected = search.found();
        if (search.is_too_long()) continue;
        SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + text_of(made->recording) + chart_text(made->chart));
        // With a small `table_bytes`, tables are often cleared; this must not change the verdict.
        const std::size_t table_bytes = seed % 2 == 0 ? 1'000'000 : 10'000;
        const RecordingVerdict verdict =
            checked(made->chart, made->recording, {.most_hypotheses = 100'000, .table_bytes = table_bytes});
        EXPECT_TRUE(expected || damaged);
        if (verdict.reason.starts_with("too many orders")) {
            ++limited;
            continue;
        }
        if (verdict.kind == RecordingVerdict::Kind::Unknown) {
            EXPECT_TRUE(search.met_fault() && !expected) << verdict.reason;
            ++faults;
            continue;
        }
        EXPECT_EQ(verdict.kind == RecordingVerdict::Kind::Conforms, expected) << text_of(verdict);
        if (HasFailure()) return;
        ++(expected ? conforming : deviating);
    }
    EXPECT_GT(conforming, 1'000);
    EXPECT_GT(deviating, 200);
    EXPECT_GT(faults, 0);
    EXPECT_LE(limited, test_size(6'000) / 1'000);
}

TEST(RandomizedRecording, AcceptsLongRecordingsWithDelays) {
    int conforming = 0, changes = 0;
    for (int seed = 1; seed <= test_size(600); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        auto made = random_case(random, 20, 10'000, 600);
        if (!made || !record_outputs(*made, random)) continue;
        const RecordingVerdict verdict = checked(made->chart, made->recording);
        ASSERT_EQ(verdict.kind, RecordingVerdict::Kind::Conforms)
            << "seed " << seed << '\n'
            << text_of(verdict) << text_of(made->recording) << chart_text(made->chart);
        ++conforming;
        for (const auto& [output, history] : made->recording.outputs) changes += static_cast<int>(history.size()) - 1;
    }
    EXPECT_GT(conforming, 100);
    EXPECT_GT(changes, 400);
}

/// Clocks of a recording: for each clock, the bound of its offset, and for each variable, the index of its clock + 1.
struct Clocks {
    std::vector<Ticks> bounds = {};
    std::vector<std::size_t> clock_of = {};

    Ticks largest() const { return std::ranges::max(bounds); }
    Ticks offset(std::size_t variable, const std::vector<Ticks>& offsets) const {
        return clock_of[variable] == 0 ? 0 : offsets[clock_of[variable] - 1];
    }
};

Clocks random_clocks(const Chart& chart, std::size_t count, Ticks bound, Random& random) {
    Clocks clocks;
    for (std::size_t k = 0; k < count; ++k) clocks.bounds.push_back(random_number(random, 0, bound));
    for (std::size_t k = 0; k < chart.variables.size(); ++k)
        clocks.clock_of.push_back(static_cast<std::size_t>(random_number(random, 0, static_cast<std::int64_t>(count))));
    return clocks;
}

std::vector<Ticks> random_offsets(const Clocks& clocks, Random& random) {
    std::vector<Ticks> offsets;
    for (const Ticks bound : clocks.bounds) offsets.push_back(random_number(random, -bound, bound));
    return offsets;
}

/// Adds the offset of its clock, multiplied by `sign`, to the time of each change, and omits the changes after `end`.
/// Returns nothing if a change would not be after the first sample.
std::optional<Recording> shifted(Recording recording, const Clocks& clocks, const std::vector<Ticks>& offsets,
                                 Ticks sign, Ticks end) {
    recording.end = end;
    for (auto* const variables : {&recording.inputs, &recording.outputs})
        for (auto& [variable, history] : *variables) {
            const auto same = [](const TimedValue& one, const TimedValue& next) { return one.value == next.value; };
            history.erase(std::unique(history.begin(), history.end(), same), history.end());
            for (std::size_t k = 1; k < history.size(); ++k) history[k].time += sign * clocks.offset(variable, offsets);
            if (history.size() > 1 && history[1].time <= recording.begin) return {};
            std::erase_if(history, [&](const TimedValue& entry) { return entry.time > end; });
        }
    return recording;
}

/// Calls `use` with all offsets within the bounds.
void for_all_offsets(const Clocks& clocks, const auto& use) {
    std::vector<Ticks> offsets;
    for (const Ticks bound : clocks.bounds) offsets.push_back(-bound);
    while (true) {
        use(offsets);
        std::size_t k = 0;
        while (k < offsets.size() && offsets[k] == clocks.bounds[k]) {
            offsets[k] = -clocks.bounds[k];
            ++k;
        }
        if (k == offsets.size()) return;
        ++offsets[k];
    }
}

// Reference method: the test corrects the times of the recording by each possible combination of offsets, and checks
// the result without offsets. Only the part of the recording that all clocks cover is checked.
TEST(RandomizedRecording, HasTheVerdictOfTheBestClockOffsets) {
    int conforming = 0, deviating = 0, narrowed = 0, excluded = 0;
    for (int seed = 1; seed <= test_size(3'000); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        auto made = random_case(random, random_number(random, 0, 2), 24, 9);
        if (!made || !record_outputs(*made, random)) continue;
        const Clocks clocks =
            random_clocks(made->chart, static_cast<std::size_t>(random_number(random, 1, 2)), 3, random);
        const Ticks end = made->recording.end;
        auto recording = shifted(made->recording, clocks, random_offsets(clocks, random), 1, end);
        if (!recording) continue;
        if (chance(random, 60)) damage(recording->outputs, made->chart, random);
        SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + text_of(*recording) + chart_text(made->chart));
        const auto verdict_for = [&](const std::vector<Ticks>& offsets, Ticks until) {
            const auto corrected = shifted(*recording, clocks, offsets, -1, until);
            return corrected ? checked(made->chart, *corrected).kind : RecordingVerdict::Kind::Deviates;
        };
        const Ticks known = end - clocks.largest();
        std::vector<std::vector<Ticks>> possible;
        bool unknown = false;
        for_all_offsets(clocks, [&](const std::vector<Ticks>& offsets) {
            const RecordingVerdict::Kind kind = verdict_for(offsets, known);
            unknown = unknown || kind == RecordingVerdict::Kind::Unknown;
            if (kind == RecordingVerdict::Kind::Conforms) possible.push_back(offsets);
        });
        const RecordingVerdict verdict =
            checked(made->chart, *recording, {.clocks = clocks.bounds, .clock_of = clocks.clock_of});
        if (verdict.reason.starts_with("too many")) continue;
        EXPECT_EQ(verdict.kind == RecordingVerdict::Kind::Conforms, !possible.empty()) << text_of(verdict);
        EXPECT_TRUE(unknown || verdict.kind != RecordingVerdict::Kind::Unknown) << verdict.reason;
        for (std::size_t k = 0; k < verdict.offsets.size() && !possible.empty(); ++k) {
            const Ticks low = verdict.offsets[k].low_us / 1'000, high = verdict.offsets[k].high_us / 1'000;
            for (const std::vector<Ticks>& offsets : possible)
                EXPECT_TRUE(low <= offsets[k] && offsets[k] <= high) << low << ' ' << offsets[k] << ' ' << high;
            narrowed += high - low < 2 * clocks.bounds[k] ? 1 : 0;
            if (clocks.bounds.size() > 1) continue;
            // With an offset at either end of the range, the recording without its last part does
            // not deviate.
            for (const Ticks offset : {low, high})
                EXPECT_NE(verdict_for({offset}, known - 2 * clocks.largest()), RecordingVerdict::Kind::Deviates)
                    << offset;
            excluded += low > -clocks.bounds[k] && high < clocks.bounds[k] ? 1 : 0;
        }
        if (HasFailure()) return;
        ++(possible.empty() ? deviating : conforming);
    }
    EXPECT_GT(conforming, 200);
    EXPECT_GT(deviating, 100);
    EXPECT_GT(narrowed, 100);
    EXPECT_GT(excluded, 5);
}

TEST(RandomizedRecording, FindsTheClockOffsetsOfLongRecordings) {
    int conforming = 0, found = 0;
    for (int seed = 1; seed <= test_size(300); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        auto made = random_case(random, 20, 10'000, 600);
        if (!made || !record_outputs(*made, random)) continue;
        const Clocks clocks =
            random_clocks(made->chart, static_cast<std::size_t>(random_number(random, 1, 2)), 300, random);
        const std::vector<Ticks> offsets = random_offsets(clocks, random);
        const auto recording = shifted(made->recording, clocks, offsets, 1, made->recording.end);
        if (!recording) continue;
        const RecordingVerdict verdict =
            checked(made->chart, *recording, {.clocks = clocks.bounds, .clock_of = clocks.clock_of});
        ASSERT_EQ(verdict.kind, RecordingVerdict::Kind::Conforms)
            << "seed " << seed << '\n'
            << text_of(verdict) << text_of(*recording) << chart_text(made->chart);
        ++conforming;
        for (std::size_t k = 0; k < offsets.size(); ++k) {
            const ClockOffset& offset = verdict.offsets[k];
            EXPECT_TRUE(offset.low_us <= 1'000 * offsets[k] && 1'000 * offsets[k] <= offset.high_us) << seed;
            found += offset.high_us - offset.low_us <= 80'000 && clocks.bounds[k] > 40 ? 1 : 0;
        }
    }
    EXPECT_GT(conforming, 60);
    EXPECT_GT(found, 10);
}

TEST(RandomizedRecording, JoinsZonesIfAndOnlyIfTheirUnionIsAZone) {
    int joined = 0, separate = 0;
    for (int seed = 1; seed <= test_size(2'000); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const auto zone = [&]() -> std::optional<Zone> {
            Zone made;
            for (int k = 0; k < 2; ++k) {
                const std::size_t x = made.add();
                if (!made.constrain(x, 0, 3) || !made.constrain(0, x, 3)) return {};
            }
            for (int k = 0; k < 3; ++k) {
                const auto x = static_cast<std::size_t>(random_number(random, 0, 2));
                const auto y = static_cast<std::size_t>(random_number(random, 0, 2));
                if (x != y && !made.constrain(x, y, random_number(random, -2, 4))) return {};
            }
            return made;
        };
        const auto one = zone(), other = zone();
        if (!one || !other) continue;
        const auto united = one->joined(*other);
        bool equal = true;
        std::vector<std::pair<Ticks, Ticks>> in_union;
        const auto contains = [](const Zone& large, Ticks x, Ticks y) {
            Zone point;
            point.assign(point.add(), x);
            point.assign(point.add(), y);
            return large.includes(point);
        };
        for (Ticks x = -3; x <= 3; ++x)
            for (Ticks y = -3; y <= 3; ++y)
                if (contains(*one, x, y) || contains(*other, x, y)) in_union.emplace_back(x, y);
        const auto bound = [&](const auto& value) {
            Ticks most = -10;
            for (const auto& [x, y] : in_union) most = std::max(most, value(x, y));
            return most;
        };
        for (Ticks x = -3; x <= 3; ++x)
            for (Ticks y = -3; y <= 3; ++y) {
                const bool in_hull =
                    x <= bound([](Ticks a, Ticks) { return a; }) && -x <= bound([](Ticks a, Ticks) { return -a; }) &&
                    y <= bound([](Ticks, Ticks b) { return b; }) && -y <= bound([](Ticks, Ticks b) { return -b; }) &&
                    x - y <= bound([](Ticks a, Ticks b) { return a - b; }) &&
                    y - x <= bound([](Ticks a, Ticks b) { return b - a; });
                equal = equal && in_hull == (std::ranges::find(in_union, std::pair(x, y)) != in_union.end());
                EXPECT_TRUE(!united || contains(*united, x, y) == in_hull) << seed;
            }
        ASSERT_EQ(united.has_value(), equal) << "seed " << seed;
        ++(equal ? joined : separate);
    }
    EXPECT_GT(joined, 100);
    EXPECT_GT(separate, 100);
}

}  // namespace
}  // namespace grafverif
