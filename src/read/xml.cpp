// SPDX-License-Identifier: MIT
#include "read/xml.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <new>
#include <string>
#include <string_view>
#include <unordered_set>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"
#include "support/messages.hpp"
#include "support/text/encoding.hpp"
#include "support/xml_text.hpp"
#include "syntax/language/readable.hpp"
#include "syntax/st/st_tree.hpp"

namespace grafverif {

namespace {

/// Returns the value of `encoding` in the XML declaration as a view of the text, or an empty string if the declaration
/// has no such value.
std::string_view declared_encoding(std::string_view text) {
    const std::string_view head =
        text.substr(0, text.starts_with("<?xml") ? std::min(text.find("?>"), text.size()) : 0);
    const std::size_t word = head.find("encoding");
    if (word == std::string_view::npos) return {};
    const std::size_t open = head.find_first_of("\"'", word);
    if (open == std::string_view::npos) return {};
    const std::size_t close = head.find(head[open], open + 1);
    return close == std::string_view::npos ? std::string_view{} : head.substr(open + 1, close - open - 1);
}

/// Converts the text of `source` to UTF-8 if its byte order mark or XML declaration specifies UTF-16 or Latin-1 (or
/// Windows-1252). Returns false after an error: the encoding is not supported.
bool decode_xml(Id<Source> source, Sources& sources, Diagnostics& diagnostics) {
    std::string& text = sources[source].text;
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
        if (text.size() % 2 == 0) text = utf8_of_utf16(text);  // `is_readable` reports an odd number of bytes
        return true;
    }
    const std::size_t mark = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    const std::string_view encoding = declared_encoding(std::string_view(text).substr(mark));
    const std::string name = st::capitals(encoding);
    if (mark == 3 || name.empty() || name == "UTF-8" || name == "UTF8" || name == "ASCII" || name == "US-ASCII")
        return true;
    if (name == "ISO-8859-1" || name == "LATIN1" || name == "WINDOWS-1252" || name == "CP1252") {
        text = utf8_of_latin(text);
        return true;
    }
    const auto begin = static_cast<std::uint32_t>(encoding.data() - text.data());
    diagnostics.add(
        messages::unknown_encoding({source, begin, begin + static_cast<std::uint32_t>(encoding.size())}, encoding));
    return false;
}

constexpr std::size_t deepest_element = 1000;

std::string_view described(pugi::xml_parse_status status) {
    switch (status) {
    case pugi::status_unrecognized_tag: return "invalid tag";
    case pugi::status_bad_pi: return "a processing instruction does not end";
    case pugi::status_bad_comment: return "a comment does not end";
    case pugi::status_bad_cdata: return "a CDATA section does not end";
    case pugi::status_bad_doctype: return "the document type declaration does not end";
    case pugi::status_bad_pcdata: return "a text does not end";
    case pugi::status_bad_start_element: return "a start tag does not end";
    case pugi::status_bad_attribute: return "an attribute must have the form `name=\"value\"`";
    case pugi::status_bad_end_element: return "an end tag is malformed";
    case pugi::status_end_element_mismatch: return "an end tag closes another element, or an element is not closed";
    case pugi::status_no_document_element: return "the document has no element";
    default: return "the document cannot be parsed";
    }
}

/// True if an attribute occurs twice in one element, which XML forbids.
bool has_twins(pugi::xml_node node) {
    std::unordered_set<std::string_view> seen;
    for (const pugi::xml_attribute& one : node.attributes())
        if (!seen.insert(one.name()).second) return true;
    return false;
}

}  // namespace

std::optional<Xml> Xml::read(Id<Source> source, Sources& sources, Diagnostics& diagnostics) {
    if (!decode_xml(source, sources, diagnostics)) return {};
    const Span whole = without_mark({source, 0, static_cast<std::uint32_t>(sources[source].text.size())}, sources);
    if (!is_readable(whole, sources, diagnostics)) return {};
    const std::string_view text = std::string_view(sources[source].text).substr(whole.begin);
    const auto place = [&](std::size_t at) {
        const auto begin = static_cast<std::uint32_t>(whole.begin + std::min(at, text.size()));
        return Span{source, begin, std::min(begin + 1, whole.end)};
    };
    if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
        diagnostics.add(messages::broken_xml(place(nul), "the document contains a NUL byte"));
        return {};
    }
    Xml xml;
    xml.source_ = source;
    xml.begin_ = whole.begin;
    xml.buffer_.assign(text.begin(), text.end());
    const unsigned flags = pugi::parse_cdata | pugi::parse_comments | pugi::parse_doctype;
    const pugi::xml_parse_result result =
        xml.document_.load_buffer_inplace(xml.buffer_.data(), xml.buffer_.size(), flags, pugi::encoding_utf8);
    if (result.status == pugi::status_out_of_memory) throw std::bad_alloc();
    if (!result) {
        diagnostics.add(messages::broken_xml(place(static_cast<std::size_t>(result.offset)), described(result.status)));
        return {};
    }
    for (const pugi::xml_node& node : xml.document_.children()) {
        if (node.type() == pugi::node_doctype && std::strstr(node.value(), "<!ENTITY") != nullptr) {
            diagnostics.add(messages::declared_entities(xml.where(node)));
            return {};
        }
        if (node.type() != pugi::node_element) continue;
        if (xml.root_) {
            diagnostics.add(messages::broken_xml(xml.where(node), "the document has a second root element"));
            return {};
        }
        xml.root_ = node;
    }
    std::size_t depth = 0;
    for (pugi::xml_node node = xml.root_;;) {
        if (node.type() == pugi::node_element && has_twins(node)) {
            diagnostics.add(messages::broken_xml(xml.where(node), "an attribute occurs twice"));
            return {};
        }
        if (node.first_child()) {
            node = node.first_child();
            if (++depth < deepest_element) continue;
            diagnostics.add(messages::elements_too_deep(xml.where(node), deepest_element));
            return {};
        }
        while (node != xml.root_ && !node.next_sibling()) {
            node = node.parent();
            --depth;
        }
        if (node == xml.root_) return xml;
        node = node.next_sibling();
    }
}

