// SPDX-License-Identifier: MIT
// A trace as a JSON value, for every report that has one.
#pragma once

#include <nlohmann/json.hpp>

#include "grafverif/ir/trace.hpp"

namespace grafverif {

nlohmann::ordered_json trace_json(const Trace& trace);

}  // namespace grafverif
