// SPDX-License-Identifier: MIT
// Texts of diagnostics about imported charts: XML and IEC 61131-3.
#include <fmt/format.h>

#include "support/messages.hpp"
#include "support/wording.hpp"

namespace grafverif::messages {

Diagnostic broken_xml(Span where, std::string_view why) {
    return error("broken-xml", where, fmt::format("this is not well-formed XML: {}", why));
}

Diagnostic elements_too_deep(Span where, std::size_t limit) {
    return error("too-deep", where, fmt::format("the elements nest deeper than {} levels", limit));
}

Diagnostic declared_entities(Span where) {
    return error("xml-entities", where, "the document declares entities of its own; write out what they stand for");
}

Diagnostic unknown_encoding(Span where, std::string_view encoding) {
    return error("xml-encoding", where,
                 fmt::format("the encoding `{}` is not known here; convert the file to UTF-8", clipped(encoding)));
}

Diagnostic unknown_format(Span where, std::string_view root) {
    return error(
        "unknown-format", where,
        fmt::format(
            "{} that is known here; read are AGRAFE GRAFCET (XML, `<grafcet:Grafcet>`), PLCopen TC6 XML "
            "(`<project>`) and textual Sequential Function Charts (`PROGRAM`, `FUNCTION_BLOCK`)",
            root.empty() ? "the file begins with no chart" : fmt::format("`{}` begins no chart", clipped(root))));
}

Diagnostic dangling_reference(Span where, std::string_view reference, std::string_view kind) {
    return error("dangling-reference", where,
                 fmt::format("`{}` is no {} of this file; was it deleted, or copied from another file?",
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
                 fmt::format("{} cannot be taken over; {}, or leave it out with `--lossy`", what, hint));
}

Diagnostic left_out(Span where, std::string_view what) {
    return warning("left-out", where, fmt::format("{} is left out: `--lossy`", what));
}

Diagnostic renamed(Span where, std::string_view name, std::string_view now) {
    return warning("renamed", where, fmt::format("`{}` is called `{}` here", clipped(name), clipped(now)));
}

Diagnostic chosen_range(Span where, std::string_view variable, std::int64_t low, std::int64_t high,
                        std::string_view why) {
    return warning("chosen-range", where,
                   fmt::format("`{}` takes the range {}..{}: {}", clipped(variable), low, high, why));
}

Diagnostic without_effect(Span where, std::string_view what, std::string_view hint) {
    return warning("without-effect", where, fmt::format("{} has no effect; {}", what, hint));
}

Diagnostic chosen_kind(Span where, std::string_view variable, std::string_view kind, std::string_view why) {
    return warning("chosen-kind", where, fmt::format("`{}` becomes an {}: {}", clipped(variable), kind, why));
}

Diagnostic mixed_actions(Span where, std::string_view output, std::string_view stored) {
    return warning(
        "mixed-actions", where,
        fmt::format("`{0}` has continuous and stored actions; it is true where a continuous action says so or "
                    "what was stored last, now `{1}`, is true",
                    clipped(output), clipped(stored)));
}

Diagnostic explicit_priority(Span where, std::string_view step, std::size_t branches) {
    return warning("explicit-priority", where,
                   fmt::format("a Sequential Function Chart takes one of the {} branches behind `{}`; their conditions "
                               "now exclude each other by priority",
                               branches, clipped(step)));
}

Diagnostic differs_from_sfc(Span where, std::string_view what) {
    return warning("differs-from-sfc", where, std::string(what));
}

Diagnostic ours_already(Span where) {
    return error("nothing-to-import", where,
                 "the file is in our own language, which every verb reads; `grafverif fmt` prints it");
}

Diagnostic nothing_to_import(Span where, std::string_view what) {
    return error("nothing-to-import", where, fmt::format("the file has no {}; nothing can be taken over", what));
}

Diagnostic program_is_no_chart(Span where, std::string_view name) {
    return error(
        "nothing-to-import", where,
        fmt::format("`{}` is a program without a Sequential Function Chart, and no steps can be read back from "
                    "its statements; take the chart that it was written from, and ask `grafverif test` whether "
                    "a controller that runs it does what the chart says",
                    name));
}

}  // namespace grafverif::messages
