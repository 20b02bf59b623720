// SPDX-License-Identifier: MIT
// The legal UPPAAL name of every element of a network. Variables, processes, templates and the urgent channel share the
// global scope. The parameters, clocks, locations and procedures of a template share a local scope, which must not hide
// a global variable that the template reads or writes.
#pragma once

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "syntax/print/legal_names.hpp"

namespace grafverif::uppaal {

/// Long guards become functions of their template, which are named `guard_1`, `guard_2`, ...
inline constexpr std::string_view guard_prefix = "guard_";

struct LocalNames {
    std::vector<std::string> parameters = {}, clocks = {}, locations = {}, procedures = {};
    /// All names that further local names must not use, including the names of parameters, clocks, locations and
    /// procedures.
    std::unordered_set<std::string> taken = {};
};

struct Names {
    std::vector<std::string> variables = {}, processes = {}, templates = {};
    std::string channel = {};             ///< channel on which every urgent edge emits
    std::vector<LocalNames> locals = {};  ///< local names of each template

    /// Names that differ from the names in the network; a local name is listed as `template.name`.
    std::vector<Renaming> changed = {};
};

Names names(const Network& network);

}  // namespace grafverif::uppaal
