// SPDX-License-Identifier: MIT
// Messages about unknown names on the command line, two files that do not match, and files or documents of the wrong
// type.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "grafverif/support/diagnostic.hpp"

namespace grafverif::messages {

/// `nearest` is the most similar known name. If `nearest` is empty, the message lists all known names.
Diagnostic no_such_choice(std::string_view kind, std::string_view name, std::span<const std::string> known,
                          std::string_view nearest);

/// The name of the output indicates the format `named`, but the file would be written in the format `written`. `how` is
/// the remedy.
Diagnostic other_format(std::string_view path, std::string_view named, std::string_view written, std::string_view how);

/// `--set` names a constant that the closed loop does not have. `nearest` is the most similar name.
Diagnostic no_such_constant(Span loop, std::string_view loop_name, std::string_view name, std::string_view nearest);

/// `--over` lists values that the constant cannot have. `problem` and `remedy` are the two parts of the message.
Diagnostic bad_values(Span where, std::string_view problem, std::string_view remedy);

/// Only one of two compared charts, `owner` (in backticks), has an input or output (`kind`) with the name `name`.
Diagnostic not_in_both(Span where, std::string_view kind, std::string_view name, std::string_view owner);
/// The input or output (`kind`) with the name `name` has different ranges in two compared charts. `range` and `other`
/// are the ranges as text.
Diagnostic other_type(Span where, std::string_view kind, std::string_view name, std::string_view range,
                      std::string_view other);
/// Two controllers cannot be compared. `remedy` is in the imperative.
Diagnostic not_comparable(Span where, std::string_view problem, std::string_view remedy);
Diagnostic nothing_to_compare(Span where, std::string_view chart);
/// A chart cannot start in the requested situation.
Diagnostic no_such_beginning(Span where, std::string_view chart, std::string_view why);
/// `--resolution` does not divide a duration of the charts.
Diagnostic coarse_resolution(std::string_view resolution, std::string_view duration, std::string_view divides_all);

/// `--state` names an existing file that is not a state file.
Diagnostic no_state_file(std::string_view path);

/// A change of a document in an editor could not be applied.
Diagnostic out_of_step();

}  // namespace grafverif::messages
