// SPDX-License-Identifier: MIT
// Names: what every name in some files stands for, read from their trees alone, so that half a text has names too.
//
// A thing is known by its key: `chart press/v START`. Inputs and outputs of the controllers of a loop that have one name
// are one thing to who asks for references: the loop shares them by their name.
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

enum class Kind {
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

/// A thing that a file declares.
struct Thing {
    Kind kind = Kind::Chart;
    std::string name = {}, key = {};
    std::string owner = {};  ///< the key of what it is part of; empty: of a file
    const Parsed* file = nullptr;
    Span where = {};  ///< its name
    Span whole = {};  ///< its declaration
};

/// A name where it stands.
struct Use {
    std::string key = {};
    Span where = {};
    std::uint32_t skipped = 0;  ///< bytes at its beginning that are no part of the name: the `X` of `X2`
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
    /// All names of a file, in order; a path that is not among the files has none.
    const std::vector<Use>& uses(const Parsed& file) const;
    const Use* use_at(const Parsed& file, std::size_t offset) const;
    const Thing* thing(const std::string& key) const;
    /// What `name` would stand for as a term, or as a step, in what stands at `offset`; empty: nothing.
    std::string meaning(const Parsed& file, std::size_t offset, std::string_view name) const;
    /// The things of a chart, component or loop, or all of that kind that stand in a file.
    std::vector<const Thing*> parts(const std::string& owner) const;
    std::vector<const Thing*> all(Kind kind) const;
    /// The chart, component or loop whose declaration holds `offset`; null: none.
    const Thing* around(const Parsed& file, std::size_t offset) const;
    /// The charts that a loop controls.
    std::vector<std::string> controllers(const std::string& loop) const;
    /// The component of an instance; empty: unknown.
    std::string component_of(const std::string& instance) const;

    /// Every use of what is meant by `key`, declarations included, file by file.
    std::vector<FileUse> everywhere(const std::string& key) const;

private:
    friend class Declarer;
    friend class Finder;

    std::set<std::string> tied(const std::string& key) const;
    void take_library();

    Files files_;
    std::map<std::string, Thing> things_ = {};
    std::map<std::string, std::vector<std::string>> controllers_ = {};  ///< charts by loop, as keys
    std::map<std::string, std::string> components_ = {};                ///< by instance, as keys
    std::map<std::string, std::vector<std::string>> steps_ = {};  ///< keys by `chart C/NAME`, whatever partial chart
    std::map<const Parsed*, std::vector<Use>> uses_ = {};
};

/// What the comment says that stands above a declaration, or behind it on its line; without its marks.
std::string comment_of(const Parsed& file, Span whole);
/// The line of a component's comment that is about a parameter: `order: rod in`.
std::string parameter_comment(const Parsed& file, Span component, std::string_view parameter);
/// How a thing is declared, in one line.
std::string declaration_text(const Thing& thing);

}  // namespace grafverif::lsp
