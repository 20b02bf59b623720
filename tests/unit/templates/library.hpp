// SPDX-License-Identifier: MIT
// The components of templates/, each on a separate test bench.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "grafverif/ir/component.hpp"
#include "support/naive_tadd.hpp"

namespace grafverif {

/// The names of all files of templates/, in alphabetical order.
std::vector<std::string> library_names();

/// The component of templates/NAME.grafcet.
Component library_component(const std::string& name);

/// One instance named `it`; durations in milliseconds.
Bench bench(const std::string& name, const std::map<std::string, std::int64_t>& constants = {},
            const std::string& initially = "");

/// A single component with Boolean ports whose time unit is a second, regardless of its durations.
Network component_in_seconds(const std::string& name, const std::map<std::string, std::int64_t>& constants = {});

/// The only possible value of a variable; fails the test if there are several.
std::int64_t only(const Bench& bench, const std::string& variable);
/// The only possible location of the instance.
std::string place_of(const Bench& bench);

}  // namespace grafverif
