// SPDX-License-Identifier: MIT
// Validates combinations of options: outputs, limits and untimed models.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/options.hpp"

namespace grafverif::app {

/// Validates inputs and outputs. The options must name every output file that the command requires. At most one option
/// may read standard input, and at most one document may be written to standard output. Returns an error message or an
/// empty string.
std::string validate_outputs(const CliCommand& verb, const Options& options);

/// Validates options that require or exclude another option. `given` is true if the option of that name was given.
std::string validate_combinations(const CliCommand& verb, const Options& options,
                                  const std::function<bool(const char* name)>& given);

/// Validates limits. Reduces a time limit that exceeds the range of the clock to this range.
std::string validate_limits(Options& options);

/// Validates the options of the untimed model.
std::string validate_untimed(Options& options);

/// Parses arguments of the form `NAME=VALUE` with distinct names. Returns an error message or an empty string.
std::string take_constants(const std::vector<std::string>& given, Options& options);
/// Parses the values of `--ablate CORRECTION`, which disables a correction of the method (see
/// docs/explanation/modelling-rules.md).
std::string disable_corrections(const std::vector<std::string>& cures, Options& options);
std::string take_jobs(const std::vector<std::string>& given, Options& options);

}  // namespace grafverif::app
