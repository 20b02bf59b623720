// SPDX-License-Identifier: MIT
// XML escaping and unescaping. Markup is escaped, and characters that XML 1.0 forbids (control characters, invalid
// UTF-8) are replaced by U+FFFD, so a document is well-formed for every input.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace grafverif {

/// Appends `text` as character data.
void escape_xml(std::string_view text, std::string& xml);

/// `text` as an attribute value in double quotes.
std::string attribute_xml(std::string_view text);

/// Appends `text` as the contents of a comment, in which `--` is not allowed.
void comment_xml(std::string_view text, std::string& xml);

/// Resolves the references in the XML text `written`. Unknown references, except to characters and the five predefined
/// entities, are kept. `origins`: source position of each resulting byte and of the end, if `written` starts at
/// `begin`.
std::string unescape_xml(std::string_view written, std::uint32_t begin, std::vector<std::uint32_t>& origins);
std::string unescape_xml(std::string_view written);

}  // namespace grafverif
