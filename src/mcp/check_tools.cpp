// SPDX-License-Identifier: MIT
// Implements the tools `check`, `explain`, `tune` and `faults`. `check` returns verdicts. `explain` returns the verdict
// and the counterexample of one property as text and as data. `tune` and `faults` return verdicts for variants of a
// closed loop. Each of these tools converts the JSON output of a command.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>

#include "mcp/tools.hpp"
#include "support/json_text.hpp"

namespace grafverif::mcp {

namespace {

using Kind = Argument::Kind;

/// Limits of a result, so that a client can process it. `check` shortens each counterexample more than `explain`.
constexpr std::size_t short_trace = 4000, long_trace = 200'000, most_steps = 1000, most_boxes = 100;

constexpr const char* property_schema = R"({
  "type": "object",
  "properties": {
    "name": {"type": "string"},
    "description": {"type": ["string", "null"]},
    "verdict": {"enum": ["holds", "violated", "unknown"]},
    "expected": {"enum": ["holds", "violated"]},
    "as_expected": {"type": "boolean"},
    "vacuous": {"type": "boolean", "description": "true if the property holds only for a trivial reason"},
    "declared": {"type": "boolean", "description": "false for properties that grafverif adds"},
    "reason": {"type": ["string", "null"], "description": "reason for the verdict `unknown`"},
    "assumptions": {"type": "string", "description": "model, engine and assumptions under which the verdict applies"},
    "notes": {"type": "array", "items": {"type": "string"}},
    "file": {"type": ["string", "null"]},
    "line": {"type": ["integer", "null"]},
    "column": {"type": ["integer", "null"]},
    "counterexample": {"type": ["string", "null"], "description": "table of the run that shows the verdict"}
  },
  "required": ["name", "verdict", "expected", "as_expected", "assumptions"]
})";

/// JSON schema of the result of `faults`. A combination is a list of names of faults.
constexpr const char* faults_schema = R"({
  "type": "object",
  "properties": {
    "model": {"type": "string"},
    "order": {"type": "integer"},
    "combinations": {"type": "integer"},
    "checks": {"type": "integer", "description": "number of checks of a model"},
    "faults": {"type": "array", "items": {"type": "object"}},
    "properties": {
      "type": "array",
      "items": {
        "type": "object",
        "properties": {
          "name": {"type": "string"},
          "without_faults": {"enum": ["holds", "violated", "unknown"]},
          "minimal": {"type": "array", "items": {"type": "array", "items": {"type": "string"}}},
          "unproved": {
            "type": "array",
            "description": "elements of `minimal` with subsets whose verdicts are unknown",
            "items": {"type": "array", "items": {"type": "string"}}
          },
          "unknown": {"type": "array", "description": "combinations whose verdicts are unknown, with reasons"},
          "non_monotone": {
            "type": "array",
            "description": "pairs of combinations: `violating` leads to a violation, its superset `holding` does not"
          }
        },
        "required": ["name", "without_faults", "minimal", "unproved", "unknown", "non_monotone"]
      }
    },
    "errors": {
      "type": "array",
      "description": "model errors; every verdict that depends on states after a model error is unknown",
      "items": {
        "type": "object",
        "properties": {
          "faults": {"type": "array", "items": {"type": "string"}},
          "code": {"type": "string"},
          "message": {"type": "string"}
        },
        "required": ["faults", "code", "message"]
      }
    }
  },
  "required": ["model", "order", "combinations", "checks", "faults", "properties", "errors"]
})";

constexpr const char* errors_schema = R"({
  "type": "array",
  "description": "model errors; every verdict that depends on states after a model error is unknown",
  "items": {
    "type": "object",
    "properties": {"code": {"type": "string"}, "message": {"type": "string"}, "run": {"type": "string"}},
    "required": ["code", "message"]
  }
})";

