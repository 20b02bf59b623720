// SPDX-License-Identifier: MIT
// Passes of the conversion of Sequential Function Charts, each over a complete network.
#pragma once

#include <vector>

#include "read/sfc/sfc.hpp"

namespace grafverif {

/// A transition with its translated condition.
struct SfcBranch {
    const st::Transition* written = nullptr;
    Id<tree::Expr> condition = {};
};

/// Makes the transitions after one step mutually exclusive according to their priority: each condition is conjoined
/// with the negation of each condition of higher priority, unless the two conditions are syntactically exclusive.
void exclude_by_priority(Sfc& sfc, std::vector<SfcBranch>& branches);

}  // namespace grafverif
