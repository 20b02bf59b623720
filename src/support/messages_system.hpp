// SPDX-License-Identifier: MIT
// Messages about resources that the operating system refuses, and about truncated files.
#pragma once

#include "grafverif/support/diagnostic.hpp"

namespace grafverif::messages {

/// The run ended early, as with out_of_memory; exit code 3.
Diagnostic threads_refused();
Diagnostic incomplete_utf16(Span where);

}  // namespace grafverif::messages
