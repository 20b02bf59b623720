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
    /// Steps by name, per partial chart.
    std::vector<std::unordered_map<Id<tree::Word>, Id<Chart::Step>>> steps = {};
    /// All steps with a name, in order of declaration.
    std::unordered_map<std::string_view, std::vector<Id<Chart::Step>>> steps_by_name = {};
    std::unordered_map<std::string, Id<Chart::TimeCondition>> times = {};
    std::unordered_map<std::uint64_t, Term> known_names = {};  ///< resolved terms of names, by partial chart and word
    /// For each variable: the position of its first action of the respective type.
    std::vector<Span> continuous = {}, stored = {};
    Id<Chart::PartialChart> here = {};  ///< partial chart of the current term

    std::string_view text(tree::Name name) const { return file.text(name); }
};

/// As InCopy. In an instance of a chart, nothing is recorded, because the chart itself records its names.
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
/// Returns a resolver of terms that may contain only constants: each name is an error, which names `user`.
Terms constant_terms(ChartScope& scope, std::string_view user);
void resolve_variables(ChartScope& scope, const tree::Variables& written);
/// Checks the variables that are bound to the ports of partial charts.
void check_ports(ChartScope& scope, const std::vector<tree::ChartItem>& items);
/// Reports variables whose name is that of a step variable, or begins with `X` and a digit.
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
/// Resolves terms with the names of `scope`, which must outlive the result.
Terms terms_of(ChartScope& scope);
/// Returns the term of a condition, or an invalid id after an error.
Id<Expr> resolve_condition(ChartScope& scope, Id<tree::Expr> node, Id<Chart::PartialChart> here, std::string_view user);
/// Returns the step named `label` in `here`; reports an unknown name.
Id<Chart::Step> step_in(ChartScope& scope, Id<Chart::PartialChart> here, tree::Name label);
Id<Chart::PartialChart> partial_named(ChartScope& scope, tree::Name name);

// -- reachability.cpp
/// Reports steps that no sequence of transitions can activate.
void check_reachability(const Chart& chart, Diagnostics& diagnostics);

}  // namespace grafverif
