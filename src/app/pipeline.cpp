// SPDX-License-Identifier: MIT
#include "app/pipeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

#include "app/system/files.hpp"
#include "app/library.hpp"
#include "app/outputs.hpp"
#include "app/progress_line.hpp"
#include "compose/compose.hpp"
#include "conform/automaton.hpp"
#include "conform/mealy.hpp"
#include "conform/test_sequence.hpp"
#include "derive/derive.hpp"
#include "emit/nusmv/nusmv.hpp"
#include "emit/structured_text/structured_text.hpp"
#include "emit/uppaal/uppaal.hpp"
#include "plant/plant.hpp"
#include "read/test_csv.hpp"
#include "read/text.hpp"
#include "schedule/controller.hpp"
#include "schedule/network.hpp"
#include "schedule/together.hpp"
#include "support/messages.hpp"

namespace grafverif::app {

namespace {

// Reach: which files a file may include. A chart does not decide which other files of the machine are read: those below
// the folder of the main file, below the folder of its project, and below folders that the user names. The current
// folder has no part in it. The folder of the project is the nearest above the main file, its own included, that holds
// `.git` or `grafverif.project`.

class Reach {
public:
    /// `main`: the main file. `folders`: those of `-I`.
    Reach(const std::filesystem::path& main, const std::vector<std::string>& folders);

