// SPDX-License-Identifier: MIT
// The component library, embedded from templates/ at build time.
#pragma once

#include <span>

#include "read/text.hpp"

namespace grafverif {

/// Every component of the library, in alphabetical order of file names.
std::span<const LibraryEntry> library();

}  // namespace grafverif
