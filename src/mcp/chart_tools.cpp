// SPDX-License-Identifier: MIT
// Implements the tools `read`, `draw`, `simulate`, `analyse` and `compare`.
#include <fmt/format.h>

#include <algorithm>

#include "mcp/tools.hpp"
#include "read/formats.hpp"

namespace grafverif::mcp {

namespace {

using Kind = Argument::Kind;

/// Limits of a result: maximum length of the text in bytes, and maximum numbers of findings and scans.
constexpr std::size_t longest_text = 200'000, most_findings = 200, most_scans = 1000;

Json string_type() { return {{"type", "string"}}; }
Json list_of(Json items) { return {{"type", "array"}, {"items", std::move(items)}}; }

std::string word(FileFormat format) {
    switch (format) {
    case FileFormat::Unknown:
    case FileFormat::Grafcet: return "grafcet";
    case FileFormat::Xml: return "xml";
    case FileFormat::StructuredText: return "structured-text";
    }
    return {};
}

/// Returns `file:line:column: `, or an empty string if the element has no position.
std::string place_of(const Json& element) {
    if (!element.contains("file") || !element["file"].is_string()) return {};
    return fmt::format("{}:{}:{}: ", element["file"].get<std::string>(), element["line"].dump(),
                       element["column"].dump());
}

std::string message_line(const Json& element, const char* level) {
    return fmt::format("{}{}: {} [{}]\n", place_of(element), element.at(level).get<std::string>(),
                       element.at("message").get<std::string>(), element.at("code").get<std::string>());
}

/// Returns the models in the output of `check --list`, each with the list of its properties.
Json models_of(const Json& listed) {
    Json models = Json::array();
    for (const Json& each : listed) {
        const auto known = std::ranges::find_if(models, [&](const Json& model) {
            return model["name"] == each.at("model") && model["kind"] == each.at("kind");
        });
        Json& model = known != models.end() ? *known : (models.push_back(nullptr), models.back());
        if (model.is_null())
            model = {{"name", each.at("model")}, {"kind", each.at("kind")}, {"properties", Json::array()}};
        if (each.at("property").is_string())
            model["properties"].push_back(
                {{"name", each["property"]}, {"description", each.at("text")}, {"expected", each.at("expected")}});
    }
    return models;
}

ToolResult read(ToolCall& call) {
    const std::string text = call.content(), operand = call.operand();
    const FileFormat format = format_of(text);
    const ProgramResult listed = call.execute({"check", operand, "--list", "--format=json", "--diagnostics=json"});
    const Json models = Json::parse(listed.out, nullptr, false), messages = Json::parse(listed.err, nullptr, false);
    ToolResult result;
    result.data = {{"format", word(format)},
                   {"text", text},
                   {"models", models.is_array() ? models_of(models) : Json::array()},
                   {"diagnostics", messages.is_array() ? messages : Json::array()}};
    if (format == FileFormat::Xml || format == FileFormat::StructuredText) {
        const ProgramResult imported = call.execute({"import", operand});
        if (imported.status == 0) result.data["text"] = imported.out;
    }
    result.data["text"] = shortened(result.data["text"].get<std::string>(), longest_text);
    result.text = result.data["text"].get<std::string>() + '\n';
    for (const Json& each : result.data["diagnostics"]) result.text += message_line(each, "severity");
    return result;
}

ToolResult draw(ToolCall& call) {
    std::vector<std::string> command = {"draw", call.operand()};
    call.add_options(command, {"chart", "situation", "notation"});
    ProgramResult drawn = call.execute(std::move(command));
    if (drawn.status != 0) throw CallError{drawn.err};
    return {std::move(drawn.out), {}};
}

ToolResult simulate(ToolCall& call) {
    std::vector<std::string> command = {"simulate", call.path("file"), "--script=-"};
    call.add_options(command, {"loop", "chart", "mode", "grain", "set"});
    call.set_input(call.text("commands") + "\nshow\n");
    const ProgramResult played = call.execute(std::move(command));
    constexpr int unmet = 1;
    std::string run = shortened(played.out, longest_text), text = run + played.err;
    if (played.status != 0 && played.status != unmet) throw CallError{std::move(text)};
    return {std::move(text),
            {{"run", std::move(run)}, {"expectations_met", played.status == 0}, {"messages", played.err}}};
}

ToolResult analyse(ToolCall& call) {
    std::vector<std::string> command = {"analyse", call.operand(), "--format=json"};
    call.add_options(command, {"chart", "mode"});
    const Json found = call.execute_json(std::move(command));
    ToolResult result;
    copy_members(found, {"chart", "mode", "complete", "obstacle", "open", "notes"}, result.data);
    result.text = fmt::format("{}: {} findings{}\n", found.at("chart").get<std::string>(), found.at("findings").size(),
                              found.at("complete").get<bool>() ? "" : "; the search is not complete");
    Json findings = first_of(found.at("findings"), most_findings);
    for (Json& finding : findings) {
        finding.erase("trace");
        result.text += message_line(finding, "level");
    }
    result.data["findings"] = std::move(findings);
    for (const Json& note : found.at("notes")) result.text += "note: " + note.get<std::string>() + '\n';
    return result;
}

ToolResult compare(ToolCall& call) {
    std::vector<std::string> command = {"compare", call.path("file"), call.path("other"), "--format=json"};
    call.add_options(command, {"chart", "other_chart", "mode"});
    const Json found = call.execute_json(std::move(command));
    ToolResult result;
    copy_members(found,
                 {"charts", "mode", "outcome", "reason", "shortest", "constrained", "restricted", "ignored", "changes"},
                 result.data);
    result.data["scans"] = first_of(found.at("scans"), most_scans);
    result.text = fmt::format("{} ({})\n", found.at("outcome").get<std::string>(), found.at("mode").get<std::string>());
    if (found.at("reason").is_string()) result.text += found["reason"].get<std::string>() + '\n';
    for (const Json& scan : result.data["scans"]) result.text += scan.dump() + '\n';
    return result;
}

}  // namespace

Tool read_tool() {
    Tool tool{
        "read", "Read a file",
        "Returns the text of a file, its models with their properties, and its errors and warnings. A file in another "
        "format (AGRAFE, PLCopen XML, textual SFC) is converted to the grafverif language.",
        input_arguments()};
    tool.output_schema = {{"type", "object"},
                          {"properties",
                           {{"format", {{"enum", {"grafcet", "xml", "structured-text"}}}},
                            {"text", string_type()},
                            {"models", list_of({{"type", "object"}})},
                            {"diagnostics", list_of({{"type", "object"}})}}},
                          {"required", Json::array({"format", "text", "models", "diagnostics"})}};
    tool.run = read;
    return tool;
}

Tool draw_tool() {
    Tool tool{"draw", "Draw a chart", "Returns a drawing of a chart in the notation of IEC 60848, as SVG.",
              input_arguments()};
    tool.arguments.push_back(chart_argument());
    tool.arguments.push_back({"situation", Kind::Name, "steps to mark as active, such as 3,5"});
    tool.arguments.push_back(
        {"notation", Kind::Choice, "notation of conditions (default: iec)", false, {"iec", "text"}});
    tool.run = draw;
    return tool;
}

Tool simulate_tool() {
    Tool tool{
        "simulate",
        "Simulate a loop or chart",
        "Starts a closed loop or a chart at power-on, executes commands, one per line, and returns the run and the "
        "final values. `NAME = VALUE` sets an input. `wait 3s` lets time pass, and `wait` waits for the next "
        "event. `do INSTANCE [LOCATION]` takes an enabled edge of an instance, and `NUMBER` selects a numbered choice. "
        "`expect CLAIM` and `expect within 5s CLAIM` check a condition such as `X3` or `LEVEL >= 3`, and `wait until "
        "CLAIM` waits until a condition is true. `force STEP on|off` activates or deactivates a step, which starts a "
        "what-if run. `repeat N {` ... `}` repeats commands.",
        {file_argument(true), {"commands", Kind::Text, "commands, one per line", true}}};
    for (Argument& each : model_arguments()) tool.arguments.push_back(std::move(each));
    for (Argument& each : loop_arguments()) tool.arguments.push_back(std::move(each));
    tool.output_schema = {
        {"type", "object"},
        {"properties",
         {{"run", string_type()},
          {"expectations_met", {{"type", "boolean"}}},
          {"messages",
           {{"type", "string"}, {"description", "expectations that are not met, with their line numbers"}}}}},
        {"required", Json::array({"run", "expectations_met", "messages"})}};
    tool.run = simulate;
    return tool;
}

Tool analyse_tool() {
    Tool tool{
        "analyse", "Analyse a chart",
        "Finds possible errors of a chart without a plant, for arbitrary inputs. Examples are races, contradictory "
        "forcing orders, total instability, steps that are never active, and transitions that are never cleared.",
        input_arguments()};
    tool.arguments.push_back(chart_argument());
    tool.arguments.push_back(mode_argument());
    tool.output_schema = {{"type", "object"},
                          {"properties",
                           {{"chart", string_type()},
                            {"mode", string_type()},
                            {"complete", {{"type", "boolean"}}},
                            {"obstacle", {{"type", {"string", "null"}}}},
                            {"open", {{"type", "array"}}},
                            {"notes", list_of(string_type())},
                            {"findings", list_of({{"type", "object"}})}}},
                          {"required", Json::array({"chart", "complete", "findings"})}};
    tool.run = analyse;
    return tool;
}

Tool compare_tool() {
    Tool tool{
        "compare",
        "Compare two charts or programs",
        "Proves that two charts or PLC programs have equal outputs in every scan, for all inputs, or returns the scans "
        "of a distinguishing sequence.",
        {{"file", Kind::Name, "path of the first file", true},
         {"other", Kind::Name, "path of the second file", true},
         {"chart", Kind::Name, "chart of the first file, and of the second file unless `other_chart` is given"},
         {"other_chart", Kind::Name, "chart of the second file"}}};
    tool.arguments.push_back(mode_argument());
    tool.output_schema = {{"type", "object"},
                          {"properties",
                           {{"charts", {{"type", "array"}}},
                            {"mode", string_type()},
                            {"outcome", {{"enum", {"equal", "different", "unknown"}}}},
                            {"reason", {{"type", {"string", "null"}}}},
                            {"scans", list_of({{"type", "object"}})},
                            {"changes", list_of({{"type", "object"}})}}},
                          {"required", Json::array({"charts", "outcome", "scans"})}};
    tool.run = compare;
    return tool;
}

}  // namespace grafverif::mcp