std::vector<Argument> check_arguments() {
    std::vector<Argument> all = input_arguments();
    for (Argument& each : model_arguments()) all.push_back(std::move(each));
    for (Argument& each : loop_arguments()) all.push_back(std::move(each));
    const std::vector<Argument> own = {
        {"engine",
         Kind::Choice,
         "engine (default: timed for a closed loop, otherwise auto)",
         false,
         {"auto", "timed", "symbolic", "pdr", "bmc"}},
        {"untimed", Kind::Flag,
         "check the untimed model; `assumptions` states what each verdict implies for the timed loop"},
        {"plant", Kind::Choice, "plant of the untimed model", false, {"none", "constraints", "automata"}},
        {"properties_file", Kind::Name, "path of the property file, if the input is a PLC program (IEC 61131-3)"},
    };
    all.insert(all.end(), own.begin(), own.end());
    return all;
}

std::vector<std::string> check_command(ToolCall& call) {
    std::vector<std::string> command = {"check", call.operand(), "--format=json"};
    call.add_options(command, {"loop", "chart", "mode", "grain", "engine", "untimed", "plant", "set"});
    if (call.has("properties_file")) command.push_back("--properties=" + call.path("properties_file"));
    return command;
}

/// Joins a list of lines; returns an empty string for null.
std::string text_of_lines(const Json& lines) {
    std::string text;
    if (lines.is_array())
        for (const Json& line : lines) text += line.get<std::string>() + '\n';
    return text;
}

bool is_expected(const Json& property) { return property.at("verdict") == property.at("expected"); }

/// Converts an element of `properties` in the output of `check`. If `always` is false, the result contains the trace
/// only if the verdict is unexpected.
Json property_of(const Json& found, std::size_t longest_trace, bool always) {
    const bool shown = always || !is_expected(found);
    Json made = {
        {"name", found.at("name")},
        {"description", found.at("text")},
        {"as_expected", is_expected(found)},
        {"counterexample",
         shown ? Json(text_or_null(shortened(text_of_lines(found.at("trace_text")), longest_trace))) : Json()}};
    copy_members(
        found,
        {"verdict", "expected", "vacuous", "declared", "reason", "assumptions", "notes", "file", "line", "column"},
        made);
    return made;
}

Json errors_of(const Json& document, std::size_t longest_trace) {
    Json errors = Json::array();
    if (document.contains("errors"))
        for (const Json& each : document["errors"])
            errors.push_back({{"code", each.at("code")},
                              {"message", each.at("message")},
                              {"run", shortened(text_of_lines(each.at("trace_text")), longest_trace)}});
    return errors;
}

/// Returns a line such as `guarded: violated, expected holds: the steps are never active together`.
std::string verdict_line(const Json& property) {
    std::string line =
        fmt::format("{}: {}", property["name"].get<std::string>(), property["verdict"].get<std::string>());
    if (property["vacuous"].get<bool>()) line += ", vacuously";
    if (!property["as_expected"].get<bool>())
        line += fmt::format(", expected {}", property["expected"].get<std::string>());
    else if (property["verdict"] == "violated") line += ", as expected";
    if (property["description"].is_string()) line += ": " + property["description"].get<std::string>();
    line += '\n';
    if (property["reason"].is_string()) line += "    reason: " + property["reason"].get<std::string>() + '\n';
    for (const Json& note : property["notes"]) line += "    note: " + note.get<std::string>() + '\n';
    if (property["counterexample"].is_string()) line += property["counterexample"].get<std::string>();
    return line;
}

/// Returns the verdicts as text. Verdicts under the same assumptions are listed together.
std::string verdicts_text(const Json& data, const Json& properties) {
    std::string text;
    for (const Json& error : data["model_errors"])
        text += fmt::format("model error: {} [{}]\n{}", error["message"].get<std::string>(),
                            error["code"].get<std::string>(), error["run"].get<std::string>());
    std::vector<std::string> order;
    std::map<std::string, std::string> by_assumptions;
    for (const Json& property : properties) {
        const auto assumptions = property["assumptions"].get<std::string>();
        if (!by_assumptions.contains(assumptions)) order.push_back(assumptions);
        by_assumptions[assumptions] += verdict_line(property);
    }
    for (const std::string& assumptions : order)
        text += fmt::format("Assumptions: {}\n{}", assumptions, by_assumptions[assumptions]);
    return text;
}

