// SPDX-License-Identifier: MIT
// Names: the declarations in a set of files, and all occurrences of their names, as name resolution records them. For
// an incomplete text, Names contains only the names that the parser and name resolution reach.
//
// Declarations that must have the same name are one element in searches for references. Examples are the inputs of the
// controllers of a loop, which the loop shares by name.
#pragma once

#include <cstddef>
#include <deque>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lsp/workspace.hpp"
#include "syntax/resolve/references.hpp"

namespace grafverif::lsp {

/// An element that a file declares. The position of its name identifies the element.
struct Declaration {
    DeclarationKind kind = DeclarationKind::Chart;
    std::string name = {};
    /// The element that contains this element; null for a top-level element of the file.
    const Declaration* owner = nullptr;
    const Parsed* file = nullptr;
    Span where = {};        ///< position of the name of the element
    Span whole = {};        ///< position of the complete declaration
    std::size_t order = 0;  ///< number of elements that were recorded before this element
    std::string text = {};  ///< the declaration in one line; if empty, the source text is used
};

/// An occurrence of a name.
struct Use {
    const Declaration* element = nullptr;
    Span where = {};  ///< position of the occurrence; includes the `X` of a step variable `X2`
    bool declares = false, writes = false;

    /// Returns the position without the `X` of a step variable.
    Span name() const { return last_name(where, element->name); }
};

struct FileUse {
    const Parsed* file = nullptr;
    Use use = {};
};

/// The recorded names of a text with its includes.
struct Recording {
    const References* references = nullptr;
    std::vector<std::shared_ptr<const Parsed>> files = {};  ///< the file of each source; may be null
};

class Names {
public:
    using Kinds = std::initializer_list<DeclarationKind>;

    /// If several recordings contain the same file, the declarations of this file are the same elements in all
    /// recordings. If a name denotes several elements, `use_at` returns the element of the last recording.
    explicit Names(const std::vector<Recording>& recordings);
    Names(const Names&) = delete;
    Names& operator=(const Names&) = delete;

    /// Returns all files of the recordings, each once.
    const Files& files() const { return files_; }
    /// Returns all uses of names in a file, sorted by position; empty if `files()` does not contain the file.
    const std::vector<Use>& uses(const Parsed& file) const;
    const Use* use_at(const Parsed& file, std::size_t offset) const;
    /// Returns the element of the file `file` that `name` would denote at `offset`, as a term or as a step, or null if
    /// there is no such element. The result is only a guess, for text that the parser has skipped.
    const Declaration* meaning(const Parsed& file, std::size_t offset, std::string_view name) const;
    /// Returns the chart, component or loop with this name, or null if there is no such element.
    const Declaration* find(DeclarationKind kind, std::string_view name) const;
    /// Returns the element `name` of `owner` or of a partial chart of `owner`, or null if there is no such element.
    /// `owner` may be null. If `permitted` is not empty, only elements whose kind it contains are considered.
    const Declaration* part(const Declaration* owner, std::string_view name, Kinds permitted = {}) const;
    /// `parts` returns the elements of `owner`, or the elements of all files if `owner` is null. `all` returns the
    /// charts, components or loops. The results of `parts` and `all` are sorted by name.
    const std::vector<const Declaration*>& parts(const Declaration* owner) const;
    std::vector<const Declaration*> all(DeclarationKind kind) const;
    /// Returns the chart, component or loop whose declaration contains `offset`, or null if there is no such element.
    const Declaration* around(const Parsed& file, std::size_t offset) const;
    /// Returns the elements of kind `kind` to which a declaration refers, such as the charts of a loop or the component
    /// of an instance.
    std::vector<const Declaration*> referred(const Declaration* element, DeclarationKind kind) const;

    /// Returns the representative of all elements that must have the same name as `element`; null if `element` is null.
    const Declaration* shared(const Declaration* element) const;
    /// Returns every use of the elements that must have the same name as `element`, including declarations. The uses
    /// are ordered by file, and each position occurs once.
    std::vector<FileUse> everywhere(const Declaration& element) const;

private:
    using Site = std::pair<const Parsed*, std::uint32_t>;  ///< file and offset of a declared name

    const Declaration* declared(const Recording& recording, Span where) const;
    void take(const Recording& recording);
    void take_uses(const Recording& recording);

    Files files_ = {};
    std::deque<Declaration> elements_ = {};
    std::map<Site, Declaration*> sites_ = {};
    std::map<const Declaration*, std::vector<const Declaration*>> parts_ = {};  ///< elements by owner, sorted by name

    /// Union-find forest of the elements that must have a common name.
    std::map<const Declaration*, const Declaration*> shared_ = {};
    std::map<const Parsed*, std::vector<Use>> uses_ = {};
};

/// Returns true if two names are equal in the language of a file: names in Structured Text are not case-sensitive.
bool same_name(const Parsed& file, std::string_view a, std::string_view b);
/// Returns the text of the comment above a declaration or at the end of the line of the declaration.
std::string comment_of(const Parsed& file, Span whole);
/// Returns the line of a component's comment that describes the parameter `parameter`, such as `order: rod in`.
std::string parameter_comment(const Parsed& file, Span component, std::string_view parameter);
/// Returns the declaration of an element in one line.
std::string declaration_text(const Declaration& element);

}  // namespace grafverif::lsp
