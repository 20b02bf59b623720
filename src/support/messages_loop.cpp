// SPDX-License-Identifier: MIT
// Texts of diagnostics about closed loops.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "support/messages.hpp"
#include "support/messages_choice.hpp"
#include "support/wording.hpp"

namespace grafverif::messages {

Diagnostic missing_argument(Span where, std::string_view component, std::string_view parameter,
                            std::string_view example) {
    return error("missing-argument", where,
                 fmt::format("`{}` needs `{}`; write `{} = {}`", clipped(component), clipped(parameter),
                             clipped(parameter), example));
}

Diagnostic output_not_a_name(Span where, std::string_view parameter) {
    return error(
        "argument-not-a-name", where,
        fmt::format("`{}` is an output, which writes one variable; bind it to the name of a variable, and write "
                    "the term where that is read",
                    clipped(parameter)));
}

Diagnostic no_signal(Span where, std::string_view name, std::string_view what) {
    return error("no-signal", where,
                 fmt::format("`{}` is {}, no signal; an input reads inputs and outputs of controllers and what "
                             "instances write: let the chart put it out",
                             clipped(name), what));
}

Diagnostic constant_without_value(Span where, std::string_view constant) {
    return error("constant-without-value", where,
                 fmt::format("the constant `{0}` has no value; write `{0} = VALUE`", clipped(constant)));
}

Diagnostic constant_below(Span where, std::string_view constant) {
    return error("constant-below", where,
                 fmt::format("`{}` is declared further down; a constant reads those above it", clipped(constant)));
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
                 fmt::format("the constant `{0}` is {1}, and cannot be set to `{2}`; write `--set {0}={3}`",
                             clipped(constant), kind, clipped(value), example));
}

Diagnostic setting_out_of_range(Span where, std::string_view constant, std::string_view value, std::int64_t low,
                                std::int64_t high) {
    return error("bad-setting", where,
                 fmt::format("the constant `{}` has the range {}..{}, and cannot be set to `{}`", clipped(constant),
                             low, high, clipped(value)));
}

Diagnostic missing_initially(Span where, std::string_view component, std::string_view locations) {
    return error("missing-initially", where,
                 fmt::format("`{}` has no initial location of its own; write `initially` and one of {}",
                             clipped(component), locations));
}

Diagnostic undriven_input(Span where, std::string_view input, std::string_view reader, bool boolean, Span loop) {
    const std::string cure = boolean
                                 ? fmt::format("environment {0}_any = free(OUT = {0});", clipped(input))
                                 : fmt::format("environment {0}_any = free_integer(OUT = {0}, ...);", clipped(input));
    Diagnostic diagnostic =
        error("undriven-input", where,
              fmt::format("nothing drives the input `{}` of `{}`; write `{}`", clipped(input), clipped(reader), cure));
    if (!boolean) return diagnostic;
    const Span before_end = {loop.source, loop.end - 1, loop.end - 1};
    return with_fix(std::move(diagnostic), before_end,
                    fmt::format("    environment {0}_any = free(OUT = {0});\n", input));
}

Diagnostic undriven_variable(Span where, std::string_view variable, std::string_view suggestion) {
    std::string cure = fmt::format("write `environment {0}_any = free(OUT = {0});`", clipped(variable));
    if (!suggestion.empty()) cure = fmt::format("did you mean `{}`?", clipped(suggestion));
    Diagnostic diagnostic =
        error("undriven-input", where, fmt::format("nothing drives `{}`; {}", clipped(variable), cure));
    return suggestion.empty() ? diagnostic : with_fix(std::move(diagnostic), where, suggestion);
}

Diagnostic argument_type(Span where, std::string_view name, std::string_view found, std::string_view expected) {
    return error("type-mismatch", where,
                 fmt::format("`{}` is {}; {} is expected here", clipped(name), found, expected));
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
                 fmt::format("`{}` is a clock, which properties do not read; read a location or a variable instead",
                             clipped(clock)));
}

Diagnostic place_outside_property(Span where) {
    return error(
        "place-outside-property", where,
        "`in` asks where an instance of the plant is, and properties alone know that; read its outputs instead");
}

Diagnostic unknown_time(Span where, const std::vector<std::string>& waited) {
    constexpr std::string_view why = "a property reads the time conditions that its charts read";
    if (!waited.empty())
        return error(
            "unknown-time", where,
            fmt::format("{}, and of this one only with {}", why, clipped(fmt::format("{}", fmt::join(waited, ", ")))));
    return error("unknown-time", where,
                 fmt::format("{}, and none of them waits for this; `p holds for 3s`, `q at most 3s since p` and "
                             "`p leads to q within 3s` are properties with times of their own",
                             why));
}

Diagnostic ambiguous_time(Span where, std::string_view first, std::string_view second) {
    return error("ambiguous-time", where,
                 fmt::format("`{}` and `{}` both wait for this, each with a timer of its own; let the property read a "
                             "step or an output of the one that is meant",
                             clipped(first), clipped(second)));
}

Diagnostic declared_twice(Span where, std::string_view what) {
    return error("declared-twice", where, fmt::format("the loop says its {} twice; keep one", what));
}

Diagnostic constraint_reads(Span where, std::string_view name, std::string_view what) {
    return error("constraint-not-input", where,
                 fmt::format("`{}` is no {}, and a constraint is assumed of free inputs; state a property instead",
                             clipped(name), what));
}

Diagnostic observer_blocks(Span where, std::string_view observer) {
    return error(
        "observer-blocks", where,
        fmt::format("an invariant of `{}` would block the system that it watches; take it out", clipped(observer)));
}

Diagnostic observer_acts(Span where, std::string_view observer) {
    return error("observer-acts", where,
                 fmt::format("an assignment of `{}` would change the system that it watches; take it out, and let "
                             "properties read its locations",
                             clipped(observer)));
}

Diagnostic bad_formula(Span where, std::string_view language, std::string_view what) {
    return error("bad-formula", where, fmt::format("this is no formula of {}: {}", language, what));
}

Diagnostic formula_at_stable(Span where) {
    return error("bad-formula", where,
                 "a formula is passed through as it stands, in settled states and others; leave out `at stable`");
}

Diagnostic observer_without_start(Span where, std::string_view observer) {
    return error("no-initial-location", where,
                 fmt::format("the observer `{}` starts nowhere; write `initial location NAME;`", clipped(observer)));
}

Diagnostic constraints_contradict(Span where, std::string_view constraint, bool decided) {
    return error(
        "constraints-contradict", where,
        fmt::format("{} of the inputs that satisfy `{}` together with the constraints before it, so the model would "
                    "have no state; correct one of them",
                    decided ? "there are no values" : "no values were found in the memory allowed",
                    clipped(constraint)));
}

Diagnostic too_wide(Span where, std::string_view variable, std::int64_t values, std::int64_t most) {
    return error("too-wide", where,
                 fmt::format("`{}` has {} values, and a symbolic model takes {} at most; give it a narrower range or a "
                             "coarser unit",
                             clipped(variable), values, most));
}

}  // namespace grafverif::messages
