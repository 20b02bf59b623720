// SPDX-License-Identifier: MIT
// Escapes and unescapes text for XML. Markup characters are escaped. Characters that XML 1.0 forbids (control
// characters, invalid UTF-8) are replaced by U+FFFD, so that a document is well-formed for every input.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace grafverif {

/// Appends `text` as character data.
void escape_xml(std::string_view text, std::string& xml);

/// Returns `text` as an attribute value in double quotes.
std::string attribute_xml(std::string_view text);

/// Appends `text` as the content of a comment, in which `--` is not allowed.
void comment_xml(std::string_view text, std::string& xml);

/// Resolves references to characters and to the five predefined entities in the XML text `written`. Other references
/// are kept. `begin` is the source position of `written`. `origins` receives the source position of each resulting byte
/// and of the end.
std::string unescape_xml(std::string_view written, std::uint32_t begin, std::vector<std::uint32_t>& origins);
std::string unescape_xml(std::string_view written);

}  // namespace grafverif
