// SPDX-License-Identifier: MIT
#include "app/command_context.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/outputs.hpp"
#include "ir/program/program.hpp"
#include "ir/task_cycles.hpp"
#include "pipeline/check.hpp"
#include "pipeline/file_watcher.hpp"
#include "pipeline/files.hpp"
#include "pipeline/models.hpp"
#include "read/test_csv.hpp"
#include "read/text.hpp"
#include "support/messages.hpp"
#include "support/messages_choice.hpp"
#include "support/messages_program.hpp"
#include "support/printable.hpp"
#include "syntax/resolve/nearest_of.hpp"

namespace grafverif::app {

namespace {

std::optional<std::string> read_named(const std::string& path, const CommandContext& job, std::string& why) {
    if (path != "-" && !job.options.within.empty()) return PermittedFolders(job.options.within).read(path, why);
    const auto own = path == "-" ? std::optional(STDIN_FILENO) : own_descriptor(path);
    if (own == STDIN_FILENO && job.in != nullptr) return read_stream(*job.in, why);
    return own ? read_descriptor(*own, why) : content_of_file(path, why);
}

}  // namespace

std::optional<Id<Source>> read_source(const std::string& path, CommandContext& job) {
    std::string why;
    if (job.watch != nullptr) job.watch->note(path);
    auto text = read_named(path, job, why);
    if (!text) {
        job.diagnostics.add(messages::cannot_read(path, why));
        return {};
    }
    if (!note_input(path, job)) return {};
    return job.sources.add({path == "-" ? "<standard input>" : path, std::move(*text)});
}

void remove_task_cycles(Model& model) {
    for (ClosedLoop& loop : model.loops)
        for (ClosedLoop::Controller& controller : loop.controllers) controller.cycle.reset();
}

std::optional<Model> read_model(const std::string& path, CommandContext& job) {
    const auto file = read_source(path, job);
    return file ? read_model(*file, path, job) : std::nullopt;
}

std::optional<Model> read_model(Id<Source> file, const std::string& path, CommandContext& job) {
    for (const std::string& folder : job.options.include_folders) {
        if (std::filesystem::is_directory(folder)) continue;
        job.diagnostics.add(messages::cannot_read(folder, "the folder does not exist"));
        return {};
    }
    const Reach reach(path == "-" ? "./-" : path,  // standard input counts as a file in the current folder
                      job.options.include_folders, PermittedFolders(job.options.within));
    const auto load = [&](const std::string& included, std::string& why) -> std::optional<std::string> {
        if (job.watch != nullptr) job.watch->note(included);
        auto text = reach.read(included, why);
        if (text && !note_input(included, job)) return why = "the file is also an output", std::nullopt;
        return text;
    };
    ReadContext context = context_of(reach, job.options.include_folders, job.options.lossy);
    context.load = load;
    context.constants.insert(job.options.constants.begin(), job.options.constants.end());
    auto model = read_text(file, job.sources, context, job.diagnostics);
    if (model && job.options.cycle == CycleTime::Zero) remove_task_cycles(*model);
    return model;
}

namespace {

/// Returns the element with the name `wanted`. If `wanted` is empty, returns the only element of the table. Adds an
/// error that lists all elements if no element has this name, or if no name is given and the choice is ambiguous.
template <class T>
std::optional<Id<T>> chosen(const Table<T>& table, const std::optional<std::string>& wanted, std::string_view kind,
                            std::string_view option, CommandContext& job) {
    std::vector<std::string> names;
    for (const Id<T> id : table.ids()) {
        if (wanted && table[id].name == *wanted) return id;
        names.push_back(table[id].name);
    }
    if (!wanted && table.size() == 1) return *table.ids().begin();
    if (wanted) job.diagnostics.add(messages::no_such_choice(kind, *wanted, names, nearest_of(*wanted, names)));
    else job.diagnostics.add(messages::ambiguous_choice(kind, option, names));
    return {};
}

/// True if the loop declares every constant that `--set` names. With `--all`, the result is always true: read_text
/// checks that each constant exists in at least one loop.
bool has_constants_set(const ClosedLoop& loop, CommandContext& job) {
    if (job.options.all) return true;
    std::vector<std::string> known;
    for (const NamedConstant& constant : loop.constants) known.push_back(constant.name);
    for (const auto& [name, value] : job.options.constants)
        if (std::ranges::find(known, name) == known.end()) {
            job.diagnostics.add(messages::no_such_constant(loop.origin, loop.name, name, nearest_of(name, known)));
            return false;
        }
    return true;
}

/// Reports each PLC program that has timers, if `--cycle` requests cycle time zero. Returns false after an error.
bool has_cycles_required(const Model& model, const ClosedLoop& loop, CommandContext& job) {
    if (job.options.cycle == CycleTime::Task) return true;
    const std::size_t errors = job.diagnostics.errors();
    for (const ClosedLoop::Controller& controller : loop.controllers) {
        const Chart& chart = model.charts[controller.chart];
        if (chart.program && layout_of(*chart.program).longest > 0)
            job.diagnostics.add(messages::program_with_cycle_zero(controller.origin, controller.name));
    }
    return job.diagnostics.errors() == errors;
}

}  // namespace

bool is_of_a_chart(const Model& model, const Options& options) {
    return options.chart || (!options.loop && model.loops.empty());
}

std::optional<Id<ClosedLoop>> chosen_loop(const Model& model, CommandContext& job) {
    if (model.loops.empty() && !job.options.loop) {
        job.diagnostics.add(messages::no_closed_loop());
        return {};
    }
    const auto loop = chosen(model.loops, job.options.loop, "closed loop", "--loop", job);
    if (!loop || !has_constants_set(model.loops[*loop], job)) return {};
    return has_cycles_required(model, model.loops[*loop], job) ? loop : std::nullopt;
}

bool keep_requested(ClosedLoop& loop, CommandContext& job) {
    const std::vector<std::string>& requested = job.options.properties;
    if (requested.empty()) return true;
    std::vector<std::string> known;
    Table<Property> kept;
    for (const Property& property : loop.properties) {
        known.push_back(property.name);
        if (std::ranges::find(requested, property.name) != requested.end()) kept.add(property);
    }
    loop.properties = std::move(kept);
    return all_known(requested, known, job.diagnostics);
}

namespace {

/// True if all charts with the requested name are equal; otherwise adds an error. Controllers of several closed loops
/// may have equal names.
bool is_unique(const Model& model, std::string_view name, Diagnostics& diagnostics) {
    const Chart* first = nullptr;
    const auto written = [](const Chart& chart) { return chart.instance_of.empty() ? chart.name : chart.instance_of; };
    for (const Chart& chart : model.charts) {
        if (chart.name != name) continue;
        if (first == nullptr) first = &chart;
        const bool same = written(chart) == written(*first) && chart.has_defaults && first->has_defaults;
        if (&chart == first || same) continue;
        diagnostics.add(messages::duplicate_name(chart.origin, "chart", name, first->origin));
        return false;
    }
    return true;
}

}  // namespace

std::optional<Id<Chart>> chosen_chart(const Model& model, CommandContext& job) {
    if (job.options.chart && !is_unique(model, *job.options.chart, job.diagnostics)) return {};
    // Without `--chart`, an instance of a chart is never selected, and a chart with parameters only if all charts have
    // parameters.
    for (const bool with_parameters : {false, true}) {
        std::vector<Id<Chart>> found;
        for (const Id<Chart> id : model.charts.ids())
            if (model.charts[id].has_parameters == with_parameters && model.charts[id].instance_of.empty())
                found.push_back(id);
        if (!job.options.chart && found.size() == 1) return found.front();
        if (!found.empty()) break;
    }
    return chosen(model.charts, job.options.chart, "chart", "--chart", job);
}

namespace {

/// True if `name` denotes the step: `3` or `G1.3`, with or without the `X` of the step variable.
bool is_called(const Chart& chart, Id<Chart::Step> step, std::string_view name) {
    const std::string& partial = chart.partial_charts[chart.steps[step].chart].name;
    const std::string& own = chart.steps[step].name;
    return name == own || name == "X" + own || name == partial + '.' + own || name == partial + ".X" + own;
}

}  // namespace

std::vector<Id<Chart::Step>> named_steps(const Chart& chart, std::string_view rest, std::string_view option,
                                         CommandContext& job) {
    std::vector<Id<Chart::Step>> steps;
    while (!rest.empty()) {
        const std::string_view name = rest.substr(0, rest.find(','));
        rest.remove_prefix(std::min(name.size() + 1, rest.size()));
        std::vector<Id<Chart::Step>> meant;
        for (const Id<Chart::Step> step : chart.steps.ids())
            if (is_called(chart, step, name)) meant.push_back(step);
        if (meant.size() == 1) {
            steps.push_back(meant.front());
            continue;
        }
        std::vector<std::string> known;
        for (const Id<Chart::Step> step : chart.steps.ids())
            if (meant.empty() || std::ranges::find(meant, step) != meant.end())
                known.push_back(step_variable(chart, step));
        job.diagnostics.add(meant.empty() ? messages::no_such_choice("step", name, known, nearest_of(name, known))
                                          : messages::ambiguous_choice("step", option, known));
    }
    return steps;
}

ExecutionMode execution_mode(const Model& model, Id<Chart> chart, const CommandContext& job) {
    return grafverif::execution_mode(model, chart, job.options.mode);
}

ReadOptions read_options(const Options& options) {
    return {.include_folders = options.include_folders, .lossy = options.lossy, .constants = options.constants};
}

ModelOptions model_options(const Options& options) { return {options.mode, options.grain, options.untimed}; }

ModelOptions model_options(const Options& options, const ClosedLoop& loop) {
    ModelOptions made = model_options(options);
    if (!options.plant && has_task_cycle(loop)) made.untimed.plant = PlantApproach::Automata;
    return made;
}

structured_text::Form structured_text_form(const Options& options) {
    return options.format == Format::Text ? structured_text::Form::Text : structured_text::Form::PlcopenXml;
}

ConformOptions conform_options(const Options& options, const Limits& limits) {
    return {options.mode, false, options.minimise, options.cover, options.one_cycle_each, limits};
}

std::optional<Equations> equations_of(const Model& model, Id<Chart> chart, CommandContext& job) {
    return grafverif::equations_of(model, chart, job.diagnostics);
}

std::optional<TestSequence> test_sequence(const Model& model, Id<Chart> chart, CommandContext& job) {
    const Chart& tested = model.charts[chart];
    for (const auto& [kind, what] :
         {std::pair(Chart::VariableKind::Input, "inputs"), std::pair(Chart::VariableKind::Output, "outputs")})
        if (std::ranges::none_of(tested.variables,
                                 [kind = kind](const auto& variable) { return variable.kind == kind; }))
            job.diagnostics.add(messages::nothing_to_test(tested.origin, tested.name, what));
    const auto file = job.diagnostics.has_errors() ? std::nullopt : read_source(*job.options.sequence, job);
    if (!file) return {};
    return read_test_csv(*file, job.sources, tested, execution_mode(model, chart, job), job.diagnostics);
}

std::optional<Network> network_of(const Model& model, Id<ClosedLoop> loop, CommandContext& job) {
    for (const std::string& cure : job.options.disabled_corrections)
        job.diagnostics.add(messages::ablation_active(cure));
    return grafverif::network_of(model, loop, ComposeOptions{job.options.grain, job.options.mode, job.options.without},
                                 job.diagnostics);
}

std::optional<TransitionSystem> transition_system_of(const Model& model, Id<ClosedLoop> loop, CommandContext& job) {
    return grafverif::transition_system_of(model, loop, model_options(job.options, model.loops[loop]), job.diagnostics);
}

void print_failures(const std::vector<std::string>& failures, const Streams& streams) {
    for (const std::string& failure : failures)
        streams.err << "grafverif: internal error: " << printable(failure) << '\n';
}

Colour colour_on(const Screen& screen, const Options& options) {
    const bool automatic = options.colour == ColourChoice::Auto && screen.colours;
    return automatic || options.colour == ColourChoice::Always ? Colour::Ansi : Colour::Plain;
}

ResourceLimits::ResourceLimits(const Options& options, const Streams& streams)
    : line_(streams.err, streams.err_screen.rewrites && !options.quiet),
      limits_{options.max_states, options.max_memory, options.deadline, &interrupt_.requested(),
              [this](const Progress& now) { line_.show(now.words); }} {}

}  // namespace grafverif::app