ToolResult check(ToolCall& call) {
    std::vector<std::string> command = check_command(call);
    call.add_options(command, {"property"});
    int code = 0;
    const Json found = call.execute_json(std::move(command), &code);
    Json properties = Json::array();
    for (const Json& each : found.at("properties")) properties.push_back(property_of(each, short_trace, false));
    ToolResult result;
    result.data = {
        {"model", found.at("model")}, {"as_expected", code == 0}, {"model_errors", errors_of(found, short_trace)}};
    result.text = fmt::format("{}: {}\n{}", found.at("model").get<std::string>(),
                              code == 0 ? "all verdicts are as expected" : "not all verdicts are as expected",
                              verdicts_text(result.data, properties));
    result.data["properties"] = std::move(properties);
    return result;
}

/// Returns the first steps of a trace as JSON, without their members `moment`.
Json steps_of(const Json& trace) {
    Json steps = first_of(trace.at("steps"), most_steps);
    for (Json& step : steps) step.erase("moment");
    return steps;
}

Json causes_of(const Json& trace) {
    Json causes = Json::array();
    if (const Json& run = trace.at("run"); run.contains("causes"))
        for (const Json& cause : run["causes"].at("values")) causes.push_back(cause.at("words"));
    return causes;
}

/// Returns the explanation of the proof of one property (docs/explanation/why.md), or null if the document has none.
Json proof_of(const Json& document, const Json& name) {
    if (document.contains("why"))
        for (const Json& each : document["why"].at("properties"))
            if (each.at("property") == name) return each;
    return nullptr;
}

/// Returns a line for each type of element that the proof needs, such as `proof needs steps: 4`.
std::string proof_text(const Json& proof) {
    std::string text;
    for (const char* const member : {"transitions", "steps", "parts", "timings", "open"}) {
        if (!proof.is_object() || proof.at(member).empty()) continue;
        const auto names = proof[member].get<std::vector<std::string>>();
        const bool open = std::string_view(member) == "open";
        text +=
            fmt::format("{}: {}\n", open ? "undecided" : fmt::format("proof needs {}", member), fmt::join(names, ", "));
    }
    return text;
}

ToolResult explain(ToolCall& call) {
    std::vector<std::string> command = check_command(call);
    call.add_options(command, {"property", "why"});
    const Json found = call.execute_json(std::move(command));
    const auto property = std::ranges::find_if(
        found.at("properties"), [&](const Json& each) { return each.at("name") == call.text("property"); });
    if (property == found["properties"].end())
        throw CallError{fmt::format("`{}` does not select a single result; pass the complete name of one property",
                                    call.text("property"))};
    ToolResult result;
    result.data = property_of(*property, long_trace, true);
    result.data["model"] = found.at("model");
    result.data["model_errors"] = errors_of(found, long_trace);
    const Json& trace = property->at("trace");
    result.data["steps"] = trace.is_object() ? steps_of(trace) : Json::array();
    result.data["steps_complete"] = !trace.is_object() || trace.at("steps").size() <= most_steps;
    result.data["loop_from"] = trace.is_object() ? trace.at("loop_from") : Json();
    result.data["causes"] = trace.is_object() ? causes_of(trace) : Json::array();
    result.data["proof"] = proof_of(found, property->at("name"));
    result.text = verdicts_text(result.data, Json::array({result.data})) + proof_text(result.data["proof"]);
    return result;
}

