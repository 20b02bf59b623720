// SPDX-License-Identifier: MIT
// Returns the lines of each type of declaration, without comments. `column` is the indentation in characters.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "syntax/language/tree.hpp"

namespace grafverif {

using Lines = std::vector<std::string>;

Lines item_lines(const tree::File& file, const tree::Variables& written, std::size_t column);
Lines item_lines(const tree::File& file, const tree::Constraint& written, std::size_t column);
Lines item_lines(const tree::File& file, const tree::Transition& written, std::size_t column);
Lines item_lines(const tree::File& file, const tree::ContinuousAction& written, std::size_t column);
Lines item_lines(const tree::File& file, const tree::StoredAction& written, std::size_t column);
Lines item_lines(const tree::File& file, const tree::ForcingOrder& written, std::size_t column);
Lines item_lines(const tree::File& file, const tree::Clocks& written, std::size_t column);
Lines item_lines(const tree::File& file, const tree::Location& written, std::size_t column);
Lines item_lines(const tree::File& file, const tree::Edge& written, std::size_t column);
Lines item_lines(const tree::File& file, const tree::Controller& written, std::size_t column);
Lines item_lines(const tree::File& file, const tree::Grain& written, std::size_t column);
Lines item_lines(const tree::File& file, const tree::Schedule& written, std::size_t column);
Lines item_lines(const tree::File& file, const tree::ObserverEdge& written, std::size_t column);
Lines item_lines(const tree::File& file, const tree::TimeUnit& written, std::size_t column);
Lines item_lines(const tree::File& file, const tree::Instance& written, std::size_t column);
Lines item_lines(const tree::File& file, const tree::Fault& written, std::size_t column);
Lines item_lines(const tree::File& file, const tree::Property& written, std::size_t column);
Lines item_lines(const tree::File& file, const tree::Accept& written, std::size_t column);

/// Returns the head of a step without its actions, such as `initial step 0`.
std::string step_head(const tree::File& file, const tree::Step& step);
/// Returns a step such as `step 1 { A; B; }` if the line is short and the step has at most two actions or only plain
/// actions. For any other step, the result is empty.
std::optional<std::string> step_in_one_line(const tree::File& file, const tree::Step& step, std::size_t column);
/// Returns the head of a chart or component, `KEYWORD NAME(PARAMETERS)`, on several lines if one line would be too
/// long.
std::string head_with_parameters(const tree::File& file, std::string_view keyword, tree::Name name,
                                 const std::vector<tree::Variables>& parameters);
/// Returns the lines of a chart instance, `partial NAME = CHART(ARGUMENTS);`.
Lines instance_lines(const tree::File& file, const tree::Partial& written, std::size_t column);

}  // namespace grafverif
