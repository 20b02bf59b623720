// SPDX-License-Identifier: MIT
// The statements of a controller in Structured Text.
#pragma once

#include <string>

#include "emit/controller/code.hpp"
#include "emit/structured_text/dialects.hpp"

namespace grafverif::structured_text {

std::string body_of(const controller::Code& code, const DialectRow& dialect);

/// Returns a literal such as `T#3s`.
std::string time_literal(std::int64_t milliseconds);

}  // namespace grafverif::structured_text