std::string value_text(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

/// Returns values of constants such as `RAM = 1s..6s`.
std::string ranges_text(const Json& ranges) {
    std::string all;
    for (const auto& [name, range] : ranges.items()) {
        const std::string first = value_text(range.at(0)), last = value_text(range.at(1));
        all += fmt::format("{}{} = {}", all.empty() ? "" : ", ", name, first == last ? first : first + ".." + last);
    }
    return all;
}

/// Converts an element of `properties` in the output of `tune`, and appends its text to `text`.
Json tuned_property(const Json& found, std::string& text) {
    Json made;
    copy_members(found, {"name", "expected", "current", "margins"}, made);
    made["boxes"] = first_of(found.at("boxes"), most_boxes);
    made["boxes_complete"] = found.at("boxes").size() <= most_boxes;
    text += fmt::format("{}: {} with the current values\n", found.at("name").get<std::string>(),
                        found.at("current").get<std::string>());
    for (const Json& box : made["boxes"])
        text += fmt::format("  {}: {}\n", ranges_text(box.at("constants")), box.at("verdict").get<std::string>());
    for (const Json& margin : made["margins"])
        text += fmt::format("  margin {}: {} at {} = {}\n", margin.at("direction").get<std::string>(),
                            margin.at("verdict").get<std::string>(), margin.at("constant").get<std::string>(),
                            value_text(margin.at("value")));
    return made;
}

ToolResult tune(ToolCall& call) {
    std::vector<std::string> command = {"tune", call.operand(), "--format=json"};
    call.add_options(command, {"loop", "mode", "grain", "set", "over", "property"});
    const Json found = call.execute_json(std::move(command));
    ToolResult result;
    copy_members(found, {"model", "constants", "points", "checks"}, result.data);
    result.text = fmt::format("{}: {} points\n", found.at("model").get<std::string>(), found.at("points").dump());
    result.data["properties"] = Json::array();
    for (const Json& each : found.at("properties"))
        result.data["properties"].push_back(tuned_property(each, result.text));
    return result;
}

/// Returns a combination of faults as text, such as `A + B`.
std::string combination_text(const Json& faults) {
    std::string names;
    for (const Json& fault : faults) names += (names.empty() ? "" : " + ") + fault.get<std::string>();
    return names.empty() ? "no fault" : names;
}

/// Converts an element of `properties` in the output of `faults` without its runs, and appends its text to `text`.
Json property_with_faults(const Json& found, std::string& text) {
    Json made;
    copy_members(found, {"name", "without_faults", "unknown", "non_monotone"}, made);
    made["minimal"] = Json::array();
    made["unproved"] = Json::array();
    std::string all, open;
    for (const Json& cut : found.at("minimal")) {
        made["minimal"].push_back(cut.at("faults"));
        all += (all.empty() ? "" : "; ") + combination_text(cut.at("faults"));
        if (cut.at("unknown_subsets").empty()) continue;
        made["unproved"].push_back(cut.at("faults"));
        all += " (minimality is unproved)";
    }
    for (const Json& each : found.at("unknown"))
        open += (open.empty() ? "" : "; ") + combination_text(each.at("faults"));
    std::string verdict = found.at("without_faults") != "holds"
                              ? found.at("without_faults").get<std::string>() + " without faults"
                          : !all.empty() ? "violated with " + all
                          : open.empty() ? "no combination leads to a violation"
                                         : "";
    if (!open.empty()) verdict += (verdict.empty() ? "unknown for " : "; unknown for ") + open;
    text += fmt::format("{}: {}\n", found.at("name").get<std::string>(), verdict);
    return made;
}

ToolResult faults(ToolCall& call) {
    std::vector<std::string> command = {"faults", call.operand(), "--format=json",
                                        fmt::format("--order={}", call.number("order", 1))};
    call.add_options(command, {"loop", "mode", "grain", "set", "property"});
    const Json found = call.execute_json(std::move(command));
    ToolResult result;
    copy_members(found, {"model", "order", "combinations", "checks", "faults"}, result.data);
    result.text = fmt::format("{}: {} combinations of at most {} faults\n", found.at("model").get<std::string>(),
                              found.at("combinations").dump(), found.at("order").dump());
    result.data["properties"] = Json::array();
    for (const Json& each : found.at("properties"))
        result.data["properties"].push_back(property_with_faults(each, result.text));
    result.data["errors"] = Json::array();
    for (const Json& each : found.at("errors")) {
        Json error;
        copy_members(each, {"faults", "code", "message"}, error);
        result.data["errors"].push_back(std::move(error));
        result.text += fmt::format("model error with {}: {}\n", combination_text(each.at("faults")),
                                   each.at("message").get<std::string>());
    }
    return result;
}

}  // namespace

