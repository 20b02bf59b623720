// SPDX-License-Identifier: MIT
#include "mcp/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/overloaded.hpp"
#include "support/printable.hpp"
#include "syntax/resolve/nearest_of.hpp"

namespace grafverif::mcp {

namespace {

Json type_of(const Argument& argument) {
    switch (argument.kind) {
    case Argument::Kind::Text: return {{"type", "string"}};
    case Argument::Kind::Name: return {{"type", "string"}, {"minLength", 1}, {"maxLength", longest_name}};
    case Argument::Kind::Names:
        return {{"type", "array"},
                {"items", {{"type", "string"}, {"minLength", 1}, {"maxLength", longest_name}}},
                {"maxItems", most_names}};
    case Argument::Kind::Flag: return {{"type", "boolean"}};
    case Argument::Kind::Number: return {{"type", "integer"}, {"minimum", argument.least}, {"maximum", argument.most}};
    case Argument::Kind::Choice: return {{"type", "string"}, {"enum", argument.choices}};
    }
    unreachable();
}

bool has_nul(const Json& value) { return value.get_ref<const std::string&>().find('\0') != std::string::npos; }

std::string name_error(const Json& value) {
    if (!value.is_string()) return "must be a string";
    if (has_nul(value)) return "must not contain the character NUL";
    const std::size_t size = value.get_ref<const std::string&>().size();
    if (size == 0) return "must not be empty";
    return size > longest_name ? fmt::format("must have at most {} bytes", longest_name) : "";
}

std::string names_error(const Json& value) {
    if (!value.is_array()) return "must be a list of strings";
    if (value.size() > most_names) return fmt::format("must have at most {} elements", most_names);
    for (const Json& each : value)
        if (const std::string error = name_error(each); !error.empty())
            return "has an invalid element: each element " + error;
    return {};
}

std::string number_error(const Argument& argument, const Json& value) {
    const bool fits = value.is_number_integer() &&
                      (!value.is_number_unsigned() || value.get<std::uint64_t>() <= std::uint64_t{INT64_MAX}) &&
                      value.get<std::int64_t>() >= argument.least && value.get<std::int64_t>() <= argument.most;
    return fits ? "" : fmt::format("must be an integer from {} to {}", argument.least, argument.most);
}

std::string choice_error(const Argument& argument, const Json& value) {
    if (std::ranges::any_of(argument.choices, [&](const std::string& each) { return value == each; })) return {};
    return fmt::format("must be one of {}", fmt::join(argument.choices, ", "));
}

/// Returns the rule that the value violates, such as `must be a string`, or an empty string.
std::string value_error(const Argument& argument, const Json& value) {
    switch (argument.kind) {
    case Argument::Kind::Text:
        if (!value.is_string()) return "must be a string";
        return has_nul(value) ? "must not contain the character NUL" : "";
    case Argument::Kind::Name: return name_error(value);
    case Argument::Kind::Names: return names_error(value);
    case Argument::Kind::Flag: return value.is_boolean() ? "" : "must be true or false";
    case Argument::Kind::Number: return number_error(argument, value);
    case Argument::Kind::Choice: return choice_error(argument, value);
    }
    unreachable();
}

std::string unknown_argument(const std::vector<Argument>& known, const std::string& name) {
    std::vector<std::string> names;
    for (const Argument& each : known) names.push_back(each.name);
    return unknown_name_text("argument", printable(name.substr(0, longest_name)), names);
}

}  // namespace

Json schema_of(const std::vector<Argument>& known) {
    Json properties = Json::object(), required = Json::array();
    for (const Argument& each : known) {
        Json type = type_of(each);
        type["description"] = each.description;
        properties[each.name] = std::move(type);
        if (each.required) required.push_back(each.name);
    }
    Json schema = {{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
    if (!required.empty()) schema["required"] = std::move(required);
    return schema;
}

std::string argument_error(const std::vector<Argument>& known, const Json& received) {
    if (!received.is_object()) return "`arguments` must be an object";
    for (const auto& [name, value] : received.items()) {
        const auto argument = std::ranges::find(known, name, &Argument::name);
        if (argument == known.end()) return unknown_argument(known, name);
        if (const std::string error = value_error(*argument, value); !error.empty())
            return fmt::format("the argument `{}` {}", name, error);
    }
    for (const Argument& each : known)
        if (each.required && !received.contains(each.name))
            return fmt::format("the argument `{}` is missing", each.name);
    return {};
}

}  // namespace grafverif::mcp
