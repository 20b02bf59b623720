// SPDX-License-Identifier: MIT
#include "lsp/names.hpp"

#include <algorithm>
#include <utility>

#include "lsp/library.hpp"
#include "lsp/walk.hpp"
#include "support/overloaded.hpp"

namespace grafverif::lsp {

namespace {

bool is_shared(DeclarationKind kind) { return kind == DeclarationKind::Input || kind == DeclarationKind::Output; }

}  // namespace

Names::Names(Files files) : files_(std::move(files)) {
    for (const auto& file : files_) declare_all(*file, *this);
    take_library();
    for (const auto& file : files_) declare_plant(*file, *this);
    for (const auto& file : files_) uses_[file.get()] = uses_in(*file, *this);
}

void Names::take_library() {
    std::set<std::string> wanted;
    for (const auto& [instance, component] : components_)
        if (!elements_.contains(component)) wanted.insert(component.substr(component.find(' ') + 1));
    for (const std::string& name : wanted) {
        const auto file = library_file(name);
        if (file == nullptr) continue;
        files_.push_back(file);
        declare_all(*file, *this);
    }
}

const std::vector<Use>& Names::uses(const Parsed& file) const {
    static const std::vector<Use> none;
    const auto found = uses_.find(&file);
    return found == uses_.end() ? none : found->second;
}

const Use* Names::use_at(const Parsed& file, std::size_t offset) const {
    const std::vector<Use>& all = uses(file);
    auto after = std::ranges::upper_bound(all, offset, {}, [](const Use& use) { return use.where.begin; });
    while (after != all.begin()) {
        const Use& use = *--after;
        if (use.where.end >= offset) return &use;
        if (use.where.end + 256 < offset) break;
    }
    return nullptr;
}

const Declaration* Names::element(const std::string& key) const {
    const auto found = elements_.find(key);
    return found == elements_.end() ? nullptr : &found->second;
}

std::vector<const Declaration*> Names::parts(const std::string& owner) const {
    std::vector<const Declaration*> found;
    const std::string prefix = owner + "/";
    for (auto part = elements_.lower_bound(prefix); part != elements_.end() && part->first.starts_with(prefix); ++part)
        found.push_back(&part->second);
    return found;
}

std::vector<const Declaration*> Names::all(DeclarationKind kind) const {
    std::vector<const Declaration*> found;
    for (const auto& [key, element] : elements_)
        if (element.kind == kind) found.push_back(&element);
    return found;
}

const Declaration* Names::around(const Parsed& file, std::size_t offset) const {
    const Declaration* best = nullptr;
    for (const auto& [key, element] : elements_) {
        const bool holds = element.file == &file && element.owner.empty() && element.whole.begin <= offset &&
                           offset <= element.whole.end;
        if (holds && (best == nullptr || best->whole.begin < element.whole.begin)) best = &element;
    }
    return best;
}

std::vector<std::string> Names::controllers(const std::string& loop) const {
    const auto found = controllers_.find(loop);
    return found == controllers_.end() ? std::vector<std::string>() : found->second;
}

std::string Names::component_of(const std::string& instance) const {
    const auto found = components_.find(instance);
    return found == components_.end() ? std::string() : found->second;
}

/// Returns `key`, and the inputs and outputs that are shared with this element, directly or through several loops.
std::set<std::string> Names::tied(const std::string& key) const {
    std::set<std::string> found = {key};
    const Declaration* const first = element(key);
    if (first == nullptr || !is_shared(first->kind)) return found;
    std::vector<std::string> waiting = {first->owner};
    while (!waiting.empty()) {
        const std::string chart = std::move(waiting.back());
        waiting.pop_back();
        for (const auto& [loop, charts] : controllers_) {
            if (std::ranges::find(charts, chart) == charts.end()) continue;
            for (const std::string& other : charts) {
                const Declaration* const same = element(other + "/v " + first->name);
                if (same != nullptr && is_shared(same->kind) && found.insert(same->key).second)
                    waiting.push_back(other);
            }
        }
    }
    return found;
}

std::vector<FileUse> Names::everywhere(const std::string& key) const {
    const std::set<std::string> keys = tied(key);
    std::vector<FileUse> found;
    for (const auto& file : files_)
        for (const Use& use : uses(*file))
            if (keys.contains(use.key)) found.push_back({file.get(), use});
    return found;
}

std::string Names::meaning(const Parsed& file, std::size_t offset, std::string_view name) const {
    const Declaration* const owner = around(file, offset);
    if (owner == nullptr) return {};
    std::string key = term_key(*this, *owner, "", name);
    if (key.empty() && owner->kind == DeclarationKind::Chart)
        key = term_key(*this, *owner, "", "X" + std::string(name));
    if (key.empty() && owner->kind == DeclarationKind::Component) key = owner->key + "/l " + std::string(name);
    if (key.empty() && owner->kind == DeclarationKind::Loop)
        for (const char* kind : {"chart ", "component "})
            if (elements_.contains(kind + std::string(name))) key = kind + std::string(name);
    return elements_.contains(key) ? key : std::string();
}

// -- text about an element --------------------------------------------------------------------------------------------

namespace {

std::string without_marks(std::string_view comment) {
    std::string text;
    if (comment.starts_with("//")) {
        comment.remove_prefix(2);
        if (comment.starts_with(' ')) comment.remove_prefix(1);
        return std::string(comment);
    }
    comment.remove_prefix(std::min<std::size_t>(2, comment.size()));
    if (comment.ends_with("*/")) comment.remove_suffix(2);
    return std::string(comment);
}

std::size_t line_of(const Parsed& file, std::size_t offset) { return file.text->position(offset).line; }

}  // namespace

std::string comment_of(const Parsed& file, Span whole) {
    std::size_t line = line_of(file, whole.begin);
    std::vector<std::string> lines;
    for (auto comment = file.tree.comments.rbegin(); comment != file.tree.comments.rend(); ++comment) {
        if (comment->where.begin >= whole.begin || !comment->own_line) continue;
        if (line_of(file, comment->where.end) + 1 != line) break;
        line = line_of(file, comment->where.begin);
        if (!comment->text.starts_with("// SPDX-")) lines.push_back(without_marks(comment->text));
    }
    std::string text;
    for (auto each = lines.rbegin(); each != lines.rend(); ++each) text += *each + "\n";
    for (const tree::Comment& comment : file.tree.comments)
        if (!comment.own_line && comment.where.begin >= whole.end &&
            line_of(file, comment.where.begin) == line_of(file, whole.end))
            text += without_marks(comment.text) + "\n";
    while (text.ends_with('\n')) text.pop_back();
    return text;
}

std::string parameter_comment(const Parsed& file, Span component, std::string_view parameter) {
    const std::string comment = comment_of(file, component);
    for (std::size_t at = 0; at < comment.size();) {
        const std::size_t end = std::min(comment.find('\n', at), comment.size());
        std::string_view line = std::string_view(comment).substr(at, end - at);
        at = end + 1;
        line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
        if (!line.starts_with(parameter) || !line.substr(parameter.size()).starts_with("  ")) continue;
        line.remove_prefix(parameter.size());
        for (const std::string_view kind : {"", "input", "output", "constant"}) {
            line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
            if (!kind.empty() && line.starts_with(kind) && line.substr(kind.size()).starts_with(' '))
                line.remove_prefix(kind.size());
        }
        return std::string(line);
    }
    return {};
}

std::string declaration_text(const Declaration& element) {
    const auto joined = [&](Span where) {
        std::string text;
        for (const char byte : element.file->bytes(where)) {
            const bool blank = byte == ' ' || byte == '\n' || byte == '\r' || byte == '\t';
            if (!blank) text += byte;
            else if (!text.ends_with(' ')) text += ' ';
        }
        return text;
    };
    const auto head = [&] {  // text of the declaration, up to its body
        std::string text = joined(element.whole);
        text.resize(std::min(text.find('{'), text.size()));
        while (text.ends_with(' ') || text.ends_with(';')) text.pop_back();
        return text;
    };
    switch (element.kind) {
    case DeclarationKind::Chart:
    case DeclarationKind::Component:
    case DeclarationKind::Loop:
    case DeclarationKind::Partial:
    case DeclarationKind::Step:
    case DeclarationKind::Observer: return head();
    case DeclarationKind::Input: return "input " + joined(element.whole);
    case DeclarationKind::Output: return "output " + joined(element.whole);
    case DeclarationKind::Internal: return "internal " + joined(element.whole);
    case DeclarationKind::InputParameter: return "input " + joined(element.whole);
    case DeclarationKind::OutputParameter: return "output " + joined(element.whole);
    case DeclarationKind::Constant:
        return (element.owner.starts_with("loop ") ? "constant " : "") + joined(element.whole);
    case DeclarationKind::Own: return "variable " + joined(element.whole);
    case DeclarationKind::Clock: return "clock " + element.name;
    case DeclarationKind::PlantVariable: return element.name + ", of the plant: " + joined(element.whole);
    case DeclarationKind::Transition:
    case DeclarationKind::Location:
    case DeclarationKind::Instance:
    case DeclarationKind::Fault:
    case DeclarationKind::Property: return joined(element.whole);
    }
    unreachable();
}

}  // namespace grafverif::lsp
