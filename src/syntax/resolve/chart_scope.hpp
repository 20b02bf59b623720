// SPDX-License-Identifier: MIT
// ChartScope: symbol tables of a chart during name resolution. Names are looked up by their word id.
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
#include "syntax/resolve/expand.hpp"
#include "syntax/resolve/references.hpp"
#include "syntax/resolve/terms.hpp"

namespace grafverif {

struct ChartScope {
    const tree::File& file;
    Diagnostics& diagnostics;
    Recorder record = {};
    Chart chart = {};

    std::unordered_map<Id<tree::Word>, Id<Chart::Variable>> variables = {};
    std::unordered_map<Id<tree::Word>, Id<Chart::PartialChart>> partials = {};
    /// For each partial chart: its steps by name.
    std::vector<std::unordered_map<Id<tree::Word>, Id<Chart::Step>>> steps = {};
    /// For each name: all steps with this name, in order of declaration.
    std::unordered_map<std::string_view, std::vector<Id<Chart::Step>>> steps_by_name = {};
    std::unordered_map<std::string, Id<Chart::TimeCondition>> times = {};
    std::unordered_map<std::uint64_t, Term> known_names = {};  ///< resolved terms of names, by partial chart and word

    /// For each variable: the position of its first continuous action and of its first stored action.
    std::vector<Span> continuous = {}, stored = {};
    Id<Chart::PartialChart> here = {};  ///< partial chart of the current term

    std::string_view text(tree::Name name) const { return file.text(name); }
};

/// Context for diagnostics in a copy (see InCopy). In an instance of a chart, the object also disables the recording of
/// names, because the resolution of the chart itself records them.
class InChartCopy {
public:
    InChartCopy(ChartScope& scope, std::uint32_t copy)
        : copy_(scope.diagnostics, scope.file, copy), scope_(&scope), outer_(scope.record) {
        if (copy > 0 && scope.file.copies[copy - 1].in_instance) scope.record = scope.record.silent();
    }
    InChartCopy(ChartScope& scope, tree::Name name) : InChartCopy(scope, name.copy) {}
    InChartCopy(const InChartCopy&) = delete;
    InChartCopy& operator=(const InChartCopy&) = delete;
    ~InChartCopy() { scope_->record = outer_; }

private:
    InCopy copy_;
    ChartScope* scope_;
    Recorder outer_;
};

/// A step of the tree, together with its id.
struct WrittenStep {
    const tree::Step* step = nullptr;
    Id<Chart::Step> id = {};
};
/// A transition of the tree, together with its partial chart.
struct WrittenTransition {
    const tree::Transition* transition = nullptr;
    Id<Chart::PartialChart> chart = {};
};
struct WrittenChart {
    std::vector<WrittenStep> steps = {};
    std::vector<WrittenTransition> transitions = {};
};

// -- variables.cpp

/// Returns a resolver of terms without names: each name is an error. `user` describes the term in messages.
Terms constant_terms(ChartScope& scope, std::string_view user);
void resolve_variables(ChartScope& scope, const tree::Variables& written);
/// Checks the variables that are bound to the ports of partial charts.
void check_ports(ChartScope& scope, const std::vector<tree::ChartItem>& items);
/// Reports variables that have the name of a step variable, or a name that begins with `X` and a digit.
void check_step_like(ChartScope& scope);

// -- steps.cpp: steps, partial charts and their owners
WrittenChart declare_steps(ChartScope& scope, const tree::Chart& written);
void resolve_owners(ChartScope& scope, const WrittenChart& written);

// -- links.cpp: transitions
void resolve_transitions(ChartScope& scope, const WrittenChart& written);
// -- actions.cpp
void resolve_actions(ChartScope& scope, const WrittenChart& written);
void resolve_stored(ChartScope& scope, const tree::Assignment& written, Chart::StoredAction action);

// -- condition.cpp

/// Returns a resolver of terms with the names of `scope`. `scope` must outlive the result.
Terms terms_of(ChartScope& scope);
/// Resolves a condition to a term; invalid after an error.
Id<Expr> resolve_condition(ChartScope& scope, Id<tree::Expr> node, Id<Chart::PartialChart> here, std::string_view user);
/// Returns the step `label` of the partial chart `here`. Reports an unknown name.
Id<Chart::Step> step_in(ChartScope& scope, Id<Chart::PartialChart> here, tree::Name label);
Id<Chart::PartialChart> partial_named(ChartScope& scope, tree::Name name);

// -- reachability.cpp

/// Reports steps that no sequence of transitions can activate.
void check_reachability(const Chart& chart, Diagnostics& diagnostics);

}  // namespace grafverif
