// SPDX-License-Identifier: MIT
// Passes of the conversion of Sequential Function Charts. Each pass handles a complete network (steps and transitions
// of a chart).
#pragma once

#include <vector>

#include "read/sfc/sfc.hpp"

namespace grafverif {

/// A transition and its translated condition.
struct SfcBranch {
    const st::Transition* written = nullptr;
    Id<tree::Expr> condition = {};
};

/// Makes the transitions after one step mutually exclusive according to their priority: adds the negations of all
/// conditions with higher priority to each condition, except negations of conditions that are syntactically exclusive
/// with it.
void exclude_by_priority(Sfc& sfc, std::vector<SfcBranch>& branches);

}  // namespace grafverif
