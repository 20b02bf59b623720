// SPDX-License-Identifier: MIT
// Xml: a document with the place of everything in it. Nothing is replaced or normalised while it is parsed, so that a
// text read later has the places of the file.
//
// Elements and attributes are known by their local names: prefixes differ from tool to tool.
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
    /// Empty after an error: no text, not well-formed, entities, nested deeper than 1,000 levels. A document in Latin-1
    /// or UTF-16 is rewritten in `sources` as UTF-8, so that places are those of what is shown.
    static std::optional<Xml> read(Id<Source> source, Sources& sources, Diagnostics& diagnostics);

    pugi::xml_node root() const { return root_; }
    Id<Source> source() const { return source_; }

    /// The name in the start tag of an element; the text of anything else.
    Span where(pugi::xml_node node) const;
    /// The value of the attribute, or where(node) without it.
    Span where(pugi::xml_node node, std::string_view attribute) const;
    /// The texts within an element, in order.
    st::Text text(pugi::xml_node node) const;
    /// The value of an attribute as a text.
    st::Text text(pugi::xml_node node, std::string_view attribute) const;
    /// The value of an xsd:boolean, false where there is none, or after an error.
    bool flag(pugi::xml_node node, std::string_view attribute, Diagnostics& diagnostics) const;
    /// What text() stands for.
    std::string content(pugi::xml_node node) const;

private:
    std::uint32_t offset(const char* place) const {
        return begin_ + static_cast<std::uint32_t>(place - buffer_.data());
    }

    Id<Source> source_ = {};
    std::uint32_t begin_ = 0;  ///< of the buffer in the source
    std::vector<char> buffer_ = {};
    pugi::xml_document document_ = {};
    pugi::xml_node root_ = {};
};

/// `Grafcet` of `grafcet:Grafcet`.
std::string_view local_name(const char* name);
bool is(pugi::xml_node node, std::string_view name);
/// The first child element of that name.
pugi::xml_node child(pugi::xml_node node, std::string_view name);
std::vector<pugi::xml_node> children(pugi::xml_node node, std::string_view name);
pugi::xml_attribute attribute(pugi::xml_node node, std::string_view name);
/// Empty where there is none.
std::string value(pugi::xml_node node, std::string_view attribute);
/// The text of a comment of XML as lines of ours, `// ...`.
std::vector<std::string> comment_lines(std::string_view text);

}  // namespace grafverif
