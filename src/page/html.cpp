// SPDX-License-Identifier: MIT
#include "page/html.hpp"

#include "support/printable.hpp"
#include "support/xml_text.hpp"

namespace grafverif {

namespace {

/// True if `tag` is an inline element. After an inline element, no line break is written, because browsers render a
/// line break as a blank.
bool inline_tag(std::string_view tag) { return tag == "code" || tag == "strong" || tag == "span"; }

}  // namespace

Html& Html::open(std::string_view tag, const Attributes& attributes) {
    (html_ += '<') += tag;
    for (const auto& [name, value] : attributes)
        ((((html_ += ' ') += name) += "=\"") += attribute_xml(printable(value))) += '"';
    html_ += '>';
    return *this;
}

Html& Html::close(std::string_view tag) {
    ((html_ += "</") += tag) += inline_tag(tag) ? ">" : ">\n";
    return *this;
}

Html& Html::text(std::string_view words) {
    escape_xml(printable_lines(words), html_);
    return *this;
}

Html& Html::put(std::string_view tag, std::string_view words, const Attributes& attributes) {
    return open(tag, attributes).text(words).close(tag);
}

Html& Html::prose(std::string_view message) {
    for (bool code = false;; code = !code) {
        const std::size_t end = message.find('`');
        const std::string_view part = message.substr(0, end);
        if (code) put("code", part);
        else text(part);
        if (end == std::string_view::npos) return *this;
        message.remove_prefix(end + 1);
    }
}

Html& Html::trusted(std::string_view markup) {
    html_ += markup;
    return *this;
}

}  // namespace grafverif
