// SPDX-License-Identifier: MIT
#include "app/list_properties.hpp"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <ostream>

#include "pipeline/check.hpp"
#include "report/report_source.hpp"
#include "support/json_text.hpp"
#include "support/printable.hpp"

namespace grafverif::app {

namespace {

using Json = nlohmann::ordered_json;

struct Listed {
    std::string model = {};
    bool is_loop = true;
    Property property = {};  ///< without a name, the entry denotes the check of the complete model
};

/// Returns the selected properties of the loop, or nothing after an error.
std::optional<std::vector<Listed>> listed(const Model& model, Id<ClosedLoop> id, CommandContext& job) {
    const ClosedLoop& loop = model.loops[id];
    std::vector<Property> found;
    if (job.options.check_untimed) {
        const auto system = transition_system_of(model, id, job);
        if (!system) return {};
        found.assign(system->properties.begin(), system->properties.end());
        for (const TransitionSystem::Omitted& omitted : system->omitted) found.push_back(omitted.property);
    } else {
        const auto network = network_of(model, id, job);
        if (!network) return {};
        found.assign(network->properties.begin(), network->properties.end());
    }
    std::vector<std::string> names;
    for (const Property& property : found) names.push_back(property.name);
    if (!all_known(job.options.properties, names, job.diagnostics)) return {};
    std::vector<Listed> list;
    for (Property& property : found) {
        const std::string stem = property.name.substr(0, property.name.find('.'));
        const bool requested =
            job.options.properties.empty() || std::ranges::any_of(job.options.properties, [&](const std::string& name) {
                return name == property.name || name == stem;
            });
        if (requested) list.push_back({loop.name, true, std::move(property)});
    }
    if (list.empty()) {
        list.push_back({loop.name});
        list.back().property.origin = loop.origin;
    }
    return list;
}

Json as_json(const Listed& each, const CommandContext& job) {
    const auto where = file_place(job.sources, each.property.origin);
    return {{"file", job.options.operands[0]},
            {"place", where ? Json{{"file", where->file}, {"line", where->at.line}, {"column", where->at.column}}
                            : Json(nullptr)},
            {"model", each.model},
            {"kind", each.is_loop ? "loop" : "chart"},
            {"property", text_or_null(each.property.name)},
            {"text", text_or_null(each.property.text)},
            {"expected", each.property.expected_violated ? "violated" : "holds"}};
}

}  // namespace

ExitCode list_properties(const Model& model, CommandContext& job, const Streams& streams) {
    std::vector<Listed> list;
    if (job.options.chart || (model.loops.empty() && !job.options.loop)) {
        for (const Chart& chart : model.charts)
            if (!job.options.chart || chart.name == *job.options.chart) {
                list.push_back({chart.name, false});
                list.back().property.origin = chart.origin;
            }
        if (list.empty() && job.options.chart && !chosen_chart(model, job)) return ExitCode::Input;
    } else {
        std::vector<Id<ClosedLoop>> loops;
        if (!job.options.loop) loops.assign(model.loops.ids().begin(), model.loops.ids().end());
        else if (const auto loop = chosen_loop(model, job)) loops = {*loop};
        for (const Id<ClosedLoop> id : loops) {
            auto of_loop = listed(model, id, job);
            if (!of_loop) return ExitCode::Input;
            std::ranges::move(*of_loop, std::back_inserter(list));
        }
    }
    Json all = Json::array();
    for (const Listed& each : list) {
        if (job.options.format == Format::Text)
            streams.out << job.options.operands[0] << '\t' << each.model
                        << (each.property.name.empty() ? "" : "\t" + each.property.name) << '\n';
        else if (job.options.format == Format::JsonLines) streams.out << json_text(as_json(each, job), -1) << '\n';
        else all.push_back(as_json(each, job));
    }
    if (job.options.format == Format::Json) streams.out << json_text(all) << '\n';
    return ExitCode::Done;
}

}  // namespace grafverif::app
