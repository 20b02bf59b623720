// SPDX-License-Identifier: MIT
// The general sequencer and the plant sequencer of WODES06, as variables of main: see together.hpp.
#pragma once

#include <vector>

#include "schedule/controller_instances.hpp"
#include "schedule/plant_instances.hpp"

namespace grafverif::schedule {

class Sequencer {
public:
    /// Adds its variables to main; they get their values in `run`.
    Sequencer(Assembly& assembly, PlantInstances& plant);

    Id<Expr> is(std::int64_t state);
    enum State : std::int64_t { Controllers, Controlled, InputsRead, Treatment, OutputsWritten, Test };

    /// What it tells the automata, once they are instances of main.
    Signals signals();
    /// The states in which properties are judged.
    Id<Expr> judged();
    /// The values of its variables. `controllers_settled`: their evolution is over after this step.
    void run(Id<Expr> controllers_settled);
    /// `plant_settles` and `controllers_settle`.
    void add_properties();

private:
    Id<Expr> moves(std::size_t process);
    void set(Id<Symbol> symbol, Id<Expr> initial, Id<Expr> next);

    Assembly& assembly_;
    PlantInstances& plant_;
    std::size_t processes_ = 0;
    Id<Symbol> state_ = {}, first_ = {}, changed_ = {}, move_ = {}, round_over_ = {}, in_round_ = {};
};

}  // namespace grafverif::schedule
