// SPDX-License-Identifier: MIT
// Provides the style and the script of pages, from the folder `web/`, and their hashes. A page permits only scripts and
// styles with these hashes. cmake/embed_web.cmake generates the sources.
#pragma once

#include <string_view>

namespace grafverif {

struct WebText {
    std::string_view text = {};
    std::string_view sha256 = {};  ///< SHA-256 hash of the text in base64
};

WebText page_style();
WebText page_script();

}  // namespace grafverif
