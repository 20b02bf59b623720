// SPDX-License-Identifier: MIT
#include "grafverif/support/messages.hpp"

#include <fmt/format.h>

namespace grafverif::messages {

namespace {

Diagnostic error(std::string_view code, Span where, std::string message) {
    return {Severity::Error, std::string(code), where, std::move(message), {}};
}

}  // namespace

// -- the command line and files ------------------------------------------------------------------------------------

Diagnostic cannot_read(std::string_view path, std::string_view why) {
    return error("cannot-read", {}, fmt::format("cannot read `{}`: {}", path, why));
}

// -- reading ---------------------------------------------------------------------------------------------------------

// -- derive ----------------------------------------------------------------------------------------------------------

// -- plant and compose -------------------------------------------------------------------------------------------------

// -- schedule and emit -------------------------------------------------------------------------------------------------

}  // namespace grafverif::messages
