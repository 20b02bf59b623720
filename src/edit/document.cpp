// SPDX-License-Identifier: MIT
#include "edit/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "edit/layout.hpp"
#include "grafverif/ir/drawing.hpp"
#include "lsp/rename.hpp"
#include "lsp/scan.hpp"
#include "pipeline/chart_text.hpp"
#include "rpc/uri.hpp"

namespace grafverif::edit {

namespace {

const lsp::LspDiagnostic* first_error(const lsp::Root& root) {
    const auto found = std::ranges::find(root.typed, Severity::Error, &lsp::LspDiagnostic::severity);
    return found == root.typed.end() ? nullptr : &*found;
}

bool has_errors(const lsp::Root& root) { return !root.reading.model || root.reading.diagnostics.has_errors(); }

}  // namespace

Document::Document(std::string path, std::vector<std::string> include_folders, std::string text)
    : path_(std::move(path)),
      uri_(rpc::uri_of_path(path_)),
      include_folders_(std::move(include_folders)),
      history_(std::move(text)) {
    reading();
}

lsp::Workspace Document::workspace_for(const std::string& text) const {
    lsp::Workspace workspace(include_folders_);
    workspace.open(uri_, 0, text);
    return workspace;
}

const lsp::Root& Document::reading() {
    if (current_ != nullptr) return *current_;
    lsp::Workspace workspace = workspace_for(text());
    current_ = lsp::DiagnosticStore().read(rpc::path_of_uri(uri_), workspace);
    parsed_ = workspace.parsed(rpc::path_of_uri(uri_));
    if (!has_errors(*current_)) drawn_ = current_, drawn_parsed_ = parsed_;
    return *current_;
}

std::shared_ptr<const lsp::Root> Document::drawn() { return reading(), drawn_; }

Change Document::perform(const Operation& operation, bool trial) {
    if (has_errors(reading())) {
        const lsp::LspDiagnostic* const error = first_error(*current_);
        if (error == nullptr) return {"the text cannot be read", {}, {}};
        return {fmt::format("correct the errors in the text first (line {}: {})", error->where.range.start.line + 1,
                            error->message),
                {},
                {}};
    }
    const Elements elements(parsed_->tree);
    if (operation.kind != OperationKind::Rename) {
        Plan plan = plan_of(text(), parsed_->tree, elements, operation);
        if (operation.kind == OperationKind::Delete && plan.obstacle.empty()) plan.obstacle = remaining_use(plan.edits);
        return accept(std::move(plan), trial);
    }
    const Element* const element = elements.at(operation.at);
    if (element == nullptr || element->action != nullptr || element->assignment != nullptr)
        return {"only steps and transitions can be renamed", {}, {}};
    return rename(*element, operation.text, trial);
}

/// Returns the reason why edits that delete a declaration are rejected: a use of its name remains, which would be an
/// error or denote another element. The text is empty if no such use remains.
std::string Document::remaining_use(const std::vector<TextEdit>& edits) const {
    lsp::Workspace workspace = workspace_for(text());
    const std::string path = rpc::path_of_uri(uri_);
    const auto names = lsp::names_of(workspace, {lsp::DiagnosticStore().read(path, workspace)});
    const auto file = workspace.parsed(path);
    const auto is_deleted = [&](const lsp::Parsed* in, Span where) {
        return in == file.get() && std::ranges::any_of(edits, [&](const TextEdit& edit) {
                   return edit.begin <= where.begin && where.end <= edit.end;
               });
    };
    for (const auto& each : names->files())
        for (const lsp::Use& use : names->uses(*each))
            if (is_deleted(use.element->file, use.element->where) && !is_deleted(each.get(), use.name()))
                return fmt::format("`{}` is also used in {} {}; change this line first", use.element->name,
                                   each == file ? "line" : each->path + ", line",
                                   each->text->position(use.where.begin).line + 1);
    return {};
}

Change Document::rename(const Element& element, const std::string& name, bool trial) {
    const bool unnamed = element.is_transition() && !element.transition->name.valid();
    if (!lsp::is_name(name, true)) return {fmt::format("`{}` is not a valid name here", name), {}, {}};
    if (unnamed) return accept({{naming(*element.transition, name)}, {}, element.where.begin}, trial);
    lsp::Workspace workspace = workspace_for(text());
    const std::string path = rpc::path_of_uri(uri_);
    workspace.add_folder(std::filesystem::path(path).parent_path());
    std::vector<std::shared_ptr<const lsp::Root>> roots;
    for (const std::string& each : workspace.roots(path)) roots.push_back(lsp::DiagnosticStore().read(each, workspace));
    if (workspace.cut_short())
        return {"the folder of the file has too many files to find all uses of the name", {}, {}};
    const auto names = lsp::names_of(workspace, roots);
    const auto file = workspace.parsed(path);
    const Span where = element.is_step() ? element.step->name.where : element.transition->name.where;
    const lsp::Use* const use = names->use_at(*file, where.begin);
    if (use == nullptr) return {"the declaration of the element was not found", {}, {}};
    const lsp::Renaming renaming = lsp::renamed(workspace, roots, *names, *use->element, name);
    if (!renaming.obstacle.empty()) return {renaming.obstacle, {}, {}};
    Plan plan{.selected = element.where.begin};
    for (const lsp::Edit& edit : renaming.edits) {
        if (edit.where.path != file->path)
            return {fmt::format("`{}` is also used in `{}`, which `edit` does not write", use->element->name,
                                edit.where.path),
                    {},
                    {}};
        plan.edits.push_back(
            {file->text->offset(edit.where.range.start), file->text->offset(edit.where.range.end), edit.replacement});
    }
    sort(plan.edits);
    for (const TextEdit& edit : plan.edits)
        if (edit.end <= element.where.begin)
            *plan.selected += static_cast<std::uint32_t>(edit.replacement.size()) - (edit.end - edit.begin);
    return accept(std::move(plan), trial);
}

/// Applies the edits of a plan if the resulting text has no errors. If `trial` is true, only checks this condition.
Change Document::accept(Plan plan, bool trial) {
    if (!plan.obstacle.empty()) return {std::move(plan.obstacle), {}, {}};
    const std::string after = applied(text(), plan.edits);
    if (after == text()) return {"the text would not change", {}, {}};
    lsp::Workspace workspace = workspace_for(after);
    auto root = lsp::DiagnosticStore().read(rpc::path_of_uri(uri_), workspace);
    if (has_errors(*root)) {
        const lsp::LspDiagnostic* const error = first_error(*root);
        return {"the change would make the text invalid: " + (error != nullptr ? error->message : "it cannot be read"),
                root->reading.diagnostics_text(),
                {}};
    }
    if (trial) return {{}, {}, plan.selected};
    history_.apply(plan.edits);
    current_ = drawn_ = std::move(root);
    parsed_ = drawn_parsed_ = workspace.parsed(rpc::path_of_uri(uri_));
    return {{}, {}, plan.selected};
}

Copy Document::copied(const std::vector<std::uint32_t>& at) {
    if (has_errors(reading())) return {"correct the errors in the text first", {}};
    return edit::copied(text(), parsed_->tree, Elements(parsed_->tree), at);
}

std::vector<lsp::Proposal> Document::proposals(const std::string& text, std::size_t cursor) const {
    lsp::Workspace workspace = workspace_for(text);
    const std::string path = rpc::path_of_uri(uri_);
    const auto names = lsp::names_of(workspace, {lsp::DiagnosticStore().read(path, workspace)});
    return lsp::proposals(*names, *workspace.parsed(path), cursor);
}

void Document::type(std::string_view text) {
    if (text == this->text()) return;
    history_.apply({difference(this->text(), text)}, true);
    current_ = nullptr;
}

void Document::replace(std::string_view text) {
    if (text == this->text()) return;
    history_.apply({difference(this->text(), text)});
    current_ = nullptr;
}

std::optional<std::uint32_t> Document::undo() {
    if (!history_.can_undo()) return {};
    current_ = nullptr;
    return history_.undo();
}

std::optional<std::uint32_t> Document::redo() {
    if (!history_.can_redo()) return {};
    current_ = nullptr;
    return history_.redo();
}

Drawing Document::drawing(Id<Chart> chart, const std::string& prefix) {
    const ParseResult& reading = drawn()->reading;
    return drawing_of(*reading.model, chart, {.prefix = prefix}, reading.sources, drawn_parsed_->tree, Id<Source>{0});
}

std::vector<DrawnElement> Document::elements(Id<Chart> id, const std::string& prefix) {
    std::vector<DrawnElement> list;
    if (drawn() == nullptr) return list;
    const Chart& chart = drawn_->reading.model->charts[id];
    const ElementIds ids = element_ids(chart, prefix);
    const Elements declared(drawn_parsed_->tree);
    const Layout layout(drawn_parsed_->text->bytes(), drawn_parsed_->tree);
    const auto add = [&](Span origin, DrawnElement drawn) {
        // Source 0 is the file itself; all other sources are included files and the component library.
        const bool here = origin.source.valid() && origin.source.index == 0;
        const Element* const element = here ? declared.at(origin.begin) : nullptr;
        if (element == nullptr) return;
        drawn.where = drawn.part = element->where;
        if (drawn.kind == "step") drawn.part = element->step->name.where;
        if (drawn.kind == "transition" && element->transition->condition.valid())
            drawn.part = layout.condition(*element->transition);
        if (drawn.kind != "step") drawn.text = drawn_parsed_->bytes(drawn.part);
        list.push_back(std::move(drawn));
    };
    for (const auto step : chart.steps.ids())
        add(chart.steps[step].origin, {.id = ids.steps[step.index], .kind = "step", .name = chart.steps[step].name});
    for (const auto transition : chart.transitions.ids())
        add(chart.transitions[transition].origin, {.id = ids.transitions[transition.index],
                                                   .condition = ids.conditions[transition.index],
                                                   .kind = "transition",
                                                   .name = chart.transitions[transition].name});
    for (const auto action : chart.continuous.ids())
        add(chart.continuous[action].origin, {.id = ids.continuous[action.index], .kind = "action"});
    for (const auto action : chart.stored.ids())
        add(chart.stored[action].origin, {.id = ids.stored[action.index], .kind = "action"});
    for (const auto order : chart.forcing.ids())
        add(chart.forcing[order].origin, {.id = ids.forcing[order.index], .kind = "action"});
    return list;
}

}  // namespace grafverif::edit
