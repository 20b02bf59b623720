// SPDX-License-Identifier: MIT
// The legal name of every entity of a network in UPPAAL. Variables, processes, templates and the urgent channel share
// the global scope. The parameters, clocks, locations and procedures of a template share a local scope, which must not
// hide a global that the template reads or writes.
#pragma once

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "syntax/print/legal_names.hpp"

namespace grafverif::uppaal {

/// Long guards become functions of their template, named `guard_1`, `guard_2`, ...
inline constexpr std::string_view guard_prefix = "guard_";

struct LocalNames {
    std::vector<std::string> parameters = {}, clocks = {}, locations = {}, procedures = {};
    std::unordered_set<std::string> taken = {};  ///< all of these, and other names that additional names must avoid
};

struct Names {
    std::vector<std::string> variables = {}, processes = {}, templates = {};
    std::string channel = {};             ///< every urgent edge emits on it
    std::vector<LocalNames> locals = {};  ///< per template
    std::vector<Renaming> changed = {};   ///< names that differ from the network's; local ones as `template.name`
};

Names names(const Network& network);

}  // namespace grafverif::uppaal
