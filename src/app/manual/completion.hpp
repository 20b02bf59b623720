// SPDX-License-Identifier: MIT
// Shell scripts that complete command lines of grafverif: commands, options, option values and files.
#pragma once

#include <span>
#include <string>

#include "app/options.hpp"

namespace grafverif::app {

std::string bash_completion(std::span<const CliCommand> verbs);
std::string zsh_completion(std::span<const CliCommand> verbs);
std::string fish_completion(std::span<const CliCommand> verbs);

}  // namespace grafverif::app
