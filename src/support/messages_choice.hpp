// SPDX-License-Identifier: MIT
// What is said where a name on the command line is none that the file has.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "grafverif/support/diagnostic.hpp"

namespace grafverif::messages {

/// `nearest`: the one that may be meant; empty: all are listed.
Diagnostic no_such_choice(std::string_view kind, std::string_view name, std::span<const std::string> known,
                          std::string_view nearest);

}  // namespace grafverif::messages
