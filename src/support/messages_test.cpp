// SPDX-License-Identifier: MIT
// Texts of diagnostics about tests, test tables, recordings and Structured Text.
#include "support/messages.hpp"

#include <fmt/format.h>

#include "support/messages_choice.hpp"
#include "support/messages_log.hpp"
#include "support/wording.hpp"

namespace grafverif::messages {

Diagnostic not_in_structured_text(Span where, std::string_view what) {
    return error(
        "not-in-structured-text", where,
        fmt::format("{} cannot be translated to Structured Text with the same result on every PLC; rewrite it", what));
}

Diagnostic not_in_c(Span where, std::string_view what) {
    return error("not-in-c", where,
                 fmt::format("{} cannot be translated to C that has no undefined behaviour; rewrite it", what));
}

Diagnostic cannot_run(std::string_view command) {
    return error("cannot-run", {},
                 fmt::format("the shell cannot run `{}`; pass a command that starts the controller", command));
}

Diagnostic nothing_to_test(Span where, std::string_view chart, std::string_view what) {
    return error("nothing-to-test", where,
                 fmt::format("`{}` has no {} and cannot be tested; declare at least one", clipped(chart), what));
}

Diagnostic empty_test(Span where) {
    return error("bad-sequence", where, "the table has no test step; write one row of inputs and outputs per step");
}

Diagnostic unknown_column(Span where, std::string_view name, std::string_view chart) {
    return error("bad-sequence", where,
                 fmt::format("the column `{}` is neither an input nor an output of `{}`, nor one of `sequence`, "
                             "`step`, `wait`, `cycles`, `situation`; remove or rename it",
                             clipped(name), clipped(chart)));
}

Diagnostic missing_column(Span where, std::string_view kind, std::string_view name) {
    return error("bad-sequence", where,
                 fmt::format("the first row has no column for the {} `{}`; add it", kind, clipped(name)));
}

Diagnostic repeated_column(Span where, std::string_view name) {
    return error("bad-sequence", where, fmt::format("the column `{}` occurs twice; remove one", clipped(name)));
}

Diagnostic row_length(Span where, std::size_t found, std::size_t wanted) {
    return error("bad-sequence", where,
                 fmt::format("this row has {} field{}, but the first row has {}; add or remove fields", found,
                             found == 1 ? "" : "s", wanted));
}

Diagnostic bad_field(Span where, std::string_view problem) {
    return error("bad-sequence", where, std::string(problem));
}

Diagnostic misplaced_wait(Span where, bool first) {
    return error("bad-sequence", where,
                 first
                     ? "the first step of a sequence cannot wait, because it begins at power-on; remove `wait`"
                     : "a step with `wait` changes an input; wait in a separate row with the inputs of the row before");
}

Diagnostic misplaced_activation(Span where) {
    return error("bad-sequence", where,
                 "step 0 is misplaced or has other values than the scan that activates the initial steps; make it the "
                 "first row of its sequence, with one cycle and the inputs of step 1");
}

// -- recordings --

Diagnostic bad_log(Span where, std::string_view problem) { return error("bad-log", where, std::string(problem)); }

Diagnostic unrecorded_inputs(Span where, std::string_view chart, std::string_view names) {
    return error("unrecorded", where,
                 fmt::format("the log has no column for {} of `{}`; record each input, or pass `--map COLUMN=NAME`",
                             names, clipped(chart)));
}

Diagnostic no_recorded_output(Span where, std::string_view chart) {
    return error("unrecorded", where,
                 fmt::format("the log has no column for any output of `{}`; record at least one output, or pass "
                             "`--map COLUMN=NAME`",
                             clipped(chart)));
}

Diagnostic unrecorded_outputs(std::string_view chart, std::string_view names) {
    return warning(
        "unrecorded", {},
        fmt::format("the log has no column for {} of `{}`, which {} not checked; record each output, or pass "
                    "`--map COLUMN=NAME`",
                    names, clipped(chart), names.find(", ") == std::string_view::npos ? "is" : "are"));
}

Diagnostic ignored_columns(Span where, std::string_view names) {
    return note(
        where,
        fmt::format("columns ignored, because no checked chart has an input or output of the same name: {}", names));
}

// -- charts that cannot be compared --

Diagnostic not_in_both(Span where, std::string_view kind, std::string_view name, std::string_view owner) {
    return error("not-comparable", where,
                 fmt::format("the {} `{}` exists only in {}; compare charts with the same inputs and outputs", kind,
                             clipped(name), owner));
}

Diagnostic other_type(Span where, std::string_view kind, std::string_view name, std::string_view range,
                      std::string_view other) {
    return error(
        "not-comparable", where,
        fmt::format("the {} `{}` is {} here and {} in the other chart; compare charts with the same inputs and outputs",
                    kind, clipped(name), range, other));
}

Diagnostic not_comparable(Span where, std::string_view problem, std::string_view remedy) {
    return error("not-comparable", where, fmt::format("{}; {}", problem, remedy));
}

Diagnostic nothing_to_compare(Span where, std::string_view chart) {
    return error(
        "not-comparable", where,
        fmt::format("`{}` has no outputs and cannot be compared; declare at least one output", clipped(chart)));
}

Diagnostic no_such_beginning(Span where, std::string_view chart, std::string_view why) {
    return error("not-comparable", where,
                 fmt::format("`{}` cannot start in the situation of `--from-situation`: {}", clipped(chart), why));
}

Diagnostic coarse_resolution(std::string_view resolution, std::string_view duration, std::string_view divides_all) {
    return error("not-comparable", {},
                 fmt::format("`--resolution {}` does not divide `{}`; use `{}` or a divisor of it", resolution,
                             duration, divides_all));
}

}  // namespace grafverif::messages
