// SPDX-License-Identifier: MIT
// `build`: translates a closed loop to a UPPAAL project and a NuSMV model. Either all files or no files are written.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "support/json_text.hpp"
#include "support/printable.hpp"

namespace grafverif::app {

namespace {

std::vector<Product> products(const Model& model, Id<ClosedLoop> loop, CommandContext& job) {
    const std::string name = job.options.name.value_or(model.loops[loop].name);
    const std::filesystem::path folder = job.options.output.value_or("./" + name + ".grafverif");
    std::vector<Product> made;
    if (job.options.target != Target::Nusmv) {
        if (const auto network = network_of(model, loop, job)) {
            UppaalProject project = uppaal_project(*network, job.diagnostics);
            made.push_back({{folder / (name + ".xml"), std::move(project.project)},
                            "UPPAAL project of the closed loop, for UPPAAL or `verifyta`"});
            made.push_back({{folder / (name + ".q"), std::move(project.queries)},
                            "queries of the UPPAAL project, for `verifyta`"});
        }
    }
    if (job.options.target != Target::Uppaal) {
        if (const auto system = transition_system_of(model, loop, job))
            made.push_back({{folder / (name + ".smv"), nusmv_model(*system, job.diagnostics)},
                            model_options(job.options, model.loops[loop]).untimed.plant == PlantApproach::Automata
                                ? "NuSMV model of the closed loop with plant automata"
                                : "NuSMV model of the controller with free inputs and timers"});
    }
    return made;
}

std::string listed(const std::vector<Product>& made, Format format) {
    if (format == Format::Json) {
        nlohmann::ordered_json files = nlohmann::ordered_json::array();
        for (const Product& product : made)
            files.push_back(
                {{"path", product.file.path.string()}, {"bytes", product.file.content.size()}, {"use", product.use}});
        return json_text(nlohmann::ordered_json{{"files", files}}) + "\n";
    }
    std::string text = "wrote\n";
    for (const Product& product : made)
        text += fmt::format("  {}\n      {}\n", printable(product.file.path.string()), product.use);
    return text;
}

}  // namespace

ExitCode build(CommandContext& job, const Streams&) {
    auto model = read_model(job.options.operands[0], job);
    if (!model) return ExitCode::Input;
    std::vector<Id<ClosedLoop>> loops;
    if (job.options.all) loops.assign(model->loops.ids().begin(), model->loops.ids().end());
    if (loops.empty())  // the file has no loop, or `--all` is missing
        if (const auto loop = chosen_loop(*model, job)) loops = {*loop};
    for (const Id<ClosedLoop> loop : loops)
        if (!keep_requested(model->loops[loop], job)) return ExitCode::Input;
    for (const Id<ClosedLoop> loop : loops)
        for (Product& product : products(*model, loop, job)) job.products.push_back(std::move(product));
    return ExitCode::Done;
}

void list_products(CommandContext& job) {
    if (!job.options.quiet && !job.products.empty()) job.closing = listed(job.products, job.options.format);
}

CliCommand build_usage() {
    return {
        "build",
        "FILE...",
        1,
        any_number,
        "write the UPPAAL project and the NuSMV model of a closed loop",
        "Writes, for the closed loop NAME of FILE (.grafcet):\n"
        "  NAME.xml  UPPAAL project of the timed closed loop, with queries\n"
        "  NAME.q    the queries only\n"
        "  NAME.smv  NuSMV model of the controller with free inputs and timers; with --plant automata: of the loop\n"
        "\n"
        "If a construct cannot be translated exactly, it is reported with its line, and no file is written. After an\n"
        "error or a signal, either all files are written or no file has changed (docs/reference/files.md). --depfile\n"
        "writes the dependencies for a build system (docs/how-to/build-systems.md).",
        {"grafverif build samples/testing_station/testing_station.grafcet",
         "grafverif build station.grafcet -o models --create-dirs --grain atomic --target uppaal",
         "grafverif build station.grafcet -o models --name station --depfile models/station.d",
         "grafverif build press.grafcet oven.grafcet --all -o models"},
        {OptionGroup::OutputDirectory, OptionGroup::All, OptionGroup::Target, OptionGroup::Loop, OptionGroup::Constants,
         OptionGroup::Questions, OptionGroup::Mode, OptionGroup::Grain, OptionGroup::Cycle, OptionGroup::Untimed,
         OptionGroup::Format}};
}

}  // namespace grafverif::app