    /// The content of the regular file at `path`, if it is in reach; else nothing, and `why`.
    std::optional<std::string> read(const std::string& path, std::string& why) const;

private:
    std::vector<std::filesystem::path> roots_ = {};   ///< links followed
};

namespace fs = std::filesystem;

std::optional<fs::path> project_of(fs::path folder) {
    for (;; folder = folder.parent_path()) {
        std::error_code ignored;
        for (const char* mark : {".git", "grafverif.project"})
            if (fs::exists(folder / mark, ignored)) return folder;
        if (!folder.has_relative_path()) return {};
    }
}

bool is_below(const fs::path& file, const fs::path& root) {
    return std::mismatch(root.begin(), root.end(), file.begin(), file.end()).first == root.end();
}

/// What tells the file at `path` from others (see file_identity); empty: nothing is there.
std::string identity_of_existing(const std::string& path) {
    struct stat status = {};
    return ::stat(path.c_str(), &status) == 0 ? fmt::format("{}:{}", status.st_dev, status.st_ino) : std::string();
}

Reach::Reach(const fs::path& main, const std::vector<std::string>& folders) {
    roots_.push_back(fs::weakly_canonical(fs::absolute(main).parent_path()));
    if (auto project = project_of(roots_.front())) roots_.push_back(std::move(*project));
    for (const std::string& folder : folders) roots_.push_back(fs::weakly_canonical(fs::absolute(folder)));
}

std::optional<std::string> Reach::read(const std::string& path, std::string& why) const {
    std::error_code failure;
    const fs::path file = fs::canonical(path, failure);
    if (!failure && std::ranges::none_of(roots_, [&](const fs::path& root) { return is_below(file, root); })) {
        why = "it lies neither below the folder of the main file nor below that of its project, which `.git` or `grafverif.project` "
              "marks; let it be read with `-I FOLDER`";
        return {};
    }
    return read_file(failure ? fs::path(path) : file, why);
}

std::optional<std::string> read_named(const std::string& path, const Job& job, std::string& why) {
    const auto own = path == "-" ? std::optional(STDIN_FILENO) : own_descriptor(path);
    if (own == STDIN_FILENO && job.in != nullptr) return read_stream(*job.in, why);
    return own ? read_descriptor(*own, why) : read_file(path, why);
}

}  // namespace

std::optional<Id<Source>> read_source(const std::string& path, Job& job) {
    std::string why;
    auto text = read_named(path, job, why);
    if (!text) {
        job.diagnostics.add(messages::cannot_read(path, why));
        return {};
    }
    if (!note_input(path, job)) return {};
    return job.sources.add({path == "-" ? "<standard input>" : path, std::move(*text)});
}

std::optional<Model> read_model(const std::string& path, Job& job) {
    for (const std::string& folder : job.options.include_folders) {
        if (std::filesystem::is_directory(folder)) continue;
        job.diagnostics.add(messages::cannot_read(folder, "there is no such folder"));
        return {};
    }
    const auto file = read_source(path, job);
    if (!file) return {};
    const Reach reach(path == "-" ? "./-" : path, job.options.include_folders);   // standard input stands in the current folder
    const auto load = [&](const std::string& included, std::string& why) -> std::optional<std::string> {
        auto text = reach.read(included, why);
        if (text && !note_input(included, job)) return why = "it is also an output", std::nullopt;
        return text;
    };
    return read_text(*file, job.sources, {load, library(), job.options.lossy, identity_of_existing, job.options.include_folders}, job.diagnostics);
}

namespace {

/// The entity called `wanted`, or the only one; an error naming the candidates otherwise.
template <class T>
std::optional<Id<T>> chosen(const Table<T>& table, const std::optional<std::string>& wanted, std::string_view kind,
                            std::string_view option, Job& job) {
    std::vector<std::string> names;
    for (const Id<T> id : table.ids()) {
        if (wanted && table[id].name == *wanted) return id;
        names.push_back(table[id].name);
    }
    if (!wanted && table.size() == 1) return *table.ids().begin();
    if (wanted) job.diagnostics.add(messages::no_such_choice(kind, *wanted, names));
    else job.diagnostics.add(messages::ambiguous_choice(kind, option, names));
    return {};
}

/// The equations of every controller of the loop, in order.
std::optional<std::vector<Equations>> equations_of_controllers(const Model& model, const ClosedLoop& loop, Job& job) {
    std::vector<Equations> all;
    for (const ClosedLoop::Controller& controller : loop.controllers)
        if (auto equations = derive(model.charts[controller.chart], job.diagnostics)) all.push_back(std::move(*equations));
    if (all.size() != loop.controllers.size()) return {};
    return all;
}

}  // namespace

std::optional<Id<ClosedLoop>> chosen_loop(const Model& model, Job& job) {
    if (model.loops.empty() && !job.options.loop) {
        job.diagnostics.add(messages::no_closed_loop());
        return {};
    }
    return chosen(model.loops, job.options.loop, "closed loop", "--loop", job);
}

std::optional<Id<Chart>> chosen_chart(const Model& model, Job& job) {
    return chosen(model.charts, job.options.chart, "chart", "--chart", job);
}

ExecutionMode execution_mode(const Model& model, Id<Chart> chart, const Job& job) {
    std::optional<ExecutionMode> agreed;
    for (const ClosedLoop& loop : model.loops)
        for (const ClosedLoop::Controller& controller : loop.controllers) {
            if (controller.chart != chart) continue;
            if (agreed && *agreed != controller.mode) return job.options.mode.value_or(ExecutionMode::StabilitySearch);
            agreed = controller.mode;
        }
    return job.options.mode.value_or(agreed.value_or(ExecutionMode::StabilitySearch));
}

std::optional<Equations> equations_of(const Model& model, Id<Chart> chart, Job& job) {
    return derive(model.charts[chart], job.diagnostics);
}

std::optional<TestSequence> test_sequence(const Model& model, Id<Chart> chart, Job& job) {
    const Chart& tested = model.charts[chart];
    for (const auto& [kind, what] : {std::pair(Chart::VariableKind::Input, "inputs"), std::pair(Chart::VariableKind::Output, "outputs")})
        if (std::ranges::none_of(tested.variables, [kind = kind](const auto& variable) { return variable.kind == kind; }))
            job.diagnostics.add(messages::nothing_to_test(tested.origin, tested.name, what));
    const auto file = job.diagnostics.has_errors() ? std::nullopt : read_source(*job.options.sequence, job);
    if (!file) return {};
    return read_test_csv(*file, job.sources, tested, execution_mode(model, chart, job), job.diagnostics);
}

std::optional<LocationAutomaton> automaton_of(const Model& model, Id<Chart> chart, Job& job, const Streams& streams,
                                              const Interrupt& interrupt, bool partial) {
    const auto equations = equations_of(model, chart, job);
    if (!equations) return {};
    ProgressLine line(streams.err, streams.err_is_terminal && !job.options.quiet);
    AutomatonOptions options;
    options.mode = execution_mode(model, chart, job);
    options.partial = partial;
    options.max_locations = job.options.max_states.value_or(options.max_locations);
    options.max_memory = job.options.max_memory.value_or(options.max_memory);
    options.deadline = job.options.deadline;
    options.stop = &interrupt.asked();
    options.progress = [&line](const ConformProgress& now) {
        line.show([&] {
            return fmt::format("{} locations, {} to go on from, {} evolutions", now.locations, now.locations - now.done,
                               now.evolutions);
        });
    };
    return location_automaton(*equations, options, job.diagnostics);
}

std::optional<MealyMachine> mealy_of(const Model& model, Id<Chart> chart, Job& job, const Streams& streams,
                                     const Interrupt& interrupt) {
    const auto automaton = automaton_of(model, chart, job, streams, interrupt);
    if (!automaton) return {};
    MealyOptions options;
    options.max_states = job.options.max_states.value_or(options.max_states);
    options.max_memory = job.options.max_memory.value_or(options.max_memory);
    options.deadline = job.options.deadline;
    options.stop = &interrupt.asked();
    auto machine = mealy_machine(*automaton, options, job.diagnostics);
    return machine && job.options.minimise ? minimised(*machine, options, model.charts[chart].origin, job.diagnostics) : std::move(machine);
}

std::optional<TestSequence> test_of(const Model& model, Id<Chart> chart, const MealyMachine& machine, Job& job) {
    TestOptions options;
    options.cover = job.options.cover;
    options.one_cycle_each = job.options.one_cycle_each;
    return test_sequence(machine, options, model.charts[chart].origin, job.diagnostics);
}

std::optional<Network> network_of(const Model& model, Id<ClosedLoop> id, Job& job) {
    const ClosedLoop& loop = model.loops[id];
    const auto equations = equations_of_controllers(model, loop, job);
    const auto plant_network = plant(model, loop, job.diagnostics);
    if (!equations || !plant_network) return {};
    for (const std::string& cure : job.options.cures_left_out) job.diagnostics.add(messages::cure_left_out(cure));
    const ComposeOptions options{job.options.grain, job.options.mode, job.options.without};
    auto network = compose(*plant_network, loop, *equations, options, job.diagnostics);
    if (network)
        for (const Property& property : network->observed)
            job.diagnostics.add(messages::not_expressible(property.origin, property.name, "timed",
                                                          "it reads an observer, and observers watch untimed models"));
    return network;
}

namespace {

std::optional<TransitionSystem> scheduled(const Model& model, const ClosedLoop& loop, Job& job) {
    ScheduleOptions options = job.options.untimed;
    options.mode = job.options.mode;
    const auto equations = equations_of_controllers(model, loop, job);
    if (!equations) return {};
    if (options.plant != PlantApproach::Automata) {
        if (options.plant == PlantApproach::Constraints && !constraints_agree(loop, job.diagnostics)) return {};
        return schedule_controllers(model, loop, *equations, options);
    }
    const auto plant_network = plant(model, loop, job.diagnostics);
    if (!plant_network) return {};
    const Schedule schedule = options.schedule.value_or(loop.schedule.value_or(Schedule::Interleaved));
    if (schedule != Schedule::Interleaved)
        return schedule_together(model, loop, *equations, *plant_network, options, job.diagnostics);
    const ComposeOptions composing{job.options.grain, job.options.mode, {}};
    const auto network = compose(*plant_network, loop, *equations, composing, job.diagnostics);
    if (!network) return {};
    return schedule_network(*network, options, job.diagnostics);
}

}  // namespace

std::optional<TransitionSystem> transition_system_of(const Model& model, Id<ClosedLoop> id, Job& job) {
    auto system = scheduled(model, model.loops[id], job);
    if (system) *system = nusmv::sayable(std::move(*system));
    return system;
}

TransitionSystem controller_of(const Model& model, Id<Chart> chart, const Equations& equations, const Job& job) {
    return schedule_controller(equations, execution_mode(model, chart, job));
}

namespace {

structured_text::Form structured_text_form(const Job& job) {
    return job.options.format == Format::Text ? structured_text::Form::Text : structured_text::Form::PlcopenXml;
}

}  // namespace

std::string structured_text_controller(const Equations& equations, ExecutionMode mode, Job& job) {
    if (!structured_text::expressible(equations, job.diagnostics)) return {};
    std::ostringstream out;
    structured_text::emit(equations, {mode, static_cast<std::uint32_t>(job.options.max_evolutions), structured_text_form(job)}, out);
    return std::move(out).str();
}

std::string structured_text_test(const TestSequence& test, const Job& job) {
    std::ostringstream out;
    structured_text::emit_test(test, structured_text_form(job), out);
    return std::move(out).str();
}

UppaalProject uppaal_project(const Network& network, Job& job) {
    const Network lowered = uppaal::lower(network);
    for (const uppaal::Inexpressible& left_out : uppaal::inexpressible(lowered)) {
        const Property& property = lowered.properties[left_out.property];
        job.diagnostics.add(messages::not_expressible(property.origin, property.name, "UPPAAL", left_out.reason));
    }
    std::ostringstream project, queries;
    uppaal::emit(lowered, project);
    uppaal::emit_queries(lowered, queries);
    return {std::move(project).str(), std::move(queries).str()};
}

UppaalQuestions uppaal_questions(const Network& network) {
    const Network lowered = uppaal::lower(network);
    const std::vector<uppaal::Inexpressible> left_out = uppaal::inexpressible(lowered);
    UppaalQuestions result;
    for (const uppaal::Formula& formula : uppaal::formulas(lowered)) {
        const auto why = std::ranges::find(left_out, formula.property, &uppaal::Inexpressible::property);
        result.questions.push_back({formula.property, formula.name, formula.text, why == left_out.end() ? "" : why->reason});
    }
    std::ostringstream project;
    uppaal::emit(lowered, project);
    result.project = std::move(project).str();
    return result;
}

std::string nusmv_model(const TransitionSystem& system, Job& job) {
    for (const TransitionSystem::Omitted& omitted : system.omitted)
        job.diagnostics.add(messages::not_expressible(omitted.property.origin, omitted.property.name, "NuSMV", omitted.reason));
    std::ostringstream out;
    nusmv::emit(system, out);
    return std::move(out).str();
}

}  // namespace grafverif::app
