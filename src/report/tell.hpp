// SPDX-License-Identifier: MIT
// tell: the rows of a ChartRun; a verb.
//
// What becomes what:
//   moment of an instance    a row of its own: the location reached, what changed in the plant
//   end of a timer           a row of its own; what else timers do is internal
//   acts of a controller     one row per search for stability in which a transition is cleared or an output changes;
//                            what does neither is internal. Of a run that counts steps, one row per evolution
//   delays in a row          one row
// Where the plant moves in the midst of a PLC cycle, the cycle is told in two rows, each at its place; where the plant
// then changes an input that has been sampled and matters, the sampling is a row.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/chart_run.hpp"
#include "grafverif/ir/network.hpp"
#include "ir/network_run.hpp"

namespace grafverif {

/// Whether the moves of the translation are told too, each as a row marked internal.
enum class Detail { Chart, Everything };

/// Tells a run while it happens.
class Teller {
public:
    /// `run` outlives the teller; it has no rows yet.
    Teller(ChartRun& run, Detail detail)
        : run_(run), detail_(detail), open_(run.controllers.size()), sampled_(run.controllers.size()) {}

    /// Tells the moments that are new.
    void catch_up();
    /// The same, and ends the rows that are still open.
    void flush();
    /// The run is over: a loop in which nothing was told is told here.
    void finish();

private:
    /// What a controller has done since its last row.
    struct Open {
        std::vector<std::vector<Id<ChartRun::Transition>>> fired = {};
        bool first = false;    ///< the first evolution is among it
        bool changed = false;  ///< an output or a stored variable has changed
        bool written = false;  ///< outputs have been written since the last evolution
    };

    void add(ChartRun::Row row, std::size_t moment);
    void close(std::size_t controller, std::size_t moment);
    void close_all(std::size_t moment);
    void close_delay();
    void begin_loop();
    void tell(std::size_t moment);
    void tell_instance(std::size_t moment);
    void tell_timer(std::size_t moment);
    void tell_act(std::size_t moment, const ChartRun::Act& act);
    void tell_phase(std::size_t moment, const ChartRun::Act& act);
    void tell_sampling(std::size_t moment);

    ChartRun& run_;
    Detail detail_;
    std::vector<Open> open_;     ///< per controller
    std::vector<bool> sampled_;  ///< per controller: it has sampled inputs on which transitions are to be cleared
    std::size_t next_ = 0;       ///< the moment to tell
    std::optional<std::size_t> delay_ = {};  ///< the last moment of a delay that is not yet told
    std::int64_t delay_ms_ = 0;
};

/// What `fire` would do in `state`, in the words of a row, inputs of the controllers included: `Start: START`.
std::string choice_words(const Network& network, const NetworkState& state, const Fire& fire);

/// The run with its rows. Requires one without.
ChartRun tell(ChartRun run, Detail detail = Detail::Chart);

}  // namespace grafverif
