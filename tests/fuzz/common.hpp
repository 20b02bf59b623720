// SPDX-License-Identifier: MIT
// Common functions of several fuzz targets.
#pragma once

#include <sstream>
#include <string>

#include "grafverif/support/diagnostic.hpp"

namespace grafverif::fuzz {

/// A chart with inputs and outputs of all types, and a closed loop that contains it.
inline constexpr const char* press_text = R"(grafcet press {
    input start, stop, done;
    input level: int 0..9;
    output down, lamp;
    output speed: int -1..3;

    initial step 1;
    step 2 { down; speed := level % 3 on activation; }

    transition t1: 1 -> 2 when start && !stop;
    transition t2: 2 -> 1 when done && 2s/X2;
}

closed_loop pressing {
    controller press;
    plant L = lamp(ON = lamp);
    environment A = push_button(OUT = start);
    environment B = push_button(OUT = stop);
    environment C = free(OUT = done);
    environment D = free_integer(OUT = level, LOW = 0, HIGH = 9);

    property p: never X2 && down;
    property q: X1 leads to X2;
    property r: reachable speed == 2;
}
)";

/// Returns the diagnostics as displayed to users. The targets call this function because formatting must not fail.
inline std::string shown(const Diagnostics& diagnostics, const Sources& sources) {
    std::ostringstream text;
    render_text(diagnostics.all(), sources, Colour::Plain, text);
    return text.str();
}

}  // namespace grafverif::fuzz
