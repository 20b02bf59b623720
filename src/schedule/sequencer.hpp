// SPDX-License-Identifier: MIT
// The general sequencer and the plant sequencer of WODES06, as variables of main: see together.hpp.
#pragma once

#include "schedule/plant_instances.hpp"

namespace grafverif::schedule {

class Sequencer {
public:
    /// Adds its variables to main; they get their values in `run`.
    Sequencer(Main& main, const Network& plant);

    Id<Expr> is(std::int64_t state) const { return main_.draft.is(state_, state); }
    enum State : std::int64_t { Controllers, Controlled, InputsRead, Treatment, OutputsWritten, Test };

    /// What it tells the automata, once they are instances of main.
    Signals signals(const PlantInstances& plant);
    /// The states in which properties are judged.
    Id<Expr> judged() const;
    /// The values of its variables. `signals`: what `signals` returned; `controllers_settled`: their evolution is over
    /// after this step.
    void run(const PlantInstances& plant, const Signals& signals, Id<Expr> controllers_settled);
    /// `plant_settles` and `controllers_settle`.
    void add_properties() const;

private:
    Id<Expr> moves(std::size_t process) const { return main_.draft.is(move_, static_cast<std::int64_t>(process)); }

    Main& main_;
    Id<Symbol> move_ = {}, state_ = {}, first_ = {}, changed_ = {};
};

}  // namespace grafverif::schedule
