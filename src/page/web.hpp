// SPDX-License-Identifier: MIT
// The style and the script of pages, as they stand in `web/`, and the hashes by which a page allows them and nothing
// else. The sources are made by cmake/embed_web.cmake.
#pragma once

#include <string_view>

namespace grafverif {

struct WebText {
    std::string_view text = {};
    std::string_view sha256 = {};  ///< of the text, in base64
};

WebText page_style();
WebText page_script();

}  // namespace grafverif
