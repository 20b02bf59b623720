// SPDX-License-Identifier: MIT
// Arguments of the tools: a table from which their JSON schema is derived, and the check of received arguments.
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
    std::vector<std::string> choices = {};  ///< values of a Choice
    std::int64_t least = 0, most = 0;       ///< range of a Number
};

/// Maximum length in bytes of a Name, and maximum number of Names.
inline constexpr std::size_t longest_name = 4096, most_names = 1000;

/// Returns the JSON schema of an object with these members.
Json schema_of(const std::vector<Argument>& known);
/// Returns the error of the received arguments, or an empty string: an argument is unknown, missing, of another type or
/// outside of its range, or a text contains the character NUL.
std::string argument_error(const std::vector<Argument>& known, const Json& received);

}  // namespace grafverif::mcp
