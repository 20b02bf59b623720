// SPDX-License-Identifier: MIT
// Text inside XML: markup escaped, and what XML 1.0 forbids (control characters, broken UTF-8) replaced by U+FFFD, so
// that a document is well-formed whatever a comment of the input held.
#pragma once

#include <string>
#include <string_view>

namespace grafverif {

/// Appends `text` as character data.
void escape_xml(std::string_view text, std::string& xml);

/// `text` as the value of an attribute in double quotes.
std::string attribute_xml(std::string_view text);

/// Appends `text` as the inside of a comment, where `--` may not stand.
void comment_xml(std::string_view text, std::string& xml);

}  // namespace grafverif
