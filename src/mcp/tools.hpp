// SPDX-License-Identifier: MIT
// Defines the table of all tools that the MCP server offers. A tool runs commands of grafverif and converts their
// output to a short result.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mcp/arguments.hpp"
#include "mcp/tool_call.hpp"

namespace grafverif::mcp {

struct Tool {
    std::string name = {}, title = {}, description = {};
    std::vector<Argument> arguments = {};
    Json output_schema = {};  ///< schema of ToolResult::data; null if the tool has no data

    /// Executes a call with checked arguments. Throws CallError if the call fails.
    ToolResult (*run)(ToolCall& call) = nullptr;
};

/// Returns all tools. The ranges of `timeout` and `max_memory` depend on the environment.
std::vector<Tool> tools(const ServerEnvironment& environment);

/// Returns the tools in the form in which the method `tools/list` returns them. In protocol versions before 2025-06-18,
/// tools have neither titles nor output schemas.
Json tool_list(std::span<const Tool> tools, bool structured);

// The following functions return the tools without their common arguments; they are defined in chart_tools.cpp,
// check_tools.cpp and complete_tool.cpp.
Tool read_tool();
Tool draw_tool();
Tool simulate_tool();
Tool analyse_tool();
Tool compare_tool();
Tool check_tool();
Tool explain_tool();
Tool tune_tool();
Tool faults_tool();
Tool complete_tool();

Argument file_argument(bool required = false);
Argument chart_argument();
Argument mode_argument();
/// Returns the arguments that name the input: `file` and `text`. A call has exactly one of these arguments.
std::vector<Argument> input_arguments();
/// Returns the arguments that select a loop or chart of the input, and the execution mode.
std::vector<Argument> model_arguments();
/// Returns the arguments for tools that execute closed loops: grain and constants.
std::vector<Argument> loop_arguments();

}  // namespace grafverif::mcp
