// SPDX-License-Identifier: MIT
// Texts of diagnostics about charts.
#include <fmt/format.h>

#include "support/messages.hpp"
#include "support/messages_notation.hpp"
#include "support/wording.hpp"

namespace grafverif::messages {

Diagnostic empty_chart(Span where, std::string_view chart) {
    return error("empty-chart", where,
                 fmt::format("the chart `{}` has no step; write `initial step 0;`", clipped(chart)));
}

Diagnostic no_initial_step(Span where, std::string_view chart) {
    return error("no-initial-step", where,
                 fmt::format("`{}` has no initial step, and none of its steps can become active; mark a step `initial`",
                             clipped(chart)));
}

Diagnostic no_activation_link(Span where, std::string_view chart) {
    return error("no-activation-link", where,
                 fmt::format("`{}` is enclosed, but none of its steps has an activation link; mark a step `linked`",
                             clipped(chart)));
}

Diagnostic unreachable_step(Span where, std::string_view step, std::size_t others) {
    std::string message = fmt::format("no sequence of transitions activates step `{}`", clipped(step));
    if (others == 1) message += " or the step after it";
    if (others > 1) message += fmt::format(" or the {} steps linked to it", others);
    return warning("unreachable-step", where, message + "; link it to the rest of the chart");
}

Diagnostic missing_condition(Span where) {
    return error("missing-condition", where,
                 "this transition has no transition condition; write `when true` if it is always satisfied");
}

Diagnostic detached_transition(Span where) {
    return error("detached-transition", where,
                 "this transition has neither upstream nor downstream steps; add at least one");
}

Diagnostic step_twice(Span where, std::string_view step) {
    return error(
        "step-twice", where,
        fmt::format("step `{}` is listed twice on this side of the transition; remove one occurrence", clipped(step)));
}

Diagnostic step_of_other_chart(Span where, std::string_view step, std::string_view chart) {
    return error("step-of-other-chart", where,
                 fmt::format("step `{}` belongs to {}; link only steps of the same partial chart", clipped(step),
                             chart.empty() ? "the main part of the chart"
                                           : fmt::format("the partial chart `{}`", clipped(chart))));
}

Diagnostic not_an_output(Span where, std::string_view variable, std::string_view kind) {
    return error(
        "not-an-output", where,
        fmt::format("`{}` is an {} variable, not an output; use a stored action (`:=`)", clipped(variable), kind));
}

Diagnostic assigned_input(Span where, std::string_view variable) {
    return error("assigned-input", where,
                 fmt::format("`{}` is an input and cannot be assigned; assign an output or internal variable",
                             clipped(variable)));
}

Diagnostic continuous_and_stored(Span where, std::string_view output, Span other) {
    Diagnostic diagnostic =
        error("continuous-and-stored", where,
              fmt::format("`{}` has continuous and stored actions; use only one kind of action for each output",
                          clipped(output)));
    diagnostic.notes.push_back(note(other, "the action of the other kind is here"));
    return diagnostic;
}

Diagnostic missing_event(Span where) {
    return error("missing-event", where,
                 "the assignment has no event; append `on activation`, `on deactivation` or `on event ...`");
}

Diagnostic enclosing_cycle(Span where, std::string_view chart) {
    return error(
        "enclosing-cycle", where,
        fmt::format("`{0}` contains the step to which `{0}` belongs; remove the cyclic enclosure", clipped(chart)));
}

Diagnostic forcing_cycle(Span where, std::string_view chart) {
    return error("forcing-cycle", where,
                 fmt::format("this forcing order closes a cycle, because `{}` forces or encloses the partial chart of "
                             "the order; remove an order so that forcing is hierarchical",
                             clipped(chart)));
}

Diagnostic forced_twice(Span where, std::string_view chart, Span first) {
    Diagnostic diagnostic =
        error("forced-twice", where,
              fmt::format("`{}` is forced to two situations at the same time; remove one order", clipped(chart)));
    diagnostic.notes.push_back(note(first, "the other order is here"));
    return diagnostic;
}

Diagnostic forced_differently(Span where, std::string_view chart, Span first) {
    Diagnostic diagnostic = warning("forced-differently", where,
                                    fmt::format("two partial charts force `{}` to different situations; ensure that "
                                                "their orders are never active at the same time",
                                                clipped(chart)));
    diagnostic.notes.push_back(note(first, "the other order is here"));
    return diagnostic;
}

Diagnostic forced_beside(Span where, std::string_view expansion, std::string_view with, Span first) {
    Diagnostic diagnostic = error(
        "forced-twice", where,
        fmt::format("`{0}` is forced directly, and also as the expansion of a macro-step of `{1}`; remove one order",
                    clipped(expansion), clipped(with)));
    diagnostic.notes.push_back(note(first, "the other order is here"));
    return diagnostic;
}

Diagnostic edge_under_time(Span where) {
    return error(
        "edge-under-time", where,
        "an edge lasts for one evolution and has no duration; apply the time condition to the variable itself");
}

Diagnostic edge_of_edge(Span where) {
    return error("edge-of-edge", where, "an edge operator is applied to an edge; apply it to the variable itself");
}

Diagnostic edge_in_assignation(Span where, std::string_view output) {
    return error("edge-in-assignation", where,
                 fmt::format("the assignation condition of `{}` contains an edge, which is not a lasting state; store "
                             "the output `on event`, or remove the edge operator",
                             clipped(output)));
}

Diagnostic event_without_edge(Span where, std::string_view target) {
    return error("event-without-edge", where,
                 fmt::format("`{}` is assigned on an event that can be true without an edge; add `rise(...)` or "
                             "`fall(...)` to the event",
                             clipped(target)));
}

Diagnostic not_an_expansion(Span where, std::string_view chart) {
    return error("not-an-expansion", where,
                 fmt::format("`{0}` is a partial chart, not an expansion; write `expansion {0}`", clipped(chart)));
}

Diagnostic owned_twice(Span where, std::string_view chart, Span first) {
    Diagnostic diagnostic =
        error("owned-twice", where,
              fmt::format("`{}` already belongs to another step; use a separate partial chart for this step",
                          clipped(chart)));
    diagnostic.notes.push_back(note(first, "the other step is here"));
    return diagnostic;
}

Diagnostic unused_expansion(Span where, std::string_view chart) {
    return error(
        "unused-expansion", where,
        fmt::format("no macro-step has the expansion `{0}`; write `macro step ... expands {0};`", clipped(chart)));
}

Diagnostic entry_and_exit(Span where, std::string_view chart) {
    return error("entry-and-exit", where,
                 fmt::format("the expansion `{}` does not have exactly one entry step and one exit step; mark one step "
                             "`entry` and one `exit`",
                             clipped(chart)));
}

Diagnostic constraint_not_on_inputs(Span where, std::string_view other) {
    return error("constraint-not-on-inputs", where,
                 fmt::format("this constraint reads {}; use only inputs in a constraint", other));
}

Diagnostic misplaced_mark(Span where, std::string_view mark, std::string_view place) {
    return error("misplaced-mark", where, fmt::format("`{}` is not allowed here; it is valid only in {}", mark, place));
}

}  // namespace grafverif::messages
