// SPDX-License-Identifier: MIT
// Returns addresses of pages of the documentation site.
#pragma once

#include <string>
#include <string_view>

namespace grafverif {

/// Returns the address at which the site is published (CMake variable GRAFVERIF_DOCUMENTATION_URL), or an empty string
/// if the site is not published.
std::string_view documentation_url();

/// Returns the address of the entry of the diagnostic `code` on the site at `base`; empty if `base` is empty.
std::string diagnostic_page(std::string_view code, std::string_view base = documentation_url());

/// Returns the text of `code` for a terminal: a hyperlink (OSC 8) to the entry of `code` on the site at `base`, or only
/// `code` if `base` is empty.
std::string terminal_link(std::string_view code, std::string_view base = documentation_url());

}  // namespace grafverif
