// SPDX-License-Identifier: MIT
// Html: builds the text of a page. Text and values of attributes are escaped, so that browsers never interpret text of
// the user as markup. Control characters, including characters that control the text direction, become `?`.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace grafverif {

class Html {
public:
    using Attributes = std::vector<std::pair<std::string_view, std::string>>;

    /// Begins an element. The tag and the names of attributes are not escaped; they must be constants in the source
    /// code.
    Html& open(std::string_view tag, const Attributes& attributes = {});
    Html& close(std::string_view tag);
    Html& text(std::string_view words);
    /// Adds an element that contains only text.
    Html& put(std::string_view tag, std::string_view words, const Attributes& attributes = {});
    /// Adds a message. Text between backticks is formatted as code.
    Html& prose(std::string_view message);
    /// Adds markup without escaping it. Requires that grafverif generated the markup.
    Html& trusted(std::string_view markup);

    const std::string& str() const { return html_; }

private:
    std::string html_ = {};
};

}  // namespace grafverif
