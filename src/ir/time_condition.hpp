// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "grafverif/ir/expr.hpp"

namespace grafverif {

/// Returns the value of `t1/v/t2` (IEC 60848) for the observed variable v (`watched`) and the output of its timer
/// (`end`). If `rise_ms` or `fall_ms` is 0, the condition has no t1 or t2. `end` is the timer output for the value of v
/// after the previous cycle; if v reads an input, v may have changed since then. In an untimed model, timers may expire
/// independently of v; therefore, a condition without t2 also requires that v is true.
inline Id<Expr> time_condition(Exprs& exprs, std::int64_t rise_ms, Id<Expr> watched, std::int64_t fall_ms,
                               Id<Expr> end) {
    if (fall_ms == 0) return exprs.conjunction(watched, end);
    return rise_ms > 0 ? end : exprs.disjunction(watched, end);
}

}  // namespace grafverif
