// SPDX-License-Identifier: MIT
// A script of simulation commands, which is parsed completely before it is executed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "simulate/commands.hpp"

namespace grafverif {

struct Script {
    struct Line {
        Command command = {};
        std::uint32_t number = 0;
    };
    std::vector<Line> lines = {};
    /// Line numbers of invalid lines, with error messages.
    std::vector<std::pair<std::uint32_t, std::string>> error_texts = {};
};

Script script_of(std::string_view text);

}  // namespace grafverif
