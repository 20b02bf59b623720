// SPDX-License-Identifier: MIT
#include "read/text.hpp"

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "ir/program/interface.hpp"
#include "read/formats.hpp"
#include "read/program/program.hpp"
#include "support/messages.hpp"
#include "support/messages_choice.hpp"
#include "support/messages_program.hpp"
#include "support/overloaded.hpp"
#include "syntax/language/parse.hpp"
#include "syntax/language/tree.hpp"
#include "syntax/resolve/nearest_of.hpp"
#include "syntax/resolve/resolve.hpp"

namespace grafverif {

namespace {

// Parses the input file and all files that it includes. In the result, a file follows the files that it includes.

std::string identity(const std::string& path, const ReadContext& context) {
    return context.identity ? context.identity(path) : path;
}

/// Returns the path `folder`/`written`, normalized if the normalized path denotes the same file. The normalized path
/// may denote another file: if `link` is a symbolic link, `link/../a` and `a` may be different files.
std::string joined(const std::filesystem::path& folder, const std::string& written, const ReadContext& context) {
    const std::filesystem::path path = folder / written;
    const std::string shorter = path.lexically_normal().generic_string();
    return identity(shorter, context) == identity(path.generic_string(), context) || !context.identity
               ? shorter
               : path.generic_string();
}

enum class State { Open, Done };

/// A file whose includes are being processed. The stack of open files is explicit, so that the native stack does not
/// limit nesting.
struct Open {
    tree::File file = {};
    std::string identity = {};
    std::size_t next = 0;  ///< next declaration to process
};

/// Parses a file and its includes, each file once. Reports cycles and unreadable files at the include line. Sets
/// `missing` if a file is unreadable.
std::vector<tree::File> parse_with_includes(Id<Source> file, Sources& sources, const ReadContext& context,
                                            bool& missing, Diagnostics& diagnostics) {
    std::vector<tree::File> files;
    std::unordered_map<std::string, State> states;
    std::vector<Open> open;
    const auto enter = [&](Id<Source> source, std::string identity) {
        states[identity] = State::Open;
        open.push_back({read_any(source, sources, {context.lossy, context.stop}, diagnostics), std::move(identity), 0});
    };
    const std::string main = sources[file].name;
    enter(file,
          identity(context.identity ? main : std::filesystem::path(main).lexically_normal().generic_string(), context));
    while (!open.empty()) {
        Open& top = open.back();
        if (top.next == top.file.declarations.size()) {
            states[top.identity] = State::Done;
            files.push_back(std::move(top.file));
            open.pop_back();
            continue;
        }
        const auto* include = std::get_if<tree::Include>(&top.file.declarations[top.next++]);
        if (include == nullptr) continue;
        const std::string path = path_of_include(sources[top.file.source].name, include->path, context);
        const std::string known_as = identity(path, context);
        const auto known = states.find(known_as.empty() ? path : known_as);
        if (known != states.end()) {
            if (known->second == State::Open) diagnostics.add(messages::include_cycle(include->where, path));
            continue;
        }
        std::string why = "includes are not available here";
        auto text = context.load ? context.load(path, why) : std::nullopt;
        if (!text) {
            missing = true;
            diagnostics.add(messages::cannot_include(include->where, include->path, why));
            states[known_as.empty() ? path : known_as] = State::Done;
            continue;
        }
        enter(sources.add({path, std::move(*text)}), known_as);
    }
    return files;
}

struct ReadState {
    Sources& sources;
    const ReadContext& context;
    Diagnostics& diagnostics;
    Recorder record = {};
    Model model = {};
    std::uint64_t copied = 0;  ///< number of elements in copies of replicated declarations
    std::unordered_map<std::string, Span> charts = {}, components = {}, loops = {};  ///< known names with their
                                                                                     ///< positions
    WrittenCharts written = {};
    std::unordered_set<std::string> components_in_error = {};
};

/// True if the name is new in `seen`; otherwise reports a duplicate.
bool is_new(ReadState& reading, std::unordered_map<std::string, Span>& seen, std::string_view kind,
            std::string_view name, Span where) {
    const auto [known, fresh] = seen.try_emplace(std::string(name), where);
    if (!fresh) reading.diagnostics.add(messages::duplicate_name(where, kind, name, known->second));
    return fresh;
}

/// True if the names in a declaration must be resolved: the declaration is complete and its name is new, or the
/// recorder also records references in declarations with errors.
bool is_resolved(const ReadState& reading, bool fresh, bool broken) {
    return reading.record.beyond_errors() || (fresh && !broken);
}

void read_chart(ReadState& reading, const tree::File& file, const tree::Chart& written) {
    const std::string name(file.text(written.name));
    const bool fresh = is_new(reading, reading.charts, "chart or program", name, written.name.where);
    std::optional<Chart> chart;
    if (is_resolved(reading, fresh, written.broken))
        chart = resolve_chart(file, written, reading.diagnostics, reading.record, &reading.copied, &reading.written);
    if (chart && fresh) reading.model.charts.add(std::move(*chart));
    else if (fresh) reading.written.in_error.insert(name);
}

/// True if a closed loop can declare all inputs and outputs of a program. Otherwise, reports the inputs and outputs
/// that are parts of structures, arrays and instances.
bool has_elementary_signals(const Program& program, Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.errors();
    const ProgramLayout layout = layout_of(program);
    const auto check = [&](Id<Program::Unit> unit, std::size_t begin) {
        for (const Program::Variable& variable : program.units[unit].variables) {
            const std::span cells = std::span(layout.cells).subspan(begin, size_of(program, variable.type));
            begin += cells.size();
            const auto signal = std::ranges::find_if(cells, [&](const ProgramCell& cell) {
                return (cell.input || cell.output) && cell.name != variable.name;
            });
            if (signal == cells.end()) continue;
            diagnostics.add(
                messages::composite_signal(variable.origin, signal->input ? "input" : "output", signal->name));
        }
    };
    check(program.globals, 0);
    if (program.main != program.globals) check(program.main, layout.main);
    return diagnostics.errors() == errors;
}

/// Reads the file of a PLC program, and adds a chart that represents the program in closed loops.
void read_plc_program(ReadState& reading, const tree::File& file, const tree::PlcProgram& written) {
    const std::string name(file.text(written.name));
    if (!is_new(reading, reading.charts, "chart or program", name, written.name.where)) return;
    reading.record.declare(DeclarationKind::Chart, name, written.name.where, written.where);
    reading.written.in_error.insert(name);
    const std::string path = path_of_include(reading.sources[file.source].name, written.path, reading.context);
    std::string why = "other files are not available here";
    auto text = reading.context.load ? reading.context.load(path, why) : std::nullopt;
    if (!text) return reading.diagnostics.add(messages::cannot_include(written.path_where, written.path, why));
    const Id<Source> source = reading.sources.add({path, std::move(*text)});
    References names;
    const Recorder record = reading.record.is_recording() ? Recorder(&names) : Recorder();
    const auto program = read_program(source, reading.sources, reading.diagnostics, record);
    if (program && has_elementary_signals(program->program(), reading.diagnostics)) {
        reading.written.in_error.erase(name);
        Chart chart = interface_of({std::make_shared<const Program>(program->program())}, name, written.name.where);
        // In the loop, the name of the program qualifies its variables and steps. Therefore, the program is recorded as
        // the owner of its variables and steps. The declarations in the text of the program follow.
        for (const Chart::Variable& each : chart.variables)
            reading.record.declare(declaration_kind(each.kind), each.name, each.origin, each.origin, chart.origin);
        for (const Chart::Step& each : chart.steps)
            reading.record.declare(DeclarationKind::Step, each.name, each.origin, each.origin, chart.origin);
        reading.model.charts.add(std::move(chart));
    }
    reading.record.add(std::move(names));
}

/// Returns the component `name` of the library, or null if the library has no component of this name.
const LibraryEntry* library_entry(const ReadState& reading, std::string_view name) {
    const auto entry = std::ranges::find(reading.context.library, name, &LibraryEntry::name);
    return entry == reading.context.library.end() ? nullptr : &*entry;
}

void read_component(ReadState& reading, const tree::File& file, const tree::Component& written) {
    const std::string name(file.text(written.name));
    const bool fresh = is_new(reading, reading.components, "component", name, written.name.where);
    if (fresh && library_entry(reading, name) != nullptr)
        reading.diagnostics.add(messages::shadows_library(written.name.where, name));
    std::optional<Component> component;
    if (is_resolved(reading, fresh, written.broken))
        component = resolve_component(file, written, reading.diagnostics, reading.record, &reading.copied);
    if (component && fresh) reading.model.components.add(std::move(*component));
    else if (fresh) reading.components_in_error.insert(name);
}

/// Reads charts and components first, because loops refer to them independently of the order of declaration. Charts
/// with instances of other charts are read later.
void read_parts(ReadState& reading, const tree::File& file) {
    for (const tree::Declaration& declaration : file.declarations) {
        std::visit(overloaded{
                       [](const tree::Include&) {},
                       [](const tree::ClosedLoop&) {},
                       [&](const tree::Chart& chart) {
                           if (!has_instances(chart.items)) read_chart(reading, file, chart);
                       },
                       [&](const tree::Component& component) { read_component(reading, file, component); },
                       [&](const tree::PlcProgram& program) { read_plc_program(reading, file, program); },
                   },
                   declaration);
    }
}

/// Reads the charts that contain instances of other charts.
void read_charts_with_instances(ReadState& reading, const tree::File& file) {
    for (const tree::Declaration& declaration : file.declarations)
        if (const auto* chart = std::get_if<tree::Chart>(&declaration); chart != nullptr && has_instances(chart->items))
            read_chart(reading, file, *chart);
}

/// Adds the component `name` from the component library, if the library defines it and the input does not.
void take_from_library(ReadState& reading, const std::string& name) {
    const LibraryEntry* const entry = library_entry(reading, name);
    if (entry == nullptr || reading.components.contains(name)) return;
    const Id<Source> source = reading.sources.add({std::string(entry->path), std::string(entry->text)});
    const tree::File file = parse_file(source, reading.sources, reading.diagnostics);
    for (const tree::Declaration& declaration : file.declarations) {
        const auto* written = std::get_if<tree::Component>(&declaration);
        if (written == nullptr || file.text(written->name) != name) continue;
        reading.components.emplace(name, written->name.where);
        auto component = resolve_component(file, *written, reading.diagnostics, reading.record, &reading.copied);
        if (component) reading.model.components.add(std::move(*component));
        else reading.components_in_error.insert(name);
    }
}

void take_components(ReadState& reading, const tree::File& file) {
    for (const tree::Declaration& declaration : file.declarations) {
        const auto* loop = std::get_if<tree::ClosedLoop>(&declaration);
        if (loop == nullptr) continue;
        each_item(loop->items, [&](const tree::LoopItem& item) {
            if (const auto* instance = std::get_if<tree::Instance>(&item))
                take_from_library(reading, std::string(file.text(instance->component)));
            if (const auto* fault = std::get_if<tree::Fault>(&item))
                take_from_library(reading, std::string(file.text(fault->behaviour.component)));
        });
    }
}

/// Reports each constant that the user has set (`--set`) and that no loop declares.
void check_settings(ReadState& reading) {
    std::vector<std::string> known;
    for (const ClosedLoop& loop : reading.model.loops)
        for (const NamedConstant& constant : loop.constants) known.push_back(constant.name);
    for (const auto& [name, value] : reading.context.constants)
        if (std::ranges::find(known, name) == known.end())
            reading.diagnostics.add(
                messages::no_such_choice("closed-loop constant", name, known, nearest_of(name, known)));
}

LoopContext loop_context(ReadState& reading) {
    LoopContext context{reading.model, reading.written, reading.components_in_error, {}, reading.context.constants};
    for (const auto& [name, where] : reading.components) context.component_names.push_back(name);
    for (const LibraryEntry& entry : reading.context.library) context.component_names.emplace_back(entry.name);
    std::ranges::sort(context.component_names);
    const auto repeated = std::ranges::unique(context.component_names);
    context.component_names.erase(repeated.begin(), repeated.end());
    return context;
}

void read_loops(ReadState& reading, const tree::File& file, const LoopContext& context) {
    for (const tree::Declaration& declaration : file.declarations) {
        const auto* written = std::get_if<tree::ClosedLoop>(&declaration);
        if (written == nullptr) continue;
        const bool fresh = is_new(reading, reading.loops, "closed loop", file.text(written->name), written->name.where);
        if (!is_resolved(reading, fresh, written->broken)) continue;
        auto loop = resolve_loop(file, *written, context, reading.diagnostics, reading.record, &reading.copied);
        if (loop) reading.model.loops.add(std::move(*loop));
    }
}

/// Adds the declarations of the files to the model. If declarations are `hidden` (omitted because of an error), loops
/// are not added, because they may refer to hidden declarations.
void read_all(ReadState& reading, std::span<const tree::File> files, bool hidden) {
    for (const tree::File& parsed : files)
        for (const tree::Declaration& declaration : parsed.declarations)
            if (const auto* chart = std::get_if<tree::Chart>(&declaration))
                reading.written.charts.try_emplace(std::string(parsed.text(chart->name)), &parsed, chart);
    for (const tree::File& parsed : files) read_parts(reading, parsed);
    for (const tree::File& parsed : files) read_charts_with_instances(reading, parsed);
    for (const tree::File& parsed : files) take_components(reading, parsed);
    const LoopContext loops = loop_context(reading);
    if (!hidden)
        for (const tree::File& parsed : files) read_loops(reading, parsed, loops);
}

/// Records the declarations and references of files that contain errors.
void record_beyond_errors(std::span<const tree::File> files, Sources& sources, const ReadContext& context) {
    *context.references = {};
    Diagnostics ignored;
    ReadState reading{sources, context, ignored, Recorder(context.references, true)};
    read_all(reading, files, false);
    // Removes references to undeclared names: an instance of a chart refers to names of the surrounding chart, and
    // their declarations may have errors.
    std::set<std::pair<std::uint32_t, std::size_t>> declared;
    const auto site = [](Span where) { return std::pair(where.source.index, std::size_t{where.begin}); };
    for (const References::Declaration& each : context.references->declarations) declared.insert(site(each.where));
    std::erase_if(context.references->references,
                  [&](const References::Reference& each) { return !declared.contains(site(each.declaration)); });
}

}  // namespace

std::string path_of_include(const std::string& from, const std::string& written, const ReadContext& context) {
    const std::string candidate = joined(std::filesystem::path(from).parent_path(), written, context);
    if (!context.identity || !context.identity(candidate).empty()) return candidate;
    for (const std::string& folder : context.folders)
        if (const std::string path = joined(folder, written, context); !context.identity(path).empty()) return path;
    return candidate;
}

std::optional<Model> read_text(Id<Source> file, Sources& sources, const ReadContext& context,
                               Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.errors();
    bool files_missing = false;
    const std::vector<tree::File> files = parse_with_includes(file, sources, context, files_missing, diagnostics);
    if (context.stop != nullptr && *context.stop) return {};
    auto model = model_of(files, files_missing, sources, context, diagnostics);
    if (diagnostics.errors() == errors) return model;
    if (context.references != nullptr) record_beyond_errors(files, sources, context);
    return {};
}

std::optional<Model> model_of(std::span<const tree::File> files, bool files_missing, Sources& sources,
                              const ReadContext& context, Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.errors();
    ReadState reading{sources, context, diagnostics, Recorder(context.references)};
    // Declarations that were omitted because of an error may define names to which loops refer.
    const bool hidden = std::ranges::any_of(files, &tree::File::incomplete) || files_missing;
    read_all(reading, files, hidden);
    if (diagnostics.errors() != errors || std::ranges::any_of(files, &tree::File::broken)) return {};
    check_settings(reading);
    if (diagnostics.errors() != errors) return {};
    assert(verify(reading.model).empty());
    return std::move(reading.model);
}

}  // namespace grafverif
