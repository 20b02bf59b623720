// SPDX-License-Identifier: MIT
// LoopScope: symbol tables of a closed loop during name resolution.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "syntax/language/tree.hpp"
#include "syntax/resolve/resolve.hpp"
#include "syntax/resolve/terms.hpp"

namespace grafverif {

struct LoopScope {
    /// A constant: the position of its name and, if it has a value, its index in `loop.constants`.
    struct Declared {
        Span where = {};
        std::optional<std::size_t> number = {};
    };

    const tree::File& file;
    const LoopContext& context;
    Diagnostics& diagnostics;
    Recorder record = {};
    ClosedLoop loop = {};

    std::map<std::string, Id<Chart>, std::less<>> charts = {};
    std::unordered_map<std::string_view, Id<Component>> components = {};
    std::unordered_map<std::string_view, Id<ClosedLoop::Controller>> controllers = {};
    std::unordered_map<std::string, Id<ClosedLoop::Shared>> shared = {};
    std::unordered_map<std::string_view, Id<ClosedLoop::Instance>> instances = {};
    std::unordered_map<std::string_view, Id<ClosedLoop::Observer>> observers = {};
    std::unordered_map<std::string_view, Span> faults = {};
    /// For each shared variable: the name of the instance that writes it; empty if no instance writes it.
    std::vector<std::string> instance_writers = {};
    std::set<std::string, std::less<>> excused = {};    ///< variables that instances with errors may write
    std::set<std::string, std::less<>> valueless = {};  ///< constants without a value, because of an error

    /// The position of the last declaration of a constant; the key is the name without indices.
    struct LastDeclaration {
        Span name = {}, whole = {};
    };
    std::unordered_map<std::string_view, LastDeclaration> last_declarations = {};
    std::map<std::string, Declared, std::less<>> constants = {};
    /// The declarations of component instances in the syntax tree, by name.
    std::unordered_map<std::string_view, const tree::Instance*> written_instances = {};
    std::uint64_t* copied = nullptr;  ///< see Expansion::copied
    bool too_large = false;           ///< true if the instances of charts are too large

    /// True if an element to which the loop refers contains an error; always false if the resolution continues after
    /// errors.
    bool incomplete = false;

    /// The steps, internal variables and partial charts of each controller, by name.
    struct Inside {
        std::unordered_map<std::string_view, std::vector<Id<Chart::Step>>> steps = {};
        std::unordered_map<std::string_view, Id<Chart::Variable>> internals = {};
        std::unordered_map<std::string_view, Id<Chart::PartialChart>> partials = {};
    };
    std::vector<Inside> inside = {};
    std::unordered_map<std::string, Id<ClosedLoop::Symbol>> symbols = {};

    std::string_view text(tree::Name name) const { return file.text(name); }
    const Chart& chart(Id<ClosedLoop::Controller> controller) const {
        return context.model.charts[loop.controllers[controller].chart];
    }
};

/// Returns a list of the quoted names of the locations of `component`.
std::string location_list(const Component& component);

// -- constants.cpp

/// `announce_constants` must be called first, with the declarations before their expansion. `resolve_constants` must be
/// called for each group of constants before all functions that read these constants.
void announce_constants(LoopScope& scope, const tree::File& file, const tree::ClosedLoop& written);
void resolve_constants(LoopScope& scope, const tree::Variables& written);
/// Reports constants with the name of another element. Must be called when all names are known.
void check_constant_names(LoopScope& scope);
/// Returns the position of the declaration of a shared variable, an internal variable or a step variable; empty
/// if the name denotes another element or is undeclared.
std::optional<Span> variable_named(const LoopScope& scope, std::string_view name);
/// Returns the value of the constant `name` as a term; empty if the constant does not exist. `where` is the position of
/// the occurrence.
std::optional<Term> constant_named(LoopScope& scope, std::string_view name, Span where);
/// Returns the resolver of terms that read only constants. `user` describes the term in messages.
Terms constant_terms(LoopScope& scope, std::string_view user);

// -- chart_instance.cpp

/// Handles a controller that is an instance of a chart: adds the copied chart to the model. The result is invalid after
/// an error.
Id<Chart> instantiate(LoopScope& scope, const tree::Controller& written);

// -- instances.cpp
void resolve_instances(LoopScope& scope, const tree::ClosedLoop& written);

// -- observers.cpp

/// `declare_observers` declares names and locations; it must be called first, because properties read them.
/// `resolve_observers` and `resolve_constraints` resolve edges and constraints.
void declare_observers(LoopScope& scope, const tree::ClosedLoop& written);
void resolve_observers(LoopScope& scope, const tree::ClosedLoop& written);
void resolve_constraints(LoopScope& scope, const tree::ClosedLoop& written);

// -- loop_names.cpp: names in properties and constraints
Terms property_terms(LoopScope& scope);
/// Returns the resolver of terms that are bound to inputs of an instance. These terms may contain shared variables and
/// constants.
Terms port_terms(LoopScope& scope);

// -- loop_times.cpp

/// Resolves a time condition `t1/v/t2` in a property. The term reads the timer of a controller with the same time
/// condition. The result is empty if `node` is not a time condition.
std::optional<Term> time_term(LoopScope& scope, const tree::Expr& node);
/// Returns the leaf for `symbol` in expressions of the loop.
Id<Expr> symbol_leaf(LoopScope& scope, const ClosedLoop::Symbol& symbol);

// -- loop.cpp

/// Returns the shared variable with this name. Declares the variable if necessary.
Id<ClosedLoop::Shared> shared_named(LoopScope& scope, std::string_view name, const Type& type, Span where);

}  // namespace grafverif
