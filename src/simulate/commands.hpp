// SPDX-License-Identifier: MIT
// The commands of `simulate`, one per line, typed or from a script:
//
//   NAME = VALUE         make an input (or a variable of the plant) true, false, or a number; of a chart alone also
//                        `NAME = VALUE, NAME = VALUE`, at once
//   wait 3s              let time pass: ms, s or min;  `wait` alone: until something happens by itself, or can
//   do INSTANCE          the instance does what it can;  `do INSTANCE LOCATION`: what leads it to the location
//   force STEP on        a trial: the step is made active by hand, or not (`off`); no run of the model from then on
//   3                    the third of the choices listed
//   back                 undo the last command
//   quit                 end;  so does the end of the input
//
// Empty lines and what stands behind `//` or `#` mean nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "simulate/settings.hpp"

namespace grafverif {

struct SetCommand {
    std::vector<Setting> settings = {};  ///< at least one
    bool operator==(const SetCommand&) const = default;
};
struct WaitCommand {
    std::optional<std::int64_t> milliseconds = {};
    bool operator==(const WaitCommand&) const = default;
};
struct DoCommand {
    std::string instance = {}, location = {};
    bool operator==(const DoCommand&) const = default;
};
struct ForceCommand {
    std::string step = {};
    bool active = false;
    bool operator==(const ForceCommand&) const = default;
};
struct ChooseCommand {
    std::size_t number = 0;
    bool operator==(const ChooseCommand&) const = default;
};
struct BackCommand {
    bool operator==(const BackCommand&) const = default;
};
struct QuitCommand {
    bool operator==(const QuitCommand&) const = default;
};
struct HelpCommand {
    bool operator==(const HelpCommand&) const = default;
};
struct NoCommand {
    bool operator==(const NoCommand&) const = default;
};
/// What is wrong with the line.
struct BadCommand {
    std::string complaint = {};
    bool operator==(const BadCommand&) const = default;
};

using Command = std::variant<SetCommand, WaitCommand, DoCommand, ForceCommand, ChooseCommand, BackCommand, QuitCommand,
                             HelpCommand, NoCommand, BadCommand>;

Command command_of(std::string_view line);

}  // namespace grafverif
