// SPDX-License-Identifier: MIT
#include "page/html.hpp"

#include "support/printable.hpp"
#include "support/xml_text.hpp"

namespace grafverif {

Html& Html::open(std::string_view tag, const Attributes& attributes) {
    (html_ += '<') += tag;
    for (const auto& [name, value] : attributes)
        ((((html_ += ' ') += name) += "=\"") += attribute_xml(printable(value))) += '"';
    html_ += '>';
    return *this;
}

Html& Html::close(std::string_view tag) {
    ((html_ += "</") += tag) += ">\n";
    return *this;
}

Html& Html::text(std::string_view words) {
    escape_xml(printable_lines(words), html_);
    return *this;
}

Html& Html::put(std::string_view tag, std::string_view words, const Attributes& attributes) {
    return open(tag, attributes).text(words).close(tag);
}

Html& Html::ours(std::string_view markup) {
    html_ += markup;
    return *this;
}

}  // namespace grafverif
