// SPDX-License-Identifier: MIT
// Messages about resources that the system refuses, and about files that are cut off.
#pragma once

#include "grafverif/support/diagnostic.hpp"

namespace grafverif::messages {

/// Ended a run before its end, like out_of_memory; exit code 3.
Diagnostic threads_refused();
Diagnostic incomplete_utf16(Span where);

}  // namespace grafverif::messages
