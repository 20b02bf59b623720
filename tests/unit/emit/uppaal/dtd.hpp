// SPDX-License-Identifier: MIT
// Checks that a UPPAAL project is valid for its document type.
#pragma once

#include <string>

namespace grafverif::test {

bool has_xmllint();

/// True if xmllint finds that the document is valid. Otherwise the messages of xmllint are printed on standard output.
bool is_valid(const std::string& xml);

}  // namespace grafverif::test
