// SPDX-License-Identifier: MIT
// Names: resolves every name in some files, from their syntax trees alone, so that incomplete texts have names too.
//
// An element is identified by its key: `chart press/v START`. Inputs and outputs of the controllers of a loop that have
// one name count as one element in searches for references, since the loop shares them by name.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lsp/workspace.hpp"

namespace grafverif::lsp {

enum class DeclarationKind {
    Chart,
    Component,
    Loop,
    Partial,
    Input,
    Output,
    Internal,
    Step,
    Transition,
    InputParameter,
    OutputParameter,
    Constant,
    Own,
    Clock,
    Location,
    Instance,
    PlantVariable,
    Property,
    Observer,
};

/// An element that a file declares.
struct Declaration {
    DeclarationKind kind = DeclarationKind::Chart;
    std::string name = {}, key = {};
    std::string owner = {};  ///< the key of the element that contains it; empty: the file
    const Parsed* file = nullptr;
    Span where = {};  ///< its name
    Span whole = {};  ///< its declaration
};

/// A use of a name.
struct Use {
    std::string key = {};
    Span where = {};
    std::uint32_t skipped = 0;  ///< bytes at its beginning before the name: the `X` of `X2`
    bool declares = false, writes = false;
};

struct FileUse {
    const Parsed* file = nullptr;
    Use use = {};
};

class Names {
public:
    explicit Names(Files files);

    const Files& files() const { return files_; }
    /// All names of a file, in order; none for a path that is not among the files.
    const std::vector<Use>& uses(const Parsed& file) const;
    const Use* use_at(const Parsed& file, std::size_t offset) const;
    const Declaration* thing(const std::string& key) const;
    /// The element that `name` would denote as a term, or as a step, at `offset`; empty if none.
    std::string meaning(const Parsed& file, std::size_t offset, std::string_view name) const;
    /// The elements of a chart, component or loop, or all elements of that kind in the files.
    std::vector<const Declaration*> parts(const std::string& owner) const;
    std::vector<const Declaration*> all(DeclarationKind kind) const;
    /// The chart, component or loop whose declaration contains `offset`; null if none.
    const Declaration* around(const Parsed& file, std::size_t offset) const;
    /// The charts that a loop controls.
    std::vector<std::string> controllers(const std::string& loop) const;
    /// The component of an instance; empty: unknown.
    std::string component_of(const std::string& instance) const;

    /// Every use of the element `key`, including declarations, file by file.
    std::vector<FileUse> everywhere(const std::string& key) const;

private:
    friend class Declarer;
    friend class Finder;

    std::set<std::string> tied(const std::string& key) const;
    void take_library();

    Files files_;
    std::map<std::string, Declaration> elements_ = {};
    std::map<std::string, std::vector<std::string>> controllers_ = {};  ///< charts by loop, as keys
    std::map<std::string, std::string> components_ = {};                ///< by instance, as keys
    std::map<std::string, std::vector<std::string>> steps_ = {};  ///< keys by `chart C/NAME`, for any partial chart
    std::map<const Parsed*, std::vector<Use>> uses_ = {};
};

/// The text of the comment above a declaration, or at the end of its line.
std::string comment_of(const Parsed& file, Span whole);
/// The line of a component's comment that describes a parameter: `order: rod in`.
std::string parameter_comment(const Parsed& file, Span component, std::string_view parameter);
/// The declaration of an element, in one line.
std::string declaration_text(const Declaration& thing);

}  // namespace grafverif::lsp
