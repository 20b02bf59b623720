// SPDX-License-Identifier: MIT
// Text inside XML: markup escaped, and what XML 1.0 forbids (control characters, broken UTF-8) replaced by U+FFFD, so
// that a document is well-formed whatever a comment of the input held; and the way back.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace grafverif {

/// Appends `text` as character data.
void escape_xml(std::string_view text, std::string& xml);

/// `text` as the value of an attribute in double quotes.
std::string attribute_xml(std::string_view text);

/// Appends `text` as the inside of a comment, where `--` may not stand.
void comment_xml(std::string_view text, std::string& xml);

/// The characters that `written`, text of XML, stands for; references to anything but characters and the five entities
/// of XML stay as they are. `origins`: the place of each byte, `written` beginning at `begin`, and of the end.
std::string unescape_xml(std::string_view written, std::uint32_t begin, std::vector<std::uint32_t>& origins);
std::string unescape_xml(std::string_view written);

}  // namespace grafverif
