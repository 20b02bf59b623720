// SPDX-License-Identifier: MIT
// Handles requests of the editor about names and positions, such as definition, references and hover.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "lsp/completion.hpp"
#include "lsp/hover.hpp"
#include "lsp/outline.hpp"
#include "lsp/rename.hpp"
#include "lsp/scan.hpp"
#include "lsp/session.hpp"
#include "support/memory_reserve.hpp"
#include "support/overloaded.hpp"
#include "syntax/language/format.hpp"

namespace grafverif::lsp {

namespace {

/// Returns the number of the symbol kind in LSP 3.17 ("SymbolKind").
int symbol_kind(DeclarationKind kind) {
    switch (kind) {
    case DeclarationKind::Chart: return 2;  // kind: module
    case DeclarationKind::Loop:
    case DeclarationKind::Partial: return 3;  // kind: namespace
    case DeclarationKind::Component:
    case DeclarationKind::Unit: return 5;    // kind: class
    case DeclarationKind::Action: return 6;  // kind: method
    case DeclarationKind::Fault:
    case DeclarationKind::Property: return 7;
    case DeclarationKind::DataType: return 10;    // kind: enum
    case DeclarationKind::Observer: return 11;    // kind: interface
    case DeclarationKind::Transition: return 12;  // kind: function
    case DeclarationKind::Input:
    case DeclarationKind::Output:
    case DeclarationKind::Internal:
    case DeclarationKind::InputParameter:
    case DeclarationKind::OutputParameter:
    case DeclarationKind::Own:
    case DeclarationKind::Clock:
    case DeclarationKind::PlantVariable: return 13;  // kind: variable
    case DeclarationKind::Constant: return 14;
    case DeclarationKind::Instance: return 19;  // kind: object
    case DeclarationKind::EnumerationValue:
    case DeclarationKind::Location: return 22;  // kind: enum member
    case DeclarationKind::Step: return 24;      // kind: event
    }
    unreachable();
}

Json markdown(const std::string& text) { return {{"kind", "markdown"}, {"value", text}}; }

}  // namespace

Json Session::feature_capabilities() {
    Json types = Json::array(), modifiers = Json::array();
    for (const std::string_view type : token_types) types.push_back(type);
    for (const std::string_view modifier : token_modifiers) modifiers.push_back(modifier);
    return {{"completionProvider", {{"triggerCharacters", {".", "(", "="}}}},
            {"hoverProvider", true},
            {"definitionProvider", true},
            {"referencesProvider", true},
            {"documentHighlightProvider", true},
            {"renameProvider", {{"prepareProvider", true}}},
            {"documentSymbolProvider", true},
            {"foldingRangeProvider", true},
            {"documentFormattingProvider", true},
            {"codeLensProvider", {{"resolveProvider", false}}},
            {"executeCommandProvider",
             {{"commands", {"grafverif.check", "grafverif.showVerdict", "grafverif.draw", "grafverif.simulate"}}}},
            {"semanticTokensProvider",
             {{"legend", {{"tokenTypes", types}, {"tokenModifiers", modifiers}}}, {"full", true}}}};
}

std::shared_ptr<const Parsed> Session::parsed(const Json& params) {
    const std::string path = document(params);
    const ReserveUse use(false);
    auto file = workspace_.parsed(path);
    if (file == nullptr) throw RequestError{request_failed, "the document does not exist"};
    return file;
}

/// Returns the names of a file, of all files that include it, and of the files that these files include. The result is
/// valid until the text of one of these files changes, or until this function is called for another file.
const Names& Session::names(const std::string& path) {
    settle();
    const ReserveUse use(false);
    std::vector<std::shared_ptr<const Root>> roots;
    for (const std::string& each : workspace_.roots(path)) {
        std::shared_ptr<const Root> root = board_.root(each);
        for (const auto& known : named_)
            if (root == nullptr && known->path == each) root = known;
        const bool current = root != nullptr && workspace_.holds(root->inputs);
        roots.push_back(current ? std::move(root) : board_.read(each, workspace_));
    }
    if (names_ == nullptr || roots != named_) names_ = names_of(workspace_, roots);
    named_ = std::move(roots);
    return *names_;
}

Session::Pointed Session::pointed(const Json& params) {
    const auto file = parsed(params);
    const Names& all = names(file->path);
    const std::size_t offset = file->text->offset(position_of(params.at("position")));
    if (const Use* const use = all.use_at(*file, offset)) return {file, &all, use->element, use->where};
    for (const Word& word :
         words_of(file->text->bytes(), file->language))  // also finds names in text that the parser has skipped
        if (word.begin <= offset && offset <= word.end &&
            (word.kind == Word::Kind::Name || word.kind == Word::Kind::Number)) {
            const std::string name = file->text->bytes().substr(word.begin, word.end - word.begin);
            return {file, &all, all.meaning(*file, offset, name), {file->tree.source, word.begin, word.end}};
        }
    return {file, &all, nullptr, {}};
}

Json Session::place_json(const Parsed& file, Span where) const {
    return json_of(Place{file.path, file.text->range(where.begin, where.end)}, uris());
}

Json Session::hover(const Json& params) {
    const Pointed at = pointed(params);
    const Declaration* const element = at.element;
    if (element == nullptr) return nullptr;
    const Model* model = nullptr;
    for (const std::string& path : workspace_.roots(at.file->path))
        if (const auto root = board_.root(path); root != nullptr && root->reading.model) model = &*root->reading.model;
    return {{"contents", markdown(hover_text(*at.names, *element, model) + verdict_text(*element))},
            {"range", json_of(at.file->text->range(at.where.begin, at.where.end))}};
}

Json Session::definition(const Json& params) {
    const Pointed at = pointed(params);
    const Declaration* const element = at.element;
    // An editor cannot open library files, because they are not on the disk.
    if (element == nullptr || element->file->path.starts_with('<')) return nullptr;
    return place_json(*element->file, element->where);
}

Json Session::references(const Json& params) {
    const Pointed at = pointed(params);
    const bool declarations = flag(params, {"context", "includeDeclaration"});
    Json found = Json::array();
    if (at.element == nullptr) return found;
    for (const FileUse& each : at.names->everywhere(*at.element))
        if ((declarations || !each.use.declares) && !each.file->path.starts_with('<'))
            found.push_back(place_json(*each.file, each.use.where));
    return found;
}

Json Session::highlights(const Json& params) {
    const Pointed at = pointed(params);
    Json found = Json::array();
    if (at.element == nullptr) return found;
    for (const FileUse& each : at.names->everywhere(*at.element))
        if (each.file == at.file.get())
            found.push_back({{"range", json_of(at.file->text->range(each.use.where.begin, each.use.where.end))},
                             {"kind", each.use.writes || each.use.declares ? 3 : 2}});
    return found;
}

Json Session::prepare_rename(const Json& params) {
    const Pointed at = pointed(params);
    const Declaration* const element = at.element;
    if (element == nullptr) return nullptr;
    const Span name = last_name(at.where, element->name);
    return {{"range", json_of(at.file->text->range(name.begin, name.end))}, {"placeholder", element->name}};
}

Json Session::rename(const Json& params) {
    const auto name = params.at("newName").get<std::string>();
    const Pointed at = pointed(params);
    if (at.element == nullptr) throw RequestError{request_failed, "there is no name at this position"};
    const Declaration* element = at.element;
    if (element->file->is_renamable) {
        const auto file = workspace_.parsed(element->file->path);
        const std::uint32_t begin = element->where.begin;
        // The names are determined again for the file that contains the declaration, because the result includes the
        // names of all files that include this file.
        const Use* const declared = names(file->path).use_at(*file, begin);
        element = declared == nullptr ? nullptr : declared->element;
    }
    if (element == nullptr) throw RequestError{request_failed, "there is no name at this position"};
    if (workspace_.cut_short())
        throw RequestError{request_failed, "the workspace is too large to find all references; open a smaller folder"};
    if (!std::ranges::all_of(named_, [this](const auto& root) { return workspace_.holds(root->inputs); }))
        throw RequestError{request_failed, "a file that may contain the name is unreadable or has changed; try again"};
    Renaming renaming = renamed(workspace_, named_, *names_, *element, name);
    if (!renaming.obstacle.empty()) throw RequestError{request_failed, renaming.obstacle};
    return json_of(renaming.edits, uris());
}

Json Session::symbols(const Json& params) {
    const auto file = parsed(params);
    const std::vector<Entry> entries = outline(names(file->path), *file);
    std::vector<Json> symbols;
    for (const Entry& entry : entries)
        symbols.push_back(
            {{"name", entry.element->name.empty() ? "?" : entry.element->name},
             {"detail", declaration_text(*entry.element).substr(0, 100)},
             {"kind", symbol_kind(entry.element->kind)},
             {"range", json_of(file->text->range(entry.element->whole.begin, entry.element->whole.end))},
             {"selectionRange", json_of(file->text->range(entry.element->where.begin, entry.element->where.end))}});
    Json top = Json::array();
    for (std::size_t k = entries.size(); k-- > 0;) {
        Json& symbol = symbols[k];
        if (symbol.contains("children")) std::ranges::reverse(symbol["children"]);
        if (entries[k].parent) symbols[*entries[k].parent]["children"].push_back(std::move(symbol));
        else top.push_back(std::move(symbol));
    }
    std::ranges::reverse(top);
    return top;
}

Json Session::folding(const Json& params) {
    const auto file = parsed(params);
    Json found = Json::array();
    for (const Fold& fold : folds(names(file->path), *file)) {
        found.push_back({{"startLine", fold.first}, {"endLine", fold.last}});
        if (fold.comment) found.back()["kind"] = "comment";
    }
    return found;
}

Json Session::semantic_tokens(const Json& params) {
    const auto file = parsed(params);
    return {{"data", tokens(names(file->path), *file)}};
}

Json Session::completion(const Json& params) {
    const auto file = parsed(params);
    const std::size_t cursor = file->text->offset(position_of(params.at("position")));
    Json items = Json::array();
    for (const Proposal& proposal : proposals(names(file->path), *file, cursor)) {
        Json item = {{"label", proposal.label}, {"kind", static_cast<int>(proposal.kind)}};
        if (!proposal.detail.empty()) item["detail"] = proposal.detail;
        if (!proposal.documentation.empty())
            item["documentation"] = {{"kind", "plaintext"}, {"value", proposal.documentation}};
        if (!proposal.snippet.empty() && can_.takes_snippets)
            item["insertText"] = proposal.snippet, item["insertTextFormat"] = 2;
        items.push_back(std::move(item));
    }
    return {{"isIncomplete", false}, {"items", std::move(items)}};
}

/// Returns a list with an edit that replaces the text by its canonical form, as `fmt` writes it. The list is empty if
/// the text is in canonical form. Returns null if the text has syntax errors or no declarations.
Json Session::formatting(const Json& params) {
    const auto file = parsed(params);
    if (file->broken || file->tree.declarations.empty()) return nullptr;
    const std::string text = formatted(file->tree);
    if (text == file->text->bytes()) return Json::array();
    return Json::array({{{"range", json_of(file->text->range(0, file->text->bytes().size()))}, {"newText", text}}});
}

}  // namespace grafverif::lsp
