// SPDX-License-Identifier: MIT
// The component library, embedded in the program from templates/ at build time.
#pragma once

#include <span>

#include "read/text.hpp"

namespace grafverif::app {

/// Every component of the library, in alphabetical order of file names.
std::span<const LibraryEntry> library();

}  // namespace grafverif::app
