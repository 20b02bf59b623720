// SPDX-License-Identifier: MIT
// Texts of diagnostics about faults of a closed loop.
#pragma once

#include <string_view>

#include "grafverif/support/diagnostic.hpp"

namespace grafverif::messages {

/// The component of a fault does not write a variable that the instance replaced by the fault writes.
Diagnostic fault_lacks_output(Span where, std::string_view fault, std::string_view component, std::string_view variable,
                              std::string_view instance);
/// An output of a fault is bound to a variable that the instance replaced by the fault does not write.
Diagnostic fault_writes_other(Span where, std::string_view fault, std::string_view output, std::string_view instance);
/// `type` is the type of the variable in the fault, and `wanted` is its type in the instance.
Diagnostic fault_type(Span where, std::string_view fault, std::string_view variable, std::string_view type,
                      std::string_view wanted);
Diagnostic fault_cannot_start(Span where, std::string_view fault, std::string_view location);
Diagnostic no_faults(Span loop, std::string_view name);

}  // namespace grafverif::messages
