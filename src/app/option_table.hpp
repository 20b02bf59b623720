// SPDX-License-Identifier: MIT
// The rows of the table of options.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/options.hpp"

namespace grafverif::app {

/// An option of the verbs that accept its group.
struct Option {
    Accepts accepts = Accepts::Always;
    std::string name = {};   ///< with its letter, if it has one: `output,o`
    std::string value = {};  ///< what stands for its value in the help; empty: a switch, which has none
    std::string help = {};   ///< empty: not shown
    /// Puts values given, or that it was given, where they belong; what is wrong with them, or nothing.
    std::function<std::string(const std::vector<std::string>&, Options&)> take = {};
    bool repeated = false;
    bool is_command = false;  ///< taken as a separate word only: `--NAME=COMMAND` may be the name of a file

    std::string long_name() const { return name.substr(0, name.find(',')); }
    std::string letter() const { return name.find(',') == std::string::npos ? "" : name.substr(name.find(',') + 1); }
};
/// The options of `verb`, in the order of --help.
std::vector<Option> options_of(const Verb& verb);

}  // namespace grafverif::app
