// SPDX-License-Identifier: MIT
// RecordingCheck: decides if a recording of inputs and outputs can be a recording of a chart (stability search).
//
// An admissible timing, with jitter J, consists of the instants at which the chart executes cycles, with at least one
// tick between them, such that:
//   power-on   the first instant is at most J before or after the first sample, which has the first values of inputs
//   inputs     each recorded change of an input at time t is observed by an instant in [t - J, t + J]. The changes of
//              one input are observed in their order. If an instant observes several changes of one input, it reads the
//              last value.
//              Changes of different inputs may be observed in any order
//   times      an instant observes that a delay T of the chart, which started at instant s, has elapsed if and only if
//              the instant is at or after s + T; at least one instant is in [s + T, s + T + J], unless the delay was
//              stopped before
//   outputs    each change of an output by an instant e is recorded at a time in [e - J, e + J]. The changes of one
//              output are recorded in their order. If several changes are recorded at the same time, only the last
//              value is visible. The resulting values are the recorded values of the output. Before the first sample,
//              the output has its initial value
// An instant reads the inputs once. If an instant has a model error (total instability, race, value out of range), the
// timing ends at this instant; if no other timing is admissible, the verdict is unknown. Each instant observes a change
// of an input, or that a delay has elapsed. The recording deviates from the chart if no admissible timing exists for
// any continuation after the last sample.
//
// The recorded times of some variables can be times of other clocks. Each other clock has a constant offset, which is
// unknown but bounded. A change that is recorded at time t of another clock occurred at time t - offset, which is after
// the first sample. The first sample contains the values of all variables at its time. Instants and delays are measured
// by the clock of the controller. A timing is admissible if it satisfies the conditions for some offsets within the
// bounds.
//
// Method: a hypothesis is a state of the chart, with a zone (bounds of differences) over the instants that matter for
// its future. All hypotheses together represent all admissible timings up to the current time. Each hypothesis is
// expanded as soon as the recording is known up to J after the next instant of the hypothesis. The zone also contains
// the negated offset of each clock. Thus the conditions for recorded times remain bounds of differences, and the check
// has the same precision for unknown offsets. To limit the number of hypotheses, hypotheses that differ only in their
// zones are joined if the union of the zones is a zone. If possible, a change of an output is assigned to the next
// recorded change of this output. The choice of the next recorded change excludes no admissible timing, because a later
// change of the output can be assigned to the same recorded change.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ir/recording.hpp"
#include "run/recording/reactions.hpp"
#include "run/recording/zone.hpp"

namespace grafverif {

struct RecordingSettings {
    Ticks jitter = 20'000;
    Ticks ticks_per_ms = 1'000;
    std::size_t most_hypotheses = 10'000;
    std::uint64_t shown_instants = printed_instants;   ///< minimum number of stored instants of a long timing
    std::size_t table_bytes = std::size_t{64} << 20U;  ///< approximate size of the tables of reactions
    std::function<bool()> stopped = {};                ///< returns true if the check must end; may be empty
    std::vector<Ticks> clocks = {};                    ///< for each further clock: maximum absolute value of its offset
    std::vector<std::size_t> clock_of = {};  ///< for each variable: index in `clocks` + 1, or 0; empty without clocks
};

struct RecordedValue {
    Id<Chart::Variable> variable = {};
    std::int64_t value = 0;
    std::uint64_t line = 0;
};

/// Values of chart variables that are recorded at the same time. The times of successive samples do not decrease.
struct RecordedSample {
    Ticks time = 0;
    std::uint64_t line = 0;
    std::vector<RecordedValue> values = {};
};

class RecordingCheck {
public:
    /// `outputs` are the recorded outputs. `chart` must outlive the check.
    RecordingCheck(const Chart& chart, const std::vector<Id<Chart::Variable>>& outputs, RecordingSettings settings);

    /// Adds a sample. The first sample has a value for each input and each recorded output. Returns false if the
    /// verdict is final.
    bool add(const RecordedSample& sample);
    /// Declares that all samples before `time` have been added, and continues the check as far as these samples
    /// determine it. Requires that at least one sample has been added. Returns false if the verdict is final.
    bool pass(Ticks time);

    /// Returns the verdict for the samples so far.
    RecordingVerdict verdict() const;

private:
    static constexpr std::size_t last = 1;         ///< variable of zones: the last instant
    static constexpr std::size_t first_clock = 2;  ///< variable of zones: the negated offset of the first clock

