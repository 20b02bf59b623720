// SPDX-License-Identifier: MIT
// What is said where a name on the command line is none that the file has, of two files that do not go together, and of a
// file or document that is not what it must be.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "grafverif/support/diagnostic.hpp"

namespace grafverif::messages {

/// `nearest`: the one that may be meant; empty: all are listed.
Diagnostic no_such_choice(std::string_view kind, std::string_view name, std::span<const std::string> known,
                          std::string_view nearest);

/// An output is called like a file of the format `named`, and `written` is written there; `how` to get the other.
Diagnostic other_format(std::string_view path, std::string_view named, std::string_view written, std::string_view how);

/// `--set` of a constant that the closed loop at hand does not have; `nearest`: the one that may be meant.
Diagnostic no_such_constant(Span loop, std::string_view loop_name, std::string_view name, std::string_view nearest);

/// Of two charts to be compared: a `kind` (input, output) that only the chart `owner` has.
Diagnostic not_in_both(Span where, std::string_view kind, std::string_view name, std::string_view owner);
/// Likewise one with two ranges, in words.
Diagnostic other_type(Span where, std::string_view kind, std::string_view name, std::string_view range,
                      std::string_view other);
Diagnostic nothing_to_compare(Span where, std::string_view chart);
/// A chart cannot begin with the situation asked for.
Diagnostic no_such_beginning(Span where, std::string_view chart, std::string_view why);
/// `--resolution` does not divide a duration of the charts.
Diagnostic coarse_resolution(std::string_view resolution, std::string_view duration, std::string_view divides_all);

/// `--state` names a file that is there and is another one.
Diagnostic no_state_file(std::string_view path);

/// Of a document in an editor.
Diagnostic out_of_step();

}  // namespace grafverif::messages
