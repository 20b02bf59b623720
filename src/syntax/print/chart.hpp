// SPDX-License-Identifier: MIT
// The terms of a chart as the file would write them: `a && X2`, `3s/X2`.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/network.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

/// Writes the leaves of the chart's terms; the chart outlives it.
LeafPrinter leaf_printer(const Chart& chart);

std::string term_text(const Chart& chart, Id<Expr> term);

/// `3s/X2`, `2s/(a && b)/1s`: a time condition (IEC 60848, 4.4); `text` writes what it watches.
std::string time_text(const Chart& chart, const Chart::TimeCondition& time,
                      const std::function<std::string(Id<Expr>)>& text);
/// The same of a timer, `watched` as conditions write it.
std::string time_text(std::int64_t rise_ms, const std::string& watched, std::int64_t fall_ms);
/// What stands before the names of a controller's own things, where there are several: `press.`.
std::string prefix_of(const Network& network, const Network::Controller& controller);
/// A timer as conditions write it, index in `controller.timers`; of what is no name empty.
std::string time_text(const Network& network, const Network::Controller& controller, std::size_t timer);
/// Per process of the network what it is called: a timer as conditions write it, where that is a name; else its own name.
std::vector<std::string> told_names(const Network& network);
/// The same of what a property reads.
std::string time_text(const Chart& chart, const ClosedLoop::TimeSymbol& symbol);

}  // namespace grafverif
