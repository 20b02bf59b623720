// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "grafverif/ir/expr.hpp"

namespace grafverif {

/// Value of `t1/v/t2` (IEC 60848) for the observed variable v (`watched`) and the output of its timer (`end`); a
/// time of 0 is not written. `end` is the output after the last cycle; an input may have changed since. In an untimed
/// model, timers expire independently of v. Without t2, v itself must therefore be true now.
inline Id<Expr> time_condition(Exprs& exprs, std::int64_t rise_ms, Id<Expr> watched, std::int64_t fall_ms,
                               Id<Expr> end) {
    if (fall_ms == 0) return exprs.conjunction(watched, end);
    return rise_ms > 0 ? end : exprs.disjunction(watched, end);
}

}  // namespace grafverif
