// SPDX-License-Identifier: MIT
#include "support/messages.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/messages_choice.hpp"
#include "support/wording.hpp"

namespace grafverif::messages {

namespace {

/// Returns a list such as `a`, `b`, `c`.
std::string listed(std::span<const std::string> names) {
    std::string text;
    for (const std::string& name : names) text += fmt::format("{}`{}`", text.empty() ? "" : ", ", name);
    return text;
}

}  // namespace

// -- the command line and files ------------------------------------------------------------------------------------

Diagnostic cannot_read(std::string_view path, std::string_view why) {
    return error("cannot-read", {}, fmt::format("cannot read `{}`: {}", path, why));
}

Diagnostic io_error(std::string_view what) { return error("cannot-write", {}, std::string(what)); }

Diagnostic cannot_listen(std::uint64_t port, std::string_view why) {
    const std::string where = port == 0 ? "on any port" : fmt::format("on port {}", port);
    return error("cannot-listen", {},
                 fmt::format("cannot listen {}: {}; select another port with `--port`", where, why));
}

Diagnostic output_is_input(std::string_view output, std::string_view input) {
    return error(
        "output-is-input", {},
        output == input
            ? fmt::format("`{}` is both input and output of this command; choose another output file", output)
            : fmt::format("output `{}` is the same file as input `{}`; choose another output file", output, input));
}

Diagnostic out_of_step() {
    return error("out-of-memory", {},
                 "out of memory, so the document differs from the editor's text; close the document and open it again");
}

Diagnostic no_state_file(std::string_view path) {
    return error("not-a-state-file", {},
                 fmt::format("`{}` exists and is not a state file of `mutate`; choose another file", path));
}

Diagnostic output_twice(std::string_view one, std::string_view other) {
    return error(
        "output-twice", {},
        one == other
            ? fmt::format("two outputs have the name `{}`; choose a different file for each", one)
            : fmt::format("the outputs `{}` and `{}` are the same file; choose a different file for each", one, other));
}

Diagnostic other_format(std::string_view path, std::string_view named, std::string_view written, std::string_view how) {
    return error("other-format", {}, fmt::format("`{}` would contain {}, not {}; {}", path, written, named, how));
}

Diagnostic missing_folder(std::string_view output, std::string_view folder) {
    return error("missing-folder", {},
                 output == folder
                     ? fmt::format("output folder `{}` does not exist; create it or pass `--create-dirs`", folder)
                     : fmt::format("the folder `{1}` of the output `{0}` does not exist; create it or pass "
                                   "`--create-dirs`",
                                   output, folder));
}

Diagnostic not_in_depfile(std::string_view name, std::string_view reader) {
    return error("not-in-depfile", {},
                 fmt::format("a depfile for {} cannot represent the file name `{}`; rename the file or select another "
                             "format with `--depfile-format`",
                             reader, name));
}

Diagnostic ablation_active(std::string_view cure) {
    return warning("cure-left-out", {},
                   fmt::format("`{}` is removed from the model, so verdicts do not apply to the chart; omit "
                               "`--ablate` to check the chart",
                               cure));
}

Diagnostic missing_program(std::string_view program, std::string_view instead) {
    return error(
        "missing-program", {},
        fmt::format("`{}` is not on the PATH; install it, or use the embedded engine: `{}`", program, instead));
}

Diagnostic no_closed_loop() {
    return error("no-closed-loop", {},
                 "the file has no closed loop; declare `closed_loop NAME { controller CHART; ... }`, or use a command "
                 "for charts: `plc` runs a chart, `check` checks a chart, `nusmv` writes a model of a chart");
}

Diagnostic no_such_choice(std::string_view kind, std::string_view name, std::span<const std::string> known,
                          std::string_view nearest) {
    const std::string advice =
        nearest.empty() ? "choose one of " + listed(known) : fmt::format("did you mean `{}`?", nearest);
    return error("no-such-choice", {},
                 known.empty() ? fmt::format("the file has no {}", kind)
                               : fmt::format("the file has no {} `{}`; {}", kind, name, advice));
}

Diagnostic no_such_choice(std::string_view kind, std::string_view name, std::span<const std::string> known) {
    return no_such_choice(kind, name, known, {});
}

Diagnostic ambiguous_choice(std::string_view kind, std::string_view option, std::span<const std::string> known) {
    if (known.empty()) return error("no-such-choice", {}, fmt::format("the file has no {}", kind));
    return error("ambiguous-choice", {},
                 fmt::format("the file has several {}s: {}; choose with `{}`", kind, listed(known), option));
}

Diagnostic beyond_32_bits(Span where, std::string_view what, std::string_view target) {
    return error(
        "beyond-32-bits", where,
        fmt::format(
            "{} may exceed 32 bits, and {} would silently compute a wrong value; reduce the ranges or constants", what,
            target));
}

Diagnostic not_expressible(Span property, std::string_view name, std::string_view target, std::string_view reason) {
    return warning("not-expressible", property,
                   fmt::format("property `{}` is omitted from the {} model; {}", name, target, reason));
}

// -- derive ----------------------------------------------------------------------------------------------------------

Diagnostic output_cycle(Span where, std::span<const std::string> outputs) {
    constexpr std::size_t shown = 6;
    std::string path;
    for (const std::string& output : outputs.first(std::min(shown, outputs.size())))
        path += fmt::format("`{}` reads ", output);
    if (outputs.size() > shown)
        path += fmt::format("{} more outputs, the last of which reads ", outputs.size() - shown);
    return error("output-cycle", where,
                 fmt::format("the output `{}` depends on itself ({}`{}`); remove one of these outputs from an "
                             "assignation condition, which is expanded with the equation of each output that it reads",
                             outputs.front(), path, outputs.front()));
}

Diagnostic term_too_large(Span where, std::string_view what, std::size_t limit) {
    return error("too-large", where,
                 fmt::format("the equation of {} has more than {} terms, because outputs in conditions are replaced by "
                             "their equations; read internal variables instead",
                             what, limit));
}

Diagnostic term_too_deep(Span where, std::string_view what, std::size_t limit) {
    return error("too-large", where,
                 fmt::format("the equation of {} is nested deeper than {} levels, because outputs in conditions are "
                             "replaced by their equations; read internal variables instead",
                             what, limit));
}

Diagnostic terms_too_large(Span where, std::string_view grafcet, std::size_t limit) {
    return error("too-large", where,
                 fmt::format("expanding the equations of `{}` adds more than {} terms; read fewer outputs in "
                             "conditions or store fewer different values",
                             grafcet, limit));
}

Diagnostic too_many_stored_values(Span where, std::string_view variable, std::size_t limit) {
    return error("too-large", where,
                 fmt::format("more than {} different values are stored in `{}`; reduce the number of actions on it",
                             limit, variable));
}

// -- plant and compose ------------------------------------------------------------------------------------------------

namespace {

/// Returns a duration in the notation of charts: `3s`, `250ms`.
std::string time_text(std::int64_t milliseconds) {
    if (milliseconds != 0 && milliseconds % 1000 == 0) return fmt::format("{}s", milliseconds / 1000);
    return fmt::format("{}ms", milliseconds);
}

}  // namespace

Diagnostic no_multiple_of_time_unit(Span where, std::int64_t milliseconds, std::int64_t unit_ms) {
    return error("no-multiple-of-time-unit", where,
                 fmt::format("`{}` is not a multiple of the time unit `{}`; remove `time unit` or choose a unit that "
                             "divides every duration",
                             time_text(milliseconds), time_text(unit_ms)));
}

Diagnostic duration_too_long(Span where, std::int64_t milliseconds, std::int64_t unit_ms) {
    return error("duration-too-long", where,
                 fmt::format("`{}` is {} time units of `{}`, which exceeds the range of model checkers; choose "
                             "durations with a larger common divisor",
                             time_text(milliseconds), milliseconds / unit_ms, time_text(unit_ms)));
}

Diagnostic many_time_units(Span where, std::int64_t milliseconds, std::int64_t unit_ms) {
    return warning("many-time-units", where,
                   fmt::format("`{}` is {} time units of `{}`, which slows down engines with integer time; choose "
                               "durations with a larger common divisor",
                               time_text(milliseconds), milliseconds / unit_ms, time_text(unit_ms)));
}

Diagnostic bad_task_cycle(Span where, std::int64_t least_ms, std::int64_t most_ms) {
    if (least_ms <= 0)
        return error("bad-task-cycle", where, "the task cycle is not above zero; write a duration such as `10ms`");
    return error("bad-task-cycle", where,
                 fmt::format("the range `{0}..{1}` of the task cycle is empty; write `every {1}..{0}`",
                             time_text(least_ms), time_text(most_ms)));
}

Diagnostic cycle_without_time(Span where, std::string_view controller) {
    return error("cycle-without-time", where,
                 fmt::format("`{}` has a task cycle, which this untimed model does not represent; pass `--plant "
                             "automata --schedule interleaved`, or pass `--cycle zero`",
                             controller));
}

Diagnostic no_value(Span where, std::string_view instance) {
    return error(
        "no-value", where,
        fmt::format("the value of `{}` at power-on cannot be computed; check for a division by zero", instance));
}

Diagnostic bad_range(Span where, std::string_view variable, std::int64_t low, std::int64_t high) {
    return error("bad-range", where,
                 fmt::format("the range {1}..{2} of `{0}` is empty or not within -32768..32767; correct its bounds",
                             variable, low, high));
}

Diagnostic initial_out_of_range(Span where, std::string_view variable, std::int64_t initial, std::int64_t low,
                                std::int64_t high) {
    return error(
        "initial-out-of-range", where,
        fmt::format(
            "the initial value {1} of `{0}` is outside its range {2}..{3}; extend the range or change the value",
            variable, initial, low, high));
}

Diagnostic second_writer(Span where, std::string_view variable, std::string_view first, std::string_view second) {
    return error("two-writers", where,
                 fmt::format("`{}` is assigned by `{}` and by `{}`; assign each shared variable in one place only",
                             variable, first, second));
}

Diagnostic urgent_invariant(Span where, std::string_view component, std::string_view location) {
    return error(
        "urgent-invariant", where,
        fmt::format("the invariant of the target location `{}` can be violated when this urgent edge of `{}` is taken; "
                    "reset the clock of the invariant on this edge, or add the same bound to the source location",
                    location, component));
}

Diagnostic range_skipped(Span where, std::string_view variable, std::string_view mover, std::int64_t step,
                         std::string_view detector, std::int64_t low, std::int64_t high) {
    return warning("range-skipped", where,
                   fmt::format("`{}` moves `{}` in steps of {}, which can skip the range {}..{} that `{}` detects; "
                               "choose steps of at most {}",
                               mover, variable, step, low, high, detector, high - low + 1));
}

}  // namespace grafverif::messages
