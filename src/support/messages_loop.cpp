// SPDX-License-Identifier: MIT
// Texts of diagnostics about closed loops.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "support/messages.hpp"
#include "support/messages_choice.hpp"
#include "support/messages_fault.hpp"
#include "support/wording.hpp"

namespace grafverif::messages {

Diagnostic missing_argument(Span where, std::string_view component, std::string_view parameter,
                            std::string_view example) {
    return error("missing-argument", where,
                 fmt::format("argument `{1}` of `{0}` is missing; write `{2} = {3}`", clipped(component),
                             clipped(parameter), clipped(parameter), example));
}

Diagnostic output_not_a_name(Span where, std::string_view parameter) {
    return error(
        "argument-not-a-name", where,
        fmt::format(
            "the output `{}` is bound to a term; bind it to a variable, and use the term where the variable is read",
            clipped(parameter)));
}

Diagnostic port_not_a_variable(Span where, std::string_view port) {
    return error("argument-not-a-name", where,
                 fmt::format("the port `{}` is bound to a term; bind it to a variable, and write the term in the chart",
                             clipped(port)));
}

Diagnostic bound_twice(Span where, std::string_view variable, std::string_view first, std::string_view second) {
    return error("duplicate-name", where,
                 fmt::format("`{0}` is bound to `{1}` and `{2}`; bind it to one port, and read this port in the chart",
                             clipped(variable), clipped(first), clipped(second)));
}

Diagnostic partial_in_partial(Span where, std::string_view chart) {
    return error(
        "unsupported", where,
        fmt::format(
            "an instance of `{0}` cannot be a partial chart, because `{0}` contains partial charts; declare the "
            "instance as a controller of the closed loop",
            clipped(chart)));
}

Diagnostic no_signal(Span where, std::string_view name, std::string_view what) {
    return error("no-signal", where,
                 fmt::format("`{}` is {}, not a signal; bind the input to a controller input or output or to a plant "
                             "variable, or add an output to the chart",
                             clipped(name), what));
}

Diagnostic constant_without_value(Span where, std::string_view constant) {
    return error("constant-without-value", where,
                 fmt::format("the constant `{0}` has no value; write `{0} = VALUE`", clipped(constant)));
}

Diagnostic constant_below(Span where, std::string_view constant) {
    return error("constant-below", where,
                 fmt::format("`{}` is declared after its use; move its declaration up", clipped(constant)));
}

Diagnostic no_such_constant(Span loop, std::string_view loop_name, std::string_view name, std::string_view nearest) {
    const std::string advice = nearest.empty() ? fmt::format("declare it: `constant {} = VALUE;`", clipped(name))
                                               : fmt::format("did you mean `{}`?", clipped(nearest));
    return error(
        "no-such-choice", loop,
        fmt::format("the closed loop `{}` has no constant `{}`; {}", clipped(loop_name), clipped(name), advice));
}

Diagnostic bad_setting(Span where, std::string_view constant, std::string_view value, std::string_view kind) {
    const std::string_view example = kind == "a duration" ? "3s" : kind == "an integer" ? "4" : "true";
    return error("bad-setting", where,
                 fmt::format("the constant `{0}` is {1} and cannot be set to `{2}`; write `--set {0}={3}`",
                             clipped(constant), kind, clipped(value), example));
}

Diagnostic bad_values(Span where, std::string_view problem, std::string_view remedy) {
    return error("bad-setting", where, fmt::format("{}; {}", problem, remedy));
}

Diagnostic setting_out_of_range(Span where, std::string_view constant, std::string_view value, std::int64_t low,
                                std::int64_t high) {
    return error(
        "bad-setting", where,
        fmt::format("the constant `{}` has the range {}..{} and cannot be set to `{}`; choose a value in this range",
                    clipped(constant), low, high, clipped(value)));
}

Diagnostic missing_initially(Span where, std::string_view component, std::string_view locations) {
    return error(
        "missing-initially", where,
        fmt::format("`{}` has no initial location; write `initially` and one of {}", clipped(component), locations));
}

namespace {

/// Returns a name for an instance that drives a variable: `START_any`, `FULL_any[3]`.
std::string driver(std::string_view variable) {
    return std::string(variable).insert(std::min(variable.find('['), variable.size()), "_any");
}

}  // namespace

Diagnostic undriven_input(Span where, std::string_view input, std::string_view reader, bool boolean, Span loop) {
    const std::string cure =
        boolean
            ? fmt::format("environment {1} = free(OUT = {0});", clipped(input), clipped(driver(input)))
            : fmt::format("environment {1} = free_integer(OUT = {0}, ...);", clipped(input), clipped(driver(input)));
    Diagnostic diagnostic =
        error("undriven-input", where,
              fmt::format("the input `{}` of `{}` is not driven; write `{}`", clipped(input), clipped(reader), cure));
    if (!boolean) return diagnostic;
    const Span before_end = {loop.source, loop.end - 1, loop.end - 1};
    return with_fix(std::move(diagnostic), before_end,
                    fmt::format("    environment {1} = free(OUT = {0});\n", input, driver(input)));
}

Diagnostic undriven_variable(Span where, std::string_view variable, std::string_view suggestion) {
    std::string cure =
        fmt::format("write `environment {1} = free(OUT = {0});`", clipped(variable), clipped(driver(variable)));
    if (!suggestion.empty()) cure = fmt::format("did you mean `{}`?", clipped(suggestion));
    Diagnostic diagnostic =
        error("undriven-input", where, fmt::format("`{}` is not driven; {}", clipped(variable), cure));
    return suggestion.empty() ? diagnostic : with_fix(std::move(diagnostic), where, suggestion);
}

Diagnostic argument_type(Span where, std::string_view name, std::string_view found, std::string_view expected) {
    return error("type-mismatch", where, fmt::format("`{}` is {}; expected {}", clipped(name), found, expected));
}

Diagnostic range_mismatch(Span where, std::string_view name, std::int64_t low, std::int64_t high,
                          std::int64_t wanted_low, std::int64_t wanted_high) {
    return error("range-mismatch", where,
                 fmt::format("`{}` is written with values {}..{} and read with {}..{}; widen the range of the reader",
                             clipped(name), low, high, wanted_low, wanted_high));
}

Diagnostic no_controller(Span where, std::string_view loop) {
    return error("no-controller", where,
                 fmt::format("the closed loop `{}` has no controller; write `controller NAME;`", clipped(loop)));
}

Diagnostic clock_in_property(Span where, std::string_view clock) {
    return error("clock-in-property", where,
                 fmt::format("`{}` is a clock, which properties cannot read; read a location or a variable instead",
                             clipped(clock)));
}

Diagnostic place_outside_property(Span where) {
    return error("place-outside-property", where,
                 "the location test `in` is allowed only in properties; read an output of the instance instead");
}

Diagnostic unknown_time(Span where, const std::vector<std::string>& waited) {
    constexpr std::string_view why = "no chart has this time condition";
    if (!waited.empty())
        return error("unknown-time", where,
                     fmt::format("{}; use one that the charts have for this term: {}", why,
                                 clipped(fmt::format("{}", fmt::join(waited, ", ")))));
    return error(
        "unknown-time", where,
        fmt::format("{}; use a timed pattern: `p holds for 3s`, `q at most 3s since p` or `p leads to q within 3s`",
                    why));
}

Diagnostic ambiguous_time(Span where, std::string_view first, std::string_view second) {
    return error("ambiguous-time", where,
                 fmt::format("`{}` and `{}` have separate timers for this time condition; read a step or an output of "
                             "one of them instead",
                             clipped(first), clipped(second)));
}

Diagnostic declared_twice(Span where, std::string_view what) {
    return error("declared-twice", where,
                 fmt::format("the closed loop declares its {} twice; remove one declaration", what));
}

Diagnostic constraint_reads(Span where, std::string_view name, std::string_view what) {
    return error(
        "constraint-not-input", where,
        fmt::format("`{}` is not {} and cannot occur in a constraint; state a property instead", clipped(name), what));
}

Diagnostic observer_blocks(Span where, std::string_view observer) {
    return error(
        "observer-blocks", where,
        fmt::format("an invariant of the observer `{}` would block the observed system; remove it", clipped(observer)));
}

Diagnostic observer_acts(Span where, std::string_view observer) {
    return error("observer-acts", where,
                 fmt::format("an assignment of the observer `{}` would change the observed system; remove it, and read "
                             "the locations of the observer in properties",
                             clipped(observer)));
}

Diagnostic bad_formula(Span where, std::string_view language, std::string_view what) {
    return error("bad-formula", where, fmt::format("not a valid {} formula: {}", language, what));
}

Diagnostic formula_at_stable(Span where) {
    return error("bad-formula", where,
                 "`at stable` is not allowed for a formula, which is copied unchanged into models; remove `at stable`");
}

Diagnostic observer_without_start(Span where, std::string_view observer) {
    return error(
        "no-initial-location", where,
        fmt::format("the observer `{}` has no initial location; add `initial location NAME;`", clipped(observer)));
}

Diagnostic constraints_contradict(Span where, std::string_view constraint, bool decided) {
    return error("constraints-contradict", where,
                 fmt::format("{} satisfy `{}` together with the constraints before it, so the model {} have no "
                             "state; correct one of them",
                             decided ? "no input values" : "within the memory limit, no input values were found that",
                             clipped(constraint), decided ? "would" : "may"));
}

Diagnostic too_wide(Span where, std::string_view variable, std::int64_t values, std::int64_t most) {
    return error(
        "too-wide", where,
        fmt::format(
            "`{}` has {} values, but a symbolic model supports at most {}; reduce its range or use a coarser unit",
            clipped(variable), values, most));
}

Diagnostic fault_lacks_output(Span where, std::string_view fault, std::string_view component, std::string_view variable,
                              std::string_view instance) {
    return error(
        "fault-output", where,
        fmt::format("the fault `{0}` does not write `{2}`, which `{3}` writes; add an output to `{1}` and bind "
                    "it to `{2}`",
                    clipped(fault), clipped(component), clipped(variable), clipped(instance)));
}

Diagnostic fault_writes_other(Span where, std::string_view fault, std::string_view output, std::string_view instance) {
    return error("fault-output", where,
                 fmt::format("the output `{1}` of the fault `{0}` is not bound to an output of `{2}`; bind it to a "
                             "variable that `{2}` writes",
                             clipped(fault), clipped(output), clipped(instance)));
}

Diagnostic fault_type(Span where, std::string_view fault, std::string_view variable, std::string_view type,
                      std::string_view wanted) {
    return error("fault-output", where,
                 fmt::format("`{1}` has the type `{2}` in the fault `{0}`, but `{3}` without the fault; declare the "
                             "same type",
                             clipped(fault), clipped(variable), type, wanted));
}

Diagnostic fault_cannot_start(Span where, std::string_view fault, std::string_view location) {
    return error("fault-cannot-start", where,
                 fmt::format("the fault `{}` cannot occur, because the invariant of its initial location `{}` is false "
                             "when its clocks are 0; correct the invariant, or choose a location with `initially`",
                             clipped(fault), clipped(location)));
}

Diagnostic no_faults(Span loop, std::string_view name) {
    return error("no-faults", loop,
                 fmt::format("the closed loop `{}` declares no fault; write `fault NAME of INSTANCE: COMPONENT(...);`",
                             clipped(name)));
}

}  // namespace grafverif::messages
