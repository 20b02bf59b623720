// SPDX-License-Identifier: MIT
// Texts of diagnostics about names and files.
#include <fmt/format.h>

#include "support/messages.hpp"
#include "support/wording.hpp"

namespace grafverif::messages {

Diagnostic unknown(Span where, std::string_view kind, std::string_view name, std::string_view suggestion) {
    std::string code = fmt::format("unknown-{}", kind.substr(0, kind.find(" or ")));
    for (char& byte : code)
        if (byte == ' ') byte = '-';
    std::string message = fmt::format("unknown {} `{}`", kind, clipped(name));
    message += suggestion.empty() ? "; declare it or correct the name"
                                  : fmt::format("; did you mean `{}`?", clipped(suggestion));
    Diagnostic diagnostic = error(code, where, std::move(message));
    // For a name with indices, `where` does not cover the indices, so that a replacement could be wrong. Therefore the
    // message proposes no fix.
    if (suggestion.empty() || name.find('[') != std::string_view::npos) return diagnostic;
    return with_fix(std::move(diagnostic), last_of(where, name.size()), suggestion);
}

Diagnostic unknown_component(Span where, std::string_view name, std::string_view suggestion, std::string_view known) {
    Diagnostic diagnostic = unknown(where, "component", name, suggestion);
    diagnostic.notes.push_back(note({}, fmt::format("known components: {}", known)));
    return diagnostic;
}

Diagnostic unknown_location(Span where, std::string_view name, std::string_view suggestion, std::string_view component,
                            std::string_view locations) {
    Diagnostic diagnostic = unknown(where, "location", name, suggestion);
    diagnostic.notes.push_back(note({}, fmt::format("locations of `{}`: {}", clipped(component), locations)));
    return diagnostic;
}

Diagnostic duplicate_name(Span where, std::string_view kind, std::string_view name, Span first) {
    Diagnostic diagnostic = error("duplicate-name", where,
                                  fmt::format("a second {} is named `{}`; rename one of the two", kind, clipped(name)));
    diagnostic.notes.push_back(note(first, "the first declaration is here"));
    return diagnostic;
}

Diagnostic declared_in_copies(Span where, std::string_view kind, std::string_view name) {
    return error("duplicate-name", where,
                 fmt::format("the {} `{}` is declared in several copies; add an index to its name, or move the "
                             "declaration out of the replication",
                             kind, clipped(name)));
}

Diagnostic index_hides(Span where, std::string_view index, Span other) {
    Diagnostic diagnostic =
        error("duplicate-name", where,
              fmt::format("the index variable `{}` has the name of another declaration; rename one of the two",
                          clipped(index)));
    diagnostic.notes.push_back(note(other, "the other declaration is here"));
    return diagnostic;
}

Diagnostic ambiguous(Span where, std::string_view name, std::string_view one, std::string_view other) {
    return error("ambiguous-name", where,
                 fmt::format("`{}` is ambiguous between `{}` and `{}`; write the qualified name", clipped(name),
                             clipped(one), clipped(other)));
}

Diagnostic step_like_variable(Span where, std::string_view name) {
    return error("step-like-variable", where,
                 fmt::format("the variable `{}` looks like the step variable of step `{}`; choose another name",
                             clipped(name), clipped(name.substr(1))));
}

Diagnostic shadows_library(Span where, std::string_view name) {
    return warning("shadows-library", where,
                   fmt::format("`{}` hides the library component of the same name; rename it if this is not intended",
                               clipped(name)));
}

Diagnostic include_cycle(Span where, std::string_view path) {
    return error("include-cycle", where,
                 fmt::format("`{}` includes itself through this line; remove the line", clipped(path)));
}

Diagnostic cannot_include(Span where, std::string_view path, std::string_view why) {
    return error("cannot-include", where, fmt::format("cannot include `{}`: {}", clipped(path), why));
}

Diagnostic not_yet(Span where, std::string_view what) {
    return error("unsupported", where, fmt::format("{} is not supported; remove it", what));
}

}  // namespace grafverif::messages
