// SPDX-License-Identifier: MIT
// Generated charts and closed loops of any size, as text.
#pragma once

#include <cstddef>
#include <string>

namespace grafverif::bench {

/// A closed loop whose chart is one ring of `steps` steps with as many transitions, 16 inputs from free push-buttons,
/// 16 outputs; every tenth step has a time condition, every tenth counts.
std::string ring(std::size_t steps);

}  // namespace grafverif::bench
