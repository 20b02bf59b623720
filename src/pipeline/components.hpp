// SPDX-License-Identifier: MIT
// The component library, which is embedded from templates/ at build time.
#pragma once

#include <span>

#include "read/text.hpp"

namespace grafverif {

/// Returns all components of the library, in alphabetical order of file names.
std::span<const LibraryEntry> library();

}  // namespace grafverif
