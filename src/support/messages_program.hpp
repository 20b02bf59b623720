// SPDX-License-Identifier: MIT
// Texts of diagnostics about PLC programs (IEC 61131-3) and their properties.
#pragma once

#include <cstdint>
#include <string_view>

#include "grafverif/support/diagnostic.hpp"

namespace grafverif::messages {

/// PLC programs cannot contain the construct `what` at this position. `hint` is the remedy in the imperative.
Diagnostic not_in_program(Span where, std::string_view what, std::string_view hint);
/// IEC 61131-3 does not contain the construct `what`. `meaning` states how grafverif interprets the construct.
Diagnostic not_standard(Span where, std::string_view what, std::string_view meaning);
Diagnostic undocumented(Span where, std::string_view what, std::string_view reading);
Diagnostic program_type_mismatch(Span where, std::string_view what, std::string_view expected, std::string_view found);
Diagnostic not_a_number_of_type(Span where, std::int64_t value, std::string_view type);
Diagnostic recursive_unit(Span where, std::string_view name);
Diagnostic program_too_large(Span where, std::string_view what, std::uint64_t limit);
Diagnostic unbounded_loop(Span where, std::uint64_t limit);
/// A controller has timers, but the file does not specify an exact time between its scans.
Diagnostic program_without_cycle(Span where, std::string_view name);
/// `--cycle` sets the cycle time of a controller with timers to zero.
Diagnostic program_with_cycle_zero(Span where, std::string_view name);
Diagnostic program_beyond_64_bits(Span where, std::string_view name);
/// `name` denotes a variable of a program and the step variable of `step`.
Diagnostic step_or_variable(Span where, std::string_view name, std::string_view step);
/// An input or output is part of a structure, an array or an instance. `kind` is `input` or `output`.
Diagnostic composite_signal(Span where, std::string_view kind, std::string_view name);
/// A program in a loop is used in a way that is possible only for charts. `what` is the clause with which the message
/// begins.
Diagnostic only_for_charts(Span where, std::string_view name, std::string_view what, std::string_view hint);
Diagnostic no_program(Span where);
Diagnostic several_programs(Span where, std::string_view name);
Diagnostic bad_property(Span where, std::string_view what, std::string_view hint);

}  // namespace grafverif::messages
