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

std::string terminal_link(std::string_view code, std::string_view base) {
    const std::string page = diagnostic_page(code, base);
    if (page.empty()) return std::string(code);
    return "\x1b]8;;" + page + "\x1b\\" + std::string(code) + "\x1b]8;;\x1b\\";
}

}  // namespace grafverif
