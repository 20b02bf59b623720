// SPDX-License-Identifier: MIT
// The parts of the page of `serve`, as they stand in `web/`; the source is made by cmake/embed_live.cmake.
#pragma once

#include <span>
#include <string_view>

namespace grafverif::app {

struct LiveFile {
    std::string_view name = {}, text = {};
};

std::span<const LiveFile> live_files();

}  // namespace grafverif::app