    struct Change {
        Ticks time = 0;
        std::int64_t value = 0;
        std::uint64_t line = 0;
        std::size_t clock = 0;  ///< variable of the zone whose value plus `time` is the time of the change
    };
    /// The recorded changes of a variable that at least one hypothesis has not used. Position 0 is the first change of
    /// the recording.
    struct Signal {
        Id<Chart::Variable> variable = {};
        bool input = false;
        std::size_t clock = 0;    ///< variable of the zone: the negated offset of the clock, or 0
        std::int64_t last = 0;    ///< value of the signal in the last sample
        std::uint64_t first = 0;  ///< position of the first stored change
        std::deque<Change> changes = {};

        const Change* at(std::uint64_t position) const {
            return position - first < changes.size() ? &changes[position - first] : nullptr;
        }
    };
    /// An instant of a timing, with a pointer to the previous instant if that instant is stored.
    struct Instant {
        std::shared_ptr<Instant> previous = {};
        std::shared_ptr<const Reaction> reaction = {};
        std::vector<std::int64_t> inputs = {};
        Ticks time = 0;  ///< time of the instant if the controller reacts immediately
        std::uint64_t number = 0;
    };
    struct Hypothesis {
        StatePointer state = {};
        std::vector<std::int64_t> inputs = {};   ///< for each variable: last value of an input that was read
        std::vector<std::uint64_t> used = {};    ///< for each signal: number of observed or explained changes
        std::vector<std::int64_t> visible = {};  ///< for each output signal: the recorded value after the used changes
        /// Zone over the instants; its first variables are `last` and the clocks.
        Zone zone = {};
        /// For each timed element: zone variable of the instant at which its rise time (fall time) started, or 0 if it
        /// is not running.
        std::vector<std::size_t> rise = {}, fall = {};
        /// For each output signal: zone variable of the first instant whose change of the output is not yet assigned to
        /// a recorded change, or 0 if there is no such instant.
        std::vector<std::size_t> hidden = {};
        std::vector<Ticks> typical = {};  ///< for each variable of the zone: time to print (see Instant::time)
        std::shared_ptr<Instant> history = {};
    };
    /// The end of the timing that agrees with the longest part of the recording.
    struct End {
        Ticks deadline = 0;
        std::size_t signal = 0;
        bool missing_change = false;
        Hypothesis hypothesis = {};
        Change change = {};
    };
    /// The limit that ended the check: the number of hypotheses (Orders), the number of reactions for one sample
    /// (Reactions), or a stop by the caller (Stopped).
    enum class Limit : std::uint8_t { None, Orders, Reactions, Stopped };
    class Expansion;

    void begin(const RecordedSample& sample);
    void record(const RecordedSample& sample);
    void advance();
    void end(const Hypothesis& hypothesis);
    /// Returns the zone with the next instant as its last variable, or nothing if the hypothesis has no successor.
    std::optional<Zone> zone_of_next(const Hypothesis& from) const;
    void relax(Hypothesis& hypothesis) const;
    void reduce(std::vector<Hypothesis>& hypotheses);
    static std::size_t join(Hypothesis& hypothesis, std::vector<std::size_t>& same, std::vector<Hypothesis>& list);
    void drop_used_changes();
    void poll();
    std::uint64_t line_at(Ticks time) const;
    std::int64_t microseconds(Ticks time) const;
    Deviation deviation() const;
    void add_run(const Hypothesis& hypothesis, RecordingVerdict& verdict) const;
    std::vector<ClockOffset> offsets() const;

    const Chart& source_;
    RecordingSettings settings_;
    Ticks largest_offset_ = 0;  ///< maximum absolute value of an offset
    Reactions reactions_;
    std::vector<TimedElement> elements_;
    std::vector<Signal> signals_ = {};
    /// For each variable: index in signals_ + 1, or 0 if the variable has no signal.
    std::vector<std::size_t> signal_of_ = {};
    std::vector<Hypothesis> hypotheses_ = {};
    std::deque<std::pair<Ticks, std::uint64_t>> lines_ = {};  ///< time and line of the last samples
    bool begun_ = false;
    Ticks begin_ = 0, now_ = 0;
    Ticks known_ = 0;  ///< instants up to this time can be expanded
    std::optional<End> end_ = {};
    std::string problem_ = {};  ///< the first fault of the chart in an admissible timing
    Ticks problem_time_ = 0;
    Limit limit_ = Limit::None;
    std::uint64_t reactions_of_sample_ = 0;
};

}  // namespace grafverif
