// SPDX-License-Identifier: MIT
// Commands of `simulate`, one per line, entered interactively or read from a script:
//
//   NAME = VALUE         set an input (or a variable of the plant) to true, false, or a number; for a single chart,
//                        `NAME = VALUE, NAME = VALUE` sets several inputs simultaneously
//   wait 3s              let 3 s pass (units: ms, s, min); `wait`: let time pass until the next spontaneous or
//                        possible event
//   do INSTANCE          take the first enabled edge of the instance;  `do INSTANCE LOCATION`: an edge to LOCATION
//   force STEP on        activate (`off`: deactivate) a step; the result is no longer a run of the model
//   3                    make the third of the listed choices
//   back, undo           undo the last command
//   expect CLAIM         check that CLAIM holds now (simulate/expectation.hpp);  `expect within 5s CLAIM`: that it
//                        becomes true within this time
//   wait until CLAIM     let time pass until CLAIM holds
//   show                 print all current values
//   repeat 3 {           in a script: repeat the lines up to a line `}`
//   save FILE            write the commands executed so far as a script
//   quit                 end the simulation; the end of the input has the same effect
//
// Empty lines are ignored. Text after `//` or `#` is also ignored.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "simulate/expectation.hpp"
#include "simulate/settings.hpp"

namespace grafverif {

struct SetCommand {
    std::vector<Setting> settings = {};  ///< at least one input with its new value
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
/// A command `expect` or `wait until`. `response_timeout_ms` is its time limit. With the limit 0, the expectation must
/// hold now. Without a limit, time passes until the expectation holds or no further spontaneous event occurs.
struct ExpectCommand {
    Expectation claim = {};
    std::optional<std::int64_t> response_timeout_ms = 0;
    bool operator==(const ExpectCommand&) const = default;
};
struct ShowCommand {
    bool operator==(const ShowCommand&) const = default;
};
struct RepeatCommand {
    std::uint64_t times = 0;
    bool operator==(const RepeatCommand&) const = default;
};
/// The line `}`, which ends a `repeat`.
struct EndCommand {
    bool operator==(const EndCommand&) const = default;
};
struct SaveCommand {
    std::string file = {};
    bool operator==(const SaveCommand&) const = default;
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
/// A line that is not a valid command, with an error message.
struct BadCommand {
    std::string error_text = {};
    bool operator==(const BadCommand&) const = default;
};

using Command =
    std::variant<SetCommand, WaitCommand, DoCommand, ForceCommand, ChooseCommand, BackCommand, ExpectCommand,
                 ShowCommand, RepeatCommand, EndCommand, SaveCommand, QuitCommand, HelpCommand, NoCommand, BadCommand>;

/// Words with which a command can begin.
inline constexpr std::array<std::string_view, 12> command_text = {
    "back", "do", "expect", "force", "help", "quit", "repeat", "save", "show", "undo", "wait", "wait until"};

Command command_of(std::string_view line);

}  // namespace grafverif
