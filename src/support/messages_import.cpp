// SPDX-License-Identifier: MIT
// Texts of diagnostics about imported charts, XML and PLC programs (IEC 61131-3).
#include <fmt/format.h>

#include "support/messages.hpp"
#include "support/messages_program.hpp"
#include "support/wording.hpp"

namespace grafverif::messages {

Diagnostic broken_xml(Span where, std::string_view why) {
    return error("broken-xml", where, fmt::format("malformed XML: {}", why));
}

Diagnostic elements_too_deep(Span where, std::size_t limit) {
    return error("too-deep", where,
                 fmt::format("the elements are nested deeper than {} levels; flatten the document", limit));
}

Diagnostic declared_entities(Span where) {
    return error("xml-entities", where, "the document declares entities; replace them by their contents");
}

Diagnostic unknown_encoding(Span where, std::string_view encoding) {
    return error("xml-encoding", where,
                 fmt::format("the encoding `{}` is not supported; convert the file to UTF-8", clipped(encoding)));
}

Diagnostic unknown_format(Span where, std::string_view root) {
    return error("unknown-format", where,
                 fmt::format("{}; supported formats are AGRAFE GRAFCET (XML, `<grafcet:Grafcet>`), PLCopen TC6 XML "
                             "(`<project>`) and textual Sequential Function Charts (`PROGRAM`, `FUNCTION_BLOCK`)",
                             root.empty() ? "unknown file format"
                                          : fmt::format("unknown file format, starting with `{}`", clipped(root))));
}

Diagnostic dangling_reference(Span where, std::string_view reference, std::string_view kind) {
    return error("dangling-reference", where,
                 fmt::format("`{}` does not refer to any {} of this file; correct the reference (the element may have "
                             "been deleted, or copied from another file)",
                             clipped(reference), kind));
}

Diagnostic missing_part(Span where, std::string_view element, std::string_view part) {
    return error("missing-part", where, fmt::format("{} has no {}; add it, or remove the element", element, part));
}

Diagnostic bad_value(Span where, std::string_view what, std::string_view value, std::string_view expected) {
    return error("bad-value", where, fmt::format("the {} is `{}`; expected {}", what, clipped(value), expected));
}

Diagnostic misplaced_link(Span where, std::string_view what, std::string_view hint) {
    return error("misplaced-link", where, fmt::format("{}; {}", what, hint));
}

Diagnostic cannot_import(Span where, std::string_view what, std::string_view hint) {
    return error("cannot-import", where,
                 fmt::format("{} cannot be imported; {}, or pass `--lossy` to omit it", what, hint));
}

Diagnostic left_out(Span where, std::string_view what) {
    return warning("left-out", where, fmt::format("{} is omitted because of `--lossy`", what));
}

Diagnostic renamed(Span where, std::string_view name, std::string_view now) {
    return warning("renamed", where, fmt::format("`{}` is renamed to `{}`", clipped(name), clipped(now)));
}

Diagnostic chosen_range(Span where, std::string_view variable, std::int64_t low, std::int64_t high,
                        std::string_view why) {
    return warning("chosen-range", where,
                   fmt::format("`{}` gets the range {}..{}: {}", clipped(variable), low, high, why));
}

Diagnostic without_effect(Span where, std::string_view what, std::string_view hint) {
    return warning("without-effect", where, fmt::format("{} has no effect; {}", what, hint));
}

Diagnostic chosen_kind(Span where, std::string_view variable, std::string_view kind, std::string_view why) {
    return warning("chosen-kind", where, fmt::format("`{}` becomes an {}: {}", clipped(variable), kind, why));
}

Diagnostic mixed_actions(Span where, std::string_view output, std::string_view stored) {
    return warning("mixed-actions", where,
                   fmt::format("`{0}` has both continuous and stored actions, which IEC 60848 forbids; in the imported "
                               "chart, stored actions assign the new variable `{1}`, and `{0}` is true while `{1}` is "
                               "true or a continuous action on `{0}` is active",
                               clipped(output), clipped(stored)));
}

Diagnostic explicit_priority(Span where, std::string_view step, std::size_t branches) {
    return warning("explicit-priority", where,
                   fmt::format("a Sequential Function Chart takes only one of the {} branches after `{}`; the imported "
                               "conditions exclude each other by priority",
                               branches, clipped(step)));
}

Diagnostic differs_from_sfc(Span where, std::string_view what) {
    return warning("differs-from-sfc", where, std::string(what));
}

Diagnostic already_internal(Span where) {
    return error("nothing-to-import", where,
                 "the file is in grafverif's own language and needs no import; pass it to any command directly");
}

Diagnostic nothing_to_import(Span where, std::string_view what) {
    return error("nothing-to-import", where,
                 fmt::format("the file has no {}, so there is nothing to import; choose another file", what));
}

Diagnostic program_is_no_chart(Span where, std::string_view name) {
    return error("nothing-to-import", where,
                 fmt::format("`{0}` is a program without a Sequential Function Chart, so it has no steps to import; "
                             "check it with `grafverif check FILE --properties PROPERTIES` (`report` and `serve` "
                             "accept the same option), or use it in a closed loop: `program {0} = \"FILE\";`",
                             name));
}

// -- PLC programs -----------------------------------------------------------------------------------------------------

Diagnostic not_in_program(Span where, std::string_view what, std::string_view hint) {
    return error("not-in-program", where, fmt::format("{} is not supported in a program; {}", what, hint));
}

Diagnostic not_standard(Span where, std::string_view what, std::string_view meaning) {
    return warning("not-standard", where,
                   fmt::format("{} is not defined by IEC 61131-3; it is read as {}", what, meaning));
}

Diagnostic undocumented(Span where, std::string_view what, std::string_view reading) {
    return warning("undocumented-reading", where,
                   fmt::format("the documentation of CODESYS does not define {}; {}", what, reading));
}

Diagnostic program_type_mismatch(Span where, std::string_view what, std::string_view expected, std::string_view found) {
    return error("type-mismatch", where, fmt::format("{} is {}; expected {}", what, found, expected));
}

Diagnostic not_a_number_of_type(Span where, std::int64_t value, std::string_view type) {
    return error("out-of-range", where,
                 fmt::format("{} is outside the range of {}; use a value in this range, or a type with a larger range",
                             value, type));
}

Diagnostic recursive_unit(Span where, std::string_view name) {
    return error("recursive-unit", where,
                 fmt::format("`{}` contains or calls itself; remove the recursion", clipped(name)));
}

Diagnostic program_too_large(Span where, std::string_view what, std::uint64_t limit) {
    return error("program-too-large", where,
                 fmt::format("the program has more than {} {}; reduce their number", limit, what));
}

Diagnostic unbounded_loop(Span where, std::uint64_t limit) {
    return error("unbounded-loop", where,
                 fmt::format("this loop has no constant bound of at most {0} iterations; use a FOR loop with constant "
                             "bounds and at most {0} iterations",
                             limit));
}

Diagnostic program_without_cycle(Span where, std::string_view name) {
    return error(
        "program-without-cycle", where,
        fmt::format("the program `{0}` has timers, so its scans require a fixed interval; write `controller {0} "
                    "every 10ms;` with the interval of its task",
                    clipped(name)));
}

Diagnostic program_with_cycle_zero(Span where, std::string_view name) {
    return error("program-without-cycle", where,
                 fmt::format("the program `{}` has timers, so its scans require a fixed interval, and its cycle time "
                             "cannot be zero; omit `--cycle`",
                             clipped(name)));
}

Diagnostic program_beyond_64_bits(Span where, std::string_view name) {
    return error("program-too-large", where,
                 fmt::format("the program `{}` may compute values that exceed 64 bits; use types with fewer bits",
                             clipped(name)));
}

Diagnostic step_or_variable(Span where, std::string_view name, std::string_view step) {
    return error("ambiguous-name", where,
                 fmt::format("`{}` is a variable of the program and the step variable of `{}`; rename the variable, or "
                             "write `{}.X` for the step",
                             clipped(name), clipped(step), clipped(step)));
}

Diagnostic composite_signal(Span where, std::string_view kind, std::string_view name) {
    return error("not-in-program", where,
                 fmt::format("the {0} `{1}` is part of a structure, an array or an instance, which is not supported in "
                             "a closed loop; declare a variable of an elementary type for each {0}",
                             kind, clipped(name)));
}

Diagnostic only_for_charts(Span where, std::string_view name, std::string_view what, std::string_view hint) {
    return error("only-for-charts", where, fmt::format("`{}` is a PLC program, but {}; {}", clipped(name), what, hint));
}

Diagnostic no_program(Span where) {
    return error("no-program", where, "the file declares no PROGRAM; add one, or an instance in a CONFIGURATION");
}

Diagnostic several_programs(Span where, std::string_view name) {
    return error(
        "several-programs", where,
        fmt::format("`{}` is a second program; instantiate one of the programs in a CONFIGURATION", clipped(name)));
}

Diagnostic bad_property(Span where, std::string_view what, std::string_view hint) {
    return error("bad-property", where, fmt::format("invalid property: {}; {}", what, hint));
}

}  // namespace grafverif::messages
