// SPDX-License-Identifier: MIT
#include "app/system/screen.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>

namespace grafverif::app {

namespace {

std::string variable(const char* name) {
    const char* const value = std::getenv(name);
    return value == nullptr ? "" : value;
}

bool knows_more_than_lines(const std::string& term) { return !term.empty() && term != "dumb"; }

}  // namespace

bool has_colours(bool terminal, const std::string& no_color, const std::string& clicolor_force,
                 const std::string& term) {
    if (!no_color.empty()) return false;
    if (!clicolor_force.empty() && clicolor_force != "0") return true;
    return terminal && knows_more_than_lines(term);
}

Screen screen_of(int descriptor) {
    Screen screen{.terminal = ::isatty(descriptor) == 1};
    screen.rewrites = screen.terminal && knows_more_than_lines(variable("TERM"));
    screen.colours = has_colours(screen.terminal, variable("NO_COLOR"), variable("CLICOLOR_FORCE"), variable("TERM"));
    winsize size = {};
    if (screen.terminal && ::ioctl(descriptor, TIOCGWINSZ, &size) == 0) screen.columns = size.ws_col;
    return screen;
}

}  // namespace grafverif::app
