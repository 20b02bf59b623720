// SPDX-License-Identifier: MIT
// `components`: lists the component library or the charts and components of a file, or prints the text of one
// component.
#include "pipeline/components.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "read/formats.hpp"
#include "support/json_text.hpp"
#include "support/messages.hpp"
#include "support/overloaded.hpp"
#include "syntax/language/parse.hpp"
#include "syntax/resolve/nearest.hpp"
#include "syntax/resolve/resolve.hpp"

namespace grafverif::app {

namespace {

/// Returns the component of a library entry. The library is part of the program; therefore a parse error is an internal
/// failure.
Component component_of(const LibraryEntry& entry) {
    Sources sources;
    Diagnostics diagnostics;
    const Id<Source> file = sources.add({std::string(entry.path), std::string(entry.text)});
    const auto model = read_text(file, sources, {}, diagnostics);
    if (!model || model->components.empty())
        throw std::logic_error(fmt::format("library component {} is invalid", entry.name));
    return *model->components.begin();
}

std::string_view word(Component::ParameterKind kind) {
    switch (kind) {
    case Component::ParameterKind::Input: return "input";
    case Component::ParameterKind::Output: return "output";
    case Component::ParameterKind::Constant: return "constant";
    }
    unreachable();
}

std::string_view word(Component::ValueKind kind) {
    switch (kind) {
    case Component::ValueKind::Boolean: return "bool";
    case Component::ValueKind::Integer: return "int";
    case Component::ValueKind::Duration: return "duration";
    }
    unreachable();
}

nlohmann::ordered_json as_json(const LibraryEntry& entry) {
    const Component component = component_of(entry);
    nlohmann::ordered_json parameters = nlohmann::ordered_json::array();
    for (const Component::Parameter& parameter : component.parameters)
        parameters.push_back(
            {{"name", parameter.name},
             {"kind", word(parameter.kind)},
             {"type", word(parameter.value)},
             {"optional", parameter.kind == Component::ParameterKind::Constant && parameter.initial.has_value()}});
    return {{"name", component.name}, {"summary", component.summary}, {"parameters", parameters}};
}

std::string listing(Format format) {
    if (format == Format::Json) {
        nlohmann::ordered_json all = nlohmann::ordered_json::array();
        for (const LibraryEntry& entry : library()) all.push_back(as_json(entry));
        return json_text(all) + "\n";
    }
    std::size_t width = 0;
    for (const LibraryEntry& entry : library()) width = std::max(width, entry.name.size());
    std::string text;
    for (const LibraryEntry& entry : library())
        text += fmt::format("{:<{}}  {}\n", entry.name, width, component_of(entry).summary);
    return text;
}

/// A chart or component of a file.
struct Declared {
    std::string kind = {}, name = {}, summary = {}, file = {};
    nlohmann::ordered_json parameters = nlohmann::ordered_json::array();
};

std::string_view word(tree::VariableKind kind) {
    return kind == tree::VariableKind::Input ? "input" : kind == tree::VariableKind::Output ? "output" : "constant";
}

template <class Written>
Declared declared(const tree::File& file, const Written& written, std::string_view kind, const std::string& path) {
    Declared found{std::string(kind), std::string(file.text(written.name)), summary(file, written.where), path};
    for (const tree::Variables& group : written.parameters)
        for (const tree::Variable& each : group.variables)
            found.parameters.push_back(
                {{"name", file.text(each.name)},
                 {"kind", word(group.kind)},
                 {"optional", each.value.valid() && group.kind == tree::VariableKind::Constant}});
    return found;
}

/// Returns the charts and components of the files that have been read, without those of the library.
std::vector<Declared> declared_in_files(CommandContext& job) {
    std::vector<Declared> all;
    for (const Id<Source> id : job.sources.ids()) {
        const std::string& path = job.sources[id].name;
        const bool in_library = std::ranges::find(library(), path, &LibraryEntry::path) != library().end();
        if (in_library || format_of(job.sources[id].text) != FileFormat::Grafcet) continue;
        const tree::File file = parse_file(id, job.sources, job.diagnostics);
        for (const tree::Declaration& declaration : file.declarations) {
            if (const auto* chart = std::get_if<tree::Chart>(&declaration))
                all.push_back(declared(file, *chart, "chart", path));
            if (const auto* component = std::get_if<tree::Component>(&declaration))
                all.push_back(declared(file, *component, "component", path));
        }
    }
    return all;
}

ExitCode list_file(const std::string& path, CommandContext& job, const Streams& streams) {
    if (!read_model(path, job)) return ExitCode::Input;
    const std::vector<Declared> all = declared_in_files(job);
    std::string text;
    if (job.options.format == Format::Json) {
        nlohmann::ordered_json list = nlohmann::ordered_json::array();
        for (const Declared& each : all)
            list.push_back({{"kind", each.kind},
                            {"name", each.name},
                            {"summary", each.summary},
                            {"file", each.file},
                            {"parameters", each.parameters}});
        text = json_text(list) + "\n";
    } else {
        std::size_t width = 0;
        for (const Declared& each : all) width = std::max(width, each.name.size());
        for (const Declared& each : all)
            text += fmt::format("{:<9}  {:<{}}  {}\n", each.kind, each.name, width, each.summary);
    }
    deliver(text, job, streams);
    return ExitCode::Done;
}

}  // namespace

ExitCode components(CommandContext& job, const Streams& streams) {
    if (job.options.operands.empty()) {
        deliver(listing(job.options.format), job, streams);
        return ExitCode::Done;
    }
    const std::string& name = job.options.operands[0];
    if (name.find_first_of("./") != std::string::npos) return list_file(name, job, streams);
    const auto found = std::ranges::find(library(), name, &LibraryEntry::name);
    if (found == library().end()) {
        Nearest nearest(name);
        std::string known;
        for (const LibraryEntry& entry : library()) {
            nearest.offer(entry.name);
            known += fmt::format("{}{}", known.empty() ? "" : ", ", entry.name);
        }
        job.diagnostics.add(messages::unknown_component({}, name, nearest.best(), known));
        return ExitCode::Input;
    }
    if (job.options.format == Format::Json) deliver(json_text(as_json(*found)) + "\n", job, streams);
    else deliver(std::string(found->text), job, streams);
    return ExitCode::Done;
}

CliCommand components_usage() {
    return {
        "components",
        "[NAME]",
        0,
        1,
        "list the component library, or show one component, or list the charts and components of a file",
        "Without NAME, lists the components of the library, one per line. With NAME, shows the interface of this "
        "component\n"
        "with units, its behaviour and its source. With a file as NAME (with a dot or a slash), lists the charts and\n"
        "components of the file and of the files that it includes.",
        {"grafverif components", "grafverif components cylinder_5_3", "grafverif components line.grafcet"},
        {OptionGroup::Within, OptionGroup::Output, OptionGroup::Format}};
}

}  // namespace grafverif::app
