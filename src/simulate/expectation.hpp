// SPDX-License-Identifier: MIT
// Parses and evaluates expectations about the current state of a simulation, which the commands `expect` and `wait
// until` use:
//
//   X3                    the step 3 is active; `press.X3`, `G1.X3` with several controllers or partial charts
//   LAMP, not LAMP        an input, output, internal variable or variable of the plant is true (false)
//   LEVEL >= 3            =, ==, !=, <, <=, >, >=; for Booleans `LAMP = true`
//   Gate in open          the instance Gate is in its location open
//
// The operators `and` and `,` form conjunctions of these expectations.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "grafverif/ir/chart_run.hpp"

namespace grafverif {

struct Expectation {
    enum class Relation { Equal, NotEqual, Less, AtMost, Greater, AtLeast, In, NotIn };
    struct Condition {
        std::string name = {};
        Relation relation = Relation::Equal;
        std::int64_t value = 0;
        std::string location = {};  ///< location, for the operators In and NotIn
        bool operator==(const Condition&) const = default;
    };
    std::vector<Condition> parts = {};  ///< at least one condition; the expectation is their conjunction
    std::string text = {};              ///< text of the expectation as entered by the user
    bool operator==(const Expectation&) const = default;
};

/// Parses a decimal integer. Returns nullopt if `text` is not an integer.
std::optional<std::int64_t> number_of(std::string_view text);
/// Parses a value of a command or an expectation: `true` (1), `false` (0) or an integer.
std::optional<std::int64_t> value_of(std::string_view text);

/// Parses an expectation. Returns a message if the text is invalid.
std::variant<Expectation, std::string> parse_expectation(std::string_view text);

/// Function that returns the location of the instance with the given name after the considered event, or nullopt if
/// there is no such instance.
using LocationOf = std::function<std::optional<std::string>(std::string_view instance)>;

/// Returns text about the first condition that does not hold after event `moment` of `run`, such as `X3 is not active`,
/// or an empty string if all conditions hold. After an error, the result is nullopt, and `problem` names the element
/// that does not exist.
std::optional<std::string> unmet_part(const Expectation& claim, const ChartRun& run, std::size_t moment,
                                      const LocationOf& location_of, std::string& problem);

/// True if each condition of the expectation concerns a step. In transient situations, in which outputs are not yet
/// written, only expectations about steps can be evaluated.
bool names_only_steps(const Expectation& claim, const ChartRun& run);

}  // namespace grafverif
