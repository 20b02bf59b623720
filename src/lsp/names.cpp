// SPDX-License-Identifier: MIT
#include "lsp/names.hpp"

#include <algorithm>
#include <cctype>
#include <tuple>

#include "support/overloaded.hpp"

namespace grafverif::lsp {

Names::Names(const std::vector<Recording>& recordings) {
    for (const Recording& recording : recordings) take(recording);
    for (const Recording& recording : recordings) take_uses(recording);
    for (auto& [file, uses] : uses_) {
        const auto place = [](const Use& use) {
            return std::tuple(use.where.begin, use.where.end, use.element->order);
        };
        std::ranges::stable_sort(uses, {}, place);
        std::vector<Use> each;
        for (const Use& use : uses) {
            if (each.empty() || place(each.back()) != place(use)) each.push_back(use);
            each.back().declares |= use.declares;
            each.back().writes |= use.writes;
        }
        uses = std::move(each);
    }
    for (const Declaration& element : elements_) parts_[element.owner].push_back(&element);
    for (auto& [owner, parts] : parts_) std::ranges::stable_sort(parts, {}, &Declaration::name);
}

namespace {

/// Returns the file of a position, or null if the position belongs to no file of the recording.
const Parsed* file_of(const Recording& recording, Span where) {
    return where.source.index < recording.files.size() ? recording.files[where.source.index].get() : nullptr;
}

}  // namespace

/// Returns the element whose name is declared at `where`, or null if no element is recorded there.
const Declaration* Names::declared(const Recording& recording, Span where) const {
    const auto found = sites_.find({file_of(recording, where), where.begin});
    return found == sites_.end() ? nullptr : found->second;
}

void Names::take(const Recording& recording) {
    for (const auto& file : recording.files)
        if (file != nullptr && uses_.try_emplace(file.get()).second) files_.push_back(file);
    for (const References::Declaration& each : recording.references->declarations) {
        const Parsed* const file = file_of(recording, each.where);
        if (file == nullptr) continue;
        const auto [known, fresh] = sites_.try_emplace({file, each.where.begin});
        if (fresh)
            known->second =
                &elements_.emplace_back(Declaration{each.kind, each.name, declared(recording, each.owner), file,
                                                    each.where, each.whole, elements_.size(), each.text});
        else if (known->second->text.empty()) known->second->text = each.text;
        uses_[file].push_back({known->second, each.where, true, false});
    }
    for (const auto& [one, other] : recording.references->shared) {
        const Declaration* const first = shared(declared(recording, one));
        const Declaration* const second = shared(declared(recording, other));
        if (first != second && first != nullptr && second != nullptr) shared_[first] = second;
    }
}

void Names::take_uses(const Recording& recording) {
    for (const References::Reference& each : recording.references->references) {
        const Declaration* const element = declared(recording, each.declaration);
        const Parsed* const file = file_of(recording, each.where);
        if (element != nullptr && file != nullptr) uses_[file].push_back({element, each.where, false, each.writes});
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

const Declaration* Names::find(DeclarationKind kind, std::string_view name) const {
    for (const Declaration* const element : parts(nullptr))
        if (element->kind == kind && element->name == name) return element;
    return nullptr;
}

const Declaration* Names::part(const Declaration* owner, std::string_view name, Kinds permitted) const {
    if (owner == nullptr) return nullptr;
    for (const Declaration* const element : parts(owner))
        if (element->name == name &&
            (permitted.size() == 0 || std::ranges::find(permitted, element->kind) != permitted.end()))
            return element;
    for (const Declaration* const element : parts(owner))
        if (element->kind == DeclarationKind::Partial)
            if (const Declaration* const inner = part(element, name, permitted); inner != nullptr) return inner;
    return nullptr;
}

const std::vector<const Declaration*>& Names::parts(const Declaration* owner) const {
    static const std::vector<const Declaration*> none;
    const auto found = parts_.find(owner);
    return found == parts_.end() ? none : found->second;
}

std::vector<const Declaration*> Names::all(DeclarationKind kind) const {
    std::vector<const Declaration*> found = parts(nullptr);
    std::erase_if(found, [&](const Declaration* element) { return element->kind != kind; });
    return found;
}

const Declaration* Names::around(const Parsed& file, std::size_t offset) const {
    const Declaration* best = nullptr;
    for (const Declaration* const element : parts(nullptr)) {
        const bool holds = element->file == &file && element->whole.begin <= offset && offset <= element->whole.end;
        if (holds && (best == nullptr || best->whole.begin < element->whole.begin)) best = element;
    }
    return best;
}

std::vector<const Declaration*> Names::referred(const Declaration* element, DeclarationKind kind) const {
    std::vector<const Declaration*> found;
    if (element == nullptr) return found;
    const std::vector<Use>& all = uses(*element->file);
    auto use =
        std::ranges::lower_bound(all, element->whole.begin, {}, [](const Use& each) { return each.where.begin; });
    for (; use != all.end() && use->where.begin < element->whole.end; ++use)
        if (use->element->kind == kind && !use->declares && std::ranges::find(found, use->element) == found.end())
            found.push_back(use->element);
    return found;
}

const Declaration* Names::shared(const Declaration* element) const {
    for (auto next = shared_.find(element); next != shared_.end(); next = shared_.find(element)) element = next->second;
    return element;
}

std::vector<FileUse> Names::everywhere(const Declaration& element) const {
    const Declaration* const wanted = shared(&element);
    std::vector<FileUse> found;
    for (const auto& file : files_)
        for (const Use& use : uses(*file))
            if (shared(use.element) == wanted &&
                (found.empty() || found.back().file != file.get() || found.back().use.where.begin != use.where.begin))
                found.push_back({file.get(), use});
    return found;
}

const Declaration* Names::meaning(const Parsed& file, std::size_t offset, std::string_view name) const {
    const Declaration* const owner = around(file, offset);
    if (file.language == TextLanguage::StructuredText) {
        for (const Declaration* const scope : {owner, static_cast<const Declaration*>(nullptr)})
            for (const Declaration* const element : parts(scope))
                if (same_name(file, element->name, name)) return element;
        return nullptr;
    }
    std::vector<const Declaration*> scopes = referred(owner, DeclarationKind::Chart);
    scopes.insert(scopes.begin(), owner);
    for (const Declaration* const scope : scopes)
        if (const Declaration* const found = part(scope, name); found != nullptr) return found;
    for (const Declaration* const scope : scopes)
        if (const Declaration* const step =
                name.starts_with('X') ? part(scope, name.substr(1), {DeclarationKind::Step}) : nullptr;
            step != nullptr)
            return step;
    if (owner == nullptr || owner->kind != DeclarationKind::Loop) return nullptr;
    const Declaration* const chart = find(DeclarationKind::Chart, name);
    return chart != nullptr ? chart : find(DeclarationKind::Component, name);
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
    if (comment.ends_with("*/") || comment.ends_with("*)")) comment.remove_suffix(2);
    return std::string(comment);
}

std::size_t line_of(const Parsed& file, std::size_t offset) { return file.text->position(offset).line; }

}  // namespace

bool same_name(const Parsed& file, std::string_view a, std::string_view b) {
    if (file.language != TextLanguage::StructuredText) return a == b;
    const auto capital = [](unsigned char letter) { return std::toupper(letter); };
    return std::ranges::equal(a, b, {}, capital, capital);
}

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
    if (!element.text.empty()) return element.text;
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
        return (element.owner != nullptr && element.owner->kind == DeclarationKind::Loop ? "constant " : "") +
               joined(element.whole);
    case DeclarationKind::Own: return "variable " + joined(element.whole);
    case DeclarationKind::Clock: return "clock " + element.name;
    case DeclarationKind::PlantVariable: return element.name + ", a variable of the plant: " + joined(element.whole);
    case DeclarationKind::Transition:
    case DeclarationKind::Location:
    case DeclarationKind::Instance:
    case DeclarationKind::Fault:
    case DeclarationKind::Property:
    case DeclarationKind::Unit:
    case DeclarationKind::Action:
    case DeclarationKind::DataType:
    case DeclarationKind::EnumerationValue: return joined(element.whole);
    }
    unreachable();
}

}  // namespace grafverif::lsp
