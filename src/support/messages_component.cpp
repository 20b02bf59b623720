// SPDX-License-Identifier: MIT
// Texts of diagnostics about components.
#include <fmt/format.h>

#include "support/messages.hpp"
#include "support/wording.hpp"

namespace grafverif::messages {

Diagnostic constant_cycle(Span where, std::string_view constant) {
    return error(
        "constant-cycle", where,
        fmt::format("the default value of `{}` depends on itself; remove the cyclic reference", clipped(constant)));
}

Diagnostic clock_not_conjunct(Span where) {
    return error("clock-not-conjunct", where,
                 "a clock comparison is an operand of an operator other than `&&`; write one edge for each case");
}

Diagnostic clock_compared_with_clock(Span where) {
    return error("clock-compared-with-clock", where,
                 "a clock is compared with another clock; compare it with a duration");
}

Diagnostic clock_not_equal(Span where) {
    return error("clock-not-equal", where, "`!=` is not allowed for clocks; write one edge with `<` and one with `>`");
}

Diagnostic clock_reset(Span where, std::string_view clock) {
    return with_fix(
        error("clock-reset", where,
              fmt::format("the clock `{0}` is set to a value other than 0; write `{0} := 0`", clipped(clock))),
        where, fmt::format("{} := 0", clock));
}

Diagnostic urgent_clock_guard(Span where) {
    return error(
        "urgent-clock-guard", where,
        "an urgent edge has a clock in its guard; make the edge `timed` and add an invariant to its source location");
}

Diagnostic lower_bound_invariant(Span where) {
    return error(
        "lower-bound-invariant", where,
        "an invariant must be an upper bound of a clock (`<=` or `<`); move all other conditions to the guards of "
        "the edges");
}

Diagnostic invariant_without_clock(Span where) {
    return error("invariant-without-clock", where,
                 "an invariant contains an operand that is not a comparison of a clock with a duration; move it to the "
                 "guards of the edges");
}

Diagnostic assigned_constant(Span where, std::string_view name, std::string_view kind) {
    return error("assigned-constant", where,
                 fmt::format("`{}` is {} and cannot be assigned; assign an output or a variable of the component",
                             clipped(name), kind));
}

Diagnostic assigned_twice(Span where, std::string_view name) {
    return error("assigned-twice", where,
                 fmt::format("`{}` is assigned twice here; remove one assignment", clipped(name)));
}

Diagnostic two_initial_locations(Span where, std::string_view component, Span first) {
    Diagnostic diagnostic = error(
        "two-initial-locations", where,
        fmt::format(
            "`{}` has a second initial location; keep one, and select another one for an instance with `initially`",
            clipped(component)));
    diagnostic.notes.push_back(note(first, "the first initial location is here"));
    return diagnostic;
}

Diagnostic empty_component(Span where, std::string_view component) {
    return error("empty-component", where,
                 fmt::format("the component `{}` has no location; write `initial location NAME;`", clipped(component)));
}

Diagnostic edge_outside_chart(Span where) {
    return error("edge-outside-chart", where,
                 "rising and falling edges are allowed only in charts; store the previous value in a variable");
}

}  // namespace grafverif::messages
