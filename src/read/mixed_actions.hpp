// SPDX-License-Identifier: MIT
// Outputs that have continuous and stored actions: IEC 60848 forbids it, other formats do not. What is stored goes to a
// variable of its own, and the output is true where a continuous action says so or that variable is true: in Sequential
// Function Charts that is what N and S together mean; elsewhere it is a reading that is warned of.
#pragma once

#include "read/draft.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

void split_mixed_actions(Draft& draft, tree::Chart& chart);

}  // namespace grafverif
