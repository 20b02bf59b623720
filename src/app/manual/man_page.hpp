// SPDX-License-Identifier: MIT
// Manual pages in man(7) format, with the content of --help.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "app/options.hpp"

namespace grafverif::app {

/// Returns grafverif(1): the program, its commands, its exit codes.
std::string man_page(std::span<const CliCommand> verbs, std::string_view version);

/// Returns grafverif-COMMAND(1).
std::string man_page(const CliCommand& verb, std::string_view version);

}  // namespace grafverif::app
