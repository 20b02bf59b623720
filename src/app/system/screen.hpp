// SPDX-License-Identifier: MIT
// Screen: the terminal properties of a stream.
#pragma once

#include <cstddef>
#include <string>

namespace grafverif::app {

struct Screen {
    bool terminal = false;
    bool rewrites = false;  ///< true for a terminal on which a line can be overwritten
    bool colours = false;
    std::size_t columns = 0;  ///< number of columns; 0 means unlimited
};

/// True if colours are used by default. `NO_COLOR` (no-color.org) disables colours; `CLICOLOR_FORCE`
/// (bixense.com/clicolors) enables them in any case. If neither variable is set, a terminal has
/// colours unless its `TERM` is `dumb` or missing. An empty variable, and `CLICOLOR_FORCE=0`, are
/// treated as missing.
bool has_colours(bool terminal, const std::string& no_color, const std::string& clicolor_force,
                 const std::string& term);

/// Returns the screen of a descriptor of this process, according to the environment.
Screen screen_of(int descriptor);

}  // namespace grafverif::app
