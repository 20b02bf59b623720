// SPDX-License-Identifier: MIT
// ChartScope: a chart while it is resolved, and what its names mean. Names are found by their words, that is by number.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "syntax/language/tree.hpp"
#include "syntax/resolve/terms.hpp"

namespace grafverif {

struct ChartScope {
    const tree::File& file;
    Diagnostics& diagnostics;
    Chart chart = {};

    std::unordered_map<Id<tree::Word>, Id<Chart::Variable>> variables = {};
    std::unordered_map<Id<tree::Word>, Id<Chart::PartialChart>> partials = {};
    /// Of each partial chart.
    std::vector<std::unordered_map<Id<tree::Word>, Id<Chart::Step>>> steps = {};
    /// The steps of any name, in order of declaration.
    std::unordered_map<std::string_view, std::vector<Id<Chart::Step>>> steps_by_name = {};
    std::unordered_map<std::string, Id<Chart::TimeCondition>> times = {};
    std::unordered_map<std::uint64_t, Term> known_names = {};  ///< by partial chart and word
    std::vector<Span> continuous = {}, stored = {};            ///< by variable: its first action of that kind
    Id<Chart::PartialChart> here = {};                         ///< where the term at hand stands

    std::string_view text(tree::Name name) const { return file.text(name); }
};

/// A step or transition as written, with its partial chart.
struct WrittenStep {
    const tree::Step* step = nullptr;
    Id<Chart::Step> id = {};
};
struct WrittenTransition {
    const tree::Transition* transition = nullptr;
    Id<Chart::PartialChart> chart = {};
};
struct WrittenChart {
    std::vector<WrittenStep> steps = {};
    std::vector<WrittenTransition> transitions = {};
};

// -- resolve_variables.cpp
void resolve_variables(ChartScope& scope, const tree::Variables& written);
/// A step-like name is one that reads as the step variable of some step, or could.
void check_step_like(ChartScope& scope);

// -- resolve_steps.cpp: steps, partial charts, and who owns them
WrittenChart declare_steps(ChartScope& scope, const tree::Chart& written);
void resolve_owners(ChartScope& scope, const WrittenChart& written);

// -- resolve_links.cpp: transitions
void resolve_transitions(ChartScope& scope, const WrittenChart& written);
// -- resolve_actions.cpp
void resolve_actions(ChartScope& scope, const WrittenChart& written);
void resolve_stored(ChartScope& scope, const tree::Assignment& written, Chart::StoredAction action);

// -- resolve_condition.cpp
/// The rules of terms, with the names of `scope`; lives no longer than it.
Terms terms_of(ChartScope& scope);
/// Not valid after an error.
Id<Expr> resolve_condition(ChartScope& scope, Id<tree::Expr> node, Id<Chart::PartialChart> here, std::string_view user);
/// The step that `label` names in `here`; reports one that is not there.
Id<Chart::Step> step_in(ChartScope& scope, Id<Chart::PartialChart> here, tree::Name label);
Id<Chart::PartialChart> partial_named(ChartScope& scope, tree::Name name);

// -- reachability.cpp
/// Reports steps that no sequence of transitions can activate.
void check_reachability(const Chart& chart, Diagnostics& diagnostics);

}  // namespace grafverif
