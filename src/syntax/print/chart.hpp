// SPDX-License-Identifier: MIT
// Prints the terms of a chart in the notation of the input language: `a && X2`, `3s/X2`.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/network.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

/// Returns a function that prints the leaves of the chart's terms (variables, steps and time conditions). `chart` must
/// outlive the result.
LeafPrinter leaf_printer(const Chart& chart);

std::string term_text(const Chart& chart, Id<Expr> term);

/// Returns a time condition (IEC 60848) such as `3s/X2` or `2s/(a && b)/1s`. `text` returns the text of the observed
/// term.
std::string time_text(const Chart& chart, const Chart::TimeCondition& time,
                      const std::function<std::string(Id<Expr>)>& text);
/// Returns the time condition of a timer as text. `watched` is the text of the observed term in the notation of
/// conditions.
std::string time_text(std::int64_t rise_ms, const std::string& watched, std::int64_t fall_ms);
/// Returns the prefix that qualifies the names of a controller, such as `press.`; empty if there is only one
/// controller.
std::string prefix_of(const Network& network, const Network::Controller& controller);
/// Returns the text of the time condition of a timer, or an empty string if the timer observes a term without a name.
/// `timer` is the index in `controller.timers`.
std::string time_text(const Network& network, const Network::Controller& controller, std::size_t timer);
/// Returns the displayed name of each process of the network. For a timer whose observed term has a name, the displayed
/// name is the condition of the timer; for any other process, it is the name of the process.
std::vector<std::string> display_names(const Network& network);
/// Returns the text of a time condition that a property reads.
std::string time_text(const Chart& chart, const ClosedLoop::TimeSymbol& symbol);

}  // namespace grafverif
