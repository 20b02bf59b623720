// SPDX-License-Identifier: MIT
#include "lsp/program_completion.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "lsp/scan.hpp"

namespace grafverif::lsp {

namespace {

constexpr std::array<std::string_view, 11> elementary_types = {"BOOL", "BYTE",  "DINT", "DWORD", "INT", "SINT",
                                                               "TIME", "UDINT", "UINT", "USINT", "WORD"};
constexpr std::array<std::string_view, 10> standard_functions = {"ABS", "LIMIT", "MAX", "MIN", "MOVE",
                                                                 "ROL", "ROR",   "SEL", "SHL", "SHR"};

class ProgramProposer {
public:
    ProgramProposer(const Names& names, const Parsed& file, std::size_t cursor)
        : names_(names), file_(file), unit_(unit_at(cursor)), elements_(names.parts(nullptr)) {
        // Elements of closed loops and other programs are removed, because a program cannot use them.
        std::erase_if(elements_, [&](const Declaration* element) {
            const bool standard = element->file->path.starts_with('<');
            return element->file->language != TextLanguage::StructuredText || (element->file != &file && !standard);
        });
        const std::string_view text = std::string_view(file.text->bytes()).substr(0, cursor);
        for (const Word& word : words_of(text, file.language)) {
            const std::string_view bytes = text.substr(word.begin, word.end - word.begin);
            if (word.kind == Word::Kind::Comment || word.kind == Word::Kind::String)
                in_text_ = word.end == cursor && !is_closed(word.kind, bytes);
            // The word at the cursor is incomplete and is omitted.
            else if (word.kind == Word::Kind::Name && word.end == cursor) break;
            else words_.push_back(bytes), in_text_ = false;
        }
    }

    std::vector<Proposal> all() {
        if (in_text_) return {};
        if (last() == ".") members();
        else if ((last() == ":" || (same_name(file_, last(), "OF") && last(1) == "]")) && in_declaration()) types();
        else {
            parameters();
            terms();
        }
        return std::move(found_);
    }

private:
    static bool is_closed(Word::Kind kind, std::string_view bytes) {
        if (kind == Word::Kind::String) return bytes.size() > 1 && bytes.back() == bytes.front();
        return bytes.ends_with("*)") || bytes.ends_with("*/") || bytes.ends_with("}");
    }

    std::string_view last(std::size_t back = 0) const {
        return back < words_.size() ? words_[words_.size() - 1 - back] : std::string_view();
    }

    const Declaration* unit_at(std::size_t cursor) const {
        const Declaration* const found = names_.around(file_, cursor);
        return found != nullptr && found->kind == DeclarationKind::Unit ? found : nullptr;
    }

    void add(Proposal proposal) {
        if (seen_.insert(proposal.label).second) found_.push_back(std::move(proposal));
    }
    void add(std::string_view word, ProposalKind kind) { add({std::string(word), kind, "", "", ""}); }
    void add(const Declaration& element, const std::string& snippet = "") {
        add({element.name, kind_of(element.kind), declaration_text(element), comment_of(*element.file, element.whole),
             snippet});
    }

    /// Returns the element `name` of `owner`; null if there is no such element.
    const Declaration* part(const Declaration* owner, std::string_view name) const {
        return owner == nullptr ? nullptr : named(names_.parts(owner), name);
    }
    const Declaration* named(const std::vector<const Declaration*>& elements, std::string_view name) const {
        for (const Declaration* const element : elements)
            if (same_name(file_, element->name, name)) return element;
        return nullptr;
    }

    /// Returns the unit or data type of a variable; null if the type is elementary.
    const Declaration* type_of(const Declaration* variable) const {
        for (const DeclarationKind kind : {DeclarationKind::Unit, DeclarationKind::DataType}) {
            const auto types = names_.referred(variable, kind);
            if (!types.empty()) return types.back();
        }
        return nullptr;
    }

    /// Returns the element that the path before word number `end` denotes, such as `Line.Motor`; null if the path is
    /// unknown.
    const Declaration* owner_before(std::size_t end) const {
        std::size_t begin = end;
        // An index is skipped, because it does not change the type of the elements.
        while (begin > 0 && words_[begin - 1] == "]") {
            while (begin > 0 && words_[begin - 1] != "[") --begin;
            if (begin > 0) --begin;
        }
        if (begin == 0) return nullptr;
        const std::string_view name = words_[begin - 1];
        if (begin > 2 && words_[begin - 2] == ".") {
            const Declaration* const owner = owner_before(begin - 2);
            return owner == nullptr ? nullptr : part(type_of(owner), name);
        }
        const Declaration* const own = unit_ == nullptr ? nullptr : part(unit_, name);
        return own != nullptr ? own : named(elements_, name);
    }

