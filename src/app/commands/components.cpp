// SPDX-License-Identifier: MIT
// `components`: lists the component library, or prints the text of one component.
#include "pipeline/components.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "support/json_text.hpp"
#include "support/messages.hpp"
#include "support/overloaded.hpp"
#include "syntax/resolve/nearest.hpp"

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

}  // namespace

ExitCode components(CommandContext& job, const Streams& streams) {
    if (job.options.operands.empty()) {
        deliver(listing(job.options.format), job, streams);
        return ExitCode::Done;
    }
    const std::string& name = job.options.operands[0];
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
    return {"components",
            "[NAME]",
            0,
            1,
            "list the component library, or show one component",
            "Without NAME, lists the components of the library, one per line. With NAME, shows the interface of this "
            "component\n"
            "with units, its behaviour and its source.",
            {"grafverif components", "grafverif components cylinder_5_3"},
            {OptionGroup::Output, OptionGroup::Format}};
}

}  // namespace grafverif::app
