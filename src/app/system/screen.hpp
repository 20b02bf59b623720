// SPDX-License-Identifier: MIT
// Screen: what a person sees of a stream.
#pragma once

#include <cstddef>
#include <string>

namespace grafverif::app {

struct Screen {
    bool terminal = false;
    bool rewrites = false;  ///< a terminal on which a line can be written over
    bool colours = false;
    std::size_t columns = 0;  ///< 0: as wide as it gets
};

/// Whether to colour what goes there, if nobody says: `NO_COLOR` (no-color.org) forbids it, `CLICOLOR_FORCE`
/// (bixense.com/clicolors) asks for it in any case; else a terminal has colours unless its `TERM` is `dumb`, or missing.
/// A variable that is empty, and `CLICOLOR_FORCE=0`, count as missing.
bool has_colours(bool terminal, const std::string& no_color, const std::string& clicolor_force,
                 const std::string& term);

/// That of a descriptor of ours, by the environment.
Screen screen_of(int descriptor);

}  // namespace grafverif::app
