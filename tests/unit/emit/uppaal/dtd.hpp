// SPDX-License-Identifier: MIT
// Whether a UPPAAL project keeps to the document type that it names.
#pragma once

#include <string>

namespace grafverif::test {

bool has_xmllint();

/// Whether xmllint finds the document valid; what it says otherwise goes to standard output.
bool is_valid(const std::string& xml);

}  // namespace grafverif::test
