// SPDX-License-Identifier: MIT
#include "lsp/outline.hpp"

#include <algorithm>

#include "lsp/scan.hpp"
#include "support/overloaded.hpp"

namespace grafverif::lsp {

namespace {

std::vector<const Declaration*> elements_in(const Names& names, const Parsed& file) {
    std::vector<const Declaration*> found;
    for (const Use& use : names.uses(file))
        if (use.declares) found.push_back(use.element);
    std::ranges::stable_sort(found, {}, [](const Declaration* element) { return element->whole.begin; });
    return found;
}

/// Types of semantic tokens, as indices into token_types.
enum TokenType : std::uint32_t {
    Keyword,
    Comment,
    String,
    Number,
    Variable,
    Parameter,
    Class,
    Namespace,
    Function,
    Event,
    EnumMember,
    PropertyToken
};

TokenType type_of(DeclarationKind kind) {
    switch (kind) {
    case DeclarationKind::Chart:
    case DeclarationKind::Loop:
    case DeclarationKind::Partial: return Namespace;
    case DeclarationKind::Component:
    case DeclarationKind::Unit:
    case DeclarationKind::DataType: return Class;
    case DeclarationKind::Input:
    case DeclarationKind::Output:
    case DeclarationKind::Internal:
    case DeclarationKind::Own:
    case DeclarationKind::Clock:
    case DeclarationKind::PlantVariable:
    case DeclarationKind::Instance: return Variable;
    case DeclarationKind::Step: return Event;
    case DeclarationKind::Transition:
    case DeclarationKind::Action: return Function;
    case DeclarationKind::InputParameter:
    case DeclarationKind::OutputParameter:
    case DeclarationKind::Constant: return Parameter;
    case DeclarationKind::Location:
    case DeclarationKind::EnumerationValue: return EnumMember;
    case DeclarationKind::Property:
    case DeclarationKind::Fault:
    case DeclarationKind::Observer: return PropertyToken;
    }
    unreachable();
}

bool is_read_only(DeclarationKind kind) {
    return kind == DeclarationKind::Input || kind == DeclarationKind::InputParameter ||
           kind == DeclarationKind::Constant || kind == DeclarationKind::Step ||
           kind == DeclarationKind::EnumerationValue;
}

}  // namespace

std::vector<Entry> outline(const Names& names, const Parsed& file) {
    std::vector<Entry> entries;
    std::vector<std::size_t> open;
    for (const Declaration* const element : elements_in(names, file)) {
        while (!open.empty() && entries[open.back()].element->whole.end < element->whole.end) open.pop_back();
        if (element->kind == DeclarationKind::PlantVariable) continue;
        entries.push_back({element, open.empty() ? std::nullopt : std::optional(open.back())});
        open.push_back(entries.size() - 1);
    }
    return entries;
}

std::vector<Fold> folds(const Names& names, const Parsed& file) {
    std::vector<Fold> found;
    const auto line = [&](std::size_t offset) { return file.text->position(offset).line; };
    for (const Declaration* const element : elements_in(names, file)) {
        const Fold fold{line(element->whole.begin), line(element->whole.end)};
        if (fold.first < fold.last) found.push_back(fold);
    }
    for (const tree::Comment& comment : file.tree.comments) {
        const Fold fold{line(comment.where.begin), line(comment.where.end), true};
        const bool continues =
            comment.own_line && !found.empty() && found.back().comment && found.back().last + 1 == fold.first;
        if (continues) found.back().last = fold.last;
        else if (comment.own_line) found.push_back(fold);
    }
    std::erase_if(found, [](const Fold& fold) { return fold.first == fold.last; });
    return found;
}

std::vector<std::uint32_t> tokens(const Names& names, const Parsed& file) {
    std::vector<std::uint32_t> numbers;
    Position before;
    const std::string& text = file.text->bytes();
    const std::vector<Use>& uses = names.uses(file);
    auto use = uses.begin();
    const auto put = [&](std::size_t begin, std::size_t end, TokenType type, std::uint32_t modifiers) {
        while (begin < end) {  // divides a token at line ends, because a semantic token must not span several lines
            const std::size_t stop = std::min(std::string_view(text).substr(0, end).find('\n', begin), end);
            const Position from = file.text->position(begin), to = file.text->position(stop);
            if (from.line == to.line && from.character < to.character) {
                const bool same = from.line == before.line;
                for (const std::uint32_t number :
                     {from.line - before.line, same ? from.character - before.character : from.character,
                      to.character - from.character, static_cast<std::uint32_t>(type), modifiers})
                    numbers.push_back(number);
                before = from;
            }
            begin = stop + 1;
        }
    };
    for (const Word& word : words_of(text, file.language)) {
        while (use != uses.end() && use->where.end <= word.begin) ++use;
        const bool named = use != uses.end() && use->where.begin <= word.begin && word.end <= use->where.end;
        if (named && (word.kind == Word::Kind::Name || word.kind == Word::Kind::Number)) {
            const DeclarationKind kind = use->element->kind;
            put(word.begin, word.end, type_of(kind),
                (use->declares ? 1U : 0U) | (is_read_only(kind) ? 2U : 0U) | (use->writes ? 4U : 0U));
            continue;
        }
        switch (word.kind) {
        case Word::Kind::Name:
            if (is_keyword(std::string_view(text).substr(word.begin, word.end - word.begin), file.language))
                put(word.begin, word.end, Keyword, 0);
            break;
        case Word::Kind::Number: put(word.begin, word.end, Number, 0); break;
        case Word::Kind::String: put(word.begin, word.end, String, 0); break;
        case Word::Kind::Comment: put(word.begin, word.end, Comment, 0); break;
        case Word::Kind::Sign: break;
        }
    }
    return numbers;
}

}  // namespace grafverif::lsp
