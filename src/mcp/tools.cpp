// SPDX-License-Identifier: MIT
#include "mcp/tools.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace grafverif::mcp {

namespace {

using Kind = Argument::Kind;

}  // namespace

Argument file_argument(bool required) {
    return {"file", Kind::Name, "path of the file, absolute or relative to a folder that the server can read",
            required};
}

Argument chart_argument() {
    return {"chart", Kind::Name, "name of the chart; required if the file has several charts"};
}

Argument mode_argument() {
    return {"mode",
            Kind::Choice,
            "execution mode; overrides the mode in the model",
            false,
            {"stability-search", "every-cycle"}};
}

std::vector<Argument> input_arguments() {
    return {file_argument(), {"text", Kind::Text, "content of an unsaved file; replaces `file`"}};
}

std::vector<Argument> model_arguments() {
    return {{"loop", Kind::Name, "name of the closed loop, to select one of several closed loops in the file"},
            {"chart", Kind::Name,
             "name of the chart; required to use a chart without its closed loop, or if the file has several charts "
             "and no closed loop"},
            mode_argument()};
}

std::vector<Argument> loop_arguments() {
    return {{"grain",
             Kind::Choice,
             "phased: the plant can move within a PLC cycle; atomic: the plant cannot move within a cycle",
             false,
             {"phased", "atomic"}},
            {"set", Kind::Names, "values of constants of the closed loop, each as NAME=VALUE"}};
}

std::vector<Tool> tools(const ServerEnvironment& environment) {
    std::vector<Tool> all = {read_tool(),    draw_tool(),    check_tool(), explain_tool(), simulate_tool(),
                             analyse_tool(), compare_tool(), tune_tool(),  faults_tool(),  complete_tool()};
    for (Tool& tool : all) {
        tool.arguments.push_back({.name = "timeout",
                                  .kind = Kind::Number,
                                  .description = fmt::format("time limit of the call in seconds (default: {})",
                                                             environment.default_timeout_s()),
                                  .least = 1,
                                  .most = environment.longest_call_s});
        tool.arguments.push_back({.name = "max_memory",
                                  .kind = Kind::Number,
                                  .description = fmt::format("memory limit of the call in MiB (default: {})",
                                                             environment.default_memory_mib()),
                                  .least = 16,
                                  .most = environment.largest_call_mib});
    }
    return all;
}

Json tool_list(std::span<const Tool> tools, bool structured) {
    Json list = Json::array();
    for (const Tool& tool : tools) {
        Json entry = {
            {"name", tool.name}, {"description", tool.description}, {"inputSchema", schema_of(tool.arguments)}};
        entry["annotations"] = {
            {"title", tool.title}, {"readOnlyHint", true}, {"idempotentHint", true}, {"openWorldHint", false}};
        if (structured) entry["title"] = tool.title;
        if (structured && !tool.output_schema.is_null()) entry["outputSchema"] = tool.output_schema;
        list.push_back(std::move(entry));
    }
    return {{"tools", std::move(list)}};
}

}  // namespace grafverif::mcp