Tool check_tool() {
    Tool tool{
        "check", "Check properties",
        "Decides the properties of a closed loop, or of a chart with free inputs. Each verdict is `holds`, `violated` "
        "or `unknown`. For an unexpected verdict, the counterexample is returned as a table of the run. Without "
        "`property`, all properties are checked.",
        check_arguments()};
    tool.arguments.push_back({"property", Kind::Names, "names of the properties to check (default: all)"});
    tool.output_schema = {
        {"type", "object"},
        {"properties",
         {{"model", {{"type", "string"}}},
          {"as_expected", {{"type", "boolean"}, {"description", "true if every verdict is as expected"}}},
          {"properties", {{"type", "array"}, {"items", Json::parse(property_schema)}}},
          {"model_errors", Json::parse(errors_schema)}}},
        {"required", Json::array({"model", "as_expected", "properties", "model_errors"})}};
    tool.run = check;
    return tool;
}

Tool explain_tool() {
    Tool tool{
        "explain", "Explain a verdict",
        "Checks one property and returns its counterexample or witness completely: as a table, as a list of steps, and "
        "with its causes. With `why`, also returns, for a property that holds, the parts of the chart and the plant on "
        "which the proof depends.",
        check_arguments()};
    tool.arguments.push_back({"property", Kind::Name, "name of the property", true});
    tool.arguments.push_back(
        {"why", Kind::Flag,
         "also explain why the property holds (only for a property of a closed loop; takes longer)"});
    Json schema = Json::parse(property_schema);
    schema["properties"]["model"] = {{"type", "string"}};
    schema["properties"]["model_errors"] = Json::parse(errors_schema);
    schema["properties"]["steps"] = {
        {"type", "array"},
        {"items", {{"type", "object"}}},
        {"description", "steps of the run: time in ms, kind, component, inputs, fired, situation, outputs"}};
    schema["properties"]["steps_complete"] = {{"type", "boolean"}};
    schema["properties"]["loop_from"] = {{"type", {"integer", "null"}},
                                         {"description", "index of the step from which the run repeats forever"}};
    schema["properties"]["causes"] = {{"type", "array"}, {"items", {{"type", "string"}}}};
    schema["properties"]["proof"] = {{"type", {"object", "null"}}};
    tool.output_schema = std::move(schema);
    tool.run = explain;
    return tool;
}

Tool tune_tool() {
    Tool tool{"tune", "Decide properties for ranges of constants",
              "Decides for which values of constants of a closed loop each property holds, exactly at each point of a "
              "grid. The result is a list of boxes (products of ranges of constants), each with one verdict, and the "
              "distance from each current value to the nearest value with another verdict.",
              input_arguments()};
    for (Argument& each : model_arguments())
        if (each.name != "chart") tool.arguments.push_back(std::move(each));
    for (Argument& each : loop_arguments()) tool.arguments.push_back(std::move(each));
    tool.arguments.push_back({"over", Kind::Names, "ranges of constants, each as NAME=LOW..HIGH[:STEP]", true});
    tool.arguments.push_back({"property", Kind::Names, "names of the properties to decide (default: all)"});
    tool.output_schema = {{"type", "object"},
                          {"properties",
                           {{"model", {{"type", "string"}}},
                            {"constants", {{"type", "array"}}},
                            {"points", {{"type", "integer"}}},
                            {"checks", {{"type", "integer"}, {"description", "number of models that were checked"}}},
                            {"properties", {{"type", "array"}, {"items", {{"type", "object"}}}}}}},
                          {"required", Json::array({"model", "constants", "points", "properties"})}};
    tool.run = tune;
    return tool;
}

Tool faults_tool() {
    Tool tool{
        "faults", "Find combinations of faults that lead to violations of properties",
        "Decides for each property of a closed loop which minimal combinations of the declared faults (`fault NAME "
        "of INSTANCE: COMPONENT(...)`) lead to a violation, and which steps and outputs show each fault.",
        input_arguments()};
    for (Argument& each : model_arguments())
        if (each.name != "chart") tool.arguments.push_back(std::move(each));
    for (Argument& each : loop_arguments()) tool.arguments.push_back(std::move(each));
    tool.arguments.push_back({.name = "order",
                              .kind = Kind::Number,
                              .description = "maximum number of faults in a combination (default: 1)",
                              .least = 1,
                              .most = 8});
    tool.arguments.push_back({"property", Kind::Names, "names of the properties to decide (default: all)"});
    tool.output_schema = Json::parse(faults_schema);
    tool.run = faults;
    return tool;
}

}  // namespace grafverif::mcp
