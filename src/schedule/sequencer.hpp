// SPDX-License-Identifier: MIT
// The general sequencer and the plant sequencer of WODES06, as variables of main (see together.hpp).
#pragma once

#include "schedule/plant_instances.hpp"

namespace grafverif::schedule {

class Sequencer {
public:
    /// Adds its variables to main; `run` sets their values.
    Sequencer(Main& main, const Network& plant);

    Id<Expr> is(std::int64_t state) const { return main_.draft.is(state_, state); }
    enum State : std::int64_t { Controllers, Controlled, InputsRead, Treatment, OutputsWritten, Test };

    /// Returns its signals to the automata. Requires that these are instances of main.
    Signals signals(const PlantInstances& plant);
    /// Returns the condition for states in which properties are evaluated.
    Id<Expr> judged() const;
    /// Sets its variables. `signals` is the result of `signals`. `controllers_settled` is true if the evolution of the
    /// controllers ends with this step.
    void run(const PlantInstances& plant, const Signals& signals, Id<Expr> controllers_settled);
    /// Adds `plant_settles` and `controllers_settle`.
    void add_properties() const;

private:
    Id<Expr> moves(std::size_t process) const { return main_.draft.is(move_, static_cast<std::int64_t>(process)); }

    Main& main_;
    Id<Symbol> move_ = {}, state_ = {}, first_ = {}, changed_ = {};
};

}  // namespace grafverif::schedule
