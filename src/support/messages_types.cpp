// SPDX-License-Identifier: MIT
// Texts of diagnostics about types and values.
#include <fmt/format.h>

#include "support/messages.hpp"
#include "support/wording.hpp"

namespace grafverif::messages {

Diagnostic duration_below(Span where, std::string_view op, std::string_view written) {
    return error("type-mismatch", where,
                 fmt::format("the operand of `{0}` is a duration, because `{0}` binds tighter than `/`; write "
                             "`{0}({1}/...)` with parentheses around the time condition",
                             op, written));
}

Diagnostic type_mismatch(Span where, std::string_view user, std::string_view expected, std::string_view found) {
    return error("type-mismatch", where, fmt::format("this is {}, but {} requires {}", found, user, expected));
}

Diagnostic missing_unit(Span where, std::string_view what) {
    return error("missing-unit", where,
                 fmt::format("{} has no unit; write `ms`, `s` or `min` after the number, as in `3s`", what));
}

Diagnostic division_by_zero(Span where) {
    return error("division-by-zero", where, "division by zero; change the divisor");
}

Diagnostic not_constant(Span where, std::string_view what) {
    return error("not-constant", where, fmt::format("{} must be constant; remove the variables", what));
}

Diagnostic reads_parameter(Span where, std::string_view what, std::string_view parameter) {
    return error(
        "not-constant", where,
        fmt::format("{} cannot depend on the parameter `{}`, which has a separate value in each instance; write a "
                    "number",
                    what, clipped(parameter)));
}

Diagnostic out_of_range(Span where, std::string_view variable, std::int64_t value, std::int64_t low,
                        std::int64_t high) {
    return error("out-of-range", where,
                 fmt::format("{} is outside the range {}..{} of `{}`; extend the range or change the value", value, low,
                             high, clipped(variable)));
}

Diagnostic unbounded_integer(Span where, std::string_view variable) {
    return error("unbounded-integer", where,
                 fmt::format("the integer `{0}` has no range; add one, as in `{0}: int 0..100`", clipped(variable)));
}

Diagnostic misplaced_type(Span where, std::string_view what) {
    return error("misplaced-type", where, std::string(what));
}

Diagnostic misplaced_value(Span where, std::string_view kind) {
    return error("misplaced-value", where,
                 fmt::format("an {} cannot have an initial value; remove it (the value at power-on is false or the "
                             "minimum of the range)",
                             kind));
}

Diagnostic zero_duration(Span where) {
    return error("zero-duration", where, "the duration is zero or negative; write a duration above zero");
}

Diagnostic bad_count(Span where, std::int64_t count, std::int64_t greatest) {
    if (count == 0) return error("bad-count", where, "the count is 0; write `never p` with the same scope");
    return error(
        "bad-count", where,
        fmt::format("the count is {1}, but at most {0} is supported; write a number from 1 to {0}", greatest, count));
}

Diagnostic missing_count(Span where) {
    return error("missing-count", where,
                 "the count is missing; write a number before `times`, as in `p at most 2 times`");
}

}  // namespace grafverif::messages
