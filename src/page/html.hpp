// SPDX-License-Identifier: MIT
// A page under construction. Text and values of attributes are escaped on their way in, so that nothing that anybody
// wrote is ever read as markup; what turns the direction of text, and control characters, become `?`.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace grafverif {

class Html {
public:
    using Attributes = std::vector<std::pair<std::string_view, std::string>>;

    /// Begins an element; tags and names of attributes are ours.
    Html& open(std::string_view tag, const Attributes& attributes = {});
    Html& close(std::string_view tag);
    Html& text(std::string_view words);
    /// An element with nothing but text.
    Html& put(std::string_view tag, std::string_view words, const Attributes& attributes = {});
    /// A message: what stands between backticks is code.
    Html& prose(std::string_view message);
    /// Markup that we made ourselves.
    Html& ours(std::string_view markup);

    const std::string& str() const { return html_; }

private:
    std::string html_ = {};
};

}  // namespace grafverif
