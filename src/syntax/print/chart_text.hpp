// SPDX-License-Identifier: MIT
// Terms of a chart as our language writes them: `a && X2`, `3s/X2`.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "grafverif/ir/closed_loop.hpp"

namespace grafverif {

/// A variable, a step variable or a time condition.
void print_leaf(std::ostream& out, const Chart& chart, const Expr& leaf);

/// `3s/X2`, `2s/(a && b)/1s`: a time condition (IEC 60848, 4.4); `text` writes what it watches.
std::string time_text(const Chart& chart, const Chart::TimeCondition& time,
                      const std::function<std::string(Id<Expr>)>& text);
/// The same of a timer, `watched` as conditions write it.
std::string time_text(std::int64_t rise_ms, const std::string& watched, std::int64_t fall_ms);
/// The same of what a property reads.
std::string time_text(const Chart& chart, const ClosedLoop::TimeSymbol& symbol);

}  // namespace grafverif
