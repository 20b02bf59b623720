// SPDX-License-Identifier: MIT
// The files of the pages of `serve` and `edit`, from `web/`. cmake/embed_live.cmake generates the source.
#pragma once

#include <span>
#include <string_view>

namespace grafverif::app {

struct LiveFile {
    std::string_view name = {}, text = {};
};

std::span<const LiveFile> live_files();

}  // namespace grafverif::app
