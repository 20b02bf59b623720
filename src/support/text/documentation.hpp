// SPDX-License-Identifier: MIT
// Addresses of the documentation site.
#pragma once

#include <string>
#include <string_view>

namespace grafverif {

/// Returns the address at which the site is published, from the CMake variable GRAFVERIF_DOCUMENTATION_URL, or an empty
/// string if it is not published.
std::string_view documentation_url();

/// Returns the address of the entry of a diagnostic on the site at `base`; empty without a base.
std::string diagnostic_page(std::string_view code, std::string_view base = documentation_url());

/// Returns the text of `code` for a terminal: a hyperlink (OSC 8) to its entry on the site at `base`; without a base,
/// only `code`.
std::string terminal_link(std::string_view code, std::string_view base = documentation_url());

}  // namespace grafverif
