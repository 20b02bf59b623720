// SPDX-License-Identifier: MIT
// Pages of the manual, in the language of man(7): what --help says, laid out by `man`.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "app/options.hpp"

namespace grafverif::app {

/// grafverif(1): the program, its verbs, its exit codes.
std::string man_page(std::span<const Verb> verbs, std::string_view version);

/// grafverif-VERB(1).
std::string man_page(const Verb& verb, std::string_view version);

}  // namespace grafverif::app
