// SPDX-License-Identifier: MIT
// Parts of the conversion of Sequential Function Charts that look at a network as a whole.
#pragma once

#include <vector>

#include "read/sfc/sfc.hpp"

namespace grafverif {

/// A transition with its condition as a term of ours.
struct SfcBranch {
    const st::Transition* written = nullptr;
    Id<tree::Expr> condition = {};
};

/// Of transitions that leave one step the first by priority is taken: the conditions of the others get the negations of
/// those before them, unless they exclude each other as written.
void exclude_by_priority(Sfc& sfc, std::vector<SfcBranch>& branches);

}  // namespace grafverif
