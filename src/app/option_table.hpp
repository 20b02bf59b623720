// SPDX-License-Identifier: MIT
// The rows of the option table.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/options.hpp"

namespace grafverif::app {

/// An option. A command accepts an option if the command accepts the group of the option.
struct Option {
    OptionGroup accepts = OptionGroup::Always;
    std::string name = {};   ///< long name and, if any, short name: `output,o`
    std::string value = {};  ///< placeholder of its value in the help; empty for a switch, which has no value
    std::string help = {};   ///< help text; if empty, the help does not show the option

    /// Stores the given values in the options. For a switch, stores that the switch was given. Returns an error message
    /// or an empty string.
    std::function<std::string(const std::vector<std::string>&, Options&)> take = {};
    bool repeated = false;
    /// True: the value must be a separate argument, because a file may have the name `--NAME=COMMAND`.
    bool is_command = false;
    std::string former = {};  ///< deprecated name, which is accepted with a warning; may be empty

    std::string long_name() const { return name.substr(0, name.find(',')); }
    std::string letter() const { return name.find(',') == std::string::npos ? "" : name.substr(name.find(',') + 1); }
};
/// Returns the options of a command, in the order of --help.
std::vector<Option> options_of(const CliCommand& verb);

}  // namespace grafverif::app
