// SPDX-License-Identifier: MIT
// Reader: the values of terms of a chart over one situation, one set of variables and the inputs of one evolution.
// Memory: the terms of a chart whose past an evolution needs.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "run/interpreter.hpp"

namespace grafverif {

/// What an evolution must remember for the next one, of the terms that something of the chart reads.
struct Memory {
    std::vector<Id<Expr>> edges = {};        ///< operands of edges, in order
    std::vector<std::uint32_t> places = {};  ///< per term: its place in `edges`; empty where there are none
    std::vector<bool> time_conditions = {};  ///< per time condition: whether it is read
};

Memory memory(const Chart& chart);

/// Continuous outputs that conditions read are looked up once each.
class Reader {
public:
    /// `timed`: as in evolve(). Without `memory`, as in the first evolution, there are no edges.
    Reader(const Chart& chart, const State& state, InputValues inputs, const std::vector<bool>& timed,
           const Memory* memory)
        : chart_(chart), state_(state), inputs_(inputs), timed_(timed), memory_(memory) {}

    /// Empty where the term has no value.
    std::optional<std::int64_t> value(Id<Expr> term);
    /// Whether some action sets `output` now.
    std::optional<std::int64_t> output(Id<Chart::Variable> output);
    /// Whether an action stores values in `variable`.
    bool is_stored(Id<Chart::Variable> variable);

private:
    enum class Known : std::uint8_t { No, False, True, Lost };

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
    std::vector<std::size_t> first_time_ = {};  ///< per continuous action: its first element of `timed`
    bool lost_ = false;                         ///< something read by the term at hand has no value
};

}  // namespace grafverif
