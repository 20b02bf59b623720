// SPDX-License-Identifier: MIT
// What the parts of the NuSMV emitter share: the names of all entities, and lines of a readable length.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/transition_system.hpp"
#include "grafverif/syntax/dialect.hpp"
#include "grafverif/syntax/legal_names.hpp"

namespace grafverif::nusmv {

struct Names {
    std::vector<std::string> modules = {};
    std::vector<std::vector<std::string>> symbols = {};   ///< per module; a member's is `instance.symbol`
    std::vector<std::string> instances = {};
    std::vector<std::string> properties = {};
    /// What had to change, per scope in which it did.
    struct Changed {
        std::string scope = {};
        std::vector<Renaming> renamings = {};
    };
    std::vector<Changed> changed = {};
};

Names names_of(const TransitionSystem& system);

/// Writes the leaves of terms of `module`.
LeafPrinter leaf_printer(const Names& names, Id<TransitionSystem::Module> module);

/// `text` as a comment of lines of at most 100 columns.
void print_comment(std::ostream& out, std::string_view text);

/// `model` with each line beyond 118 columns that is no comment broken between tokens.
void print_wrapped(std::ostream& out, std::string_view model);

/// The specifications of main, in the order of the properties.
void print_properties(std::ostream& out, const TransitionSystem& system, const Names& names);

}  // namespace grafverif::nusmv
