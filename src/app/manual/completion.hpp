// SPDX-License-Identifier: MIT
// Scripts that complete command lines of grafverif: verbs, their options, the words that options take, files.
#pragma once

#include <span>
#include <string>

#include "app/options.hpp"

namespace grafverif::app {

std::string bash_completion(std::span<const Verb> verbs);
std::string zsh_completion(std::span<const Verb> verbs);
std::string fish_completion(std::span<const Verb> verbs);

}  // namespace grafverif::app
