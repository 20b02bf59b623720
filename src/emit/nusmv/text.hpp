// SPDX-License-Identifier: MIT
// Functions that the NuSMV emitters share: the names of all elements, and line breaking.
#pragma once

#include <iosfwd>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "grafverif/ir/transition_system.hpp"
#include "syntax/print/dialect.hpp"
#include "syntax/print/legal_names.hpp"

namespace grafverif::nusmv {

struct Names {
    std::vector<std::string> modules = {};
    /// Names of the symbols, per module; a member of an instance is named `instance.symbol`.
    std::vector<std::vector<std::string>> symbols = {};
    std::vector<std::string> instances = {};
    std::vector<std::string> properties = {};  ///< names of the specifications; `never_P` for a `reachable` property P

    /// The names of named values, which are global constants in NuSMV, and the index of each name.
    std::vector<std::string> values = {};
    std::unordered_map<std::string, std::size_t> value_places = {};
    /// Names that were changed, per scope.
    struct Changed {
        std::string scope = {};
        std::vector<Renaming> renamings = {};
    };
    std::vector<Changed> changed = {};
};

Names names_of(const TransitionSystem& system);

/// The terms of a system in the form in which they are printed. A number that denotes a named value becomes a leaf. The
/// indices of these leaves follow the indices of the symbols of the module.
class NamedValues {
public:
    NamedValues(const TransitionSystem& system, const Names& names)
        : system_(system), names_(names), exprs_(system.exprs) {}

    const Exprs& exprs() const { return exprs_; }
    /// Returns the term of `module` in the form in which it is printed. `symbol` is the symbol that has the value
    /// `term`; invalid if there is no such symbol.
    Id<Expr> named(Id<TransitionSystem::Module> module, Id<Expr> term, Id<TransitionSystem::Symbol> symbol = {});

private:
    using Key = std::tuple<Id<TransitionSystem::Module>, Id<Expr>, Id<TransitionSystem::Symbol>>;

    Id<Expr> rewritten(Id<TransitionSystem::Module> module, Id<Expr> term, Id<TransitionSystem::Symbol> symbol);
    bool names_values(Id<TransitionSystem::Module> module, Id<TransitionSystem::Symbol> symbol) const {
        return symbol.valid() && !system_.modules[module].symbols[symbol].values.empty();
    }

    const TransitionSystem& system_;
    const Names& names_;
    Exprs exprs_;
    std::map<Key, Id<Expr>> known_ = {};
};

/// Returns a printer for the leaves of terms of `module`.
LeafPrinter leaf_printer(const Names& names, Id<TransitionSystem::Module> module);

/// Prints `text` as a comment with lines of at most 100 columns.
void print_comment(std::ostream& out, std::string_view text);

/// Prints the specifications of main, in the order of the properties.
void print_properties(std::ostream& out, const TransitionSystem& system, const Names& names, NamedValues& values);

}  // namespace grafverif::nusmv