    static bool is_visible(const Declaration& element) {
        return element.kind == DeclarationKind::Input || element.kind == DeclarationKind::Output ||
               element.kind == DeclarationKind::Action;
    }

    void members() {
        const Declaration* const owner = owner_before(words_.size() - 1);
        if (owner == nullptr) return;
        if (owner->kind == DeclarationKind::Step) {
            add("X", ProposalKind::Field);
            add("T", ProposalKind::Field);
            return;
        }
        const Declaration* const type = type_of(owner);
        if (type == nullptr) return;
        for (const Declaration* const element : names_.parts(type))
            if (type->kind == DeclarationKind::DataType || is_visible(*element)) add(*element);
    }

    /// True if the `:` before the cursor belongs to a declaration, and not to a label of CASE or to a step.
    bool in_declaration() const {
        for (std::size_t k = words_.size(); k-- > 0;) {
            std::string word(words_[k]);
            for (char& letter : word) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
            if (word == "END_VAR" || word == "END_TYPE" || word == "STEP" || word == "INITIAL_STEP" || word == "ACTION")
                return false;
            if (word.starts_with("VAR") || word == "TYPE" || word == "FUNCTION" || word == "STRUCT") return true;
        }
        return false;
    }

    void types() {
        for (const std::string_view type : elementary_types) add(type, ProposalKind::Keyword);
        for (const Declaration* const element : elements_) {
            const bool block =
                element->kind == DeclarationKind::Unit && declaration_text(*element).starts_with("FUNCTION_BLOCK");
            if (block || element->kind == DeclarationKind::DataType) add(*element);
        }
        add("ARRAY", ProposalKind::Keyword);
    }

    /// Proposes the parameters of the call that contains the cursor.
    void parameters() {
        if (last() != "(" && last() != ",") return;
        std::size_t closed = 0;
        for (std::size_t k = words_.size(); k-- > 0;) {
            if (words_[k] == ";") return;
            if (words_[k] == ")") ++closed;
            if (words_[k] != "(" || closed-- != 0) continue;
            const Declaration* const callee = owner_before(k);
            if (callee == nullptr) return;
            const Declaration* const unit = callee->kind == DeclarationKind::Unit ? callee : type_of(callee);
            for (const Declaration* const element : unit == nullptr ? none_ : names_.parts(unit)) {
                if (element->kind == DeclarationKind::Input) add(*element, element->name + " := $1");
                if (element->kind == DeclarationKind::Output) add(*element, element->name + " => $1");
            }
            return;
        }
    }

    void terms() {
        for (const Declaration* const element : unit_ == nullptr ? none_ : names_.parts(unit_)) add(*element);
        for (const Declaration* const element : elements_) {
            if (element->kind == DeclarationKind::DataType)
                for (const Declaration* const value : names_.parts(element))
                    if (value->kind == DeclarationKind::EnumerationValue) add(*value);
            const bool function =
                element->kind == DeclarationKind::Unit && declaration_text(*element).starts_with("FUNCTION ");
            if (function || (element->kind != DeclarationKind::Unit && element->kind != DeclarationKind::DataType))
                add(*element);
        }
        for (const std::string_view function : standard_functions) add(function, ProposalKind::Function);
        for (const std::string_view keyword : structured_text_keywords()) add(keyword, ProposalKind::Keyword);
    }

    const Names& names_;
    const Parsed& file_;
    const Declaration* unit_;                   ///< the unit that contains the cursor; may be null
    std::vector<const Declaration*> elements_;  ///< declarations of the file and of the standard function blocks
    std::vector<std::string_view> words_ = {};
    bool in_text_ = false;
    const std::vector<const Declaration*> none_ = {};
    std::vector<Proposal> found_ = {};
    std::set<std::string> seen_ = {};
};

}  // namespace

std::vector<Proposal> program_proposals(const Names& names, const Parsed& file, std::size_t cursor) {
    return ProgramProposer(names, file, cursor).all();
}

}  // namespace grafverif::lsp
