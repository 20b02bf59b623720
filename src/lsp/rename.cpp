// SPDX-License-Identifier: MIT
#include "lsp/rename.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "lsp/library.hpp"
#include "lsp/scan.hpp"
#include "syntax/language/parse.hpp"

namespace grafverif::lsp {

namespace {

bool is_of_library(const Parsed& file) { return file.path.starts_with("<library>"); }

/// Returns the reason why an element cannot have any other name. Returns an empty string if it can be renamed.
std::string obstacle_of(const Names& names, const Declaration& element) {
    if (is_of_library(*element.file))
        return fmt::format("`{}` belongs to the component library and cannot be renamed", element.name);
    for (const auto& file : names.files()) {
        if (file->broken)
            return fmt::format("`{}` has syntax errors, so some names may not be found; correct them first",
                               file->path);
        for (const tree::Declaration& declaration : file->tree.declarations) {
            const auto* loop = std::get_if<tree::ClosedLoop>(&declaration);
            for (const tree::LoopItem& item : loop != nullptr ? loop->items : std::vector<tree::LoopItem>()) {
                const auto* property = std::get_if<tree::Property>(&item);
                if (property == nullptr) continue;
                for (const Word& word : words_of(property->raw))
                    if (std::string_view(property->raw)
                            .substr(word.begin, word.end - word.begin)
                            .ends_with(element.name) &&
                        word.kind != Word::Kind::Sign)
                        return fmt::format("the formula of property `{}` may contain `{}`; change both manually",
                                           file->tree.text(property->name), element.name);
            }
        }
    }
    return {};
}

/// Returns a number for each name in all files: names have equal numbers if they denote the same element. Texts that
/// differ only in the names of elements have equal results.
std::vector<std::size_t> shape_of(const Names& names) {
    std::vector<std::size_t> shape;
    std::map<std::string, std::size_t> numbers;
    for (const auto& file : names.files()) {
        shape.push_back(names.uses(*file).size());
        for (const Use& use : names.uses(*file))
            shape.push_back(numbers.emplace(use.key, numbers.size()).first->second);
    }
    return shape;
}

std::shared_ptr<const Parsed> with_edits(const Parsed& file, std::vector<std::pair<Span, std::string>> edits) {
    std::ranges::sort(edits, std::greater{}, [](const auto& edit) { return edit.first.begin; });
    std::string text = file.text->bytes();
    for (const auto& [where, replacement] : edits) text.replace(where.begin, where.end - where.begin, replacement);
    auto parsed = std::make_shared<Parsed>();
    parsed->path = file.path;
    parsed->text = std::make_shared<const Text>(std::move(text));
    Sources sources;
    Diagnostics diagnostics;
    parsed->tree = parse_file(sources.add({file.path, parsed->text->bytes()}), sources, diagnostics);
    parsed->broken = parsed->tree.broken;
    return parsed;
}

}  // namespace

Renaming renamed(const Names& names, const std::string& key, const std::string& name) {
    const Declaration* const element = names.element(key);
    if (element == nullptr) return {{}, "there is no name here"};
    const bool numbers = element->kind == DeclarationKind::Step || element->kind == DeclarationKind::Location ||
                         element->kind == DeclarationKind::Transition;
    if (!is_name(name, numbers)) return {{}, fmt::format("`{}` is not a valid name here", name)};
    if (std::string obstacle = obstacle_of(names, *element); !obstacle.empty()) return {{}, std::move(obstacle)};
    Renaming result;
    std::map<const Parsed*, std::vector<std::pair<Span, std::string>>> edits;
    for (const FileUse& each : names.everywhere(key)) {
        if (is_of_library(*each.file)) return {{}, fmt::format("`{}` is used in the component library", element->name)};
        const Span where = {each.use.where.source, each.use.where.begin + each.use.skipped, each.use.where.end};
        edits[each.file].emplace_back(where, name);
        result.edits.push_back({{each.file->path, each.file->text->range(where.begin, where.end)}, name});
    }
    Files files;
    for (const auto& file : names.files()) {
        if (is_of_library(*file)) continue;  // the files of the component library are added again when they are used
        const auto changed = edits.find(file.get());
        files.push_back(changed == edits.end() ? file : with_edits(*file, changed->second));
    }
    if (shape_of(Names(std::move(files))) != shape_of(names))
        return {{},
                fmt::format("`{}` is already declared in the scope of `{}`; choose another name", name, element->name)};
    return result;
}

}  // namespace grafverif::lsp
