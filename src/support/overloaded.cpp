// SPDX-License-Identifier: MIT
#include "support/overloaded.hpp"

#include <cstdlib>

namespace grafverif {

void unreachable() { std::abort(); }

}  // namespace grafverif
