// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "grafverif/ir/expr.hpp"

namespace grafverif {

/// What `t1/v/t2` (IEC 60848, 4.4) is, of `watched`, v, and `end`, whether its timer has ended; a time of 0 is not written. The end
/// is that of the level after the last cycle; an input may have changed it since, and an untimed model ends timers whether v is
/// true or not: without t2, v itself must be true now.
inline Id<Expr> time_condition(Exprs& exprs, std::int64_t rise_ms, Id<Expr> watched, std::int64_t fall_ms,
                               Id<Expr> end) {
    if (fall_ms == 0) return exprs.conjunction(watched, end);
    return rise_ms > 0 ? end : exprs.disjunction(watched, end);
}

}  // namespace grafverif
