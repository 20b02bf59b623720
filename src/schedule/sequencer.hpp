// SPDX-License-Identifier: MIT
// Represents the general sequencer and the plant sequencer of WODES06 by variables of main (see together.hpp).
#pragma once

#include "schedule/plant_instances.hpp"

namespace grafverif::schedule {

class Sequencer {
public:
    /// Adds the variables of the sequencer to main; `run` sets their values.
    Sequencer(Main& main, const Network& plant);

    Id<Expr> is(std::int64_t state) const { return main_.draft.is(state_, state); }
    enum State : std::int64_t { Controllers, Controlled, InputsRead, Treatment, OutputsWritten, Test };

    /// Returns the signals of the sequencer to the automata. Requires that the automata are instances of main.
    Signals signals(const PlantInstances& plant);
    /// Returns a condition that is true in states in which properties are evaluated.
    Id<Expr> considered() const;
    /// Sets the next values of the variables of the sequencer. The argument `signals` must be the result of the
    /// function `signals`. `controllers_settled` is true if the evolution of the controllers ends with this step.
    void run(const PlantInstances& plant, const Signals& signals, Id<Expr> controllers_settled);
    /// Adds the properties `plant_settles` and `controllers_settle`.
    void add_properties() const;

private:
    Id<Expr> moves(std::size_t process) const { return main_.draft.is(move_, static_cast<std::int64_t>(process)); }

    Main& main_;
    Id<Symbol> move_ = {}, state_ = {}, first_ = {}, changed_ = {};
};

}  // namespace grafverif::schedule
