// SPDX-License-Identifier: MIT
// Names: resolves every name in a set of files. It uses only the syntax trees, so that names in incomplete texts are
// also resolved.
//
// A key such as `chart press/v START` identifies an element. Inputs and outputs of the controllers of a loop that have
// the same name are treated as one element in searches for references, because the loop shares them by name.
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
    Fault,
};

/// An element that a file declares.
struct Declaration {
    DeclarationKind kind = DeclarationKind::Chart;
    std::string name = {}, key = {};
    std::string owner = {};  ///< key of the element that contains it; empty for an element of the file
    const Parsed* file = nullptr;
    Span where = {};  ///< position of its name
    Span whole = {};  ///< position of its declaration
};

/// A use of a name.
struct Use {
    std::string key = {};
    Span where = {};
    std::uint32_t skipped = 0;  ///< number of bytes before the name, such as 1 for the `X` of `X2`
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
    /// Returns all uses of names in a file, sorted by position; empty if `files()` does not contain the file.
    const std::vector<Use>& uses(const Parsed& file) const;
    const Use* use_at(const Parsed& file, std::size_t offset) const;
    const Declaration* element(const std::string& key) const;
    /// Returns the key of the element that `name` would denote at `offset`, as a term or as a step. Returns an empty
    /// string if there is no such element.
    std::string meaning(const Parsed& file, std::size_t offset, std::string_view name) const;
    /// Return the elements of a chart, component or loop (`parts`), or all elements of one kind in the files (`all`).
    std::vector<const Declaration*> parts(const std::string& owner) const;
    std::vector<const Declaration*> all(DeclarationKind kind) const;
    /// Returns the chart, component or loop whose declaration contains `offset`, or null if there is none.
    const Declaration* around(const Parsed& file, std::size_t offset) const;
    /// Returns the charts that a loop controls.
    std::vector<std::string> controllers(const std::string& loop) const;
    /// Returns the component of an instance, or an empty string if it is unknown.
    std::string component_of(const std::string& instance) const;

    /// Returns every use of the element `key`, including declarations, file by file.
    std::vector<FileUse> everywhere(const std::string& key) const;

private:
    friend class Declarer;
    friend class Finder;

    std::set<std::string> tied(const std::string& key) const;
    void take_library();

    Files files_;
    std::map<std::string, Declaration> elements_ = {};
    std::map<std::string, std::vector<std::string>> controllers_ = {};  ///< charts of each loop, as keys
    std::map<std::string, std::string> components_ = {};                ///< component of each instance, as keys
    /// Keys of the steps of all partial charts, by chart and name: `chart C/NAME`.
    std::map<std::string, std::vector<std::string>> steps_ = {};
    std::map<const Parsed*, std::vector<Use>> uses_ = {};
};

/// Returns the text of the comment above a declaration, or at the end of its line.
std::string comment_of(const Parsed& file, Span whole);
/// Returns the line of a component's comment that describes a parameter: `order: rod in`.
std::string parameter_comment(const Parsed& file, Span component, std::string_view parameter);
/// Returns the declaration of an element in one line.
std::string declaration_text(const Declaration& element);

}  // namespace grafverif::lsp
