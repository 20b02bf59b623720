// SPDX-License-Identifier: MIT
// LoopScope: a closed loop while it is resolved, and what its names mean.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "syntax/language/tree.hpp"
#include "syntax/resolve/resolve.hpp"
#include "syntax/resolve/terms.hpp"

namespace grafverif {

struct LoopScope {
    const tree::File& file;
    const LoopContext& context;
    Diagnostics& diagnostics;
    ClosedLoop loop = {};

    std::unordered_map<std::string_view, Id<Chart>> charts = {};
    std::unordered_map<std::string_view, Id<Component>> components = {};
    std::unordered_map<std::string_view, Id<ClosedLoop::Controller>> controllers = {};
    std::unordered_map<std::string, Id<ClosedLoop::Shared>> shared = {};
    std::unordered_map<std::string_view, Id<ClosedLoop::Instance>> instances = {};
    std::unordered_map<std::string_view, Id<ClosedLoop::Observer>> observers = {};
    std::vector<std::string> instance_writers = {};     ///< by shared variable: the instance that writes it, or empty
    std::unordered_set<std::string_view> excused = {};  ///< names bound in instances with errors: perhaps driven there
    std::unordered_set<std::string_view> below = {};    ///< constants not declared yet
    std::unordered_set<std::string_view> valueless = {};  ///< constants with an error
    bool incomplete = false;                              ///< something the loop names is in error itself

    /// Of each controller: its steps by name, its internal variables.
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

// -- constants.cpp
/// Before anything that reads them; then, once all other names are known, that none is one of them.
void resolve_constants(LoopScope& scope, const tree::ClosedLoop& written);
void check_constant_names(LoopScope& scope);
/// The value of the constant of that name, as a term; empty: there is none.
std::optional<Term> constant_named(LoopScope& scope, std::string_view name);
/// Terms that read constants alone, for `user`.
Terms constant_terms(LoopScope& scope, std::string_view user);
// -- resolve_instances.cpp
void resolve_instances(LoopScope& scope, const tree::ClosedLoop& written);
// -- resolve_observers.cpp
/// Their names and locations, which properties read; then their edges and all constraints.
void declare_observers(LoopScope& scope, const tree::ClosedLoop& written);
void resolve_observers(LoopScope& scope, const tree::ClosedLoop& written);
void resolve_constraints(LoopScope& scope, const tree::ClosedLoop& written);
// -- loop_names.cpp: what names mean in properties and constraints
Terms property_terms(LoopScope& scope);
/// The same in what an input of an instance is bound to: shared variables and constants.
Terms port_terms(LoopScope& scope);
// -- loop_times.cpp
/// `t1/v/t2` in a property, as the controller that waits for it reads it; empty: `node` is no time condition.
std::optional<Term> time_term(LoopScope& scope, const tree::Expr& node);
/// The leaf of an expression of the loop that stands for `symbol`.
Id<Expr> symbol_leaf(LoopScope& scope, const ClosedLoop::Symbol& symbol);
// -- resolve_loop.cpp
/// The shared variable of that name, declared where there is none yet.
Id<ClosedLoop::Shared> shared_named(LoopScope& scope, std::string_view name, const Type& type, Span where);

}  // namespace grafverif
