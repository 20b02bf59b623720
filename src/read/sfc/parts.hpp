// SPDX-License-Identifier: MIT
// Parts of the conversion of Sequential Function Charts that concern a complete network.
#pragma once

#include <vector>

#include "read/sfc/sfc.hpp"

namespace grafverif {

/// A transition with its translated condition.
struct SfcBranch {
    const st::Transition* written = nullptr;
    Id<tree::Expr> condition = {};
};

/// Makes the transitions that leave one step exclusive according to their priority: each condition is conjoined with
/// the negations of those of higher priority, unless they are syntactically exclusive.
void exclude_by_priority(Sfc& sfc, std::vector<SfcBranch>& branches);

}  // namespace grafverif
