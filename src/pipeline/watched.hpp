// SPDX-License-Identifier: MIT
// What an observer saw in a counterexample, in the words of its property.
#pragma once

#include <string>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// `property` is one of `network`; `run` is one of `observed`, whose last process is the observer of the property.
std::string watched_words(const Network& network, const Property& property, const Network& observed, const Run& run);

}  // namespace grafverif
