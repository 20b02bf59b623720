// SPDX-License-Identifier: MIT
// Reader: evaluates terms of a chart for one situation, the values of the variables, and the inputs of one evolution.
// Memory: the terms of a chart whose values must be stored for the next evolution.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "run/interpreter.hpp"

namespace grafverif {

/// The terms whose values an evolution must store for the next evolution. Only terms that the chart reads are included.
struct Memory {
    std::vector<Id<Expr>> edges = {};        ///< operands of edges, in order
    std::vector<std::uint32_t> places = {};  ///< for each term: index in `edges`; empty if no edges are read
    std::vector<bool> time_conditions = {};  ///< for each time condition: true if the chart reads it
};

Memory memory(const Chart& chart);

/// Evaluates terms. A continuous output that several conditions read is evaluated only once.
class Reader {
public:
    /// `timed` is the argument of evolve(). If `memory` is null, as in the first evolution, all edges are false.
    Reader(const Chart& chart, const State& state, InputValues inputs, const std::vector<bool>& timed,
           const Memory* memory)
        : chart_(chart), state_(state), inputs_(inputs), timed_(timed), memory_(memory) {}

    /// Returns the value of a term, or nothing if it is undefined.
    std::optional<std::int64_t> value(Id<Expr> term);
    /// Returns 1 if a continuous action currently sets `output`, 0 if no action sets it, or nothing if a condition is
    /// undefined.
    std::optional<std::int64_t> output(Id<Chart::Variable> output);
    /// True if an action stores values in `variable`.
    bool is_stored(Id<Chart::Variable> variable);

private:
    enum class Known : std::uint8_t { No, False, True, Undefined };

    std::int64_t leaf_value(const Expr& leaf);
    std::int64_t variable_value(Id<Chart::Variable> variable);
    std::int64_t edge_value(const Expr& edge);
    std::int64_t time_value(std::size_t index);
    std::optional<std::int64_t> look_up(Id<Chart::Variable> output);
    bool in_time(Id<Chart::ContinuousAction> action) const;
    void index_actions();

    const Chart& chart_;
    const State& state_;
    InputValues inputs_;
    const std::vector<bool>& timed_;
    const Memory* memory_;
    std::vector<Known> known_ = {};
    std::vector<bool> stored_ = {};
    std::vector<std::vector<Id<Chart::ContinuousAction>>> actions_ = {};
    std::vector<std::size_t> first_time_ = {};  ///< for each continuous action: index of its first element in `timed`
    bool undefined_ = false;                    ///< true if the current term reads an undefined value
};

}  // namespace grafverif
