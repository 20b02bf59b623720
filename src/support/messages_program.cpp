// SPDX-License-Identifier: MIT
#include "support/messages_program.hpp"

#include <fmt/format.h>

#include "support/wording.hpp"

namespace grafverif::messages {

Diagnostic not_in_program(Span where, std::string_view what, std::string_view hint) {
    return error("not-in-program", where, fmt::format("{} is not supported in a program; {}", what, hint));
}

Diagnostic program_type_mismatch(Span where, std::string_view what, std::string_view expected, std::string_view found) {
    return error("type-mismatch", where, fmt::format("{} is {}; expected {}", what, found, expected));
}

Diagnostic not_a_number_of_type(Span where, std::int64_t value, std::string_view type) {
    return error("out-of-range", where,
                 fmt::format("{} is outside the range of {}; convert the other operand", value, type));
}

Diagnostic recursive_unit(Span where, std::string_view name) {
    return error("recursive-unit", where,
                 fmt::format("`{}` contains or calls itself; remove the recursion", clipped(name)));
}

Diagnostic program_too_large(Span where, std::string_view what, std::uint64_t limit) {
    return error("program-too-large", where, fmt::format("the program has more than {} {}; reduce it", limit, what));
}

Diagnostic unbounded_loop(Span where, std::uint64_t limit) {
    return error(
        "unbounded-loop", where,
        fmt::format("constants do not bound this loop by {} iterations; use a FOR loop with constant bounds", limit));
}

Diagnostic no_program(Span where) {
    return error("no-program", where, "the file declares no PROGRAM; add one, or an instance in a CONFIGURATION");
}

Diagnostic several_programs(Span where, std::string_view name) {
    return error("several-programs", where,
                 fmt::format("`{}` is a second program; instantiate one of them in a CONFIGURATION", clipped(name)));
}

Diagnostic bad_property(Span where, std::string_view what, std::string_view hint) {
    return error("bad-property", where, fmt::format("{}; {}", what, hint));
}

}  // namespace grafverif::messages
