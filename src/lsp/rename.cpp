// SPDX-License-Identifier: MIT
#include "lsp/rename.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "lsp/library.hpp"
#include "lsp/scan.hpp"

namespace grafverif::lsp {

namespace {

/// True if `word` is a valid name in Structured Text, or a keyword.
bool is_structured_text_name(std::string_view word) {
    const auto in_name = [](char letter) {
        return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_';
    };
    return !word.empty() && word.size() <= 200 && std::isdigit(static_cast<unsigned char>(word.front())) == 0 &&
           std::ranges::all_of(word, in_name);
}

bool is_of_library(const Parsed& file) { return file.path.starts_with("<library>"); }

/// True if the text of `file` contains the name of `element` at a position for which name resolution has recorded no
/// meaning.
bool has_unknown_meaning(const Names& names, const Parsed& file, const Declaration& element) {
    const std::string_view text = file.text->bytes();
    const std::string step = element.kind == DeclarationKind::Step ? 'X' + element.name : "";
    return std::ranges::any_of(words_of(text, file.language), [&](const Word& word) {
        const std::string_view name = text.substr(word.begin, word.end - word.begin);
        return word.kind == Word::Kind::Name && (same_name(file, name, element.name) || name == step) &&
               names.use_at(file, word.begin) == nullptr;
    });
}

/// Returns the reason why an element cannot be renamed to any name, or an empty string if the element can be renamed.
/// `errors` is true if a text has errors, so that name resolution may not have found the meaning of some names.
std::string obstacle_of(const Names& names, const Declaration& element, bool errors) {
    if (is_of_library(*element.file))
        return fmt::format("`{}` belongs to the library and cannot be renamed", element.name);
    for (const auto& file : names.files()) {
        if (file->broken)
            return fmt::format("`{}` has syntax errors, so some names may not be found; correct the errors first",
                               file->path);
        if (errors && file->is_renamable && has_unknown_meaning(names, *file, element))
            return fmt::format(
                "`{}` contains an occurrence of `{}` whose meaning is unknown because of errors; correct the errors "
                "first",
                file->path, element.name);
        for (const tree::Declaration& declaration : file->tree.declarations) {
            const auto* loop = std::get_if<tree::ClosedLoop>(&declaration);
            std::string obstacle;
            each_item(loop != nullptr ? loop->items : std::vector<tree::LoopItem>(), [&](const tree::LoopItem& item) {
                const auto* property = std::get_if<tree::Property>(&item);
                if (property == nullptr) return;
                for (const Word& word : words_of(property->raw))
                    if (std::string_view(property->raw).substr(word.begin, word.end - word.begin).find(element.name) !=
                            std::string_view::npos &&
                        word.kind != Word::Kind::Sign)
                        obstacle = fmt::format(
                            "the formula of property `{}` may contain `{}`; rename the element manually, also "
                            "in the formula",
                            file->tree.text(property->name), element.name);
            });
            if (!obstacle.empty()) return obstacle;
        }
    }
    return {};
}

/// Returns two numbers for each occurrence of a name in all files. The first numbers of two occurrences are equal if
/// they denote the same element. The second numbers are equal if the denoted elements must have the same name. Texts
/// that differ only in the names of elements have equal results.
std::vector<std::size_t> shape_of(const Names& names, const std::vector<std::shared_ptr<const Root>>& roots) {
    std::vector<std::size_t> shape;
    std::map<const Declaration*, std::size_t> numbers;
    for (const auto& root : roots) shape.push_back(root->reading.diagnostics.errors());
    for (const auto& file : names.files()) {
        shape.push_back(names.uses(*file).size());
        for (const Use& use : names.uses(*file))
            for (const Declaration* const element : {use.element, names.shared(use.element)})
                shape.push_back(numbers.emplace(element, numbers.size()).first->second);
    }
    return shape;
}

std::string with_edits(std::string text, std::vector<Span> places, const std::string& replacement) {
    std::ranges::sort(places, std::greater{}, &Span::begin);
    for (const Span& where : places) text.replace(where.begin, where.end - where.begin, replacement);
    return text;
}

}  // namespace

std::unique_ptr<const Names> names_of(Workspace& workspace, const std::vector<std::shared_ptr<const Root>>& roots) {
    std::map<std::string, std::shared_ptr<const Parsed>> files;
    std::vector<Recording> recordings;
    for (const auto& root : roots) {
        Recording& recording = recordings.emplace_back();
        recording.references = &root->references;
        for (const Source& source : root->reading.sources) {
            auto& file = files[workspace.key(source.name)];
            if (file == nullptr)
                file = source.name.starts_with('<') ? library_file(source.name) : workspace.parsed(source.name);
            recording.files.push_back(file);
        }
    }
    // The recordings of texts without errors are last, because `use_at` prefers the last recording. For example, a file
    // with a closed loop may not include the charts of its controllers; then only a file that includes both the loop
    // and the charts has no errors.
    std::vector<Recording> ordered;
    for (const bool erroneous : {true, false})
        for (std::size_t k = 0; k < roots.size(); ++k)
            if (roots[k]->reading.diagnostics.has_errors() == erroneous) ordered.push_back(recordings[k]);
    return std::make_unique<const Names>(ordered);
}

Renaming renamed(const Workspace& workspace, const std::vector<std::shared_ptr<const Root>>& roots, const Names& names,
                 const Declaration& element, const std::string& name) {
    const bool numbers = element.kind == DeclarationKind::Step || element.kind == DeclarationKind::Location ||
                         element.kind == DeclarationKind::Transition;
    const bool structured_text = element.file->language == TextLanguage::StructuredText;
    if (structured_text ? !is_structured_text_name(name) : !is_name(name, numbers))
        return {{}, fmt::format("`{}` is not a valid name here", name)};
    const bool errors =
        std::ranges::any_of(roots, [](const auto& root) { return root->reading.diagnostics.has_errors(); });
    if (std::string obstacle = obstacle_of(names, element, errors); !obstacle.empty()) return {{}, std::move(obstacle)};
    Renaming result;
    std::map<const Parsed*, std::vector<Span>> edits;
    for (const FileUse& each : names.everywhere(element)) {
        if (is_of_library(*each.file))
            return {{}, fmt::format("`{}` is used in the library and cannot be renamed", element.name)};
        if (!each.file->is_renamable)
            return {{},
                    fmt::format("`{}` occurs in `{}`, which is neither a `.grafcet` file nor Structured Text and "
                                "cannot be edited by this command; rename the element manually in all files",
                                element.name, each.file->path)};
        const Span where = each.use.name();
        edits[each.file].push_back(where);
        result.edits.push_back({{each.file->path, each.file->text->range(where.begin, where.end)}, name});
    }
    Workspace changed = workspace;
    for (const auto& [file, places] : edits)
        changed.open(workspace.uri_of(file->path), 0, with_edits(file->text->bytes(), places, name));
    std::vector<std::shared_ptr<const Root>> after;
    for (const auto& root : roots) after.push_back(DiagnosticStore().read(root->path, changed));
    if (shape_of(*names_of(changed, after), after) != shape_of(names, roots))
        return {
            {},
            fmt::format("`{}` has another meaning in the scope of `{}`, or is not allowed there; choose another name",
                        name, element.name)};
    return result;
}

}  // namespace grafverif::lsp
