// SPDX-License-Identifier: MIT
#include "support/text/documentation.hpp"

namespace grafverif {

std::string_view documentation_url() { return GRAFVERIF_DOCUMENTATION_URL; }

std::string diagnostic_page(std::string_view code, std::string_view base) {
    if (base.empty() || code.empty()) return {};
    std::string page(base);
    if (!page.ends_with('/')) page += '/';
    return page.append("reference/diagnostics.html#").append(code);
}

}  // namespace grafverif
