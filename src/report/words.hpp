// SPDX-License-Identifier: MIT
// The words of a trace: what one edge did.
#pragma once

#include <string>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/network_run.hpp"

namespace grafverif {

/// `going_out, H 4 -> 6`: the location reached, unless it is where the instance was, and what changed in the plant.
/// `inputs`: what changed among the inputs of controllers, too.
std::string instance_words(const Network& network, const Fire& fire, const NetworkState& before,
                           const NetworkState& after, bool inputs = false);

/// `3s/X2 is true`, `a/2s is false`: one of its delays is over, and its end variable has become `value`.
std::string timer_words(const Network& network, const Network::Controller& controller,
                        const Network::TimerVariables& timing, bool value);

/// The name of the location that the edge leads to.
const std::string& location_word(const Network& network, const Fire& fire);

/// `X`, `!X`, `N = 3`.
std::string value_words(const std::string& name, const Type& type, std::int64_t value);

/// `X`, `!X`, `N 3 -> 4`.
std::string change_words(const std::string& name, const Type& type, std::int64_t before, std::int64_t after);

}  // namespace grafverif
