// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "grafverif/ir/expr.hpp"

namespace grafverif {

/// Returns the value of `t1/v/t2` (IEC 60848) for the observed variable v (`watched`) and the output of its timer
/// (`end`). A time of 0 means that the condition omits this time. `end` is the output after the previous cycle; an
/// input may have changed since then. In an untimed model, timers expire independently of v; therefore, the condition
/// without t2 also requires that v is true.
inline Id<Expr> time_condition(Exprs& exprs, std::int64_t rise_ms, Id<Expr> watched, std::int64_t fall_ms,
                               Id<Expr> end) {
    if (fall_ms == 0) return exprs.conjunction(watched, end);
    return rise_ms > 0 ? end : exprs.disjunction(watched, end);
}

}  // namespace grafverif