Span Xml::where(pugi::xml_node node) const {
    const bool element = node.type() == pugi::node_element;
    const char* text = element ? node.name() : node.value();
    if (*text == '\0') return {source_, begin_, begin_};
    const std::uint32_t begin = offset(text);
    const auto length = static_cast<std::uint32_t>(std::strlen(text));
    return {source_, begin, begin + (element ? length : std::min<std::uint32_t>(length, 1))};
}

Span Xml::where(pugi::xml_node node, std::string_view attribute) const {
    const pugi::xml_attribute found = grafverif::attribute(node, attribute);
    if (!found || *found.value() == '\0') return where(node);
    const std::uint32_t begin = offset(found.value());
    return {source_, begin, begin + static_cast<std::uint32_t>(std::strlen(found.value()))};
}

st::Text Xml::text(pugi::xml_node node) const {
    st::Text pieces;
    for (pugi::xml_node at = node.first_child(); at && at != node;) {
        const bool data = at.type() == pugi::node_cdata || at.type() == pugi::node_pcdata;
        if (data && *at.value() != '\0') {
            const std::uint32_t begin = offset(at.value());
            const auto length = static_cast<std::uint32_t>(std::strlen(at.value()));
            pieces.push_back({{source_, begin, begin + length}, at.type() == pugi::node_pcdata});
        }
        if (at.first_child()) {
            at = at.first_child();
            continue;
        }
        while (at != node && !at.next_sibling()) at = at.parent();
        if (at != node) at = at.next_sibling();
    }
    if (pieces.empty()) pieces.push_back({{source_, where(node).end, where(node).end}, false});
    return pieces;
}

st::Text Xml::text(pugi::xml_node node, std::string_view attribute) const { return {{where(node, attribute), true}}; }

std::string Xml::content(pugi::xml_node node) const {
    std::string all;
    for (const st::Piece& piece : text(node)) {
        const std::string part(buffer_.data() + (piece.where.begin - begin_), piece.where.end - piece.where.begin);
        all += piece.escaped ? unescape_xml(part) : part;
    }
    return all;
}

std::string_view local_name(const char* name) {
    const std::string_view whole = name;
    const std::size_t colon = whole.rfind(':');
    return colon == std::string_view::npos ? whole : whole.substr(colon + 1);
}

bool is(pugi::xml_node node, std::string_view name) {
    return node.type() == pugi::node_element && local_name(node.name()) == name;
}

pugi::xml_node child(pugi::xml_node node, std::string_view name) {
    for (const pugi::xml_node& one : node.children())
        if (is(one, name)) return one;
    return {};
}

std::vector<pugi::xml_node> children(pugi::xml_node node, std::string_view name) {
    std::vector<pugi::xml_node> found;
    for (const pugi::xml_node& one : node.children())
        if (is(one, name)) found.push_back(one);
    return found;
}

pugi::xml_attribute attribute(pugi::xml_node node, std::string_view name) {
    for (const pugi::xml_attribute& one : node.attributes())
        if (local_name(one.name()) == name && std::strncmp(one.name(), "xmlns", 5) != 0) return one;
    return {};
}

std::string value(pugi::xml_node node, std::string_view name) { return unescape_xml(attribute(node, name).value()); }

bool Xml::flag(pugi::xml_node node, std::string_view name, Diagnostics& diagnostics) const {
    const std::string text = value(node, name);
    if (!text.empty() && text != "true" && text != "1" && text != "false" && text != "0")
        diagnostics.add(
            messages::bad_value(where(node, name), '`' + std::string(name) + '`', text, "`true` or `false`"));
    return text == "true" || text == "1";
}

std::vector<std::string> comment_lines(std::string_view text) {
    std::vector<std::string> lines;
    constexpr std::string_view blanks = " \t\r\f\v";
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::size_t first = line.find_first_not_of(blanks);
        if (first == std::string_view::npos) continue;
        line = line.substr(first, line.find_last_not_of(blanks) + 1 - first);
        lines.push_back("// " + std::string(line));
    }
    return lines;
}

}  // namespace grafverif
