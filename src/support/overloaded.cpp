// SPDX-License-Identifier: MIT
#include "grafverif/support/overloaded.hpp"

#include <cstdlib>

namespace grafverif {

void unreachable() { std::abort(); }

}  // namespace grafverif
