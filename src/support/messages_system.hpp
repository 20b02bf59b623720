// SPDX-License-Identifier: MIT
// Messages about resources that the operating system refuses, truncated files and deprecated options.
#pragma once

#include <string_view>

#include "grafverif/support/diagnostic.hpp"

namespace grafverif::messages {

/// The run ended early, because the system refused to create a thread or a process. The exit code is 3, as for the
/// message out_of_memory.
Diagnostic threads_refused();
Diagnostic incomplete_utf16(Span where);
/// A warning: `--former` is deprecated; use `--name`.
Diagnostic deprecated_option(std::string_view former, std::string_view name);

}  // namespace grafverif::messages
