// SPDX-License-Identifier: MIT
// Reads the components of templates/ and puts each one on a separate test bench.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "grafverif/ir/component.hpp"
#include "support/naive_tadd.hpp"

namespace grafverif {

/// Returns the names of all files of templates/, in alphabetical order.
std::vector<std::string> library_names();

/// Returns the component of templates/NAME.grafcet.
Component library_component(const std::string& name);

/// Returns a bench with one instance named `it`. Durations are in milliseconds.
Bench bench(const std::string& name, const std::map<std::string, std::int64_t>& constants = {},
            const std::string& initially = "");

/// Returns the network of a single component with Boolean ports. The time unit is a second, regardless of the durations
/// of the component.
Network component_in_seconds(const std::string& name, const std::map<std::string, std::int64_t>& constants = {});

/// Returns the only possible value of a variable. Fails the test if there are several values.
std::int64_t only(const Bench& bench, const std::string& variable);
/// Returns the only possible location of the instance.
std::string place_of(const Bench& bench);

}  // namespace grafverif
