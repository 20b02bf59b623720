// SPDX-License-Identifier: MIT
// What the options say of outputs together, of limits, and of untimed models.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/options.hpp"

namespace grafverif::app {

/// What is wrong with them, or nothing: it fits together, and is enough to write them; one reads standard input, one document
/// goes to standard output.
std::string settle_outputs(const Verb& verb, const Options& options);

/// Likewise of options that mean nothing without another one, or beside it. `given`: whether the option of that name was.
std::string settle_company(const Verb& verb, const Options& options,
                           const std::function<bool(const char* name)>& given);

/// Likewise of limits; a time that no clock counts becomes one that it does.
std::string settle_limits(Options& options);

/// Likewise of the untimed model.
std::string settle_untimed(Options& options);

/// `NAME=VALUE` each, no name twice; what is wrong, or nothing.
std::string take_constants(const std::vector<std::string>& given, Options& options);
/// `--without CURE`: models with a failure that the method cures, for the page that shows them.
std::string leave_out_cures(const std::vector<std::string>& cures, Options& options);
std::string take_jobs(const std::vector<std::string>& given, Options& options);

}  // namespace grafverif::app
