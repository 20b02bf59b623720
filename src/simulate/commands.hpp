// SPDX-License-Identifier: MIT
// The commands of `simulate`, one per line, typed or from a script:
//
//   NAME = VALUE         make an input (or a variable of the plant) true, false, or a number; of a chart alone also
//                        `NAME = VALUE, NAME = VALUE`, at once
//   wait 3s              let time pass: ms, s or min;  `wait` alone: until something happens by itself, or can
//   do INSTANCE          the instance does what it can;  `do INSTANCE LOCATION`: what leads it to the location
//   force STEP on        a trial: the step is made active by hand, or not (`off`); no run of the model from then on
//   3                    the third of the choices listed
//   back, undo           undo the last command
//   expect CLAIM         it holds now (simulate/claim.hpp);  `expect within 5s CLAIM`: it does in at most so much time
//   wait until CLAIM     let time pass until it holds
//   show                 the values of everything now
//   repeat 3 {           in a script: what follows, up to a line `}`, so many times
//   save FILE            write what was done as a script
//   quit                 end;  so does the end of the input
//
// Empty lines and what stands behind `//` or `#` mean nothing.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "simulate/claim.hpp"
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
/// `patience_ms`: until then; 0: now; empty: as long as something happens by itself.
struct ExpectCommand {
    Claim claim = {};
    std::optional<std::int64_t> patience_ms = 0;
    bool operator==(const ExpectCommand&) const = default;
};
struct ShowCommand {
    bool operator==(const ShowCommand&) const = default;
};
struct RepeatCommand {
    std::uint64_t times = 0;
    bool operator==(const RepeatCommand&) const = default;
};
/// `}`
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
/// What is wrong with the line.
struct BadCommand {
    std::string complaint = {};
    bool operator==(const BadCommand&) const = default;
};

using Command =
    std::variant<SetCommand, WaitCommand, DoCommand, ForceCommand, ChooseCommand, BackCommand, ExpectCommand,
                 ShowCommand, RepeatCommand, EndCommand, SaveCommand, QuitCommand, HelpCommand, NoCommand, BadCommand>;

/// The words that a command can begin with.
inline constexpr std::array<std::string_view, 12> command_words = {
    "back", "do", "expect", "force", "help", "quit", "repeat", "save", "show", "undo", "wait", "wait until"};

Command command_of(std::string_view line);

}  // namespace grafverif
