// SPDX-License-Identifier: MIT
// Defines the arguments of the MCP tools: the table from which their JSON schema is derived, and the check of received
// arguments.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace grafverif::mcp {

using Json = nlohmann::json;

struct Argument {
    enum class Kind { Text, Name, Names, Flag, Number, Choice };
    std::string name = {};
    Kind kind = Kind::Name;
    std::string description = {};
    bool required = false;
    std::vector<std::string> choices = {};  ///< permitted values, for the kind Choice
    std::int64_t least = 0, most = 0;       ///< range of values, for the kind Number
};

/// Maximum length in bytes of a name (`longest_name`), and maximum number of names in an argument of the kind Names
/// (`most_names`).
inline constexpr std::size_t longest_name = 4096, most_names = 1000;

/// Returns the JSON schema of an object with the members `known`.
Json schema_of(const std::vector<Argument>& known);
/// Returns the error in the received arguments, or an empty string. It is an error if an argument is unknown, missing,
/// of another type or outside of its range, or if a text contains the character NUL.
std::string argument_error(const std::vector<Argument>& known, const Json& received);

}  // namespace grafverif::mcp
