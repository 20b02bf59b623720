// SPDX-License-Identifier: MIT
// The rows of the option table.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/options.hpp"

namespace grafverif::app {

/// An option of the commands that accept its group.
struct Option {
    OptionGroup accepts = OptionGroup::Always;
    std::string name = {};   ///< with its letter, if any: `output,o`
    std::string value = {};  ///< placeholder of its value in the help; empty: a switch, which has no value
    std::string help = {};   ///< empty: not shown in the help
    /// Stores the given values, or the fact that the option was given; returns an error message, or nothing.
    std::function<std::string(const std::vector<std::string>&, Options&)> take = {};
    bool repeated = false;
    bool is_command = false;  ///< only as a separate word: `--NAME=COMMAND` may be the name of a file
    std::string former = {};  ///< deprecated name, accepted with a warning; empty: none

    std::string long_name() const { return name.substr(0, name.find(',')); }
    std::string letter() const { return name.find(',') == std::string::npos ? "" : name.substr(name.find(',') + 1); }
};
/// The options of a command, in the order of --help.
std::vector<Option> options_of(const CliCommand& verb);

}  // namespace grafverif::app
