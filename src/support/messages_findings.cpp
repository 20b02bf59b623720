// SPDX-License-Identifier: MIT
// Texts of diagnostics about exclusion tables and accepted findings.
#include <fmt/format.h>

#include "support/messages.hpp"
#include "support/wording.hpp"

namespace grafverif::messages {

Diagnostic bad_exclusion_header(Span where) {
    return error("bad-exclusion", where,
                 "this is not an exclusion table; write `variable1,variable2,reason` as the first row");
}

Diagnostic bad_exclusion(Span where, std::size_t fields) {
    return error("bad-exclusion", where,
                 fmt::format("this row has {} {}; write two inputs and a reason, quoted if it contains a comma", fields,
                             fields == 1 ? "field" : "fields"));
}

Diagnostic not_a_boolean_input(Span where, std::string_view name, std::string_view chart) {
    return error("bad-exclusion", where,
                 fmt::format("`{}` is not a Boolean input of grafcet `{}`; correct the name or remove the row",
                             clipped(name), clipped(chart)));
}

Diagnostic excludes_itself(Span where, std::string_view name) {
    return error("bad-exclusion", where,
                 fmt::format("`{0}` excludes itself; write `constraint !{0};` in the grafcet", clipped(name)));
}

Diagnostic unknown_finding(Span where, std::string_view code) {
    return error(
        "unknown-finding", where,
        fmt::format("unknown finding `{}`; use a code that `grafverif analyse` prints in brackets", clipped(code)));
}

}  // namespace grafverif::messages
