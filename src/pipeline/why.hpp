// SPDX-License-Identifier: MIT
// What the properties of a loop that hold rest on: the loop is checked again without one thing after the other.
#pragma once

#include "grafverif/grafverif.hpp"
#include "grafverif/ir/why.hpp"

namespace grafverif {

/// Of the answers of `report` that hold in all states, and are declared; see Why. Each search looks at eight times
/// the states of the first one at most, 100 000 at least, or at so many as `options` allow; at the deadline and where it is stopped, what is not known stays open.
Why why_it_holds(const Model& model, Id<ClosedLoop> loop, const ModelOptions& how, const CheckOptions& options,
                 const Report& report);

}  // namespace grafverif
