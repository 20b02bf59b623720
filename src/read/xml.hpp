// SPDX-License-Identifier: MIT
// Xml: a parsed XML document with source positions. The XML parser does not replace or normalize text, so that
// expressions in the document, which are parsed later, have exact positions in the file.
//
// Elements and attributes are identified by their local names, because prefixes differ between tools.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"
#include "syntax/st/parse_st.hpp"

namespace grafverif {

class Xml {
public:
    /// Reads a document. The result is empty after an error: the document is not text, is not well-formed, declares
    /// entities, or is nested deeper than 1,000 levels. A document in Latin-1 or UTF-16 is converted to UTF-8 in
    /// `sources`; positions refer to the converted text.
    static std::optional<Xml> read(Id<Source> source, Sources& sources, Diagnostics& diagnostics);

    pugi::xml_node root() const { return root_; }
    Id<Source> source() const { return source_; }

    /// Returns the span of the name in the start tag of an element; for other nodes, the span of the first
    /// byte of their text.
    Span where(pugi::xml_node node) const;
    /// Returns the span of the attribute's value, or where(node) if the attribute is missing.
    Span where(pugi::xml_node node, std::string_view attribute) const;
    /// Returns the pieces of text in an element, in order.
    st::Text text(pugi::xml_node node) const;
    /// Returns the value of an attribute as a text with its position.
    st::Text text(pugi::xml_node node, std::string_view attribute) const;
    /// Returns the value of an attribute of type xsd:boolean; false if the attribute is missing or invalid.
    bool flag(pugi::xml_node node, std::string_view attribute, Diagnostics& diagnostics) const;
    /// Returns the pieces of `text(node)` as one string.
    std::string content(pugi::xml_node node) const;

private:
    std::uint32_t offset(const char* place) const {
        return begin_ + static_cast<std::uint32_t>(place - buffer_.data());
    }

    Id<Source> source_ = {};
    std::uint32_t begin_ = 0;  ///< offset of the buffer in the source
    std::vector<char> buffer_ = {};
    pugi::xml_document document_ = {};
    pugi::xml_node root_ = {};
};

/// Returns a name without its prefix, for example `Grafcet` for `grafcet:Grafcet`.
std::string_view local_name(const char* name);
bool is(pugi::xml_node node, std::string_view name);
/// Returns the first child element with this name.
pugi::xml_node child(pugi::xml_node node, std::string_view name);
std::vector<pugi::xml_node> children(pugi::xml_node node, std::string_view name);
pugi::xml_attribute attribute(pugi::xml_node node, std::string_view name);
/// Returns the value of an attribute, or an empty string if the attribute is missing.
std::string value(pugi::xml_node node, std::string_view attribute);
/// Returns the text of an XML comment as comment lines `// ...`.
std::vector<std::string> comment_lines(std::string_view text);

}  // namespace grafverif
