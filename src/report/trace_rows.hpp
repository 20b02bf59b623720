// SPDX-License-Identifier: MIT
// Trace rows: groups the events of a ChartRun into the rows of a printed trace.
//
//   event of an instance     separate row with the location that the instance reaches, and changed plant variables
//   timer expiry             separate row; other timer events are internal
//   actions of a controller  one row per stability search that clears a transition or changes an output; other actions
//                            are internal. In a run that counts steps: one row per evolution
//   consecutive delays       one row
//
// If the plant moves during a PLC cycle, the cycle is split into two rows. If the plant changes an input of a
// controller after this controller has sampled its inputs and before it clears transitions, the sampling is a separate
// row.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/chart_run.hpp"
#include "grafverif/ir/network.hpp"
#include "ir/network_run.hpp"

namespace grafverif {

/// `Everything` also includes the internal events of the translation, each in a row that is marked as internal.
enum class Detail { Chart, Everything };

/// Builds the rows of a run while the run is being executed.
class TraceRowBuilder {
public:
    /// Requires a run without rows. `run` must outlive the object.
    TraceRowBuilder(ChartRun& run, Detail detail)
        : run_(run), detail_(detail), open_(run.controllers.size()), sampled_(run.controllers.size()) {}

    /// Adds rows for the events that were added to the run since the last call.
    void catch_up();
    /// Adds rows for the events that were added to the run since the last call, and completes open rows.
    void flush();
    /// Completes the rows at the end of the run. If the part of the run that repeats forever has no row, adds a row to
    /// this part.
    void finish();

private:
    /// The actions of a controller since its last row.
    struct OpenRow {
        std::vector<std::vector<Id<ChartRun::Transition>>> fired = {};
        bool first = false;    ///< true if the actions include the first evolution
        bool changed = false;  ///< true if an output or a stored variable has changed
        bool written = false;  ///< true if outputs have been written since the last evolution
    };

    void add(ChartRun::Row row, std::size_t moment);
    void close(std::size_t controller, std::size_t moment);
    void close_all(std::size_t moment);
    void close_delay();
    void begin_loop();
    void add_event(std::size_t moment);
    void add_instance_row(std::size_t moment);
    void add_timer_row(std::size_t moment);
    void add_act_rows(std::size_t moment, const ChartRun::Act& act);
    void report_phase(std::size_t moment, const ChartRun::Act& act);
    void add_sampling_row(std::size_t moment);

    ChartRun& run_;
    Detail detail_;
    std::vector<OpenRow> open_;  ///< the incomplete row of each controller
    /// For each controller: true if it has sampled its inputs for an evolution that will clear transitions.
    std::vector<bool> sampled_;
    std::size_t next_ = 0;                   ///< index of the next event without a row
    std::optional<std::size_t> delay_ = {};  ///< the last event of a delay for which no row has been added yet
    std::int64_t delay_ms_ = 0;
};

/// Returns the effect of `fire` in `state` as the text of a row, including inputs of the controllers: `Start: START`.
std::string choice_text(const Network& network, const NetworkState& state, const Fire& fire);

/// Returns the run with its rows. Requires a run without rows.
ChartRun with_rows(ChartRun run, Detail detail = Detail::Chart);

}  // namespace grafverif
