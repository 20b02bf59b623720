// SPDX-License-Identifier: MIT
// Provides the texts and names of the component library, which are computed only once.
#pragma once

#include <memory>
#include <string_view>

#include "lsp/names.hpp"

namespace grafverif::lsp {

/// Returns the file of the library with this path, such as `<library>/lamp.grafcet`, or null if the library has no such
/// file.
std::shared_ptr<const Parsed> library_file(std::string_view path);
/// Returns the names of all components of the library.
const Names& library_names();

}  // namespace grafverif::lsp
