// SPDX-License-Identifier: MIT
// Commands of `simulate`, one per line, entered interactively or read from a script:
//
//   NAME = VALUE         set an input (or a variable of the plant) to true, false, or a number; for a single chart also
//                        `NAME = VALUE, NAME = VALUE`, simultaneously
//   wait 3s              let time pass: ms, s or min;  `wait` alone: until the next spontaneous or possible event
//   do INSTANCE          take the first enabled edge of the instance;  `do INSTANCE LOCATION`: one to the location
//   force STEP on        activate (`off`: deactivate) a step by hand; from then on not a run of the model
//   3                    the third of the listed choices
//   back, undo           undo the last command
//   expect CLAIM         it holds now (simulate/expectation.hpp);  `expect within 5s CLAIM`: it becomes true within
//   this time wait until CLAIM     let time pass until it holds
//   show                 print all current values
//   repeat 3 {           in a script: repeat the lines up to a line `}`
//   save FILE            write the commands so far as a script
//   quit                 end; the end of the input has the same effect
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
    std::vector<Setting> settings = {};  ///< contains at least one setting
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
/// An `expect` command. `response_timeout_ms` is its time limit. If it is 0, the expectation must hold now. If it is
/// empty, the expectation may become true for as long as spontaneous events occur.
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
/// The end of a `repeat`: `}`.
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
/// The message for an invalid line.
struct BadCommand {
    std::string error_text = {};
    bool operator==(const BadCommand&) const = default;
};

using Command =
    std::variant<SetCommand, WaitCommand, DoCommand, ForceCommand, ChooseCommand, BackCommand, ExpectCommand,
                 ShowCommand, RepeatCommand, EndCommand, SaveCommand, QuitCommand, HelpCommand, NoCommand, BadCommand>;

/// Words with which a command begins.
inline constexpr std::array<std::string_view, 12> command_text = {
    "back", "do", "expect", "force", "help", "quit", "repeat", "save", "show", "undo", "wait", "wait until"};

Command command_of(std::string_view line);

}  // namespace grafverif
