// SPDX-License-Identifier: MIT
// Variables that a location tells: DESDES06 6.2 defines `h_c_l := state = left`.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "schedule/slots.hpp"

namespace grafverif::schedule {

/// Per location the value that `variable`, which only this process writes, has there; empty where some location can be
/// entered with different values, or with one that is no constant. Locations without a way there get the initial value.
std::optional<std::vector<std::int64_t>> location_values(const Slots& slots, Id<Network::Variable> variable);

}  // namespace grafverif::schedule
